#include "bullet_buoyancy/hydrostatics/reference_waves.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/hydrostatics/reference_cell.h"

namespace bullet_buoyancy {

namespace {

constexpr std::size_t mostQuarterings = 5000;

/// Of a patch, so that one does not use up what the others need; and of a cell that is quartered later.
constexpr std::size_t mostCellsInDoubt = 4000, mostCellsInDoubtLater = 50;

void addTo(WetIntegrals& sums, const WetIntegrals& other) {
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
    double force = 0;        ///< m^3
    double overAllowed = 0;  ///< the worst quantity's share of what the whole may err
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

    CellError errorOf(const CellDoubt& doubt) const { return weigh(doubt.area * doubt.depth, 0, doubt.area); }

    /// Of a value, by another one from a lower order.
    CellError errorOf(const WetIntegrals& a, const WetIntegrals& b) const {
        const double others = std::max(
            {std::abs(a.volume - b.volume), (a.headTorque - b.headTorque).norm() / size,
             (a.volumeMoment - b.volumeMoment).norm() / size, std::abs(a.headVolume - b.headVolume) / size});
        const double areas =
            std::max({std::abs(a.wettedArea - b.wettedArea), std::abs(a.waterplane.area - b.waterplane.area),
                      (a.waterplane.firstMoment - b.waterplane.firstMoment).norm() / size,
                      (a.waterplane.secondMoment - b.waterplane.secondMoment).norm() / (size * size)});
        return weigh((a.headNormal - b.headNormal).norm(), others, areas);
    }

private:
    CellError weigh(double force, double others, double areas) const {
        return {force, std::max(std::max(force, others) / (tolerance.pressure * volume),
                                areas / (tolerance.areas * size * size))};
    }
};

struct IntegratedCell {
    const SurfacePatch* patch;
    Cell cell;
    WetIntegrals value;
    CellError error;
};

bool isBetter(const IntegratedCell& a, const IntegratedCell& b) {
    return a.error.overAllowed < b.error.overAllowed;
}

/// Cells as a heap with the worst one at the front.
class Refinement {
public:
    Refinement(const Hull& hull, WaterAroundBody& water, const ReferenceTolerance& tolerance)
        : m_water(water), m_scale(hull, tolerance) {}

    void addPatch(const SurfacePatch& patch) {
        std::vector<Cell> cells;
        for (const ParameterTriangle& triangle : patch.domain()) {
            const std::vector<double> depths =
                m_water.depths({patch.at(triangle[0]).position, patch.at(triangle[1]).position,
                                patch.at(triangle[2]).position});
            cells.push_back(makeCell(patch,
                                     {CellPoint{triangle[0], depths[0]}, CellPoint{triangle[1], depths[1]},
                                      CellPoint{triangle[2], depths[2]}},
                                     m_water));
        }
        add(patch, std::move(cells), mostCellsInDoubt);
    }

    void refine() {
        for (std::size_t i = 0; m_overAllowed > 1 && i < mostQuarterings; ++i) {
            std::pop_heap(m_cells.begin(), m_cells.end(), isBetter);
            const IntegratedCell worst = m_cells.back();
            m_cells.pop_back();
            m_overAllowed -= worst.error.overAllowed;
            const std::array<Cell, 4> children = quarters(*worst.patch, worst.cell, m_water);
            add(*worst.patch, {children.begin(), children.end()}, mostCellsInDoubtLater);
        }
    }

    ReferenceIntegrals sum() const {
        ReferenceIntegrals result;
        for (const IntegratedCell& cell : m_cells) {
            addTo(result.wet, cell.value);
            result.error += cell.error.force;
        }
        return result;
    }

private:
    /// Quarters what is in doubt before it is worth to be integrated.
    void add(const SurfacePatch& patch, std::vector<Cell> cells, std::size_t most) {
        constexpr double worthIt = 1e-2;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const Cell cell = cells[i];
            const CellDoubt doubt = doubtOf(patch, cell, m_water);
            if (doubt.isDry) continue;
            const CellError error = m_scale.errorOf(doubt);
            if (error.overAllowed < worthIt || cells.size() > most) {
                addIntegrated(patch, cell, error);
                continue;
            }
            const std::array<Cell, 4> children = quarters(patch, cell, m_water);
            cells.insert(cells.end(), children.begin(), children.end());
        }
    }

    void addIntegrated(const SurfacePatch& patch, const Cell& cell, const CellError& ofDoubt) {
        constexpr double goodEnough = 1e-2;
        const WetIntegrals rough = integrateWetPart(patch, cell, CellRule::three, m_water);
        WetIntegrals value = integrateWetPart(patch, cell, CellRule::five, m_water);
        CellError error = m_scale.errorOf(value, rough);
        if (error.overAllowed > goodEnough) {
            const WetIntegrals finest = integrateWetPart(patch, cell, CellRule::eight, m_water);
            error = m_scale.errorOf(finest, value);
            value = finest;
        }
        error.force += ofDoubt.force;
        error.overAllowed += ofDoubt.overAllowed;
        m_overAllowed += error.overAllowed;
        m_cells.push_back({&patch, cell, value, error});
        std::push_heap(m_cells.begin(), m_cells.end(), isBetter);
    }

    WaterAroundBody& m_water;
    Scale m_scale;
    std::vector<IntegratedCell> m_cells;
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
