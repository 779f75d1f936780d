#pragma once

#include "bullet_buoyancy/core/math_types.h"
#include "bullet_buoyancy/core/pose.h"

namespace bullet_buoyancy {

/// All that acts on a body at a pose but contacts and joints: forces with a potential, and a medium that
/// slows it.
struct Load {
    Vec3 force = Vec3::Zero();           ///< with gravity, N
    Vec3 torque = Vec3::Zero();          ///< about the centre of mass, world axes, N m
    double potential = 0;                ///< of force and torque, J
    double potentialRounding = 0;        ///< what of it may be rounding of large parts that cancel, J
    double dragRate = 0;                 ///< at which the velocity decays to the medium's, 1/s
    double dampingRate = 0;              ///< at which the angular momentum decays, 1/s
    Vec3 mediumVelocity = Vec3::Zero();  ///< m/s
    double displacement = 0;             ///< volume that the body takes of the medium, m^3
    Vec3 centreFromCom = Vec3::Zero();   ///< centre of that volume from the centre of mass, world axes, m
    double forceErrorBound = 0;          ///< the force is no farther than this from the true one, N
};

/// The load as a function of a body's pose, at one moment.
class LoadField {
public:
    /// The direction along which the potential changes: in a calm field, moving a body across it, or turning
    /// one about it, changes nothing. Unit length, world axes.
    virtual Vec3 up() const = 0;

    /// The potential of a pose is the same at any moment, and changes along `up` alone. Of a body in such a
    /// field no energy comes or goes but by drag and by others. In any other field the load has a potential
    /// at each moment.
    virtual bool isCalm() const = 0;

    /// With `stiffness`: also the change of (force, torque) as -stiffness times (displacement in m, rotation
    /// in rad), world axes.
    virtual Load at(const Pose& pose, Mat6* stiffness = nullptr) const = 0;

protected:
    ~LoadField() = default;
};

}  // namespace bullet_buoyancy
