#pragma once

namespace bullet_buoyancy {

/// Bodies that kernels take side by side.
inline constexpr int blockSize = 8;

/// One number of each body of a block.
struct alignas(64) BodyRow {
    double lane[blockSize];
};

struct VectorRows {
    BodyRow x, y, z;
};

struct QuaternionRows {
    BodyRow x, y, z, w;
};

/// See Pose.
struct PoseRows {
    VectorRows position;
    QuaternionRows orientation;
};

/// What acts on each body of a block at its pose, in world axes: see Load in motion/.
struct LoadRows {
    VectorRows force, torque;
    BodyRow potential, potentialRounding;
    BodyRow dragRate, dampingRate;
    BodyRow displacement;
    VectorRows centreFromCom;
    BodyRow forceErrorBound;
};

}  // namespace bullet_buoyancy
