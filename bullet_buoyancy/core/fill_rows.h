#pragma once

#include "bullet_buoyancy/core/body_rows.h"
#include "bullet_buoyancy/core/pose.h"

// Not for kernels, which may share no inline functions with other code: see core/lanes.h.
namespace bullet_buoyancy {

inline void put(const Vec3& v, VectorRows& rows, int lane) {
    rows.x.lane[lane] = v.x();
    rows.y.lane[lane] = v.y();
    rows.z.lane[lane] = v.z();
}

inline void put(const Pose& pose, PoseRows& rows, int lane) {
    put(pose.position, rows.position, lane);
    const Eigen::Quaterniond& q = pose.orientation;
    rows.orientation.x.lane[lane] = q.x();
    rows.orientation.y.lane[lane] = q.y();
    rows.orientation.z.lane[lane] = q.z();
    rows.orientation.w.lane[lane] = q.w();
}

inline Vec3 get(const VectorRows& rows, int lane) {
    return {rows.x.lane[lane], rows.y.lane[lane], rows.z.lane[lane]};
}

/// Number by number. What is wanted in two places is best got twice: a copy of what was just stored in parts
/// waits for the store.
inline void get(const VectorRows& rows, int lane, Vec3& v) {
    v.x() = rows.x.lane[lane];
    v.y() = rows.y.lane[lane];
    v.z() = rows.z.lane[lane];
}

inline void get(const PoseRows& rows, int lane, Pose& pose) {
    get(rows.position, lane, pose.position);
    pose.orientation.x() = rows.orientation.x.lane[lane];
    pose.orientation.y() = rows.orientation.y.lane[lane];
    pose.orientation.z() = rows.orientation.z.lane[lane];
    pose.orientation.w() = rows.orientation.w.lane[lane];
}

}  // namespace bullet_buoyancy
