#include <algorithm>
#include <cstdio>
#include <iterator>

#include "hard_cases/hard_case.h"
#include "hard_cases/options.h"
#include "hard_cases/score.h"
#include "plots/draw_plot.h"
#include "recording/world_film.h"
#include "scenes/interruption.h"
#include "scenes/progress.h"

namespace bullet_buoyancy::demo {
namespace {

std::vector<HardCase> select(const Options& options) {
    std::vector<HardCase> all, selected;
    addDroppedBodies(all);
    addMotions(all);
    addContacts(all);
    addHulls(all);
    addSurroundings(all);
    std::copy_if(all.begin(), all.end(), std::back_inserter(selected), [&](const HardCase& hardCase) {
        return (hardCase.quick || !options.quick) &&
               hardCase.fullName().find(options.only) != std::string::npos;
    });
    return selected;
}

/// Printed as soon as a group is complete: the cases of one stand next to each other.
void runAll(const std::vector<HardCase>& cases, bool verbose, std::vector<Score>& all) {
    scenes::Progress progress(double(cases.size()), "cases");
    const scenes::SceneWatch watch([&](const scenes::FloatScene& scene) { progress.look(scene); });
    std::size_t printed = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        progress.reach(double(i), cases[i].fullName());
        for (const Score& score : runBothWays(cases[i]))
            all.push_back(score);
        if (i + 1 < cases.size() && cases[i + 1].group == cases[i].group) continue;
        progress.clear();
        printGroup({all.begin() + std::ptrdiff_t(printed), all.end()}, verbose);
        printed = all.size();
    }
}

/// As the library floats it. Of a case that has several scenes the first is filmed.
bool film(const std::vector<HardCase>& cases, const Options& options) {
    const auto chain = std::find_if(cases.begin(), cases.end(), [](const HardCase& hardCase) {
        return hardCase.fullName() == "thirty barrels on a chain/1/60 s";
    });
    const HardCase& hardCase = options.only.empty() && chain != cases.end() ? *chain : cases.front();
    recording::WorldFilm film(options.film.film);
    const scenes::SceneWatch watch([&](const scenes::FloatScene& scene) { film.look(scene); });
    scenes::untilInterrupted([&] { hardCase.measure(scenes::Floater::library); });
    std::printf("Filmed: %s\n", hardCase.fullName().c_str());
    return writeFilm(film.film(), options.film, "hard_cases");
}

/// Those that were run: a case's quantities stand next to each other.
std::size_t casesOf(const std::vector<Score>& scores) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < scores.size(); ++i)
        count += i == 0 || scores[i].group != scores[i - 1].group || scores[i].name != scores[i - 1].name;
    return count;
}

int run(const Options& options) {
    const std::vector<HardCase> cases = select(options);
    if (options.list) {
        for (const HardCase& hardCase : cases)
            std::puts(hardCase.fullName().c_str());
        return 0;
    }
    if (cases.empty()) {
        std::fprintf(stderr, "hard_cases: no case is named so; see --list\n");
        return 1;
    }
    printHeader();
    std::vector<Score> scores;
    scenes::untilInterrupted([&] { runAll(cases, options.verbose, scores); });
    const auto failures = [&](Quantity Score::*side) {
        return std::count_if(scores.begin(), scores.end(),
                             [&](const Score& score) { return !(score.*side).passes(); });
    };
    std::printf("\n%zu cases, %zu quantities: peers' way fails %td, ours %td.\n", casesOf(scores),
                scores.size(), failures(&Score::peers), failures(&Score::ours));
    const plots::Table table{"scores", [&](std::ostream& csv) { writeCsv(csv, scores); }};
    if (!options.csv.empty() && !writeTable(table, "hard_cases", options.csv)) return 1;
    if (!options.plot.empty() && !scores.empty() && !plots::drawPlot("hard_cases", {table}, options.plot))
        return 1;
    if (options.film.isWanted() && !scenes::isInterrupted() && !film(cases, options)) return 1;
    return failures(&Score::ours) > 0 ? 1 : 0;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    int exitStatus = 0;
    const auto options = bullet_buoyancy::demo::parseOptions(argc, argv, exitStatus);
    if (!options) return exitStatus;
    return bullet_buoyancy::scenes::runInterruptibly("hard_cases",
                                                     [&] { return bullet_buoyancy::demo::run(*options); });
}
