#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bullet_buoyancy/hydrostatics/hydrostatics.h"
#include "scenes/study_cases.h"

namespace bullet_buoyancy::demo {

struct StudyHull {
    std::string name;
    std::shared_ptr<const Hull> hull;
    double length;  ///< m
};

/// Box, Wigley hull with a deck, capsule, and a sphere of 320 triangles, all of the same length (m).
std::vector<StudyHull> studyHulls(double length);

/// A sphere of so many triangles: 20 * 4^levels.
StudyHull icosphere(double diameter, int levels);

/// How an evaluation in waves fares at one tolerance, over all cases. Errors are over the weight of water
/// that the whole hull displaces, torques over that times the hull's length.
struct ToleranceRow {
    double tolerance;
    double medianError, largestError;  ///< of the force
    double medianBound, shareOver;     ///< the bound stated, and in what share it is above the tolerance
    double medianTorque, largestTorque;
    double samples;                 ///< median
    double microseconds, overFlat;  ///< median, and over the same in flat water
    int brokenBounds;               ///< cases in which the error is above the bound
};

/// What the reference leaves undecided, over the weight.
inline constexpr double errorOfReference = 1e-8;

/// One row for each tolerance of 1e-1 to 1e-5, and for 0. `reached` is told of each case before it begins, by
/// its number. Throws `Interruption` between two cases if the program is asked to end.
std::vector<ToleranceRow> studyTolerances(const StudyHull& hull, const WaterField& water,
                                          const std::vector<scenes::StudyCase>& cases, PressureModel pressure,
                                          const std::function<void(std::size_t)>& reached);

struct SampleCount {
    double samples, microseconds;  ///< medians
};

/// What an evaluation takes, without a look at its error.
SampleCount countSamples(const StudyHull& hull, const WaterField& water,
                         const std::vector<scenes::StudyCase>& cases, const HydrostaticQuery& query);

}  // namespace bullet_buoyancy::demo
