#include "bullet_buoyancy/hydrostatics/reference_waves.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/hydrostatics/reference_cell.h"

namespace bullet_buoyancy {

namespace {

constexpr std::size_t mostCells = 20000;

void add(const WetIntegrals& other, WetIntegrals& sums) {
    sums.headNormal += other.headNormal;
    sums.headTorque += other.headTorque;
    sums.volume += other.volume;
    sums.volumeMoment += other.volumeMoment;
    sums.headVolume += other.headVolume;
    sums.wettedArea += other.wettedArea;
    sums.waterplane.area += other.waterplane.area;
    sums.waterplane.firstMoment += other.waterplane.firstMoment;
    sums.waterplane.secondMoment += other.waterplane.secondMoment;
}

struct CellError {
    double force;        ///< m^3
    double overAllowed;  ///< the worst quantity's share of what the whole may err
};

/// What errors of integrals are measured by.
struct Scale {
    ReferenceTolerance tolerance;
    double volume, size;

    Scale(const Hull& hull, const ReferenceTolerance& allowed)
        : tolerance(allowed), size(hull.bounds.radius + hull.bounds.centre.norm()) {
        // What an open mesh encloses may be nothing.
        volume = std::max(std::abs(hull.moments.volume), 1e-6 * size * size * size);
    }

    CellError errorOf(const CellIntegral& cell) const {
        const WetIntegrals &a = cell.value, &b = cell.rougher;
        const double force = (a.headNormal - b.headNormal).norm() + cell.areaInDoubt * cell.depthInDoubt;
        const double pressure = std::max(
            {force, std::abs(a.volume - b.volume), (a.headTorque - b.headTorque).norm() / size,
             (a.volumeMoment - b.volumeMoment).norm() / size, std::abs(a.headVolume - b.headVolume) / size});
        const double areas =
            std::max({std::abs(a.wettedArea - b.wettedArea), std::abs(a.waterplane.area - b.waterplane.area),
                      (a.waterplane.firstMoment - b.waterplane.firstMoment).norm() / size,
                      (a.waterplane.secondMoment - b.waterplane.secondMoment).norm() / (size * size)}) +
            cell.areaInDoubt;
        return {force,
                std::max(pressure / (tolerance.pressure * volume), areas / (tolerance.areas * size * size))};
    }
};

struct Cell {
    const SurfacePatch* patch;
    CellCorners corners;
    WetIntegrals value;
    CellError error;
};

bool isBetter(const Cell& a, const Cell& b) {
    return a.error.overAllowed < b.error.overAllowed;
}

/// Cells as a heap with the worst one at the front.
class Refinement {
public:
    Refinement(const Hull& hull, WaterAroundBody& water, const ReferenceTolerance& tolerance)
        : m_water(water), m_scale(hull, tolerance) {}

    void addPatch(const SurfacePatch& patch) {
        for (const ParameterTriangle& triangle : patch.domain()) {
            const std::array<double, 3> depths = depthsOf(patch, triangle);
            addCell(patch, {CellCorner{triangle[0], depths[0]}, CellCorner{triangle[1], depths[1]},
                            CellCorner{triangle[2], depths[2]}});
        }
    }

    void refine() {
        while (m_overAllowed > 1 && m_cells.size() < mostCells)
            quarterWorst();
    }

    ReferenceIntegrals sum() const {
        ReferenceIntegrals result;
        for (const Cell& cell : m_cells) {
            add(cell.value, result.wet);
            result.error += cell.error.force;
        }
        return result;
    }

private:
    std::array<double, 3> depthsOf(const SurfacePatch& patch, const ParameterTriangle& corners) {
        const std::vector<double> depths = m_water.depths(
            {patch.at(corners[0]).position, patch.at(corners[1]).position, patch.at(corners[2]).position});
        return {depths[0], depths[1], depths[2]};
    }

    void addCell(const SurfacePatch& patch, const CellCorners& corners) {
        const CellIntegral integral = integrateCell(patch, corners, m_water);
        m_cells.push_back({&patch, corners, integral.value, m_scale.errorOf(integral)});
        m_overAllowed += m_cells.back().error.overAllowed;
        std::push_heap(m_cells.begin(), m_cells.end(), isBetter);
    }

    void quarterWorst() {
        std::pop_heap(m_cells.begin(), m_cells.end(), isBetter);
        const SurfacePatch& patch = *m_cells.back().patch;
        const auto [a, b, c] = m_cells.back().corners;
        m_overAllowed -= m_cells.back().error.overAllowed;
        m_cells.pop_back();
        const ParameterTriangle middles{(a.parameters + b.parameters) / 2, (b.parameters + c.parameters) / 2,
                                        (c.parameters + a.parameters) / 2};
        const std::array<double, 3> depths = depthsOf(patch, middles);
        const CellCorner ab{middles[0], depths[0]}, bc{middles[1], depths[1]}, ca{middles[2], depths[2]};
        addCell(patch, {a, ab, ca});
        addCell(patch, {ab, b, bc});
        addCell(patch, {ca, bc, c});
        addCell(patch, {ab, bc, ca});
    }

    WaterAroundBody& m_water;
    Scale m_scale;
    std::vector<Cell> m_cells;
    double m_overAllowed = 0;  // of all cells
};

}  // namespace

ReferenceIntegrals integrateInWaves(const Hull& hull, WaterAroundBody& water,
                                    const ReferenceTolerance& tolerance) {
    const auto patches = patchesOf(hull);
    Refinement refinement(hull, water, tolerance);
    for (const auto& patch : patches)
        refinement.addPatch(*patch);
    refinement.refine();
    return refinement.sum();
}

}  // namespace bullet_buoyancy
