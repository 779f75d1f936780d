#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "scenes/scene_watch.h"

namespace bullet_buoyancy::scenes {

/// Tells on a terminal, in a line of standard error that is written over and over, how far a long work is:
/// its share, steps of Bullet's worlds and how fast they are, and the time that is left. Silent where
/// standard error is no terminal, and during the first second. Not to be copied; for one thread.
class Progress {
public:
    /// So much is to be done, in a unit of work: "cases", "s".
    Progress(double total, std::string unit);
    ~Progress() { clear(); }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// So much of it is done, and this is worked on next.
    void reach(double done, const std::string& what = "");

    /// A step of a world that simulated so many seconds.
    void countStep(double seconds);

    /// A step of a scene, of those that are stepped in turn.
    void look(const FloatScene& scene);

    /// Wipes the line, so that others may print.
    void clear();

private:
    using Clock = std::chrono::steady_clock;

    void showIfDue();
    std::string line(double seconds) const;

    const bool m_isSeen;
    const double m_total;
    const std::string m_unit;
    const Clock::time_point m_start = Clock::now();
    Clock::time_point m_due;
    double m_done = 0, m_simulated = 0, m_sceneTime = 0, m_sceneStep = 0;
    long m_steps = 0;
    std::string m_what;
    std::size_t m_width = 0;  // of the line on the terminal
};

}  // namespace bullet_buoyancy::scenes
