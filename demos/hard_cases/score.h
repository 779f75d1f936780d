#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "hard_cases/hard_case.h"

namespace bullet_buoyancy::demo {

/// One quantity of one case, measured both ways.
struct Score {
    std::string group, name;
    Quantity peers, ours;
};

/// Runs a case both ways. A run that fails to measure what the other does is a mistake in the case: asserted.
std::vector<Score> runBothWays(const HardCase& hardCase);

/// The scores of one group, one row a quantity: the worst of each by its limit, and how many cases fail.
/// `verbose`: all of them.
void printGroup(const std::vector<Score>& scores, bool verbose);
void printHeader();

void writeCsv(std::ostream& csv, const std::vector<Score>& scores);

}  // namespace bullet_buoyancy::demo
