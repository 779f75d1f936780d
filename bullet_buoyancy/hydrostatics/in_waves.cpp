#include "bullet_buoyancy/hydrostatics/in_waves.h"

#include <algorithm>
#include <cmath>

#include "bullet_buoyancy/hydrostatics/clusters_in_waves.h"
#include "bullet_buoyancy/hydrostatics/mesh_in_waves.h"
#include "bullet_buoyancy/hydrostatics/solid_in_waves.h"
#include "bullet_buoyancy/hydrostatics/tangent_water.h"
#include "bullet_buoyancy/hydrostatics/under_plane.h"

namespace bullet_buoyancy {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What expansions may be off by at their farthest, over their mean over a hull's surface that is half wet:
/// an estimate to begin with.
constexpr double meanErrorOverLargest = 0.2;

/// For solids where the mesh's tolerance is none.
constexpr double smallestTolerance = 1e-6;

/// Rough meshes that measure shadows lie inside curved parts, by less than this.
constexpr double insideMargin = 1.01;

/// What a bend adds to a linear function in a box about its centre.
struct Excess {
    double middle, halfRange;  ///< of all its values
    double slope;              ///< largest

    Excess(const Mat3& bend, const Vec3& halfExtents) {
        const Mat3 sizes = bend.cwiseProduct(halfExtents * halfExtents.transpose()).cwiseAbs();
        middle = bend.diagonal().dot(halfExtents.cwiseAbs2()) / 4;
        halfRange = sizes.trace() / 4 + (sizes.sum() - sizes.trace()) / 2;
        slope = (bend.cwiseAbs() * halfExtents).norm();
    }
};

class HullInWaves {
public:
    HullInWaves(const Hull& hull, const WaterView& water, const HydrostaticQuery& query, MeshSum sum)
        : m_hull(hull), m_water(water), m_query(query), m_sum(sum), m_up(water.upInBody()) {
        const double level = water.field.frame().pointFromWorld(water.pose.position).z();
        const double height = level + m_up.dot(hull.bounds.centre);  // of the hull's middle
        m_isDry = height - hull.bounds.radius >= water.bounds.elevation;
        m_isUnder = hull.meshIsClosed && height + hull.bounds.radius <= -water.bounds.elevation;
        m_tolerance = std::max(query.tolerance, smallestTolerance) * hull.moments.volume;
    }

    Vec3 add(WetIntegrals& integrals) {
        if (m_isDry) return m_up;
        if (m_isUnder && addUnder(integrals)) return m_pushes;
        if (m_query.tolerance > 0 || m_hull.mesh.triangles.empty())
            addWithin(integrals);
        else
            addByCorners(integrals);
        return m_pushes;
    }

private:
    BodyBox box() const { return {m_hull.bounds.centre, m_hull.halfExtents}; }
    double allowedHeadError() const { return m_tolerance / m_hull.surfaceArea; }

    /// By the divergence theorem, with the water to second order about the middle of the displacement. False
    /// if that is not enough.
    bool addUnder(WetIntegrals& integrals) {
        const VolumeMoments& all = m_hull.moments;
        const Vec3 centre = all.centroid(), offset = (centre - m_hull.bounds.centre).cwiseAbs();
        const WaterPatch patch(m_water, {centre, m_hull.halfExtents + offset}, infinity);
        note(patch, integrals);
        const WaterExpansion& water = patch.near(centre);
        const Mat3 spread = moved(all, -centre).secondMoment;
        const double error = gradientError(water, spread, patch.reach());
        if (error > m_tolerance) return false;
        const Vec3 force = all.volume * water.head.gradient;
        integrals.headNormal += force;
        integrals.headTorque += centre.cross(force) + crossOf(spread * water.head.bend);
        integrals.volume += all.volume;
        integrals.volumeMoment += all.firstMoment;
        integrals.headVolume += all.volume * water.head.value + (spread * water.head.bend).trace() / 2;
        integrals.wettedArea += m_query.wettedArea ? m_hull.surfaceArea : 0;
        integrals.error += Vec3::Constant(error / std::sqrt(3.0));
        return true;
    }

