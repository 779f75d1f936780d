#include "floating_cube/comparison.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace bullet_buoyancy::demo {

double Comparison::deviation() const {
    return std::abs(simulated - expected);
}

void print(const Table& table) {
    std::printf("\n%s\n", table.title.c_str());
    std::printf("  %-34s %12s %12s %11s %11s\n", "", "simulated", "expected", "deviation", "tolerance");
    for (const Comparison& row : table.rows)
        std::printf("  %-34s %12.5f %12.5f %11.2e %11.2e %-4s%s\n", row.what.c_str(), row.simulated,
                    row.expected, row.deviation(), row.tolerance, row.unit.c_str(),
                    row.passes() ? "" : "  FAILS");
}

void printWorst(const std::vector<Table>& tables) {
    std::printf("\nLargest deviations, by their tolerances\n");
    for (const Table& table : tables) {
        const auto worst =
            std::max_element(table.rows.begin(), table.rows.end(), [](const auto& a, const auto& b) {
                return a.deviation() / a.tolerance < b.deviation() / b.tolerance;
            });
        std::printf("  %-34s %11.2e of %11.2e %s\n", worst->what.c_str(), worst->deviation(),
                    worst->tolerance, worst->unit.c_str());
    }
    std::printf("%s\n",
                allPass(tables) ? "All within tolerance." : "Some deviations are past their tolerance.");
}

void writeCsv(std::ostream& csv, const std::vector<Table>& tables) {
    csv << "table,quantity,unit,simulated,expected,deviation,tolerance,passes\n";
    for (const Table& table : tables)
        for (const Comparison& row : table.rows)
            csv << '"' << table.title << "\",\"" << row.what << "\"," << row.unit << ',' << row.simulated
                << ',' << row.expected << ',' << row.deviation() << ',' << row.tolerance << ','
                << row.passes() << '\n';
}

bool allPass(const std::vector<Table>& tables) {
    return std::all_of(tables.begin(), tables.end(), [](const Table& table) {
        return std::all_of(table.rows.begin(), table.rows.end(),
                           [](const Comparison& row) { return row.passes(); });
    });
}

}  // namespace bullet_buoyancy::demo
