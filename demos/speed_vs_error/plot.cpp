#include "speed_vs_error/plot.h"

#include <algorithm>
#include <sstream>

#include "scenes/gnuplot.h"

namespace bullet_buoyancy::demo {

namespace {

constexpr const char* style = R"gnuplot(
set multiplot
set border lc rgb '#888888'
set grid lc rgb '#dddddd' lt 1
set tics textcolor rgb '#333333'
set logscale xy
set colorsequence podo
set format xy '10^{%L}'
set xtics 100
set xrange [1e-17:2]
set xlabel 'error of the force / weight of the whole displacement' offset 0, 0.4 textcolor rgb '#333333'
set ylabel 'ns a body' textcolor rgb '#333333'
)gnuplot";

constexpr const char* key = R"gnuplot(
set lmargin at screen 0.05
set rmargin at screen 0.95
set bmargin at screen 0.0
set tmargin at screen 0.07
unset title
unset border
unset tics
unset grid
unset xlabel
unset ylabel
set yrange [1:10]
set key center center horizontal maxrows 2 textcolor rgb '#333333'
)gnuplot";

/// The line and points of a family.
std::string lookOf(std::size_t family) {
    return "with linespoints lt " + std::to_string(family + 1) + " pt " + std::to_string(family + 4) +
           " lw 2 ps 1.2";
}

/// What one of the four panels shows, and where its lower left corner is on the picture.
struct Panel {
    std::string water, hull;
    int triangles;
    double left, bottom;
};

/// The first and the last water, with the hulls that are in both.
std::vector<Panel> panelsOf(const std::vector<SpeedRow>& rows) {
    const auto isIn = [&](const std::string& water, const SpeedRow& row) {
        return std::any_of(rows.begin(), rows.end(), [&](const SpeedRow& other) {
            return other.water == water && other.hull == row.hull && other.triangles == row.triangles;
        });
    };
    const std::string flat = rows.front().water, sea = rows.back().water;
    const SpeedRow *simplest = &rows.front(), *finest = simplest;
    for (const SpeedRow& row : rows)
        if (row.hull == "mesh" && row.triangles > finest->triangles && isIn(sea, row)) finest = &row;
    return {{flat, simplest->hull, simplest->triangles, 0.08, 0.60},
            {flat, finest->hull, finest->triangles, 0.57, 0.60},
            {sea, simplest->hull, simplest->triangles, 0.08, 0.15},
            {sea, finest->hull, finest->triangles, 0.57, 0.15}};
}

/// A data set for each family. A tolerance of 0 is not the limit of small ones, and stands alone.
void writePanel(std::ostream& script, const std::vector<SpeedRow>& rows, const Panel& panel,
                const std::vector<std::string>& families, std::size_t number) {
    constexpr double leastError = 1e-17;  // a logarithmic axis has no zero
    for (std::size_t i = 0; i < families.size(); ++i) {
        script << "$points_" << number << '_' << i << " << EOD\n";
        for (const SpeedRow& row : rows)
            if (row.water == panel.water && row.hull == panel.hull && row.triangles == panel.triangles &&
                row.evaluator->family == families[i])
                script << (row.tolerance == 0 ? "\n" : "") << std::max(row.medianError, leastError) << ' '
                       << row.nanoseconds << '\n';
        script << "EOD\n";
    }
}

void drawPanel(std::ostream& script, const Panel& panel, const std::vector<std::string>& families,
               std::size_t number) {
    script << "set title \"" << panel.water << "\\n"
           << panel.hull << " of " << panel.triangles << " triangles\"\n"
           << "set lmargin at screen " << panel.left << "\nset rmargin at screen " << panel.left + 0.41
           << "\nset bmargin at screen " << panel.bottom << "\nset tmargin at screen " << panel.bottom + 0.32
           << '\n';
    script << "plot ";
    for (std::size_t i = 0; i < families.size(); ++i)
        script << (i > 0 ? ", " : "") << "$points_" << number << '_' << i << ' ' << lookOf(i) << " notitle";
    script << '\n';
}

/// A row of its own below the panels, since a key is no wider than its plot.
void drawKey(std::ostream& script, const std::vector<std::string>& families) {
    script << key << "plot ";
    for (std::size_t i = 0; i < families.size(); ++i)
        script << (i > 0 ? ", " : "") << "NaN " << lookOf(i) << " title '" << families[i] << '\'';
    script << '\n';
}

std::vector<std::string> familiesOf(const std::vector<SpeedRow>& rows) {
    std::vector<std::string> families;
    for (const SpeedRow& row : rows)
        if (std::find(families.begin(), families.end(), row.evaluator->family) == families.end())
            families.push_back(row.evaluator->family);
    return families;
}

}  // namespace

bool plot(const std::vector<SpeedRow>& rows, const std::string& file) {
    const std::vector<Panel> panels = panelsOf(rows);
    const std::vector<std::string> families = familiesOf(rows);
    std::ostringstream script;
    script << scenes::gnuplotOutput(file, 1000, 900, 12);
    for (std::size_t i = 0; i < panels.size(); ++i)
        writePanel(script, rows, panels[i], families, i);
    script << style;
    for (std::size_t i = 0; i < panels.size(); ++i)
        drawPanel(script, panels[i], families, i);
    drawKey(script, families);
    script << "unset multiplot\n";
    return scenes::runGnuplot(script.str(), "speed_vs_error", file);
}

}  // namespace bullet_buoyancy::demo
