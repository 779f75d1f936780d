#pragma once

#include "bullet_buoyancy/core/body_rows.h"
#include "bullet_buoyancy/core/fill_rows.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {

inline void fill(BodyRow& row, Random& random, double low, double high) {
    for (double& number : row.lane)
        number = random.uniform(low, high);
}

inline void fill(VectorRows& rows, Random& random, double halfSize) {
    for (int lane = 0; lane < blockSize; ++lane)
        put(random.inCube(halfSize), rows, lane);
}

inline void fill(PoseRows& rows, Random& random, double halfSize) {
    for (int lane = 0; lane < blockSize; ++lane)
        put(Pose{random.inCube(halfSize), random.orientation()}, rows, lane);
}

inline Pose poseOf(const PoseRows& rows, int lane) {
    Pose pose;
    get(rows, lane, pose);
    return pose;
}

}  // namespace bullet_buoyancy::test
