#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "bullet_buoyancy/motion/free_rotation.h"
#include "bullet_buoyancy/motion/load.h"

/// Loads that need no water: what the stepper makes of them can be worked out by hand. Up is z.
namespace bullet_buoyancy::test {

/// Of every load here.
struct Medium {
    double dragRate = 0;     ///< 1/s
    double dampingRate = 0;  ///< 1/s
    Vec3 velocity = Vec3::Zero();
};

class SimpleLoad : public LoadField {
public:
    Medium medium;

    Vec3 up() const override { return Vec3::UnitZ(); }
    bool isCalm() const override { return true; }

protected:
    ~SimpleLoad() = default;

    Load inMedium() const {
        Load load;
        load.dragRate = medium.dragRate;
        load.dampingRate = medium.dampingRate;
        load.mediumVelocity = medium.velocity;
        return load;
    }
};

/// Its weight (N), or nothing.
class Weight final : public SimpleLoad {
public:
    explicit Weight(double weight = 0) : m_weight(weight) {}

    Load at(const Pose& pose, Mat6* stiffness) const override {
        if (stiffness) stiffness->setZero();
        Load load = inMedium();
        load.force.z() = -m_weight;
        load.potential = m_weight * pose.position.z();
        return load;
    }

private:
    double m_weight;
};

/// Force and torque in proportion to displacement and rotation vector. The torque has the potential to first
/// order in the rotation; exactly where that is about one axis.
class Spring final : public SimpleLoad {
public:
    explicit Spring(const Mat6& stiffness) : m_stiffness(stiffness) {}

    /// N/m, against heave alone.
    explicit Spring(double heave) : m_stiffness(Mat6::Zero()) { m_stiffness(2, 2) = heave; }

    Load at(const Pose& pose, Mat6* stiffness) const override {
        if (stiffness) *stiffness = m_stiffness;
        const Vec6 displacement = (Vec6() << pose.position, rotationVector(pose.orientation)).finished();
        const Vec6 pull = m_stiffness * displacement;
        Load load = inMedium();
        load.force = -pull.head<3>();
        load.torque = -pull.tail<3>();
        load.potential = pull.dot(displacement) / 2;
        return load;
    }

private:
    Mat6 m_stiffness;
};

/// Wall-sided columns on a body, thin and long: each is lifted in proportion to how deep its end has gone
/// below z = 0, and not at all above. With the body's weight.
class Columns final : public SimpleLoad {
public:
    /// `ends` in body axes, m; `lift` of each, rho g A in N/m; `weight` in N.
    Columns(std::vector<Vec3> ends, double lift, double weight)
        : m_ends(std::move(ends)), m_lift(lift), m_weight(weight) {}

    Load at(const Pose& pose, Mat6* stiffness) const override {
        if (stiffness) stiffness->setZero();
        Load load = inMedium();
        load.force.z() = -m_weight;
        load.potential = m_weight * pose.position.z();
        for (const Vec3& end : m_ends) {
            const Vec3 arm = pose.orientation * end;
            const double draft = std::max(0.0, -pose.position.z() - arm.z()), force = m_lift * draft;
            load.force.z() += force;
            load.torque += force * arm.cross(up());
            load.potential += force * draft / 2;
            if (stiffness && draft > 0) addStiffness(*stiffness, arm, force);
        }
        return load;
    }

private:
    void addStiffness(Mat6& stiffness, const Vec3& arm, double force) const {
        const Vec6 heave = (Vec6() << up(), arm.cross(up())).finished();
        stiffness += m_lift * heave * heave.transpose();
        stiffness.bottomRightCorner<3, 3>() += force * (arm.z() * Mat3::Identity() - arm * up().transpose());
    }

    std::vector<Vec3> m_ends;
    double m_lift, m_weight;
};

/// A ditch across the way up: a spring (N/m) within `halfWidth` (m) of z = 0, and beyond it nothing, neither
/// force nor stiffness.
class Pit final : public SimpleLoad {
public:
    Pit(double spring, double halfWidth) : m_spring(spring), m_halfWidth(halfWidth) {}

    Load at(const Pose& pose, Mat6* stiffness) const override {
        const double z = pose.position.z();
        const bool within = std::abs(z) < m_halfWidth;
        if (stiffness) {
            stiffness->setZero();
            if (within) (*stiffness)(2, 2) = m_spring;
        }
        Load load = inMedium();
        if (!within) return load;
        load.force.z() = -m_spring * z;
        load.potential = m_spring * (z * z - m_halfWidth * m_halfWidth) / 2;
        return load;
    }

private:
    double m_spring, m_halfWidth;
};

/// Another load whose place is moved (m), as it is at one moment of a motion: of a body of a given weight
/// (N), which does not move with it.
class MovedLoad final : public SimpleLoad {
public:
    MovedLoad(const LoadField& load, const Vec3& place, double weight = 0)
        : m_load(load), m_place(place), m_weight(weight) {}

    bool isCalm() const override { return false; }

    Load at(const Pose& pose, Mat6* stiffness = nullptr) const override {
        Load load = m_load.at({pose.position - m_place, pose.orientation}, stiffness);
        load.potential += m_weight * m_place.z();
        return load;
    }

private:
    const LoadField& m_load;
    Vec3 m_place;
    double m_weight;
};

/// The corners of a box, in body axes.
inline std::vector<Vec3> cornersOfBox(const Vec3& halfSize) {
    std::vector<Vec3> corners;
    for (double x : {-1, 1})
        for (double y : {-1, 1})
            for (double z : {-1, 1})
                corners.push_back(halfSize.cwiseProduct(Vec3(x, y, z)));
    return corners;
}

}  // namespace bullet_buoyancy::test
