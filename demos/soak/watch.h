#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scenes/flotsam.h"
#include "scenes/sea.h"

namespace bullet_buoyancy::demo {

/// What a sea leaves possible, for each piece. Contacts in a crowd throw and bury pieces now and then.
struct WatchLimits {
    double speed;     ///< of a piece's centre, m/s
    double distance;  ///< of a piece's centre from the surface beyond its own size, m
    double sunk;      ///< the longest that a piece may be under water, or out of it, at a time, s
    double energy;    ///< kinetic energy over mass, mean of all pieces over a window, J/kg
    double ledger;    ///< energy beyond the ledger's account, over all that went through it
};

/// For a sea and the pieces in it.
WatchLimits limitsIn(const scenes::Sea& sea, const scenes::FlotsamScene& scene);

/// Extremes since the last call of `next`.
struct WatchWindow {
    double speed = 0;     ///< m/s
    double distance = 0;  ///< m
    double sunk = 0;      ///< s
    double energy = 0;    ///< J/kg, a mean
    double ledger = 0;
    long looks = 0;
};

/// Looks whether everything still is as a sea would leave it.
class Watch {
public:
    Watch(const scenes::FlotsamScene& scene, const scenes::Sea& sea, const WatchLimits& limits);

    /// After each step.
    void look();

    /// What was seen in the window that ends now; holds its mean against the limit.
    WatchWindow next();

    /// What was wrong first, empty if nothing.
    const std::string& complaint() const { return m_complaint; }

private:
    void look(std::size_t piece);
    void hold(double value, double limit, const char* what, std::size_t piece);
    void complain(const std::string& what, std::size_t piece);

    const scenes::FlotsamScene& m_scene;
    const scenes::Sea& m_sea;
    WatchLimits m_limits;
    WatchWindow m_window;
    std::vector<double> m_lastAfloat;  // when each was last partly under water, s
    std::string m_complaint;
};

/// Of all poses and velocities, by their bits.
std::uint64_t hashOf(const scenes::FlotsamScene& scene);

}  // namespace bullet_buoyancy::demo
