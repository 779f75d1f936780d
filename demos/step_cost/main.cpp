#include <CLI/CLI.hpp>
#include <cstdio>
#include <ostream>

#include "plots/draw_plot.h"
#include "recording/film_options.h"
#include "recording/world_film.h"
#include "scenes/crowd_pose.h"
#include "scenes/float_scene.h"
#include "scenes/interruption.h"
#include "scenes/progress.h"
#include "scenes/scene_watch.h"
#include "scenes/stopwatch.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

struct Options {
    int bodies = 1000, steps = 300;
    std::string csv;
    recording::FilmOptions film;
};

/// One crowd of boxes and one way to step it.
struct Case {
    const char* bodies;
    Vec3 size;
    double ratio;
    const char* scheme;
    Floater floater;
    StepScheme step;
};

struct Cost {
    double nanoseconds;  // a body and step, median over the steps
    double evaluations;  // of the water's pressure, a body and step, mean
};

/// Apart from each other.
std::vector<btRigidBody*> addCrowd(FloatScene& scene, const Case& crowd, int count) {
    std::vector<btRigidBody*> bodies;
    const double distance = 3 * crowd.size.norm();
    BodyDef def;
    def.scheme = crowd.step;
    for (int i = 0; i < count; ++i) {
        Pose pose = crowdPose(i, distance, 0.2 * crowd.size.z());
        pose.position.z() += crowd.size.z() * (0.5 - crowd.ratio);
        bodies.push_back(&scene.addFloatingBox(crowd.size, crowd.ratio, pose, def));
    }
    return bodies;
}

Cost measure(const Case& crowd, const Options& options) {
    SceneDef def;
    def.floater = crowd.floater;
    FloatScene scene(def);
    const std::vector<btRigidBody*> bodies = addCrowd(scene, crowd, options.bodies);
    Stopwatch stopwatch(scene.floater());
    scene.world().removeAction(&scene.floater());
    scene.world().addAction(&stopwatch);
    double evaluations = 0;
    for (int i = 0; i < options.steps; ++i) {
        scene.step(1.0 / 60);
        for (const btRigidBody* body : bodies)
            evaluations += scene.report(*body).evaluations;
    }
    scene.world().removeAction(&stopwatch);
    scene.world().addAction(&scene.floater());
    return {stopwatch.median() / options.bodies, evaluations / options.steps / options.bodies};
}

std::vector<Case> allCases() {
    struct Crowd {
        const char* name;
        Vec3 size;
        double ratio;
    };
    std::vector<Case> cases;
    for (const Crowd& crowd : {Crowd{"crates, 1 m, ratio 0.5", {1, 1, 0.5}, 0.5},
                               Crowd{"crates, 0.3 m, ratio 0.3", {0.3, 0.3, 0.15}, 0.3},
                               Crowd{"foam, 0.3 m, ratio 0.02", {0.3, 0.3, 0.15}, 0.02},
                               Crowd{"foam, 0.05 m, ratio 0.001", {0.05, 0.05, 0.025}, 0.001}}) {
        const auto add = [&](const char* scheme, Floater floater, StepScheme step) {
            cases.push_back({crowd.name, crowd.size, crowd.ratio, scheme, floater, step});
        };
        add("bare impulses", Floater::impulses, StepScheme::published);
        add("action, published step", Floater::library, StepScheme::published);
        add("action, guarded step", Floater::library, StepScheme::guarded);
    }
    return cases;
}

/// Of the first crowd by the guarded step, apart from the timings.
bool film(const Case& crowd, const Options& options) {
    recording::WorldFilm film(options.film.film);
    const SceneWatch watch([&](const FloatScene& scene) { film.look(scene); });
    untilInterrupted([&] { measure(crowd, options); });
    return writeFilm(film.film(), options.film, "step_cost");
}

struct Row {
    Case crowd;
    Cost cost;
    double ofPublished;  ///< its time over that of the published step
};

void writeRows(std::ostream& csv, const std::vector<Row>& rows) {
    csv << "bodies,scheme,ns_a_body,of_published,evaluations_a_step\n";
    for (const Row& row : rows)
        csv << '"' << row.crowd.bodies << "\",\"" << row.crowd.scheme << "\"," << row.cost.nanoseconds << ','
            << row.ofPublished << ',' << row.cost.evaluations << '\n';
}

void measureAll(const std::vector<Case>& cases, const Options& options, std::vector<Row>& rows) {
    Progress progress(double(cases.size()), "crowds");
    const SceneWatch watch([&](const FloatScene& scene) { progress.look(scene); });
    for (std::size_t i = 0; i < cases.size(); i += 3) {
        Cost costs[3];
        for (std::size_t j = 0; j < 3; ++j) {
            progress.reach(double(i + j), cases[i + j].bodies);
            costs[j] = measure(cases[i + j], options);
        }
        costs[0].evaluations = 1;  // bare impulses need one each and do not count them
        progress.clear();
        for (std::size_t j = 0; j < 3; ++j) {
            const Row row{cases[i + j], costs[j], costs[j].nanoseconds / costs[1].nanoseconds};
            std::printf("%-28s %-24s %12.0f %14.2f %18.2f\n", row.crowd.bodies, row.crowd.scheme,
                        row.cost.nanoseconds, row.ofPublished, row.cost.evaluations);
            rows.push_back(row);
        }
    }
}

int run(const Options& options) {
    std::printf("%-28s %-24s %12s %14s %18s\n", "bodies", "scheme", "ns a body", "of published",
                "evaluations a step");
    const std::vector<Case> cases = allCases();
    std::vector<Row> rows;
    untilInterrupted([&] { measureAll(cases, options, rows); });
    const plots::Table table{"rows", [&](std::ostream& csv) { writeRows(csv, rows); }};
    if (!options.csv.empty() && !writeTable(table, "step_cost", options.csv)) return 1;
    if (options.film.isWanted() && !isInterrupted() && !film(cases[2], options)) return 1;
    return 0;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    bullet_buoyancy::demo::Options options;
    CLI::App app{
        "Times what a body costs in the action's part of a substep of 1/60 s, by itself: bare impulses as\n"
        "most engines apply them, the published step and the guarded one in the library's action, which\n"
        "also keeps momentum, energy, reports and sleep. Medians, one thread.",
        "step_cost"};
    app.option_defaults()->always_capture_default();
    app.add_option("--bodies", options.bodies, "bodies of each kind")->check(CLI::Range(1, 100000));
    app.add_option("--steps", options.steps, "steps of each kind")->check(CLI::Range(10, 100000));
    app.add_option("--csv", options.csv, "write the table to this file");
    bullet_buoyancy::recording::addFilmOptions(app, options.film);
    CLI11_PARSE(app, argc, argv);
    return bullet_buoyancy::scenes::runInterruptibly("step_cost",
                                                     [&] { return bullet_buoyancy::demo::run(options); });
}
