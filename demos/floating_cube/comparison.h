#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace bullet_buoyancy::demo {

/// One quantity, as simulated and as it ought to be.
struct Comparison {
    std::string what;
    std::string unit;
    double simulated;
    double expected;
    double tolerance;  ///< largest absolute difference that passes; the reason stands where it is set

    double deviation() const;
    bool passes() const { return deviation() <= tolerance; }  // false for NaN
};

struct Table {
    std::string title;
    std::vector<Comparison> rows;
};

/// Prints a table with one line a row, and what failed.
void print(const Table& table);

/// Prints, for each table, the row that comes nearest to its tolerance or passes it, and a verdict.
void printWorst(const std::vector<Table>& tables);

/// Writes all tables as CSV.
void writeCsv(std::ostream& csv, const std::vector<Table>& tables);

bool allPass(const std::vector<Table>& tables);

}  // namespace bullet_buoyancy::demo
