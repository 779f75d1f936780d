#include "speed_vs_error/evaluators.h"

#include <cmath>
#include <limits>

#include "bullet_buoyancy/hydrostatics/evaluate_batch.h"
#include "bullet_buoyancy/hydrostatics/evaluate_clustered.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "speed_vs_error/centroid_pressure.h"
#include "speed_vs_error/closed_form.h"
#include "speed_vs_error/volume_points.h"

namespace bullet_buoyancy::demo {

namespace {

constexpr double nothingStated = std::numeric_limits<double>::infinity();

/// What the evaluators of the library look like.
using Evaluate = HydrostaticResult (*)(const Hull&, const Pose&, const WaterField&, const HydrostaticQuery&);

template <Evaluate evaluate>
HydrostaticResult inSinglePrecision(const Hull& hull, const Pose& pose, const WaterField& water,
                                    const HydrostaticQuery& asked) {
    HydrostaticQuery query = asked;
    query.precision = Precision::single;
    return evaluate(hull, pose, water, query);
}

class OfTheLibrary final : public ReadyEvaluator {
public:
    OfTheLibrary(Evaluate function, const Hull& hull, const WaterField& water)
        : m_evaluate(function), m_hull(hull), m_water(water) {}

    Wrench evaluate(const Pose& pose, const HydrostaticQuery& query) override {
        const HydrostaticResult result = m_evaluate(m_hull, pose, m_water, query);
        return {result.forceWorld, result.torqueAboutCom, result.forceErrorBound};
    }

private:
    Evaluate m_evaluate;
    const Hull& m_hull;
    const WaterField& m_water;
};

Evaluator library(const std::string& name, Evaluate evaluate, double error, ToleranceCounts toleranceCounts) {
    return {name, name, error, toleranceCounts, [evaluate](const Hull& hull, const WaterField& water) {
                return std::make_unique<OfTheLibrary>(evaluate, hull, water);
            }};
}

template <typename Prepare>
Evaluator baseline(const std::string& family, const std::string& name, const Prepare& prepare) {
    return {family, name, nothingStated, ToleranceCounts::never, prepare};
}

Evaluator pontoons(int count) {
    return baseline("pontoons", std::to_string(count) + " pontoons",
                    [count](const Hull& hull, const WaterField& water) {
                        return pressPoints(pontoonsOf(hull, count), water);
                    });
}

Evaluator voxels(int cellsAlong) {
    return baseline("voxels", std::to_string(cellsAlong * cellsAlong * cellsAlong) + " voxels",
                    [cellsAlong](const Hull& hull, const WaterField& water) {
                        return pressPoints(voxelsOf(hull, cellsAlong), water);
                    });
}

}  // namespace

bool Evaluator::isOfTheLibrary() const {
    return std::isfinite(error);
}

const std::vector<Evaluator>& evaluators() {
    static const std::vector<Evaluator> all{
        baseline("closed form in float", "closed form in float", closedFormInFloat),
        library("exact", evaluateExact, 1e-12, ToleranceCounts::inWaves),
        library("batch", evaluateBatch, 1e-12, ToleranceCounts::inWaves),
        library("batch in float", inSinglePrecision<evaluateBatch>, 2e-6, ToleranceCounts::inWaves),
        library("clustered", evaluateClustered, 1e-12, ToleranceCounts::inWaves),
        library("clustered in float", inSinglePrecision<evaluateClustered>, 2e-6, ToleranceCounts::inWaves),
        baseline("centroids", "centroids", pressCentroids),
        pontoons(4),
        pontoons(16),
        voxels(2),
        voxels(4),
        voxels(8),
    };
    return all;
}

}  // namespace bullet_buoyancy::demo
