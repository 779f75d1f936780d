#include "bullet_buoyancy/motion/implicit_flight.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace bullet_buoyancy {

namespace {

constexpr int mostIterations = 8, mostTrials = 12;
constexpr double sufficientDecrease = 1e-4, sufficientFlattening = 0.5;  // Wolfe's conditions, see searchLine
constexpr double residualTolerance = 1e-3;  // of the velocities: an error that the energy guard takes up
constexpr double energyTolerance = 1e-10;   // of the potential: what is left of a body at rest

Vec6 stacked(const Vec3& linear, const Vec3& angular) {
    return (Vec6() << linear, angular).finished();
}

Vec6 loadOf(const Load& load) {
    return stacked(load.force, load.torque);
}

/// A trial velocity and spin, and where they lead.
struct Trial {
    Vec6 u;
    Flight flight;
    Mat6 stiffness;
    double potential;  // incremental, J
};

class Minimiser {
public:
    Minimiser(const FlightStart& start, const Inertia& inertia, double implicitness, double dt,
              const LoadField& ahead)
        : m_start(start),
          m_inertia(inertia),
          m_weights(implicitness),
          m_kick(start.load, dt),
          m_dt(dt),
          m_field(ahead) {
        Motion explicitPart = start.motion;
        m_kick.apply(explicitPart, inertia, m_weights.firstOfStart * start.load.force,
                     m_weights.firstOfStart * start.load.torque);
        m_explicit = stacked(explicitPart.velocity, explicitPart.spin);
        const double leastGain = 1e-9 * dt;  // where drag stops all motion at once
        m_gain << Vec3::Constant(std::max(leastGain, m_weights.firstOfEnd * m_kick.linear.gain)),
            Vec3::Constant(std::max(leastGain, m_weights.firstOfEnd * m_kick.angular.gain));
        m_mobility.setZero();
        for (int i = 0; i < 3; ++i) {
            m_mobility(i, i) = inertia.linearFactor[i] / inertia.mass;
            m_mobility.block<3, 1>(3, 3 + i) =
                inertia.spinChange(start.motion.pose.orientation, Vec3::Unit(i));
        }
    }

    Flight minimise() {
        Trial best = fromRest();
        for (int iteration = 0; iteration < mostIterations; ++iteration) {
            const Vec6 left = residual(best);
            if (iteration > 0 && isSmall(left, best)) break;
            if (!improve(best, left)) break;
        }
        if (!m_left) best = evaluated(best.u);
        best.flight.evaluations = m_evaluations;
        best.flight.dissipated = dissipatedBy(best.flight.load);
        return best.flight;
    }

private:
    /// At rest, and in a calm field at rest along `up`, the load of the end is that at the start's pose.
    Trial fromRest() const {
        const Vec3 up = m_field.up(), velocity = m_explicit.head<3>(), spin = m_explicit.tail<3>();
        Trial rest;
        if (m_start.loadAhead)
            rest.u.setZero();
        else
            rest.u = stacked(velocity - up.dot(velocity) * up, up.dot(spin) * up);
        rest.flight.load = m_start.loadAhead ? *m_start.loadAhead : m_start.load;
        rest.stiffness = m_start.stiffness;
        rest.potential = kineticPart(rest.u) + rest.flight.load.potential;
        return rest;
    }

    Trial evaluated(const Vec6& u) {
        Trial trial;
        trial.u = u;
        Flight& flight = trial.flight;
        flight.departure = m_start.motion;
        flight.departure.velocity = u.head<3>();
        flight.departure.setSpin(m_inertia, u.tail<3>());
        flight.arrival =
            fly(flight.departure, m_inertia, m_dt,
                m_inertia.turnsFreely ? Turning::byMomentum : Turning::atSpin, m_start.turnLimit);
        flight.load = m_field.at(flight.arrival.pose, &trial.stiffness);
        trial.potential = kineticPart(u) + flight.load.potential;
        ++m_evaluations;
        return trial;
    }

    Dissipation dissipatedBy(const Load& end) const {
        Motion motion = m_start.motion;
        const double ofStart = m_weights.firstOfStart, ofEnd = m_weights.firstOfEnd;
        return m_kick.apply(motion, m_inertia, ofStart * m_start.load.force + ofEnd * end.force,
                            ofStart * m_start.load.torque + ofEnd * end.torque);
    }

    /// dt / gain M times a difference of velocities.
    Vec6 weighed(const Vec6& difference) const {
        const Eigen::Quaterniond& orientation = m_start.motion.pose.orientation;
        const Vec6 momentum = stacked(m_inertia.mass * difference.head<3>(),
                                      m_inertia.momentum(orientation, difference.tail<3>()));
        return m_dt * momentum.cwiseQuotient(m_gain);
    }

    double kineticPart(const Vec6& u) const {
        const Vec6 difference = u - m_explicit;
        return weighed(difference).dot(difference) / 2;
    }

