#include "boat_in_waves/plot.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "boat_in_waves/profile.h"
#include "scenes/gnuplot.h"

namespace bullet_buoyancy::demo {

namespace {

using namespace scenes;

constexpr double degrees = 180 / pi;
constexpr double drawnPeriods = 10;  // of the time series
constexpr int moments = 4;           // at which the boat is drawn, a quarter of a period apart

/// Of the first panel's strip at either side of the boat's place, and between its rows, boat lengths.
constexpr double reach = 3.6, rowHeight = 0.5;

constexpr int pictureHeight = 1100;

/// Data blocks are named, so that the commands below read like a page.
template <typename WriteRows>
void dataBlock(std::ostream& script, const std::string& name, const WriteRows& writeRows) {
    script << '$' << name << " << EOD\n";
    writeRows();
    script << "EOD\n";
}

/// Index of the sample with the highest crest at the probe, far enough from the ends of the record.
std::size_t highestCrest(const Picture& picture) {
    const auto& samples = picture.voyage.samples;
    const std::size_t margin = samples.size() / 10;
    return std::size_t(
        std::max_element(samples.begin() + std::ptrdiff_t(margin), samples.end() - std::ptrdiff_t(margin),
                         [](const auto& a, const auto& b) { return a.elevation < b.elevation; }) -
        samples.begin());
}

const VoyageSample& sampleNear(const Picture& picture, double time) {
    const auto& samples = picture.voyage.samples;
    const double index = (time - samples[0].time) / (samples[1].time - samples[0].time);
    return samples[std::size_t(std::clamp(std::round(index), 0.0, double(samples.size() - 1)))];
}

/// Elevation of the water along the line of the boat, m.
double elevationAhead(const Picture& picture, const VoyageSample& sample, double ahead) {
    const Vec2 place(sample.surge + ahead * std::cos(sample.yaw), sample.sway + ahead * std::sin(sample.yaw));
    return picture.sea.elevation(place, sample.time);
}

/// The angle of the water's slope along the boat, as at its two ends, degrees.
double slopeAlong(const Picture& picture, const VoyageSample& sample) {
    const double half = picture.boat.size.x() / 2;
    picture.sea.showAt(Vec2(sample.surge, sample.sway), sample.time);
    return degrees *
           std::atan((elevationAhead(picture, sample, half) - elevationAhead(picture, sample, -half)) /
                     (2 * half));
}

void writePolygon(std::ostream& script, const std::vector<Vec2>& polygon, const VoyageSample& sample,
                  double heightAtRest, double row) {
    const double c = std::cos(sample.pitch), s = std::sin(sample.pitch);
    for (std::size_t i = 0; i <= polygon.size(); ++i) {
        const Vec2& p = polygon[i % polygon.size()];
        script << c * p.x() - s * p.y() << ' ' << heightAtRest + sample.heave + s * p.x() + c * p.y() + row
               << '\n';
    }
    script << '\n';
}

/// The water, the boat's outline, and what of it is below the design waterline, at each moment in a row.
void writeMoments(std::ostream& script, const Picture& picture, double start) {
    const double length = picture.boat.size.x(), height = picture.boat.heightAtRest;
    const double farthest = picture.sea.gridNodes() > 0 ? picture.sea.def().gridReach : reach * length;
    const std::vector<Vec2> outline = profileOf(picture.boat.hull->mesh), bottom = below(outline, -height);
    for (int i = 0; i < moments; ++i) {
        const VoyageSample& sample = sampleNear(picture, start + i * picture.sea.def().period / moments);
        const double row = -i * rowHeight * length;
        const std::string number = std::to_string(i);
        picture.sea.showAt(Vec2(sample.surge, sample.sway), sample.time);
        dataBlock(script, "water" + number, [&] {
            for (int j = -100; j <= 100; ++j)
                script << farthest * j / 100 << ' '
                       << row + elevationAhead(picture, sample, farthest * j / 100) << ' '
                       << row - 0.6 * rowHeight * length << '\n';
        });
        dataBlock(script, "hull" + number, [&] { writePolygon(script, outline, sample, height, row); });
        dataBlock(script, "bottom" + number, [&] { writePolygon(script, bottom, sample, height, row); });
    }
}

void writeSeries(std::ostream& script, const Picture& picture, double from, double to) {
    dataBlock(script, "series", [&] {
        constexpr int rows = 600;
        for (int i = 0; i <= rows; ++i) {
            const VoyageSample& sample = sampleNear(picture, from + (to - from) * i / rows);
            script << sample.time << ' ' << sample.elevation << ' ' << sample.heave << ' '
                   << sample.pitch * degrees << ' ' << sample.roll * degrees << ' '
                   << slopeAlong(picture, sample) << '\n';
        }
    });
}

void writeSpectra(std::ostream& script, const Picture& picture) {
    const Responses& r = picture.responses;
    dataBlock(script, "spectra", [&] {
        for (std::size_t i = 1; i < r.elevation.spectrum.density.size(); ++i)
            script << r.elevation.spectrum.frequency(i) << ' ' << r.elevation.spectrum.density[i] << ' '
                   << r.heave.spectrum.density[i] << ' ' << r.pitch.spectrum.density[i] << ' '
                   << r.roll.spectrum.density[i] << '\n';
    });
    dataBlock(script, "asked", [&] {
        for (int i = 1; i <= 400; ++i) {
            const double frequency = 4.0 * i / 400 / picture.sea.def().period;
            script << frequency << ' ' << picture.sea.spectralDensity(frequency) << '\n';
        }
    });
}

constexpr const char* style = R"gnuplot(
set multiplot
set border lc rgb '#888888'
set tics textcolor rgb '#333333' nomirror
set lmargin at screen 0.09
set rmargin at screen 0.97
)gnuplot";

/// 1 on the first panel's axes is the same both ways: it is 792 wide.
void drawMoments(std::ostream& script, const Picture& picture) {
    const double length = picture.boat.size.x();
    const double width = 2 * reach * length, height = moments * rowHeight * length;
    const double top = 0.955, share = 792 * height / width / pictureHeight;
    script << "set title 'The boat in the highest waves at the probe, a quarter of a period apart; to scale, "
              "bow to the right' textcolor rgb '#333333'\n"
           << "set tmargin at screen " << top << "\nset bmargin at screen " << top - share << '\n'
           << "set xrange [" << -width / 2 << ':' << width / 2 << "]\nset yrange ["
           << -(moments - 0.45) * rowHeight * length << ':' << 0.45 * rowHeight * length
           << "]\nunset xtics\nunset ytics\nplot ";
    for (int i = 0; i < moments; ++i) {
        const std::string n = std::to_string(i);
        script
            << (i > 0 ? ", " : "") << "$hull" << n
            << " with filledcurves closed fc rgb '#d9a066' fs solid border lc rgb '#6b4a24' notitle, $bottom"
            << n << " with filledcurves closed fc rgb '#b5483a' fs solid noborder notitle, $water" << n
            << " using 1:2:3 with filledcurves fc rgb '#7fb8de' fs transparent solid 0.55 noborder notitle, "
               "$water"
            << n << " using 1:2 with lines lw 1.5 lc rgb '#2a7ab5' notitle";
    }
    script << '\n';
}

constexpr const char* motions = R"gnuplot(
set grid lc rgb '#dddddd' lt 1
set ytics autofreq
set xtics autofreq
set autoscale y
set xrange [*:*] noextend
set key at graph 1, 1.17 right horizontal textcolor rgb '#333333'
set ylabel 'm' textcolor rgb '#333333'
set title 'Water at the probe, and heave' offset -27
set tmargin at screen 0.705
set bmargin at screen 0.56
set format x ''
plot $series using 1:2 with lines lw 2 lc rgb '#2a7ab5' title 'water', \
     $series using 1:3 with lines lw 2 lc rgb '#d1495b' title 'heave'
set title 'Slope of the water along the boat, pitch (bow up), roll' offset -18
set ylabel 'degrees'
set tmargin at screen 0.51
set bmargin at screen 0.365
set format x '%g'
set xlabel 'time (s)' offset 0, 0.5 textcolor rgb '#333333'
plot $series using 1:6 with lines lw 2 lc rgb '#2a7ab5' title 'slope', \
     $series using 1:4 with lines lw 2 lc rgb '#d1495b' title 'pitch', \
     $series using 1:5 with lines lw 2 lc rgb '#4a9d5b' title 'roll'
)gnuplot";

