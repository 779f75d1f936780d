#include "scenes/boat.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/water/flat_water.h"

namespace bullet_buoyancy::scenes {

namespace {

HydrostaticResult evaluateAt(const Hull& hull, double height) {
    const FlatWater water(WaterFrame::zUp());
    Pose pose;
    pose.position.z() = height;
    HydrostaticQuery query;
    query.waterplane = true;
    return evaluateExact(hull, pose, water, query);
}

/// Height of the hull's origin above the water at which it displaces so much, by bisection.
double floatingHeight(const Hull& hull, double displacement) {
    const double centre = hull.bounds.centre.z(), radius = hull.bounds.radius;
    double low = -centre - radius, high = -centre + radius;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (evaluateAt(hull, middle).submergedVolume > displacement ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// Of the waterplane about the axis through its centroid across `axis`, m^4.
double secondMoment(const Waterplane& plane, int axis) {
    return plane.secondMoment(axis, axis) - plane.firstMoment[axis] * plane.firstMoment[axis] / plane.area;
}

TriangleMesh moved(TriangleMesh mesh, const Vec3& by) {
    for (Vec3& vertex : mesh.vertices)
        vertex += by;
    return mesh;
}

double period(double gravity, double arm, double gyration) {
    return 2 * pi * gyration / std::sqrt(gravity * arm);
}

}  // namespace

double Boat::heavePeriod(double gravity) const {
    return 2 * pi * std::sqrt(displacement / (gravity * waterplaneArea));
}

double Boat::pitchPeriod(double gravity) const {
    return period(gravity, longitudinalMetacentric, std::sqrt(inertia.y() / mass));
}

double Boat::rollPeriod(double gravity) const {
    return period(gravity, metacentricHeight, std::sqrt(inertia.x() / mass));
}

Boat makeBoat(const TriangleMesh& mesh, const LadingDef& lading) {
    Boat boat;
    const HullResult asGiven = makeHull(mesh);
    boat.status = asGiven.status;
    if (!asGiven.hull || !(lading.displacement > 0 && lading.displacement < asGiven.hull->moments.volume))
        return boat;

    const Hull& hull = *asGiven.hull;
    const double height = floatingHeight(hull, lading.displacement);
    const HydrostaticResult rest = evaluateAt(hull, height);
    boat.size = 2 * hull.halfExtents;
    const double keel = hull.bounds.centre.z() - hull.halfExtents.z();
    boat.displacement = rest.submergedVolume;
    boat.draft = -height - keel;
    boat.waterplaneArea = rest.waterplane.area;
    boat.centreOfBuoyancyAtRest = rest.centreOfBuoyancyFromCom.z() + height;

    const double metacentre =
        boat.centreOfBuoyancyAtRest + secondMoment(rest.waterplane, 1) / boat.displacement;
    boat.heightAtRest = std::min(metacentre - lading.metacentricHeight * boat.size.y(),
                                 lading.highestCentre * boat.size.z() - boat.draft);
    boat.metacentricHeight = metacentre - boat.heightAtRest;
    boat.longitudinalMetacentric = boat.centreOfBuoyancyAtRest +
                                   secondMoment(rest.waterplane, 0) / boat.displacement - boat.heightAtRest;

    Vec3 centreOfMass = rest.centreOfBuoyancyFromCom;
    centreOfMass.z() = boat.heightAtRest - height;
    boat.hull = makeHull(moved(mesh, -centreOfMass)).hull;
    boat.mass = lading.waterDensity * boat.displacement;
    const Vec3 gyration(lading.rollGyration * boat.size.y(), lading.pitchGyration * boat.size.x(),
                        lading.pitchGyration * boat.size.x());
    boat.inertia = boat.mass * gyration.cwiseAbs2();
    return boat;
}

double displacementBelowOrigin(const TriangleMesh& mesh) {
    const HullResult result = makeHull(mesh);
    return result.hull ? evaluateAt(*result.hull, 0).submergedVolume : 0;
}

}  // namespace bullet_buoyancy::scenes
