#include "floating_cube/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "bullet_buoyancy/core/constants.h"
#include "scenes/gnuplot.h"
#include "scenes/known_answers.h"

namespace bullet_buoyancy::demo {

namespace {

using namespace scenes;

constexpr double degrees = 180 / pi;
constexpr double drawnSeconds = 15;  // of the cube's fall
constexpr double drawnSide = 0.09;   // of a log's section, on the axis of density ratios
constexpr std::array<double, 7> drawnRatios{0.11, 0.24, 0.37, 0.5, 0.63, 0.76, 0.89};

/// Data blocks are named, so that the commands below read like a page.
template <typename WriteRows>
void dataBlock(std::ostream& script, const char* name, const WriteRows& writeRows) {
    script << '$' << name << " << EOD\n";
    writeRows();
    script << "EOD\n";
}

/// The corners of a log's section as it floats, drawn at its density ratio.
void writeSection(std::ostream& script, const LogResult& log) {
    constexpr std::array<std::array<double, 2>, 5> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
    const double c = std::cos(log.tilt), s = std::sin(log.tilt);
    for (const auto& [x, y] : corners)
        script << log.ratio + drawnSide / 2 * (c * x - s * y) << ' '
               << drawnSide * (log.centreHeight + (s * x + c * y) / 2) << '\n';
    script << '\n';
}

void writeData(std::ostream& script, const CubeResult& cube, const std::vector<LogResult>& logs) {
    dataBlock(script, "sections", [&] {
        for (double ratio : drawnRatios)
            writeSection(script,
                         *std::min_element(logs.begin(), logs.end(), [&](const auto& a, const auto& b) {
                             return std::abs(a.ratio - ratio) < std::abs(b.ratio - ratio);
                         }));
    });
    dataBlock(script, "logs", [&] {
        for (const LogResult& log : logs)
            script << log.ratio << ' ' << log.tilt * degrees << '\n';
    });
    dataBlock(script, "curve", [&] {
        for (int i = 0; i <= 2000; ++i)
            script << i / 2000.0 << ' ' << squareLogTilt(i / 2000.0) * degrees << '\n';
    });
    dataBlock(script, "cube", [&] {
        for (const CubeSample& sample : cube.samples)
            if (sample.time < drawnSeconds)
                script << sample.time << ' ' << sample.height << ' ' << sample.tilt * degrees << '\n';
    });
}

/// 900 by 960: every panel is 720 wide, so that 1 on the first panel's axes is 720 both ways.
constexpr const char* commands = R"gnuplot(
set multiplot
set border lc rgb '#888888'
set grid lc rgb '#dddddd' lt 1
set tics textcolor rgb '#333333'
set lmargin at screen 0.1
set rmargin at screen 0.9

set title 'How a square log floats: sections from the simulation' textcolor rgb '#333333'
set tmargin at screen 0.955
set bmargin at screen 0.825
set xrange [0:1]
set yrange [-0.0867:0.0867]
unset xtics
unset ytics
unset grid
set object 1 rectangle from graph 0, first -0.0867 to graph 1, first 0 fc rgb '#a8d4ef' fs noborder behind
plot $sections using 1:2 with filledcurves closed fc rgb '#c98d4b' fs transparent solid 0.75 border lc rgb '#6b4a24' notitle
unset object 1

set title 'Tilt of its face'
set tmargin at screen 0.76
set bmargin at screen 0.48
set xtics 0.1
set ytics 0, 15, 45
set grid
set yrange [-2:50]
set xlabel 'density of the log / density of the water' offset 0, 0.4 textcolor rgb '#333333'
set ylabel 'tilt (degrees)' textcolor rgb '#333333'
set key bottom center textcolor rgb '#333333'
plot $curve with lines lw 2 lc rgb '#2a7ab5' title 'closed form', \
     $logs with points pt 7 ps 0.6 lc rgb '#d1495b' title 'simulated in Bullet'

set title 'A cube dropped into water'
set tmargin at screen 0.36
set bmargin at screen 0.08
set autoscale x
set autoscale y
set xtics autofreq
set ytics autofreq nomirror
set y2tics 0, 15
set y2range [0:60]
set xlabel 'time (s)'
set ylabel 'centre above water (edges)'
set y2label 'tilt from face up (degrees)' textcolor rgb '#333333'
set key at graph 0.98, 0.6 right
plot $cube using 1:2 with lines lw 2 lc rgb '#2a7ab5' title 'height', \
     $cube using 1:3 axes x1y2 with lines lw 2 lc rgb '#d1495b' title 'tilt'
unset multiplot
)gnuplot";

}  // namespace

bool plot(const CubeResult& cube, const std::vector<LogResult>& logs, const std::string& file) {
    std::ostringstream script;
    script << gnuplotOutput(file, 900, 960, 13);
    writeData(script, cube, logs);
    script << commands;
    return runGnuplot(script.str(), "floating_cube", file);
}

}  // namespace bullet_buoyancy::demo
