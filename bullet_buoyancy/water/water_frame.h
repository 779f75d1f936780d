#pragma once

#include "bullet_buoyancy/core/math_types.h"

namespace bullet_buoyancy {

/// The frame in which water is described: x and y horizontal, z up, z = 0 the still water level;
/// right-handed, metres.
class WaterFrame {
public:
    /// World y is up; the frame's axes x, y, z are the world's x, -z, y.
    static WaterFrame yUp(const Vec3& originWorld = Vec3::Zero());

    /// World z is up; the frame's axes are the world's.
    static WaterFrame zUp(const Vec3& originWorld = Vec3::Zero());

    /// Any up direction (need not be of unit length; must be finite and not zero: asserted).
    /// The frame's x axis is the world axis that is most nearly horizontal, made horizontal.
    static WaterFrame fromUp(const Vec3& originWorld, const Vec3& upWorld);

    /// The point of the world that has the frame's coordinates 0, m.
    const Vec3& originWorld() const { return m_originWorld; }
    /// Turns directions: its columns are the frame's axes in the world.
    const Mat3& worldFromFrame() const { return m_worldFromFrame; }
    /// The frame's z, against gravity, unit length.
    Vec3 upWorld() const { return m_worldFromFrame.col(2); }

    /// A point of the world in the frame's coordinates.
    Vec3 pointFromWorld(const Vec3& pointWorld) const {
        return m_worldFromFrame.transpose() * (pointWorld - m_originWorld);
    }

    /// A direction or velocity of the world in the frame's coordinates.
    Vec3 vectorFromWorld(const Vec3& vectorWorld) const { return m_worldFromFrame.transpose() * vectorWorld; }

private:
    WaterFrame(const Vec3& originWorld, const Mat3& worldFromFrame)
        : m_originWorld(originWorld), m_worldFromFrame(worldFromFrame) {}

    Vec3 m_originWorld;
    Mat3 m_worldFromFrame;
};

}  // namespace bullet_buoyancy
