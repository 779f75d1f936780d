#pragma once

#include "scenes/observe.h"
#include "scenes/solids.h"

namespace bullet_buoyancy::scenes {

/// A body on its own, as it is let go.
struct DropDef {
    Solid solid = Solid::box;
    Vec3 size = Vec3::Ones();  ///< m
    double ratio = 0.5;        ///< density over the water's
    double height = 2;         ///< of the centre above the water, m
    Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
    double downwardSpeed = 0;  ///< m/s
    SceneDef scene;
    Stepping stepping;
    double shortestStep = 0;  ///< s; see `StepLengths`
};

/// A turn out of all symmetry.
Eigen::Quaterniond askew();

/// A body that falls without friction may at no time have more energy than it was let go with, nor be higher
/// than that energy allows.
struct FallResult {
    double rise;  ///< greatest height over the allowed one, which is energy / (m g)
    double
        energyGain;  ///< most energy reported less that at release, over the latter (0 J lies at the water)
    double
        motion;  ///< most kinetic energy that the poses of a step show, over what the speed makes to which
                 ///< all energy at release and a step of gravity, which Bullet gives in whole, can bring it
    bool finite;
};
FallResult fallUndamped(const DropDef& def, double seconds);

/// What `FallResult::motion` may come to, since the mean velocity of a step shows what is gained in half of
/// it: by buoyancy, that of a body let go under water, (1/ratio - 1) g, on its way to the surface.
double motionShown(const DropDef& def);

/// How a body floats once it has come to rest. The lengths by which its wet share and its freeboard can
/// differ are small where its ratio is near 0 or 1: `wetError` is over the smaller of ratio and 1 - ratio.
struct SettleResult {
    bool atRest;
    bool finite;
    double after;     ///< s
    double wetError;  ///< |wet fraction - ratio| / min(ratio, 1 - ratio)
    Vec3 up;          ///< the water's, in the body's axes
};

/// `drag` and damping default to BodyDef's.
SettleResult settle(const DropDef& def, double limitSeconds, const BodyDef& drag = {});

/// Angle between the vertical and the axis of a cube that is nearest to it, radians.
double tiltOfFace(const Vec3& upInCube);

/// Smallest angle (radians) between how a cube floats and an orientation stable at its ratio; 0 where none is
/// known in closed form.
double cubeTiltError(double ratio, const Vec3& upInCube);

/// What `SettleResult::wetError` may be: a thousandth, or a draft of 1e-5 of the body's length, and Bullet's
/// rounding of the position: by itself, and by the speed at which a body is taken for at rest, since rounding
/// leaves it no slower.
double wetErrorLimit(const DropDef& def, const BodyDef& drag = {});

/// Bullet's rounding of the body's position, as far as it is from the world's origin, m.
double positionRounding(const DropDef& def);

/// A body wholly under water that rises or sinks as fast as linear drag lets it: |v - (1/ratio - 1) g / rate|
/// over the latter, once it has had the time.
double terminalVelocityError(const DropDef& def, double linearDrag);

}  // namespace bullet_buoyancy::scenes
