#pragma once

#include <cmath>

#include "bullet_buoyancy/hull/hull.h"
#include "fuzz/expect.h"

namespace bullet_buoyancy::fuzz {

/// What must hold of any hull that was made, and of the status of any that was not.
inline void checkHull(const HullResult& result) {
    const HullStatus& status = result.status;
    BUOYANCY_EXPECT(status.accepted() == bool(result.hull), "%s", status.describe().c_str());
    BUOYANCY_EXPECT(!status.describe().empty(), "no words");
    if (!result.hull) return;
    const Hull& hull = *result.hull;

    BUOYANCY_EXPECT(hull.moments.volume > 0, "volume %g m^3", hull.moments.volume);
    BUOYANCY_EXPECT(std::isfinite(hull.moments.volume), "volume %g m^3", hull.moments.volume);
    BUOYANCY_EXPECT(hull.moments.firstMoment.allFinite(), "%s", status.describe().c_str());
    BUOYANCY_EXPECT(hull.moments.secondMoment.allFinite(), "%s", status.describe().c_str());
    BUOYANCY_EXPECT(std::isfinite(hull.surfaceArea) && hull.surfaceArea > 0, "area %g m^2", hull.surfaceArea);
    BUOYANCY_EXPECT(std::isfinite(hull.surface.area) && hull.surface.position.allFinite() &&
                        hull.surface.orientation.allFinite() && hull.surface.shadows.allFinite(),
                    "surface of %g m^2", hull.surface.area);
    BUOYANCY_EXPECT(std::isfinite(hull.bounds.radius) && hull.bounds.centre.allFinite(), "radius %g m",
                    hull.bounds.radius);
    BUOYANCY_EXPECT(hull.halfExtents.allFinite(), "radius %g m", hull.bounds.radius);
    BUOYANCY_EXPECT(hull.meshIsClosed == (status.openEdges == 0), "%zu open edges", status.openEdges);
    BUOYANCY_EXPECT(std::isfinite(status.overlapVolume) && status.overlapVolume >= 0, "overlap of %g m^3",
                    status.overlapVolume);

    for (const Triangle& t : hull.mesh.triangles) {
        BUOYANCY_EXPECT(t[0] != t[1] && t[1] != t[2] && t[2] != t[0], "corners %u %u %u", t[0], t[1], t[2]);
        for (std::uint32_t corner : t)
            BUOYANCY_EXPECT(corner < hull.mesh.vertices.size(), "corner %u", corner);
    }
    const double reach = hull.bounds.radius * (1 + 1e-12);
    for (const Vec3& vertex : hull.mesh.vertices)
        BUOYANCY_EXPECT((vertex - hull.bounds.centre).norm() <= reach, "radius %g m", hull.bounds.radius);
    // A sphere of the bounds holds all, as often as it is wound round.
    if (hull.mesh.triangles.empty() && status.overlappingPairs == 0) {
        const double most = 4.1888 * std::pow(hull.bounds.radius, 3);
        BUOYANCY_EXPECT(hull.moments.volume <= most, "%g of %g m^3", hull.moments.volume, most);
    }
}

}  // namespace bullet_buoyancy::fuzz
