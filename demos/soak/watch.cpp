#include "soak/watch.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "bullet_buoyancy/bullet/convert.h"
#include "scenes/fnv1a.h"

namespace bullet_buoyancy::demo {

using namespace scenes;

namespace {

/// Mean square of the water's velocity at the surface, m^2/s^2: in linear waves each component goes round in
/// circles with the frequency times its amplitude.
double orbitalVariance(const Sea& sea) {
    const double peak = 1 / sea.def().period, step = peak / 100;
    double variance = 0;
    for (double f = step; f < 5 * peak; f += step)
        variance += 2 * std::pow(2 * pi * f, 2) * sea.spectralDensity(f) * step;
    return variance;
}

bool isFinite(const btRigidBody& body, const BodyReport& report) {
    return toEigen(body.getWorldTransform().getOrigin()).allFinite() &&
           toEigen(body.getLinearVelocity()).allFinite() && toEigen(body.getAngularVelocity()).allFinite() &&
           std::isfinite(report.totalEnergy()) && std::isfinite(report.energy.expected()) &&
           toEigen(report.forceWorld).allFinite();
}

bool isInTheSea(const BodyReport& report) {
    return report.state == BodyState::floating || report.state == BodyState::submerged ||
           report.state == BodyState::dry;
}

/// What a body has beyond its ledger's account, over all that went through that: no more than rounding. It
/// may have less, lost to the steps.
double unaccounted(const BodyReport& report) {
    const EnergyLedger& ledger = report.energy;
    const double through = std::abs(ledger.start) + std::abs(ledger.byOthers) + std::abs(ledger.byWater) +
                           ledger.toDrag + ledger.toDamping;
    return through > 0 ? (report.totalEnergy() - ledger.expected()) / through : 0;
}

}  // namespace

WatchLimits limitsIn(const Sea& sea, const FlotsamScene& scene) {
    double largest = 0;
    for (const FlotsamPiece& piece : scene.pieces())
        largest = std::max(largest, piece.hull->bounds.radius);
    const double variance = orbitalVariance(sea);
    WatchLimits limits;
    // The highest of a day's waves are twice the significant height; who falls down one is as fast as that.
    limits.speed = std::sqrt(2 * standardGravity * (2 * sea.def().height + largest));
    limits.distance = sea.def().height + 2 * largest;
    limits.sunk = 10 * sea.def().period;
    limits.energy = 10 * (variance / 2 + 1e-3);
    limits.ledger = 1e-6;
    return limits;
}

Watch::Watch(const FlotsamScene& scene, const Sea& sea, const WatchLimits& limits)
    : m_scene(scene), m_sea(sea), m_limits(limits), m_lastAfloat(scene.pieces().size(), scene.time()) {}

void Watch::look() {
    for (std::size_t i = 0; i < m_scene.pieces().size(); ++i)
        look(i);
    ++m_window.looks;
}

void Watch::look(std::size_t i) {
    const FlotsamPiece& piece = m_scene.pieces()[i];
    const btRigidBody& body = *piece.body;
    const BodyReport report = m_scene.buoyancy().report(body);
    if (!isFinite(body, report)) return complain("not finite", i);
    if (!isInTheSea(report)) return complain("not in the sea", i);

    const Vec3 place = m_scene.water().frame().pointFromWorld(toEigen(body.getWorldTransform().getOrigin()));
    const double above = place.z() - m_sea.elevation(place.head<2>(), m_scene.time());
    if (report.state == BodyState::floating) m_lastAfloat[i] = m_scene.time();

    const double distance = std::abs(above) - piece.hull->bounds.radius;
    const double speed = toEigen(report.velocity).norm(), sunk = m_scene.time() - m_lastAfloat[i];
    const double ledger = unaccounted(report);
    m_window.distance = std::max(m_window.distance, distance);
    m_window.speed = std::max(m_window.speed, speed);
    m_window.sunk = std::max(m_window.sunk, sunk);
    m_window.ledger = std::max(m_window.ledger, ledger);
    m_window.energy += report.kineticEnergy * double(body.getInvMass()) / double(m_scene.pieces().size());
    hold(distance, m_limits.distance, above > 0 ? "m above the water" : "m under the surface", i);
    hold(speed, m_limits.speed, "m/s fast", i);
    hold(sunk, m_limits.sunk, above > 0 ? "s out of the water" : "s under water", i);
    hold(ledger, m_limits.ledger, "of its energy not accounted for", i);
}

WatchWindow Watch::next() {
    WatchWindow seen = m_window;
    seen.energy /= std::max(double(seen.looks), 1.0);
    if (!(seen.energy <= m_limits.energy) && m_complaint.empty()) {
        char words[100];
        std::snprintf(words, sizeof words, "%.3g J/kg of kinetic energy on average, and no more than %.3g",
                      seen.energy, m_limits.energy);
        m_complaint = words;
    }
    m_window = {};
    return seen;
}

void Watch::hold(double value, double limit, const char* what, std::size_t piece) {
    if (value <= limit) return;
    char words[100];
    std::snprintf(words, sizeof words, "%.3g %s, and no more than %.3g", value, what, limit);
    complain(words, piece);
}

void Watch::complain(const std::string& what, std::size_t piece) {
    if (!m_complaint.empty()) return;
    char who[60];
    std::snprintf(who, sizeof who, "%s %zu at %.2f s: ", nameOf(m_scene.pieces()[piece].kind), piece,
                  m_scene.time());
    m_complaint = who + what;
}

std::uint64_t hashOf(const FlotsamScene& scene) {
    Fnv1a hash;
    for (const FlotsamPiece& piece : scene.pieces()) {
        const btTransform& transform = piece.body->getWorldTransform();
        for (int row = 0; row < 3; ++row)
            hash.add(toEigen(transform.getBasis()[row]));
        hash.add(toEigen(transform.getOrigin()));
        hash.add(toEigen(piece.body->getLinearVelocity()));
        hash.add(toEigen(piece.body->getAngularVelocity()));
    }
    return hash.value();
}

}  // namespace bullet_buoyancy::demo
