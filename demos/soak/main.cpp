#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>

#include "recording/film_options.h"
#include "recording/flotsam_cast.h"
#include "scenes/command_line.h"
#include "scenes/flotsam.h"
#include "scenes/flotsam_options.h"
#include "scenes/interruption.h"
#include "scenes/progress.h"
#include "scenes/sea.h"
#include "scenes/stopwatch.h"
#include "soak/boom.h"
#include "soak/resident_memory.h"
#include "soak/watch.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

struct Options : FlotsamOptions {
    double hours = 24;
    bool quick = false;
    recording::FilmOptions film;
};

/// From here on, everything is afloat that was dropped, s.
constexpr double settled = 30;

/// Contacts and their caches are as many in the end as the most that were there at a time, and that is not
/// reached within minutes.
constexpr double memoryAllowance = 4 << 20;  // bytes

/// What is held against the end of the run: the most of the first part.
class MemoryWatch {
public:
    explicit MemoryWatch(double until) : m_until(until) {}

    void look(double time) {
        m_last = residentMemory();
        if (time <= m_until) m_first = std::max(m_first, m_last);
    }

    bool isKnown() const { return m_last > 0; }
    double growth() const { return m_last - m_first; }  ///< bytes
    double last() const { return m_last; }

private:
    double m_until, m_first = 0, m_last = 0;
};

void printHead(const Options& options) {
    std::printf("%d bodies in a JONSWAP sea of %g m and %g s, for %g h in steps of %.4g s\n",
                options.scene.bodies, options.sea.height, options.sea.period, options.hours, options.dt);
    std::printf("%10s %9s %9s %9s %9s %9s %9s %9s\n", "", "s a s", "J/kg", "fastest", "farthest", "longest",
                "ledger", "memory");
    std::printf("%10s %9s %9s %9s %9s %9s %9s %9s\n", "h", "", "mean", "m/s", "m", "s", "", "MiB");
}

void printWindow(double time, double rate, const WatchWindow& seen, double memory) {
    std::printf("%10.3f %9.1f %9.4f %9.2f %9.2f %9.1f %9.1e %9.2f\n", time / 3600, rate, seen.energy,
                seen.speed, seen.distance, seen.sunk, seen.ledger, memory / (1 << 20));
    std::fflush(stdout);
}

/// Whether all is well.
bool finish(const FlotsamScene& scene, const Watch& watch, const MemoryWatch& memory) {
    std::printf("hash of the final state %016" PRIx64 "\n", hashOf(scene));
    bool isWell = true;
    if (!memory.isKnown())
        std::printf("memory: not told by this system\n");
    else if (memory.growth() > memoryAllowance) {
        std::printf("memory: grew by %.2f MiB\n", memory.growth() / (1 << 20));
        isWell = false;
    }
    if (!watch.complaint().empty()) {
        std::printf("%s\n", watch.complaint().c_str());
        isWell = false;
    }
    std::printf(isWell ? "all is well\n" : "all is not well\n");
    return isWell;
}

/// Stops at the first that is not as a sea would leave it.
int run(const Options& options) {
    Sea sea(options.sea);
    if (!sea.status()) {
        std::fprintf(stderr, "soak: sea: %s\n", sea.status().describe().c_str());
        return 1;
    }
    FlotsamScene scene(options.scene, sea.water());
    const Boom boom(std::sqrt(options.scene.bodies * options.scene.area / pi), 10);
    recording::WorldFilm film(options.film.film,
                              [&](const btRigidBody& body) { return recording::castOf(scene, body); });
    const auto step = [&] {
        boom.pull(scene);
        scene.step(options.dt);
    };
    while (scene.time() < settled && !isInterrupted())
        step();

    printHead(options);
    const double end = settled + 3600 * options.hours;
    const double window = std::clamp(3600 * options.hours / 24, 10.0, 600.0);  // s
    Watch watch(scene, sea, limitsIn(sea, scene));
    MemoryWatch memory(settled + std::max((end - settled) / 20, 2 * window));
    Progress progress(end - settled, "s");
    const auto goesOn = [&] { return watch.complaint().empty() && !isInterrupted(); };
    while (scene.time() < end && goesOn()) {
        const double start = scene.time(), clock = wallTime();
        while (scene.time() < start + window && goesOn()) {
            step();
            watch.look();
            if (options.film.isWanted()) film.look(recording::viewOf(scene));
            progress.reach(scene.time() - settled);
            progress.countStep(options.dt);
        }
        memory.look(scene.time());
        progress.clear();
        printWindow(scene.time() - settled, (scene.time() - start) / (wallTime() - clock), watch.next(),
                    memory.last());
    }
    const bool isWell = finish(scene, watch, memory);
    if (options.film.isWanted() && !writeFilm(film.film(), options.film, "soak")) return 1;
    return isWell ? 0 : 1;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    bullet_buoyancy::demo::Options options;
    options.scene.bodies = 20;
    CLI::App app{
        "Leaves crates, barrels, buoys, fenders, spars, planks, lumps, rafts and a boat in an irregular sea "
        "for a day,\nwithin a boom. Exit status 1 if any flies, sinks, runs wild or is lost, or if memory "
        "grows.",
        "soak"};
    app.option_defaults()->always_capture_default();
    bullet_buoyancy::scenes::addFlotsamOptions(app, options);
    app.add_option("--hours", options.hours, "simulated")->check(CLI::Range(1e-3, 1e5));
    app.add_option("--area", options.scene.area, "of the sea within the boom, m^2 a body; below 1: heaps")
        ->check(CLI::Range(0.01, 1e4));
    app.add_flag("--quick", options.quick, "only a minute");
    bullet_buoyancy::recording::addFilmOptions(app, options.film);
    int exitStatus = 0;
    if (!bullet_buoyancy::scenes::parse(app, argc, argv, exitStatus)) return exitStatus;
    if (options.quick) options.hours = 1.0 / 60;
    return bullet_buoyancy::scenes::runInterruptibly("soak",
                                                     [&] { return bullet_buoyancy::demo::run(options); });
}
