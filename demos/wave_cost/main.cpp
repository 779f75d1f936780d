#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <ostream>

#include "plots/draw_plot.h"
#include "recording/film_options.h"
#include "recording/world_film.h"
#include "scenes/interruption.h"
#include "scenes/progress.h"
#include "scenes/statistics.h"
#include "scenes/study_seas.h"
#include "wave_cost/crowd.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

struct Options {
    int bodies = 1000, steps = 30, rounds = 9;
    std::string csv;
    recording::FilmOptions film;
};

/// Of one crowd, a figure a round: ns a body, and over those of the crowd in flat water in the same round.
struct Costs {
    std::vector<double> action, actionOverFlat, wholeOverFlat, evaluation, evaluationOverFlat;
};

struct CrowdInSea {
    std::string sea;
    double tolerance;
    std::unique_ptr<Crowd> crowd;
    Costs costs;
};

/// The first is in flat water.
std::vector<CrowdInSea> allCrowds(const std::vector<NamedSea>& seas, const WaterField& flat, int bodies) {
    std::vector<CrowdInSea> crowds;
    const auto add = [&](const std::string& name, const WaterField& water, double tolerance) {
        const BuoyancySettings settings{PressureModel::hydrostatic, tolerance};
        crowds.push_back({name, tolerance, std::make_unique<Crowd>(water, settings, bodies), {}});
    };
    add("flat water", flat, 1e-2);
    for (const NamedSea& sea : seas)
        for (double tolerance : {1e-2, 1e-3})
            add(sea.name, *sea.water, tolerance);
    return crowds;
}

/// In turn, so that what else the machine does falls on all alike.
void runRound(std::vector<CrowdInSea>& crowds, int steps) {
    SubstepTime flat{};
    double evaluationInFlat = 0;
    for (CrowdInSea& c : crowds) {
        const SubstepTime time = c.crowd->step(steps);
        const double evaluation = c.crowd->evaluate();
        if (&c == &crowds.front()) flat = time, evaluationInFlat = evaluation;
        c.costs.action.push_back(time.action / 1000);
        c.costs.actionOverFlat.push_back(time.action / flat.action);
        c.costs.wholeOverFlat.push_back(time.whole / flat.whole);
        c.costs.evaluation.push_back(evaluation / 1000);
        c.costs.evaluationOverFlat.push_back(evaluation / evaluationInFlat);
    }
}

void runAll(std::vector<CrowdInSea>& crowds, const Options& options) {
    Progress progress(options.rounds, "rounds");
    const SceneWatch watch([&](const FloatScene& scene) { progress.look(scene); });
    for (CrowdInSea& c : crowds)
        c.crowd->step(options.steps);  // from where they were put to how they float
    for (int round = 0; round < options.rounds; ++round) {
        progress.reach(round);
        runRound(crowds, options.steps);
    }
}

/// Medians and means of a crowd, in the order of the table.
struct Row {
    std::string sea;
    double tolerance, action, actionOverFlat, wholeOverFlat, evaluations, alone, aloneOverFlat, samples;
};

Row rowOf(const CrowdInSea& c) {
    return {c.sea,
            c.tolerance,
            median(c.costs.action),
            median(c.costs.actionOverFlat),
            median(c.costs.wholeOverFlat),
            c.crowd->evaluations(),
            median(c.costs.evaluation),
            median(c.costs.evaluationOverFlat),
            c.crowd->samples()};
}

void print(const std::vector<Row>& rows) {
    std::printf("%-35s %9s %9s %8s %8s %12s %9s %8s %8s\n", "sea", "tolerance", "us a step", "of flat",
                "scene's", "evaluations", "us alone", "of flat", "samples");
    for (const Row& row : rows)
        std::printf("%-35s %9.0e %9.3f %8.2f %8.2f %12.2f %9.3f %8.2f %8.1f\n", row.sea.c_str(),
                    row.tolerance, row.action, row.actionOverFlat, row.wholeOverFlat, row.evaluations,
                    row.alone, row.aloneOverFlat, row.samples);
}

void writeRows(std::ostream& csv, const std::vector<Row>& rows) {
    csv << "sea,tolerance,us_a_step,step_of_flat,scene_of_flat,evaluations,us_alone,alone_of_flat,samples\n";
    for (const Row& row : rows)
        csv << '"' << row.sea << "\"," << row.tolerance << ',' << row.action << ',' << row.actionOverFlat
            << ',' << row.wholeOverFlat << ',' << row.evaluations << ',' << row.alone << ','
            << row.aloneOverFlat << ',' << row.samples << '\n';
}

/// Of a crowd in the first sea, apart from the timings.
bool film(const WaterField& sea, const Options& options) {
    Crowd crowd(sea, {PressureModel::hydrostatic, 1e-2}, options.bodies);
    recording::WorldFilm film(options.film.film);
    const SceneWatch watch([&](const FloatScene& scene) {
        film.look({scene.world(), sea, crowd.action().time(),
                   [&](const btRigidBody& body) { return crowd.action().report(body); }});
    });
    untilInterrupted([&] { crowd.step(options.steps * options.rounds); });
    return writeFilm(film.film(), options.film, "wave_cost");
}

int run(const Options& options) {
    const FlatWater flat(WaterFrame::zUp());
    const std::vector<NamedSea> seas = threeSeas();
    std::printf("%d boxes of 1 m, ratio 0.5; seas of 1 m and 6 s; steps of 1/60 s; a box's part of each.\n",
                options.bodies);
    for (const NamedSea& sea : seas)
        std::printf("%s: steepness %.2f\n", sea.name.c_str(), sea.steepness);
    std::vector<CrowdInSea> crowds = allCrowds(seas, flat, options.bodies);
    untilInterrupted([&] { runAll(crowds, options); });
    std::vector<Row> rows;
    if (!crowds.back().costs.action.empty())
        std::transform(crowds.begin(), crowds.end(), std::back_inserter(rows), rowOf);
    print(rows);
    const plots::Table table{"rows", [&](std::ostream& csv) { writeRows(csv, rows); }};
    if (!options.csv.empty() && !writeTable(table, "wave_cost", options.csv)) return 1;
    if (options.film.isWanted() && !isInterrupted() && !film(*seas.front().water, options)) return 1;
    return 0;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    bullet_buoyancy::demo::Options options;
    CLI::App app{
        "Times what waves cost: boxes in the action's part of a substep of 1/60 s (us a step, and over that\n"
        "in flat water), in all of it with Bullet's (scene's: over that in flat water), and the evaluation\n"
        "of the pressure on them by itself, in seas of several kinds and tolerances. Processor time,\n"
        "medians over rounds, one thread.",
        "wave_cost"};
    app.option_defaults()->always_capture_default();
    app.add_option("--bodies", options.bodies, "boxes in each water")->check(CLI::Range(1, 100000));
    app.add_option("--steps", options.steps, "steps of each round")->check(CLI::Range(10, 100000));
    app.add_option("--rounds", options.rounds, "rounds")->check(CLI::Range(1, 1000));
    app.add_option("--csv", options.csv, "write the table to this file");
    bullet_buoyancy::recording::addFilmOptions(app, options.film);
    CLI11_PARSE(app, argc, argv);
    return bullet_buoyancy::scenes::runInterruptibly("wave_cost",
                                                     [&] { return bullet_buoyancy::demo::run(options); });
}
