#include "bullet_buoyancy/hydrostatics/packed_integrals.h"

#include <algorithm>
#include <array>

#include "bullet_buoyancy/hydrostatics/clip_kernels.h"
#include "bullet_buoyancy/hydrostatics/pack_rows.h"

namespace bullet_buoyancy {

namespace {

/// Asks for the first lines of what will be read soon, of a large mesh from far away in memory; what follows
/// on them comes by itself.
template <typename Data>
void prefetch([[maybe_unused]] const Data& data) {
#ifdef __GNUC__
    constexpr std::size_t line = 64, most = 16 * line;
    for (std::size_t offset = 0; offset < std::min(sizeof data, most); offset += line)
        __builtin_prefetch(reinterpret_cast<const char*>(&data) + offset);
#endif
}

template <typename Real>
class PackedMeshInWater {
public:
    PackedMeshInWater(const PackedTriangles<Real>& mesh, const PackPlane& plane, WetRowsAsked asked)
        : m_mesh(mesh),
          m_plane(plane),
          m_kernels(clipKernels<Real>()),
          m_clip(m_kernels.clip[int(asked)]),
          m_open(m_kernels.open[int(asked)]) {
        if (asked == WetRowsAsked::all)
            m_rows = {};
        else
            m_rows.pressure = {};
    }

    void addEveryTriangle() {
        m_clip(m_mesh.packs.data(), nullptr, int(m_mesh.packs.size()), m_plane, m_rows);
    }

    /// From the highest clusters down, those first that were found last.
    void addAtTheSurface() {
        if (m_mesh.levels.empty()) return addEveryTriangle();
        const int top = int(m_mesh.levels.size()) - 1;
        const auto count = std::uint32_t(m_mesh.levels.back().size());
        for (std::uint32_t first = 0; first < count; ++first) {
            push(top, first);
            while (m_stacked > 0)
                openNext();
        }
        clipListed();
    }

    PressureSums pressure() const { return m_kernels.sum(m_rows.pressure); }
    const ShadowRows<Real>& shadow() const { return m_rows.shadow; }

private:
    struct Place {
        int level;
        std::uint32_t cluster;
    };
    static constexpr int mostLevels = 8;  // 2^32 packs
    static constexpr int mostListed = 256;

    void push(int level, std::uint32_t cluster) { m_stack[std::size_t(m_stacked++)] = {level, cluster}; }

    void openNext() {
        const Place at = m_stack[std::size_t(--m_stacked)];
        std::array<std::uint8_t, packSize + 1> cut;
        const Cluster<Real>& cluster = m_mesh.levels[std::size_t(at.level)][at.cluster];
        const int count = m_open(cluster, m_plane, m_rows, cut.data());
        if (m_listed + count > mostListed) clipListed();
        for (int i = 0; i < count; ++i) {
            const std::uint32_t child = at.cluster * packSize + cut[std::size_t(i)];
            if (at.level == 0) {
                prefetch(m_mesh.packs[child]);
                m_list[std::size_t(m_listed++)] = child;
            } else {
                prefetch(m_mesh.levels[std::size_t(at.level - 1)][child]);
                push(at.level - 1, child);
            }
        }
    }

    void clipListed() {
        m_clip(m_mesh.packs.data(), m_list.data(), m_listed, m_plane, m_rows);
        m_listed = 0;
    }

