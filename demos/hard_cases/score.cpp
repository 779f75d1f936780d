#include "hard_cases/score.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>

namespace bullet_buoyancy::demo {

namespace {

/// What a group has of one quantity.
struct Summary {
    Quantity peers, ours;
    int cases = 0, peersFail = 0, oursFail = 0;
};

/// By how much a quantity is past its limit; what is not a number is worst.
double excess(const Quantity& quantity) {
    if (std::isnan(quantity.value)) return std::numeric_limits<double>::infinity();
    return quantity.limit > 0 ? quantity.value / quantity.limit : quantity.value;
}

void keepWorse(Quantity& worst, const Quantity& quantity) {
    if (excess(quantity) > excess(worst)) worst = quantity;
}

std::vector<Summary> summarise(const std::vector<Score>& scores) {
    std::vector<Summary> summaries;
    for (const Score& score : scores) {
        auto found = std::find_if(summaries.begin(), summaries.end(), [&](const Summary& summary) {
            return summary.ours.what == score.ours.what;
        });
        if (found == summaries.end())
            found = summaries.insert(summaries.end(), Summary{score.peers, score.ours});
        keepWorse(found->peers, score.peers);
        keepWorse(found->ours, score.ours);
        ++found->cases;
        found->peersFail += !score.peers.passes();
        found->oursFail += !score.ours.passes();
    }
    return summaries;
}

void printRow(const std::string& name, const Summary& row) {
    const auto verdict = [&](int failures) {
        if (failures == 0) return std::string("pass");
        return row.cases == 1 ? std::string("FAIL")
                              : "FAIL " + std::to_string(failures) + "/" + std::to_string(row.cases);
    };
    std::printf("%-44s %-26s %10.4g %-10s %10.4g %-10s %9.4g %s\n", name.c_str(), row.ours.what.c_str(),
                row.peers.value, verdict(row.peersFail).c_str(), row.ours.value,
                verdict(row.oursFail).c_str(), row.ours.limit, row.ours.unit.c_str());
}

}  // namespace

std::vector<Score> runBothWays(const HardCase& hardCase) {
    const std::vector<Quantity> peers = hardCase.measure(scenes::Floater::impulses);
    const std::vector<Quantity> ours = hardCase.measure(scenes::Floater::library);
    assert(peers.size() == ours.size());
    std::vector<Score> scores;
    for (std::size_t i = 0; i < ours.size(); ++i)
        scores.push_back({hardCase.group, hardCase.name, peers[i], ours[i]});
    return scores;
}

void printHeader() {
    std::printf("%-44s %-26s %10s %-10s %10s %-10s %9s\n", "case", "quantity", "peers' way", "", "ours", "",
                "limit");
}

void printGroup(const std::vector<Score>& scores, bool verbose) {
    if (verbose) {
        for (const Score& score : scores)
            printRow(score.name.empty() ? score.group : score.group + "/" + score.name,
                     {score.peers, score.ours, 1, !score.peers.passes(), !score.ours.passes()});
    } else {
        std::string name = scores.empty() ? "" : scores.front().group;
        for (const Summary& summary : summarise(scores)) {
            printRow(name, summary);
            name.clear();  // once a group
        }
    }
    std::fflush(stdout);
}

void writeCsv(std::ostream& csv, const std::vector<Score>& scores) {
    csv << "group,case,quantity,unit,limit,peers,peers_pass,ours,ours_pass\n";
    for (const Score& score : scores)
        csv << '"' << score.group << "\",\"" << score.name << "\",\"" << score.ours.what << "\","
            << score.ours.unit << ',' << score.ours.limit << ',' << score.peers.value << ','
            << score.peers.passes() << ',' << score.ours.value << ',' << score.ours.passes() << '\n';
}

}  // namespace bullet_buoyancy::demo