    /// Of the condition for a minimum, as a velocity.
    Vec6 residual(const Trial& trial) const {
        return trial.u - m_explicit - m_gain.cwiseProduct(m_mobility * loadOf(trial.flight.load));
    }

    bool isSmall(const Vec6& residual, const Trial& trial) const {
        const auto square = [&](const Vec6& v) { return weighed(v).dot(v); };
        const double scale = std::max(square(trial.u), square(m_explicit));
        return square(residual) <= residualTolerance * residualTolerance * scale +
                                       energyTolerance * std::abs(trial.flight.load.potential);
    }

    /// One Newton step, shortened until the potential falls. Where the load pushes a body over, only with
    /// what of the stiffness holds it. False if the potential does not fall.
    bool improve(Trial& best, const Vec6& left) {
        Vec6 direction = newtonStep(best.stiffness, left);
        if (!(weighed(left).dot(direction) < 0)) direction = newtonStep(holdingPart(best.stiffness), left);
        const double slope = weighed(left).dot(direction);
        return slope < 0 && searchLine(best, direction, slope);
    }

    Vec6 newtonStep(const Mat6& stiffness, const Vec6& left) const {
        const Mat6 jacobian = Mat6::Identity() + m_dt * m_gain.asDiagonal() * m_mobility * stiffness;
        return -jacobian.partialPivLu().solve(left);
    }

    /// The nearest matrix without negative eigenvalues, with turns measured by the radius of gyration.
    Mat6 holdingPart(const Mat6& stiffness) const {
        const double gyration = std::sqrt(m_inertia.principal.sum() / (2 * m_inertia.mass));
        Vec6 unit = Vec6::Ones();
        if (gyration > 0) unit.tail<3>().setConstant(1 / gyration);
        const Mat6 symmetric =
            unit.asDiagonal() * (stiffness + stiffness.transpose()) * unit.asDiagonal() / 2;
        const Eigen::SelfAdjointEigenSolver<Mat6> solver(symmetric);
        const Mat6 back = unit.cwiseInverse().asDiagonal() * solver.eigenvectors();
        return back * solver.eigenvalues().cwiseMax(0).asDiagonal() * back.transpose();
    }

    /// Along `direction`, on which the potential falls at first by `slope`, but no farther than it reaches:
    /// by the secant of the slopes within a bracket, since where a body comes out of the water they break
    /// (Nocedal and Wright, Numerical Optimization, 3.1 and 3.5).
    bool searchLine(Trial& best, const Vec6& direction, double slope) {
        const Trial start = best;
        const double negligible = energyTolerance * std::abs(start.flight.load.potential);
        double low = 0, lowSlope = slope, high = 1, share = firstShare(start, direction);
        bool found = false, bracketed = false;
        for (int i = 0; i < mostTrials; ++i) {
            const Trial trial = evaluated(start.u + share * direction);
            const double trialSlope = weighed(residual(trial)).dot(direction);
            const bool falls =
                trial.potential - start.potential <= sufficientDecrease * share * slope + negligible;
            if (falls && (!found || trial.potential < best.potential)) {
                best = trial;
                found = m_left = true;
            }
            const bool isPast = trialSlope > 0 || !falls;
            const bool isFlat = std::abs(trialSlope) <= negligible - sufficientFlattening * slope;
            if (falls && (isFlat || (!isPast && share == 1))) break;
            if (isPast) {
                high = share;
                const double quarter = low + (share - low) / 4;
                share = bracketed ? quarter : low - lowSlope * (share - low) / (trialSlope - lowSlope);
                bracketed = true;
            } else {
                low = share;
                lowSlope = trialSlope;
                share = bracketed ? (low + high) / 2 : std::min(1.0, 4 * share);
                if (!bracketed) continue;
            }
            share = std::clamp(share, low + 0.1 * (high - low), high - 0.1 * (high - low));
        }
        return found;
    }

    /// No load does more work than its potential holds: a light body under water, where nothing yet tells
    /// that its load will end, is carried to the surface and not as far as it would go if that went on.
    double firstShare(const Trial& start, const Vec6& direction) const {
        constexpr double margin = 1.1;
        const double work = m_dt * loadOf(start.flight.load).dot(direction) -
                            m_dt * m_dt / 2 * direction.dot(start.stiffness * direction);
        const double held = margin * start.flight.load.potential;
        return held > 0 && work > held ? held / work : 1;
    }

    const FlightStart& m_start;
    const Inertia& m_inertia;
    KickWeights m_weights;
    Kick m_kick;
    double m_dt;
    const LoadField& m_field;
    Vec6 m_explicit, m_gain;
    Mat6 m_mobility;
    int m_evaluations = 0;
    bool m_left = false;  // the start: what is best has been evaluated
};

}  // namespace

Flight flyImplicitly(const FlightStart& start, const Inertia& inertia, double implicitness, double dt,
                     const LoadField& ahead) {
    return Minimiser(start, inertia, implicitness, dt, ahead).minimise();
}

}  // namespace bullet_buoyancy
