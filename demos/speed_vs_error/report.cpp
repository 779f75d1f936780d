#include "speed_vs_error/report.h"

#include <cmath>
#include <cstdio>
#include <ostream>

namespace bullet_buoyancy::demo {

namespace {

/// Empty if it is NaN or infinite.
std::string textOf(double value, const char* format) {
    char text[32] = "";
    if (std::isfinite(value)) std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

void printRows(const std::vector<SpeedRow>& rows) {
    std::printf("\n%s, %s of %d triangles\n", rows.front().water.c_str(), rows.front().hull.c_str(),
                rows.front().triangles);
    std::printf("  %-20s %9s %11s %9s %9s %9s %9s %9s %9s\n", "evaluator", "tolerance", "ns a body", "speed",
                "force err", "largest", "torque", "largest", "bound");
    for (const SpeedRow& row : rows) {
        std::printf("  %-20s %9s %11.0f %9.2f %9.1e %9.1e %9.1e %9.1e %9s\n", row.evaluator->name.c_str(),
                    textOf(row.tolerance, "%.0e").c_str(), row.nanoseconds, row.speed, row.medianError,
                    row.largestError, row.medianTorque, row.largestTorque,
                    textOf(row.largestBound, "%.1e").c_str());
        if (row.broken > 0) std::printf("  ^ in %d poses it is farther off than it states\n", row.broken);
    }
    std::fflush(stdout);
}

void writeCsv(std::ostream& csv, const std::vector<SpeedRow>& rows) {
    csv << "water,hull,triangles,family,evaluator,tolerance,ns_a_body,speed_over_yardstick,median_force_"
           "error,"
           "largest_force_error,median_torque_error,largest_torque_error,largest_bound,broken\n";
    for (const SpeedRow& row : rows)
        csv << '"' << row.water << "\",\"" << row.hull << "\"," << row.triangles << ",\""
            << row.evaluator->family << "\",\"" << row.evaluator->name << "\"," << textOf(row.tolerance, "%g")
            << ',' << row.nanoseconds << ',' << row.speed << ',' << row.medianError << ',' << row.largestError
            << ',' << row.medianTorque << ',' << row.largestTorque << ',' << textOf(row.largestBound, "%g")
            << ',' << row.broken << '\n';
}

}  // namespace bullet_buoyancy::demo
