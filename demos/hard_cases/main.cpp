#include <algorithm>
#include <cstdio>
#include <iterator>

#include "hard_cases/hard_case.h"
#include "hard_cases/options.h"
#include "hard_cases/score.h"
#include "recording/world_film.h"
#include "scenes/scene_watch.h"

#ifdef _WIN32
#include <io.h>
#define isatty _isatty
#define fileno _fileno
#else
#include <unistd.h>
#endif

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
std::vector<Score> runAll(const std::vector<HardCase>& cases, bool verbose) {
    const bool progress = isatty(fileno(stderr));
    std::vector<Score> all, group;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (progress)
            std::fprintf(stderr, "\r\033[K%zu of %zu: %s", i + 1, cases.size(), cases[i].fullName().c_str());
        for (const Score& score : runBothWays(cases[i]))
            group.push_back(score);
        if (i + 1 < cases.size() && cases[i + 1].group == cases[i].group) continue;
        if (progress) std::fprintf(stderr, "\r\033[K");
        printGroup(group, verbose);
        all.insert(all.end(), group.begin(), group.end());
        group.clear();
    }
    return all;
}

/// As the library floats it. Of a case that has several scenes the first is filmed.
bool film(const std::vector<HardCase>& cases, const Options& options) {
    const auto chain = std::find_if(cases.begin(), cases.end(), [](const HardCase& hardCase) {
        return hardCase.fullName() == "thirty barrels on a chain/1/60 s";
    });
    const HardCase& hardCase = options.only.empty() && chain != cases.end() ? *chain : cases.front();
    recording::WorldFilm film(options.film.film);
    const scenes::SceneWatch watch([&](const scenes::FloatScene& scene) { film.look(scene); });
    hardCase.measure(scenes::Floater::library);
    std::printf("Filmed: %s\n", hardCase.fullName().c_str());
    return writeFilm(film.film(), options.film, "hard_cases");
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
    const std::vector<Score> scores = runAll(cases, options.verbose);
    const auto failures = [&](Quantity Score::*side) {
        return std::count_if(scores.begin(), scores.end(),
                             [&](const Score& score) { return !(score.*side).passes(); });
    };
    std::printf("\n%zu cases, %zu quantities: peers' way fails %td, ours %td.\n", cases.size(), scores.size(),
                failures(&Score::peers), failures(&Score::ours));
    if (!options.csv.empty() && !writeCsv(scores, options.csv)) {
        std::fprintf(stderr, "hard_cases: cannot write %s\n", options.csv.c_str());
        return 1;
    }
    if (options.film.isWanted() && !film(cases, options)) return 1;
    return failures(&Score::ours) > 0 ? 1 : 0;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    int exitStatus = 0;
    const auto options = bullet_buoyancy::demo::parseOptions(argc, argv, exitStatus);
    return options ? bullet_buoyancy::demo::run(*options) : exitStatus;
}
