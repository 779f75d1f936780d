#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <ostream>
#include <thread>

#include "bullet_buoyancy/water/flat_water.h"
#include "plots/draw_plot.h"
#include "recording/slide_show.h"
#include "scenes/interruption.h"
#include "scenes/progress.h"
#include "scenes/statistics.h"
#include "scenes/thread_scheduler.h"
#include "scenes/timed_scene.h"
#include "speed_vs_error/machine.h"
#include "speed_vs_error/options.h"
#include "speed_vs_error/report.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

/// What of the hulls is studied in a water, and how thoroughly.
struct Plan {
    int mostTriangles;
    StudyEffort effort;
};

Plan planOf(bool isFlat, bool quick) {
    if (isFlat) return quick ? Plan{5120, {40000, 2000, 16, 3}} : Plan{81920, {400000, 4000, 16, 9}};
    return quick ? Plan{320, {4000, 200, 4, 3}} : Plan{20480, {20000, 1000, 16, 5}};
}

std::vector<NamedSea> allWaters() {
    std::vector<NamedSea> waters = threeSeas();
    waters.insert(waters.begin(), {"flat water", std::make_shared<FlatWater>(WaterFrame::zUp()), 0});
    return waters;
}

struct Study {
    NamedSea water;
    NamedHull hull;
    StudyEffort effort;
};

std::vector<Study> allStudies(bool quick) {
    const std::vector<NamedHull> hulls = hullsOfAllKinds();
    std::vector<Study> all;
    for (const NamedSea& water : allWaters()) {
        const Plan plan = planOf(water.water->bounds().isFlat(), quick);
        for (const NamedHull& hull : hulls)
            if (hull.hull->mesh.triangles.size() <= std::size_t(plan.mostTriangles))
                all.push_back({water, hull, plan.effort});
    }
    return all;
}

void studyAll(bool quick, Fnv1a& hash, std::vector<SpeedRow>& all) {
    const std::vector<Study> studies = allStudies(quick);
    Progress progress(double(studies.size()), "studies");
    for (std::size_t i = 0; i < studies.size(); ++i) {
        const Study& study = studies[i];
        const auto reached = [&](double share) {
            progress.reach(double(i) + share, study.hull.name + ", " + study.water.name);
        };
        const std::vector<SpeedRow> rows = studySpeed(study.hull, study.water, study.effort, hash, reached);
        progress.clear();
        printRows(rows);
        all.insert(all.end(), rows.begin(), rows.end());
    }
}

/// Medians, after a tenth in which the bodies settle.
SubstepTime timeOf(TimedScene& scene, int substeps) {
    std::vector<double> whole, action;
    for (int i = 0; i < substeps; ++i) {
        const SubstepTime time = scene.step();
        if (i < substeps / 10) continue;
        whole.push_back(time.whole);
        action.push_back(time.action);
    }
    return {median(whole), median(action)};
}

void printScenes(int bodies, int substeps) {
    std::printf("\n%-28s %12s %14s %12s %14s %11s\n", "a world in flat water", "us a substep", "Bullet alone",
                "the action", "of Bullet's, %", "ns a body");
    for (const NamedShapes& shapes : shapesOfScenes()) {
        TimedScene scene(shapes, bodies);
        const SubstepTime time = timeOf(scene, substeps);
        const double bullet = time.whole - time.action;
        std::printf("%4d %-23s %12.0f %14.0f %12.0f %14.1f %11.0f\n", bodies, shapes.name, time.whole / 1000,
                    bullet / 1000, time.action / 1000, 100 * time.action / bullet, time.action / bodies);
    }
}

/// By the clock on the wall.
void printThreads(int bodies, int substeps) {
    std::printf("\n%-28s %12s %14s\n", "the action's threads", "us a substep", "times as fast");
    double alone = 0;
    for (int threads : {1, 2, 4}) {
        if (threads > int(std::thread::hardware_concurrency())) break;
        ThreadScheduler scheduler(threads);
        TimedScene scene(shapesOfScenes().front(), bodies, wallTime);
        const double time = timeOf(scene, substeps).action;
        if (threads == 1) alone = time;
        std::printf("%4d boxes, %d %-14s %12.0f %14.2f\n", bodies, threads,
                    threads == 1 ? "thread" : "threads", time / 1000, alone / time);
    }
}

/// A pose of each hull in each water; the larger meshes have the shape of the smaller ones.
bool film(const SpeedOptions& options) {
    constexpr double reach = 6;  // m
    constexpr std::size_t mostTriangles = 5120;
    recording::SlideShow show(options.film.film, reach);
    for (const NamedSea& water : allWaters())
        for (const NamedHull& hull : hullsOfAllKinds())
            if (hull.hull->mesh.triangles.size() <= mostTriangles)
                show.show(hull.name + ", " + water.name, recording::Look::orange, hull.hull, *water.water,
                          casesAcross(*water.water, *hull.hull, 1), 1);
    return writeFilm(&show.film(), options.film, "speed_vs_error");
}

int run(const SpeedOptions& options) {
    std::printf(
        "%s\nTimes of one evaluation; speeds in multiples of the first evaluator's in the same run. Errors\n"
        "over the weight of water that the whole hull displaces, torques over that times its bounding\n"
        "radius: medians and largest. To baselines round solids are meshes.\n",
        describeMachine().c_str());
    Fnv1a hash;
    std::vector<SpeedRow> rows;
    untilInterrupted([&] {
        studyAll(options.quick, hash, rows);
        const int bodies = options.quick ? 200 : 1000, substeps = options.quick ? 60 : 600;
        printScenes(bodies, substeps);
        printThreads(bodies, substeps);
    });
    int broken = 0;
    for (const SpeedRow& row : rows)
        broken += row.broken;
    if (broken > 0) std::printf("\n%d results are farther off than their evaluators state\n", broken);
    std::printf("\nHash of the library's results: %016" PRIx64 "\n", hash.value());
    const plots::Table table{"rows", [&](std::ostream& csv) { writeCsv(csv, rows); }};
    if (!options.csv.empty() && !writeTable(table, "speed_vs_error", options.csv)) return 1;
    if (!options.plot.empty() && !rows.empty() && !plots::drawPlot("speed_vs_error", {table}, options.plot))
        return 1;
    if (options.film.isWanted() && !isInterrupted() && !film(options)) return 1;
    return broken > 0;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    int exitStatus = 0;
    const auto options = bullet_buoyancy::demo::parseSpeedOptions(argc, argv, exitStatus);
    if (!options) return exitStatus;
    return bullet_buoyancy::scenes::runInterruptibly("speed_vs_error",
                                                     [&] { return bullet_buoyancy::demo::run(*options); });
}
