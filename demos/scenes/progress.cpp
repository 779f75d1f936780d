#include "scenes/progress.h"

#include <algorithm>
#include <cstdio>

#include "scenes/float_scene.h"

#ifdef _WIN32
#include <io.h>
#define isatty _isatty
#define fileno _fileno
#else
#include <unistd.h>
#endif

namespace bullet_buoyancy::scenes {

namespace {

constexpr std::chrono::milliseconds silence(1000), period(200);
constexpr std::size_t columns = 79;  // of the narrowest terminal; a longer line would not be written over

/// By three digits.
std::string textOf(double value, const char* unit) {
    char text[64];
    std::snprintf(text, sizeof text, value < 1000 ? "%.3g%s" : "%.0f%s", value, unit);
    return text;
}

}  // namespace

Progress::Progress(double total, std::string unit)
    : m_isSeen(isatty(fileno(stderr)) != 0),
      m_total(total),
      m_unit(std::move(unit)),
      m_due(m_start + silence) {}

void Progress::reach(double done, const std::string& what) {
    m_done = done;
    m_what = what;
    showIfDue();
}

void Progress::countStep(double seconds) {
    ++m_steps;
    m_simulated += seconds;
    showIfDue();
}

void Progress::look(const FloatScene& scene) {
    const double passed = scene.time() - m_sceneTime;
    m_sceneTime = scene.time();
    if (m_sceneTime == 0) return;
    if (passed > 0) m_sceneStep = passed;  // else it is another scene's
    countStep(m_sceneStep);
}

void Progress::clear() {
    if (m_width == 0) return;
    std::fprintf(stderr, "\r%*s\r", int(m_width), "");
    std::fflush(stderr);
    m_width = 0;
}

void Progress::showIfDue() {
    if (!m_isSeen || Clock::now() < m_due) return;
    m_due = Clock::now() + period;
    const std::string text = line(std::chrono::duration<double>(Clock::now() - m_start).count());
    std::fprintf(stderr, "\r%-*s", int(m_width), text.c_str());
    std::fflush(stderr);
    m_width = text.size();
}

std::string Progress::line(double seconds) const {
    const double share = std::clamp(m_done / m_total, 0.0, 1.0);
    std::string text = textOf(100 * share, " %, ") + textOf(m_done, " of ") + textOf(m_total, " ") + m_unit;
    if (m_steps > 0)
        text += ", " + std::to_string(m_steps) + " steps, " + textOf(m_simulated / seconds, " simulated s/s");
    if (share > 0) text += ", " + textOf(seconds * (1 - share) / share, " s left");
    if (!m_what.empty()) text += ": " + m_what;
    return text.substr(0, columns);
}

}  // namespace bullet_buoyancy::scenes