    /// Upper bound of the error of the gradient integrated over the whole volume, with the volume's second
    /// moment about the expansion's centre, and a farthest distance from there.
    double gradientError(const WaterExpansion& water, const Mat3& spread, double farthest) const {
        const bool inPlan = m_water.pressure == PressureModel::hydrostatic;
        const double distance2 = spread.trace() - (inPlan ? m_up.dot(spread * m_up) : 0);
        return 2 * water.error.second * std::sqrt(m_hull.moments.volume * distance2) +
               (3 * water.error.third + 4 * water.error.fourth * farthest) * distance2;
    }

    /// The integral of r x (bend r), from that of r r^T times the bend.
    static Vec3 crossOf(const Mat3& m) { return {m(1, 2) - m(2, 1), m(2, 0) - m(0, 2), m(0, 1) - m(1, 0)}; }

    /// With one cell if that may do, and else with cells that are made smaller until the bound is within the
    /// tolerance, or is one that lasts, or there are as many as there may be.
    void addWithin(WetIntegrals& integrals) {
        const WaterPatch one(m_water, box(), infinity);
        note(one, integrals);
        if (addUnderPlane(one, integrals)) return;
        constexpr double worthATry = 2;
        if (meanError(one) <= worthATry * allowedHeadError() && addWith(one, integrals) <= 1) return;
        double reach =
            std::min(0.8 * one.reach(),
                     one.near(m_hull.bounds.centre).error.reach(allowedHeadError() / meanErrorOverLargest));
        constexpr int mostAttempts = 6;
        for (int attempt = 1;; ++attempt) {
            const WaterPatch patch(m_water, box(), reach);
            note(patch, integrals);
            const bool isLast = attempt == mostAttempts || patch.cellCount() > WaterPatch::mostCells / 2;
            const double excess = addWith(patch, integrals, isLast);
            if (excess <= 1 || isLast) return;
            reach = std::min(reach, patch.reach()) / (1.2 * std::cbrt(excess));
        }
    }

    /// Under the plane that is nearest to the water about a closed hull, with what the water's bend adds to
    /// the gradient of hydrostatic pressure over the displacement. False if that is not enough.
    ///
    /// The force is the integral of the head's gradient over the displacement. The displacement is off by no
    /// more than the hull's shadow times the farthest that the water is from the plane; the gradient, where
    /// it is displaced, by that of the expansion's error.
    bool addUnderPlane(const WaterPatch& one, WetIntegrals& integrals) {
        if (m_water.pressure != PressureModel::hydrostatic || !m_hull.meshIsClosed) return false;
        const Vec3 centre = m_hull.bounds.centre;
        const WaterExpansion& water = one.near(centre);
        const Excess excess(water.head.bend, m_hull.halfExtents);
        const Vec3& gradient = water.head.gradient;
        const double strayed = excess.halfRange + one.errorWithin(water, one.reach());
        const double depth = water.head.value + excess.middle;
        const double reach = gradient.cwiseAbs().dot(m_hull.halfExtents) + strayed;
        if (depth <= -reach) return true;
        if (depth >= reach) return addUnder(integrals);
        const double misplaced = insideMargin * m_hull.surface.shadowAlong(m_up) * strayed;
        const double sideways = std::sqrt(std::max(0.0, gradient.squaredNorm() - 1)) + excess.slope;
        const double misturned =
            misplaced * sideways +
            gradientError(water, moved(m_hull.moments, -centre).secondMoment, one.reach());
        const double error = std::sqrt(misplaced * misplaced + misturned * misturned);
        if (error > m_tolerance) return false;

        const TangentWater plane(depth, gradient, m_up, centre);
        WetIntegrals underPlane;
        addHullUnderPlane(m_hull, plane.plane, m_sum, m_query, underPlane);
        const Vec3 moment = underPlane.volumeMoment - underPlane.volume * centre;
        const Vec3 byBend = water.head.bend * moment;
        plane.add(underPlane, integrals);
        integrals.headNormal += byBend;
        if (underPlane.volume > 0)
            integrals.headTorque += underPlane.volumeMoment.cross(byBend) / underPlane.volume;
        integrals.error += plane.steepness * underPlane.error + Vec3::Constant(error / std::sqrt(3.0));
        return true;
    }

