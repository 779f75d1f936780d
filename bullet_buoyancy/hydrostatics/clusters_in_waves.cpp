#include "bullet_buoyancy/hydrostatics/clusters_in_waves.h"

#include <array>

#include "bullet_buoyancy/hydrostatics/mesh_in_waves.h"

namespace bullet_buoyancy {

namespace {

/// What the clusters may add to errors that triangles one by one would have too, over the error allowed.
constexpr double extraError = 1.0 / 8;

Vec3 vectorOf(const PackRow<double> (&rows)[3], int lane) {
    return {rows[0].lane[lane], rows[1].lane[lane], rows[2].lane[lane]};
}

/// Those of `MomentRows` of one child.
struct ChildMoments {
    Vec3 normal;
    Mat3 first;
    std::array<Mat3, 3> second;  // second[k](i, j): of x_i x_j n_k

    ChildMoments(const MomentRows<double>& rows, int lane) : normal(vectorOf(rows.normal, lane)) {
        for (int i = 0; i < 3; ++i)
            first.row(i) = vectorOf(rows.first[i], lane);
        int row = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j, ++row)
                for (int k = 0; k < 3; ++k)
                    second[std::size_t(k)](i, j) = second[std::size_t(k)](j, i) =
                        rows.second[row][k].lane[lane];
    }
};

/// A quadratic about the middle of a child's box.
struct LocalQuadratic {
    double value;
    Vec3 gradient;
    const Mat3& bend;
    double reach;   // of the linear part over the box, either way
    double excess;  // the most that the bend adds to it

    LocalQuadratic(const Quadratic& q, const Vec3& offset, const Vec3& halfExtents) : bend(q.bend) {
        const Vec3 turn = q.bend * offset;
        value = q.value + offset.dot(q.gradient + turn / 2);
        gradient = q.gradient + turn;
        reach = gradient.cwiseAbs().dot(halfExtents);
        excess = halfExtents.dot(q.bend.cwiseAbs() * halfExtents) / 2;
    }
};

/// Integrals of a quadratic f over the surface of a child. Third moments, which the bend asks for, are those
/// of a surface that is all in the middle of the box.
struct WeightedMoments {
    double atOrigin;  // of the linear part of f
    Vec3 gradient;
    Vec3 normal;  // of f n
    Mat3 first;   // of f x n^T
    Vec3 byBend;  // of (f - its linear part) n

    WeightedMoments(const LocalQuadratic& f, const Vec3& centre, const ChildMoments& moments)
        : atOrigin(f.value - f.gradient.dot(centre)), gradient(f.gradient) {
        const Vec3 turn = f.bend * centre;
        const double bendOfCentre = turn.dot(centre);
        first = atOrigin * moments.first;
        for (Eigen::Index k = 0; k < 3; ++k) {
            const Mat3& second = moments.second[std::size_t(k)];
            first.col(k) += second * gradient;
            byBend[k] = f.bend.cwiseProduct(second).sum() / 2 - turn.dot(moments.first.col(k)) +
                        bendOfCentre * moments.normal[k] / 2;
        }
        normal = atOrigin * moments.normal + moments.first.transpose() * gradient + byBend;
        first += centre * byBend.transpose();
    }