void drawSpectra(std::ostream& script, const Picture& picture) {
    script
        << "set tmargin at screen 0.28\nset bmargin at screen 0.05\nset xrange [0:"
        << 4 / picture.sea.def().period << "]\nset yrange [0:*]\n"
        << "set key inside top right vertical\nset xlabel 'frequency (Hz)'\n"
        << "set rmargin at screen 0.5\nset title 'Spectra of water and heave' offset 0\nset ylabel 'm^2/Hz'\n"
        << "plot ";
    if (!picture.sea.isRegular())
        script << "$asked with filledcurves y1=0 fc rgb '#cfe3f2' title 'asked for', ";
    script << R"gnuplot($spectra using 1:2 with lines lw 2 lc rgb '#2a7ab5' title 'water', \
     $spectra using 1:3 with lines lw 2 lc rgb '#d1495b' title 'heave'
set lmargin at screen 0.6
set rmargin at screen 0.97
set title 'Spectra of pitch and roll' offset 0
set ylabel 'degrees^2/Hz'
plot $spectra using 1:4 with lines lw 2 lc rgb '#d1495b' title 'pitch', \
     $spectra using 1:5 with lines lw 2 lc rgb '#4a9d5b' title 'roll'
unset multiplot
)gnuplot";
}

std::string scriptOf(const Picture& picture, const std::string& file) {
    std::ostringstream script;
    script << scenes::gnuplotOutput(file, 900, pictureHeight, 12);
    const double crest = picture.voyage.samples[highestCrest(picture)].time;
    const double half = drawnPeriods / 2 * picture.sea.def().period;
    const double from = std::max(picture.voyage.samples.front().time, crest - half);
    writeMoments(script, picture, crest);
    writeSeries(script, picture, from, std::min(picture.voyage.samples.back().time, from + 2 * half));
    writeSpectra(script, picture);
    script << style;
    drawMoments(script, picture);
    script << motions;
    drawSpectra(script, picture);
    return script.str();
}

}  // namespace

bool plot(const Picture& picture, const std::string& file) {
    return scenes::runGnuplot(scriptOf(picture, file), "boat_in_waves", file);
}

}  // namespace bullet_buoyancy::demo