    double meanError(const WaterPatch& one) const {
        return meanErrorOverLargest * one.errorWithin(one.near(m_hull.bounds.centre), one.reach());
    }

    /// Adds what the hull has in the patch, unless the bound of the error is too large and may yet be made
    /// smaller. Returns what it is too large by.
    double addWith(const WaterPatch& patch, WetIntegrals& integrals, bool whatever = false) const {
        constexpr double worthATry = 1.1;  // what is estimated may be too large by so much
        Attempt attempt = attemptWith(patch, m_sum, integrals);
        if (attempt.excess > 1 && attempt.excessOneByOne <= worthATry)
            attempt = attemptWith(patch, MeshSum::oneByOne, integrals);
        if (attempt.excess <= 1 || whatever) integrals = attempt.integrals;
        return attempt.excess <= 1 ? attempt.excess : attempt.excessOneByOne;
    }

    struct Attempt {
        WetIntegrals integrals;
        double excess;          // what the bound of the error is over that allowed
        double excessOneByOne;  // about what it would be, were triangles summed up one by one
    };

    Attempt attemptWith(const WaterPatch& patch, MeshSum sum, const WetIntegrals& soFar) const {
        WetIntegrals now = soFar;
        Vec3 extra = Vec3::Zero();
        if (sum == MeshSum::oneByOne || m_hull.packed.full.levels.empty())
            addMeshInWaves(m_hull.mesh, patch, allowedHeadError(), m_query, now);
        else
            extra = addClustersInWaves(m_hull, patch, allowedHeadError(), m_query, now);
        addSolids(patch, allowedHeadError(), now);
        const double lasting = now.lastingError.norm();
        const double allowed = std::max(m_tolerance - lasting, lasting / 4);
        return {now, now.error.norm() / allowed, (now.error - extra).norm() / allowed};
    }

    void addByCorners(WetIntegrals& integrals) {
        integrals.samples += addMeshByCorners(m_hull.mesh, m_water, m_query, integrals);
        if (m_hull.spheres.empty() && m_hull.solids.empty()) return;
        const WaterPatch one(m_water, box(), infinity);
        note(one, integrals);
        const WaterPatch patch(
            m_water, box(),
            one.near(m_hull.bounds.centre).error.reach(allowedHeadError() / meanErrorOverLargest));
        note(patch, integrals);
        addSolids(patch, allowedHeadError(), integrals);
    }

    void addSolids(const WaterPatch& patch, double headError, WetIntegrals& integrals) const {
        for (const Sphere& sphere : m_hull.spheres)
            addSphereInWaves(sphere, patch, headError, m_query, integrals);
        for (const SolidOfRevolution& solid : m_hull.solids)
            addSolidInWaves(solid, patch, headError, m_query, integrals);
    }

    void note(const WaterPatch& patch, WetIntegrals& integrals) {
        integrals.samples += patch.cellCount();
        m_pushes = -patch.near(m_hull.bounds.centre).head.gradient;
    }

    const Hull& m_hull;
    const WaterView& m_water;
    const HydrostaticQuery& m_query;
    MeshSum m_sum;
    Vec3 m_up;
    bool m_isDry, m_isUnder;
    double m_tolerance;  // of the force over density and gravity, m^3
    Vec3 m_pushes = m_up;
};

}  // namespace

Vec3 addHullInWaves(const Hull& hull, const Pose& pose, const WaterField& water,
                    const HydrostaticQuery& query, MeshSum sum, WetIntegrals& integrals) {
    const WaterView view{water, water.bounds(), pose, query.time, query.pressure};
    return HullInWaves(hull, view, query, sum).add(integrals);
}

}  // namespace bullet_buoyancy