    Vec3 torque() const {
        return {first(1, 2) - first(2, 1), first(2, 0) - first(0, 2), first(0, 1) - first(1, 0)};
    }
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
          m_integrals(integrals) {
        const Vec3& up = water.upInBody();
        m_inPlan = Vec3::Ones();
        if (isHydrostatic()) m_inPlan = (m_inPlan - up.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
    }

    void add() {
        const int top = int(m_mesh.levels.size()) - 1;
        const auto count = std::uint32_t(m_mesh.levels.back().size());
        for (std::uint32_t first = 0; first < count; ++first)
            open(top, first);
    }

private:
    void open(int level, std::uint32_t index) {
        const Cluster<double>& cluster = m_mesh.levels[std::size_t(level)][index];
        for (int lane = 0; lane < packSize; ++lane) {
            const Vec3 halfExtents = vectorOf(cluster.halfExtents, lane);
            if (halfExtents.x() < 0) return;
            if (addChild(vectorOf(cluster.centre, lane), halfExtents, cluster.moments, lane)) continue;
            const std::uint32_t child = index * packSize + std::uint32_t(lane);
            if (level > 0)
                open(level - 1, child);
            else
                addPackInWaves(m_mesh.packs[child], m_origin, m_water, m_headError, m_query, m_integrals);
        }
    }

    /// False if it must be opened.
    bool addChild(const Vec3& centre, const Vec3& halfExtents, const MomentRows<double>& rows, int lane) {
        const Vec3 inBody = m_origin + centre;
        const WaterExpansion& water = m_water.near(inBody);
        const Vec3 offset = inBody - water.centre;
        const double distance = std::sqrt(m_water.distanceSquared(water, inBody));
        const double radius = std::min(halfExtents.norm(), halfExtents.dot(m_inPlan));
        const double error = m_water.errorWithin(water, distance + radius);
        const LocalQuadratic depth(water.depth, offset, halfExtents);
        const double reach = depth.reach + depth.excess + error;
        if (depth.value <= -reach) return true;
        if (depth.value < reach) return false;
        if (error - m_water.errorWithin(water, distance) > extraError * m_headError) return false;
        const LocalQuadratic head(water.head, offset, halfExtents);
        if (head.excess * halfExtents.norm() > m_headError * m_hull.bounds.radius) return false;
        addWet(depth, head, centre, {rows, lane});
        if (m_query.wettedArea) m_integrals.wettedArea += rows.area.lane[lane];
        m_integrals.error += error * vectorOf(rows.unsignedNormal, lane);
        return true;
    }

    /// See `addPressure`: of products of depth with depth or head, that of their bends is left out.
    void addWet(const LocalQuadratic& depth, const LocalQuadratic& head, const Vec3& centre,
                const ChildMoments& moments) {
        const Vec3& up = m_water.upInBody();
        const WeightedMoments ofDepth(depth, centre, moments);
        const WeightedMoments ofHead = isHydrostatic() ? ofDepth : WeightedMoments(head, centre, moments);
        const Vec3 depthMoment = ofDepth.first * up;
        const double volume = -up.dot(ofDepth.normal), byBend = up.dot(ofDepth.byBend);
        const auto timesDepth = [&](const WeightedMoments& f, double middle) {
            return ofDepth.atOrigin * up.dot(f.normal) + ofDepth.gradient.dot(f.first * up) + middle * byBend;
        };
        const double depthSquared = timesDepth(ofDepth, depth.value);
        m_integrals.headNormal += ofHead.normal;
        m_integrals.headTorque += ofHead.torque() + m_origin.cross(ofHead.normal);
        m_integrals.volume += volume;
        m_integrals.volumeMoment += volume * m_origin - depthMoment - depthSquared / 2 * up;
        m_integrals.headVolume -= timesDepth(ofHead, head.value) / 2;
        if (m_query.needsWaterplane()) addShadow(moments, depthMoment, -volume, depthSquared);
    }

    /// A point x throws its shadow on x + d up. Arguments: integrals of d x, d and d^2 n_up.
    void addShadow(const ChildMoments& moments, const Vec3& depthMoment, double depth, double depthSquared) {
        const Vec3& up = m_water.upInBody();
        const double shadow = up.dot(moments.normal);
        const Vec3 first = moments.first * up + depth * up;
        const Mat3 cross = depthMoment * up.transpose() + first * m_origin.transpose();
        Waterplane& waterplane = m_integrals.waterplane;
        waterplane.area -= shadow;
        waterplane.firstMoment -= first + shadow * m_origin;
        waterplane.secondMoment -= cross + cross.transpose() + depthSquared * up * up.transpose() +
                                   shadow * m_origin * m_origin.transpose();
        for (Eigen::Index k = 0; k < 3; ++k)
            waterplane.secondMoment -= up[k] * moments.second[std::size_t(k)];
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
};

}  // namespace

void addClustersInWaves(const Hull& hull, const WaterPatch& water, double headError,
                        const HydrostaticQuery& query, WetIntegrals& integrals) {
    ClustersInWaves(hull, water, headError, query, integrals).add();
}

}  // namespace bullet_buoyancy
