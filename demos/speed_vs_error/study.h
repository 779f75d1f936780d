#pragma once

#include <functional>

#include "scenes/fnv1a.h"
#include "scenes/study_hulls.h"
#include "scenes/study_seas.h"
#include "speed_vs_error/evaluators.h"

namespace bullet_buoyancy::demo {

struct StudyEffort {
    int trianglesInABlock;  ///< poses times triangles, about, of what is timed at once
    int mostPoses;          ///< in a block
    int posesForErrors;     ///< against the reference
    int rounds;             ///< blocks of each evaluator, interleaved
};

/// How one evaluator fares with one hull in one water at one tolerance. Errors are over the weight of water
/// that the whole hull displaces, torques over that times the radius of the hull's bounding sphere.
struct SpeedRow {
    std::string water, hull;
    int triangles;  ///< of the hull; of a round solid, those that the baselines see
    const Evaluator* evaluator;
    double tolerance;                    ///< NaN where it makes no difference
    double nanoseconds;                  ///< of one evaluation, median
    double speed;                        ///< in multiples of the yardstick's, median of the rounds
    double medianError, largestError;    ///< of the force
    double medianTorque, largestTorque;  ///< of the torque
    double largestBound;                 ///< of the force's error as stated; infinite: nothing stated
    int broken;  ///< poses in which force or torque are farther off than the evaluator states
};

/// One row for each evaluator and tolerance. `hash` goes on over the results of the library's evaluators.
/// `reached` is told the share of the poses that the reference knows. Throws `Interruption` if the program is
/// asked to end.
std::vector<SpeedRow> studySpeed(const scenes::NamedHull& hull, const scenes::NamedSea& sea,
                                 const StudyEffort& effort, scenes::Fnv1a& hash,
                                 const std::function<void(double)>& reached);

}  // namespace bullet_buoyancy::demo