    const PackedTriangles<Real>& m_mesh;
    const PackPlane& m_plane;
    const ClipKernels<Real>& m_kernels;
    typename ClipKernels<Real>::Clip m_clip;
    typename ClipKernels<Real>::Open m_open;
    WetRows<Real> m_rows;
    std::array<Place, mostLevels * packSize> m_stack;
    std::array<std::uint32_t, mostListed> m_list;
    int m_stacked = 0, m_listed = 0;
};

/// By the divergence theorem with d up, which vanishes at the surface. What depth is integrated over the
/// volume follows: up . x = depth of the origin - d.
Displacement displacementOf(const PressureSums& sums, const PackPlane& plane, const Vec3& up,
                            const PackedMesh& mesh, Precision precision) {
    const double volume = -sums.depth;
    const Vec3 depthMoment(-sums.depthMoment[0], -sums.depthMoment[1], -sums.depthMoment[2]);
    const double headVolume = (plane.depthOfOrigin * volume - up.dot(depthMoment)) / 2;
    return {volume, depthMoment + headVolume * up + volume * mesh.origin, headVolume,
            precision == Precision::single ? mesh.errorOfSingle : 0};
}

PackPlane packPlane(const PackedMesh& mesh, const WaterPlane& plane) {
    const Vec3& up = plane.upInBody;
    return {{up.x(), up.y(), up.z()}, plane.depth(mesh.origin)};
}

template <typename Real>
PressureSums press(const PackedTriangles<Real>& mesh, const PackPlane& plane, MeshSum sum) {
    if (sum == MeshSum::inPacks || mesh.levels.empty())
        return clipKernels<Real>().press(mesh.packs.data(), int(mesh.packs.size()), plane);
    PackedMeshInWater<Real> inWater(mesh, plane, WetRowsAsked::pressure);
    inWater.addAtTheSurface();
    return inWater.pressure();
}

/// A point x throws its shadow on x + d up.
template <typename Real>
void addShadow(const ShadowRows<Real>& rows, const PackPlane& plane, const Vec3& up, const Vec3& origin,
               Waterplane& waterplane) {
    const Mat3 flat = Mat3::Identity() - up * up.transpose();
    const double area = -sumOf(rows.shadow);
    const Vec3 first = -flat * sumOf(rows.shadowMoment);
    const Mat3 second = -symmetricSumOf(rows.shadowMoments2);
    const Vec3 offset = origin + plane.depthOfOrigin * up;
    waterplane.area += area;
    waterplane.firstMoment += first + area * offset;
    waterplane.secondMoment += flat * second * flat + first * offset.transpose() +
                               offset * first.transpose() + area * offset * offset.transpose();
}

template <typename Real>
void addWithShadow(const PackedMesh& mesh, const WaterPlane& water, MeshSum sum,
                   const HydrostaticQuery& query, WetIntegrals& integrals) {
    const PackPlane plane = packPlane(mesh, water);
    PackedMeshInWater<Real> inWater(mesh.in<Real>(), plane, WetRowsAsked::all);
    if (sum == MeshSum::inPacks)
        inWater.addEveryTriangle();
    else
        inWater.addAtTheSurface();
    const Vec3& up = water.upInBody;
    integrals.addDisplacement(up, displacementOf(inWater.pressure(), plane, up, mesh, query.precision));
    if (query.needsWaterplane()) addShadow(inWater.shadow(), plane, up, mesh.origin, integrals.waterplane);
    if (query.wettedArea) integrals.wettedArea += sumOf(inWater.shadow().area);
}

}  // namespace

Displacement displacementOf(const PackedMesh& mesh, const WaterPlane& water, MeshSum sum,
                            Precision precision) {
    const PackPlane plane = packPlane(mesh, water);
    const PressureSums sums =
        precision == Precision::single ? press(mesh.single, plane, sum) : press(mesh.full, plane, sum);
    return displacementOf(sums, plane, water.upInBody, mesh, precision);
}

void addPackedMesh(const PackedMesh& mesh, const WaterPlane& plane, MeshSum sum,
                   const HydrostaticQuery& query, WetIntegrals& integrals) {
    if (!query.needsWaterplane() && !query.wettedArea)
        integrals.addDisplacement(plane.upInBody, displacementOf(mesh, plane, sum, query.precision));
    else if (query.precision == Precision::single)
        addWithShadow<float>(mesh, plane, sum, query, integrals);
    else
        addWithShadow<double>(mesh, plane, sum, query, integrals);
}

}  // namespace bullet_buoyancy
