#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>

#include "bullet_buoyancy/core/constants.h"
#include "floating_cube/comparison.h"
#include "floating_cube/options.h"
#include "plots/draw_plot.h"
#include "recording/world_film.h"
#include "scenes/floating_cube.h"
#include "scenes/floating_log.h"
#include "scenes/free_spin.h"
#include "scenes/interruption.h"
#include "scenes/progress.h"
#include "scenes/scene_watch.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

constexpr double degrees = 180 / pi;

/// A body at rest under drag keeps no error but that of Bullet's pose, 6e-8 of a metre or radian in single
/// precision; the log is taken for settled a little before.
constexpr double tiltTolerance = 0.05;        // degrees
constexpr double draftTolerance = 1e-3;       // of the side
constexpr double thresholdTolerance = 0.005;  // density ratio, as the sweep is to find them
constexpr double nearThreshold =
    0.01;  // where the restoring moment vanishes, and a log takes for ever to settle

/// Symplectic Euler shortens the period 2 pi / w of an oscillation by (w dt)^2 / 24 of itself; the passages
/// of the draft are seen to a few 1e-6.
double periodTolerance(double period, const Stepping& stepping) {
    const double phase = 2 * pi / period * stepping.dt / stepping.substeps;
    return period * (1.05 * phase * phase / 24 + 1e-5);
}

Table cubeTable(const CubeResult& result, const CubeDef& def) {
    const std::string outcome =
        result.atRest ? "floats " + result.reached.name : "is not at rest yet: give it more --seconds";
    Table table{"A cube of density ratio " + std::to_string(def.ratio) + " dropped from above " + outcome,
                {}};
    table.rows.push_back({"submerged fraction", "", result.submergedFraction, def.ratio, draftTolerance});
    if (result.reached.tilt >= 0) {
        const double tilt = result.reached.tilt * degrees;
        table.rows.push_back(
            {"tilt from face up", "deg", result.samples.back().tilt * degrees, tilt, tiltTolerance});
    }
    return table;
}

Table heaveTable(const Stepping& stepping) {
    Table table{"Flat slabs (2 x 2 x 1 m) heaving without drag", {}};
    for (double ratio : {0.2, 0.35, 0.5, 0.65, 0.8}) {
        const HeaveResult heave = heaveSlab(ratio, 0.1, stepping);
        const double period = heavePeriod(ratio, standardGravity);
        const std::string name = "ratio " + std::to_string(ratio).substr(0, 4);
        table.rows.push_back({name + ": draft", "m", heave.draft, ratio, draftTolerance});
        table.rows.push_back(
            {name + ": heave period", "s", heave.period, period, periodTolerance(period, stepping)});
    }
    return table;
}

long logsOf(const Options& options) {
    return std::lround(0.9 / options.ratioStep) + 1;
}

void sweepLogs(const Options& options, std::vector<LogResult>& logs) {
    const long count = logsOf(options);
    for (long i = 0; i < count; ++i)
        logs.push_back(floatLog(0.05 + 0.9 * double(i) / double(count - 1), options.stepping));
}

Table logTable(const std::vector<LogResult>& logs) {
    Table table{"A square log: tilt of a face, and height of its centre above the water", {}};
    for (const LogResult& log : logs) {
        if (distanceFromLogThreshold(log.ratio) < nearThreshold) continue;
        const std::string name = "ratio " + std::to_string(log.ratio).substr(0, 5);
        table.rows.push_back(
            {name + ": tilt", "deg", log.tilt * degrees, squareLogTilt(log.ratio) * degrees, tiltTolerance});
        table.rows.push_back(
            {name + ": centre", "side", log.centreHeight, squareLogCentreHeight(log.ratio), draftTolerance});
    }
    return table;
}

Table thresholdTable(const Stepping& stepping) {
    const double flat = 1 / degrees, onEdge = 44 / degrees;
    Table table{"Density ratios at which the log begins to tilt, and stands on its edge", {}};
    table.rows.push_back({"begins to tilt", "", findLogThreshold(0.15, 0.25, flat, stepping), logTiltsFrom,
                          thresholdTolerance});
    table.rows.push_back({"stands on its edge", "", findLogThreshold(0.25, 0.32, onEdge, stepping),
                          logStandsOnEdgeFrom, thresholdTolerance});
    return table;
}

