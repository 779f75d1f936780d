#pragma once

#include <iosfwd>

#include "speed_vs_error/study.h"

namespace bullet_buoyancy::demo {

/// The rows of one hull in one water as a part of the table, to standard output.
void printRows(const std::vector<SpeedRow>& rows);

void writeCsv(std::ostream& csv, const std::vector<SpeedRow>& rows);

}  // namespace bullet_buoyancy::demo
