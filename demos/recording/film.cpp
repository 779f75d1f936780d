#include "recording/film.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace bullet_buoyancy::recording {

namespace {

/// Film axes are the water frame's x, z and -y.
Mat3 filmFromFrame() {
    Mat3 turn;
    turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
    return turn;
}

Vec2 offset(int index, const Vec2& reach) {
    constexpr int last = Film::waterNodes - 1;
    const Vec2 share(2.0 * (index % Film::waterNodes) / last - 1,
                     2.0 * (index / Film::waterNodes) / last - 1);
    return share.cwiseProduct(reach);
}

}  // namespace

Film::Film(const FilmDef& def, const WaterFrame& frame, const Stage& stage)
    : m_def(def),
      m_originWorld(frame.originWorld()),
      m_filmFromWorld(filmFromFrame() * frame.worldFromFrame().transpose()),
      m_stage(stage) {}

std::size_t Film::addBody(std::string name, Look look, std::shared_ptr<const Hull> hull) {
    m_bodies.push_back({std::move(name), look, std::move(hull), 0, {}, {}});
    return m_bodies.size() - 1;
}

bool Film::isDue(double time) const {
    if (m_times.empty()) return true;
    const double rounding = 1e-3 / m_def.rate;
    const double next =
        m_times.front() +
        std::floor((m_times.back() - m_times.front() + rounding) * m_def.rate + 1) / m_def.rate;
    return time >= next - rounding && time <= m_times.front() + m_def.seconds + rounding;
}

void Film::beginFrame(double time, const WaterField& water, double waterTime, const Vec2& centre) {
    m_times.push_back(time);
    if (m_stage.reach.isZero()) return;
    constexpr int nodes = waterNodes * waterNodes;
    Eigen::ArrayX2d points(nodes, 2);
    for (int i = 0; i < nodes; ++i)
        points.row(i) = (centre + offset(i, m_stage.reach)).transpose().array();
    Eigen::ArrayX3d samples(nodes, 3);
    water.sampleSurface(points, waterTime, samples);
    m_surfaces.push_back(samples.cast<float>());
}

void Film::show(std::size_t body, const Pose& pose, const WaterForce& force) {
    assert(!m_times.empty());
    FilmedBody& filmed = m_bodies[body];
    if (filmed.poses.empty()) filmed.firstFrame = m_times.size() - 1;
    Pose seen{m_filmFromWorld * (pose.position - m_originWorld),
              Eigen::Quaterniond(m_filmFromWorld) * pose.orientation};
    seen.orientation.normalize();
    // q and -q are the same turn, but a player that glides from one to the other goes round.
    if (!filmed.poses.empty() && seen.orientation.dot(filmed.poses.back().orientation) < 0)
        seen.orientation.coeffs() *= -1;
    filmed.poses.push_back(seen);
    if (!m_def.forces) return;
    filmed.forces.push_back(
        {m_filmFromWorld * (force.centre - m_originWorld), m_filmFromWorld * force.force});
}

Vec3 Film::waterNode(int index) const {
    const Vec2 place = m_stage.centre + offset(index, m_stage.reach);
    return {place.x(), 0, -place.y()};
}

bool Film::isOnStage(const FilmedBody& body, const Pose& pose) const {
    const Vec2 off(pose.position.x() - m_stage.centre.x(), pose.position.z() + m_stage.centre.y());
    const Vec2 reach = m_stage.reach + Vec2::Constant(body.hull->bounds.radius);
    return m_stage.reach.isZero() || (off.cwiseAbs().array() < reach.array()).all();
}

std::size_t Film::frameAt(double time) const {
    const auto nearest = std::min_element(m_times.begin(), m_times.end(), [&](double a, double b) {
        return std::abs(a - time) < std::abs(b - time);
    });
    return std::size_t(nearest - m_times.begin());
}

}  // namespace bullet_buoyancy::recording
