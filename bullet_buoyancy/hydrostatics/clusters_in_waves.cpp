#include "bullet_buoyancy/hydrostatics/clusters_in_waves.h"

#include <array>
#include <cmath>
#include <limits>

#include "bullet_buoyancy/hydrostatics/mesh_in_waves.h"
#include "bullet_buoyancy/hydrostatics/pack_rows.h"
#include "bullet_buoyancy/hydrostatics/wet_kernels.h"
#include "bullet_buoyancy/hydrostatics/wet_sums.h"

namespace bullet_buoyancy {

namespace {

/// What clusters may add to the bound of the error that their triangles one by one would have: over the error
/// allowed, or over that in the middle.
constexpr double absoluteExtra = 1.0 / 4, relativeExtra = 1.0 / 4;

/// About what the kernel adds to the bound of the error, over it, for knowing distances no better.
constexpr double extraOfKernel = 1.0 / 32;

/// Expansions side by side as a kernel reads them; what is there already is not written again.
class PackWaterWriter {
public:
    PackWaterWriter(const WaterPatch& patch, const Vec3& origin) : m_patch(patch), m_origin(origin) {}

    void write(int lane, const WaterExpansion& water) {
        if (m_written[std::size_t(lane)] == &water) return;
        m_written[std::size_t(lane)] = &water;
        set(m_rows.centre, lane, water.centre - m_origin);
        set(m_rows.depth, lane, water.depth);
        if (m_patch.pressure() == PressureModel::waveDynamic) set(m_rows.head, lane, water.head);
        set(m_rows.error, lane, {water.error.second, water.error.third, water.error.fourth});
    }

    void setTypicalDistance(double distance) { m_rows.typicalDistance = distance; }

    const PackWater& rows() const { return m_rows; }

private:
    static void set(PackRow<double> (&rows)[3], int lane, const Vec3& v) {
        for (int i = 0; i < 3; ++i)
            rows[i].lane[lane] = v[i];
    }

    static void set(QuadraticRows& rows, int lane, const Quadratic& q) {
        rows.value.lane[lane] = q.value;
        set(rows.gradient, lane, q.gradient);
        int row = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j, ++row)
                rows.bend[row].lane[lane] = q.bend(i, j);
    }