/// The library is held to this; what Bullet does alone is printed beside it.
Table spinTable(const Stepping& stepping) {
    const SpinDef def;
    const SpinError ours = spinError(spinFreely(def, SpinOwner::library, stepping), def.dampingRate);
    const SpinError theirs = spinError(spinFreely(def, SpinOwner::bullet, stepping), def.dampingRate);
    // The momentum is read from Bullet's velocity and rotation matrix, good to some 1e-7 each in single
    // precision.
    constexpr double rounding = 5e-6;
    constexpr double printed = std::numeric_limits<double>::infinity();
    return {"A box with three different moments of inertia, spinning damped under water for 20 s",
            {{"damped L: error of |L|", "", ours.length, 0, rounding},
             {"damped L: its axis strays by", "deg", ours.angle * degrees, 0, rounding * degrees},
             {"Bullet's damped omega: error of |L|", "", theirs.length, 0, printed},
             {"Bullet's: the axis of L strays by", "deg", theirs.angle * degrees, 0, printed}}};
}

CubeResult filmCube(const Options& options, recording::WorldFilm& film) {
    if (!options.film.isWanted()) return dropCube(options.cube, options.stepping);
    const SceneWatch watch([&](const FloatScene& scene) { film.look(scene); });
    return dropCube(options.cube, options.stepping);
}

/// What a run has found, until it was interrupted.
struct Findings {
    CubeResult cube;
    std::vector<LogResult> logs;
    std::vector<Table> tables;
};

void findAll(const Options& options, recording::WorldFilm& film, Findings& found) {
    found.cube = filmCube(options, film);
    found.tables.push_back(cubeTable(found.cube, options.cube));
    found.tables.push_back(heaveTable(options.stepping));
    const bool isWhole = untilInterrupted([&] { sweepLogs(options, found.logs); });
    found.tables.push_back(logTable(found.logs));
    if (!isWhole) return;
    found.tables.push_back(thresholdTable(options.stepping));
    found.tables.push_back(spinTable(options.stepping));
}

Findings findWithProgress(const Options& options, recording::WorldFilm& film) {
    constexpr int besideLogs = 1 + 5 + 2 * 7 + 2;  // the cube, slabs, bisections of the thresholds, spins
    Progress progress(double(logsOf(options) + besideLogs), "scenes");
    int begun = 0;
    const SceneWatch watch([&](const FloatScene& scene) {
        if (scene.time() == 0) progress.reach(begun++);
        progress.look(scene);
    });
    Findings found;
    untilInterrupted([&] { findAll(options, film, found); });
    return found;
}

void writeLogs(std::ostream& csv, const std::vector<LogResult>& logs) {
    csv << "density_ratio,tilt_deg,centre_height_sides,settled_after_s\n";
    for (const LogResult& log : logs)
        csv << log.ratio << ',' << log.tilt * degrees << ',' << log.centreHeight << ',' << log.settledAfter
            << '\n';
}

void writeFall(std::ostream& csv, const CubeResult& cube) {
    csv << "time_s,centre_height_edges,tilt_deg,energy_j\n";
    for (const CubeSample& sample : cube.samples)
        csv << sample.time << ',' << sample.height << ',' << sample.tilt * degrees << ',' << sample.energy
            << '\n';
}

bool write(const Options& options, const Findings& found) {
    const plots::Table tables{"tables", [&](std::ostream& csv) { writeCsv(csv, found.tables); }};
    const plots::Table logs{"logs", [&](std::ostream& csv) { writeLogs(csv, found.logs); }};
    const plots::Table fall{"fall", [&](std::ostream& csv) { writeFall(csv, found.cube); }};
    const auto wrote = [](const plots::Table& table, const std::string& file) {
        return file.empty() || writeTable(table, "floating_cube", file);
    };
    return wrote(tables, options.csv) && wrote(logs, options.logs) && wrote(fall, options.fall) &&
           (options.plot.empty() || found.logs.empty() ||
            plots::drawPlot("floating_cube", {logs, fall}, options.plot));
}

int run(const Options& options) {
    recording::WorldFilm film(options.film.film);
    const Findings found = findWithProgress(options, film);
    for (const Table& table : found.tables)
        print(table);
    if (!isInterrupted()) printWorst(found.tables);
    if (!write(options, found)) return 1;
    if (options.film.isWanted() && !writeFilm(film.film(), options.film, "floating_cube")) return 1;
    return allPass(found.tables) ? 0 : 1;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    int exitStatus = 0;
    const auto options = bullet_buoyancy::demo::parseOptions(argc, argv, exitStatus);
    if (!options) return exitStatus;
    return bullet_buoyancy::scenes::runInterruptibly("floating_cube",
                                                     [&] { return bullet_buoyancy::demo::run(*options); });
}
