#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace bullet_buoyancy::plots {

/// What a plot is drawn from: CSV with a line of headers, as a demo writes it to a file.
struct Table {
    std::string name;  ///< by which the plot knows it
    std::function<void(std::ostream&)> write;
};

/// Writes a table to a file. False, with a message to standard error that begins with the name of the `demo`,
/// if that fails.
bool writeTable(const Table& table, const std::string& demo, const std::string& file);

/// Draws the plot of a `demo`, which is plots/<demo>.gp, into a .png or .svg file by the program gnuplot.
/// False, with such a message, where that is not installed or fails.
bool drawPlot(const std::string& demo, const std::vector<Table>& tables, const std::string& file);

}  // namespace bullet_buoyancy::plots
