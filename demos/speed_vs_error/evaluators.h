#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"

namespace bullet_buoyancy::demo {

/// What an evaluator says of a body.
struct Wrench {
    Vec3 forceWorld;         ///< N
    Vec3 torqueAboutCom;     ///< world axes, N m
    double forceErrorBound;  ///< N; infinite where nothing is stated
};

/// An evaluator made ready for one hull in one water, with room of its own to work in.
class ReadyEvaluator {
public:
    virtual ~ReadyEvaluator() = default;
    virtual Wrench evaluate(const Pose& pose, const HydrostaticQuery& query) = 0;
};

/// In which waters the query's tolerance makes a difference.
enum class ToleranceCounts { never, inWaves, always };

struct Evaluator {
    std::string family;  ///< those of one family are joined by a line in the plot
    std::string name;

    /// The class it states: its force is no farther from the truth than its error bound and this times the
    /// weight of water that the whole hull displaces; where that bound is 0, its torque no farther than this
    /// times that weight and the radius of the hull's bounding sphere. Infinite: it states nothing.
    double error;
    ToleranceCounts toleranceCounts;

    std::function<std::unique_ptr<ReadyEvaluator>(const Hull& hull, const WaterField& water)> prepare;

    bool isOfTheLibrary() const;  ///< which states a class; what it is compared with does not
};

/// The first is the yardstick, to whose speed all are compared.
const std::vector<Evaluator>& evaluators();

}  // namespace bullet_buoyancy::demo