    const WaterPatch& m_patch;
    const Vec3& m_origin;
    PackWater m_rows;
    std::array<const WaterExpansion*, packSize> m_written{};
};

class ClustersInWaves {
public:
    ClustersInWaves(const Hull& hull, const WaterPatch& water, double headError,
                    const HydrostaticQuery& query, WetIntegrals& integrals)
        : m_hull(hull),
          m_mesh(hull.packed.full),
          m_origin(hull.packed.origin),
          m_water(water),
          m_headError(headError),
          m_query(query),
          m_integrals(integrals),
          m_packWater(water, hull.packed.origin),
          m_wantsAll(query.needsWaterplane() || query.wettedArea),
          m_addWet(wetKernels().addWet[int(m_wantsAll ? WetRowsAsked::all : WetRowsAsked::pressure)]) {
        const Vec3& up = water.upInBody();
        m_inPlan = Vec3::Ones();
        if (isHydrostatic()) m_inPlan = (m_inPlan - up.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
        m_sea.isHydrostatic = isHydrostatic();
        m_sea.validity2 = water.validity() * water.validity();
        m_sea.headError = headError;
        for (int axis = 0; axis < 3; ++axis) {
            m_sea.up[axis] = up[axis];
            m_sea.largest[axis] = water.cellCount() == 1 ? infinity : water.cell()[axis];
        }
        m_rows = {};
    }

    /// See `addClustersInWaves`.
    Vec3 add() {
        const int top = int(m_mesh.levels.size()) - 1;
        const auto count = std::uint32_t(m_mesh.levels.back().size());
        for (std::uint32_t first = 0; first < count; ++first)
            open(top, first);
        m_sums.add(m_rows);
        m_sums.addTo(m_integrals, m_origin, m_water.upInBody());
        if (m_wantsAll) m_sums.add(m_rows.shadow);
        if (m_query.needsWaterplane()) m_sums.addTo(m_integrals.waterplane, m_origin, m_water.upInBody());
        if (m_query.wettedArea) m_integrals.wettedArea += m_sums.area;
        return m_extraError + extraOfKernel * sumOf(m_rows.error);
    }

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    void open(int level, std::uint32_t index) {
        const Cluster<double>& cluster = m_mesh.levels[std::size_t(level)][index];
        for (int lane = 0; lane < packSize; ++lane) {
            const Vec3 centre = vectorOf(cluster.centre, lane);
            const Vec3 halfExtents = vectorOf(cluster.halfExtents, lane);
            if (halfExtents.x() < 0) return;
            if (addChild(centre, halfExtents, cluster.moments, lane)) continue;
            const std::uint32_t child = index * packSize + std::uint32_t(lane);
            if (level > 0)
                open(level - 1, child);
            else
                addPack(m_mesh.packs[child], centre, halfExtents);
        }
    }

    /// As distances count, m.
    double distanceOf(const Vec3& point, const WaterExpansion& water) const {
        return std::sqrt(m_water.distanceSquared(water, point));
    }

    /// Of a box, as distances count, m.
    double radiusOf(const Vec3& halfExtents) const {
        return std::min(halfExtents.norm(), halfExtents.dot(m_inPlan));
    }

    /// Nothing if it is dry, and by its moments if it is wet. False if it must be opened.
    bool addChild(const Vec3& centre, const Vec3& halfExtents, const MomentRows<double>& rows, int lane) {
        const Vec3 inBody = m_origin + centre;
        const WaterExpansion& water = m_water.near(inBody);
        const Vec3 offset = inBody - water.centre;
        const double distance = distanceOf(inBody, water), radius = radiusOf(halfExtents);
        const double error = m_water.errorWithin(water, distance + radius);
        const LocalQuadratic depth(water.depth, offset, halfExtents);
        const double reach = depth.reach + depth.excess + error;
        if (depth.value <= -reach) return true;
        if (depth.value < reach) return false;
        const double inTheMiddle = m_water.errorWithin(water, distance);
        if (error - inTheMiddle > std::max(absoluteExtra * m_headError, relativeExtra * inTheMiddle))
            return false;
        // No bound is stated of the torque, but what the third moments leave out of it should be as little.
        const LocalQuadratic head(water.head, offset, halfExtents);
        if (head.excess * halfExtents.norm() > m_headError * m_hull.bounds.radius) return false;
        addWet(depth, head, centre, {rows, lane});
        const Vec3 unsignedNormal = vectorOf(rows.unsignedNormal, lane);
        m_sums.error += error * unsignedNormal;
        m_extraError += (error - inTheMiddle) * unsignedNormal;
        m_sums.area += rows.area.lane[lane];
        return true;
    }

    void addWet(const LocalQuadratic& depth, const LocalQuadratic& head, const Vec3& centre,
                const ChildMoments& moments) {
        const Vec3& up = m_water.upInBody();
        const WeightedMoments ofDepth(depth, centre, moments);
        if (isHydrostatic())
            m_sums.add(ofDepth, ofDepth, up);
        else
            m_sums.add(ofDepth, WeightedMoments(head, centre, moments), up);
        if (m_wantsAll) m_sums.addShadow(moments, up);
    }

    /// Each triangle in the water of its middle's cell.
    void addPack(const TrianglePack<double>& pack, const Vec3& centre, const Vec3& halfExtents) {
        const Vec3 inBody = m_origin + centre;
        const WaterExpansion& first = m_water.near(inBody - halfExtents);
        const bool isInOne = &first == &m_water.near(inBody + halfExtents);
        for (int lane = 0; lane < packSize; ++lane)
            m_packWater.write(lane, isInOne ? first : m_water.near(m_origin + middleOf(pack, lane)));
        m_packWater.setTypicalDistance(
            std::max(distanceOf(inBody, m_water.near(inBody)), radiusOf(halfExtents) / 2));
        std::array<std::uint8_t, packSize> left;
        const int count = m_addWet(pack, m_packWater.rows(), m_sea, m_rows, left.data());
        addInWaves(pack, left.data(), count, m_origin, m_water, m_headError, m_query, m_integrals);
    }

    static Vec3 middleOf(const TrianglePack<double>& pack, int lane) {
        return (vectorOf(pack.a, lane) + vectorOf(pack.b, lane) + vectorOf(pack.c, lane)) / 3;
    }

    bool isHydrostatic() const { return m_water.pressure() == PressureModel::hydrostatic; }

    const Hull& m_hull;
    const PackedTriangles<double>& m_mesh;
    const Vec3& m_origin;
    const WaterPatch& m_water;
    double m_headError;
    const HydrostaticQuery& m_query;
    WetIntegrals& m_integrals;
    Vec3 m_inPlan;  // what of lengths along the body's axes counts as distance
    PackWaterWriter m_packWater;
    PackSea m_sea;
    bool m_wantsAll;
    AddWetTriangles m_addWet;
    HeadRows m_rows;
    WetSums m_sums;
    Vec3 m_extraError = Vec3::Zero();
};

}  // namespace

Vec3 addClustersInWaves(const Hull& hull, const WaterPatch& water, double headError,
                        const HydrostaticQuery& query, WetIntegrals& integrals) {
    return ClustersInWaves(hull, water, headError, query, integrals).add();
}

}  // namespace bullet_buoyancy
