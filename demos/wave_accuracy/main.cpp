#include <cstdio>
#include <ostream>

#include "plots/draw_plot.h"
#include "recording/slide_show.h"
#include "scenes/interruption.h"
#include "scenes/progress.h"
#include "scenes/study_seas.h"
#include "wave_accuracy/options.h"
#include "wave_accuracy/study.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

constexpr double peakPeriod = 6;      // s
constexpr double wavesInAHull = 0.2;  // length of hulls over that of the waves of that period

std::vector<NamedSea> allSeas() {
    StudySeaDef irregular;
    irregular.peakPeriod = peakPeriod;
    StudySeaDef shortCrested = irregular;
    shortCrested.components = 16;
    shortCrested.spreading = 10;
    shortCrested.highestFrequency = 2;
    return {airySea("JONSWAP of 64 waves from 3.5 m on", irregular),
            airySea("short-crested sea of 16 waves from 14 m on", shortCrested)};
}

void printRow(const ToleranceRow& row) {
    std::printf("  %9.0e %9.1e %9.1e %9.1e %7.1f %9.1e %9.1e %8.0f %9.2f %7.2f\n", row.tolerance,
                row.medianError, row.largestError, row.medianBound, 100 * row.shareOver, row.medianTorque,
                row.largestTorque, row.samples, row.microseconds, row.overFlat);
    if (row.brokenBounds > 0)
        std::printf("  ^ in %d cases the force is farther off than its bound says\n", row.brokenBounds);
}

/// A row of the study, and what it is of.
struct AccuracyRow {
    std::string sea;
    StudyHull hull;
    ToleranceRow row;
};

void writeRows(std::ostream& csv, const std::vector<AccuracyRow>& rows) {
    csv << "sea,hull,triangles,tolerance,median_error,largest_error,median_bound,share_over_tolerance,"
           "median_torque_error,largest_torque_error,samples,us,of_flat\n";
    for (const auto& [sea, hull, row] : rows)
        csv << '"' << sea << "\",\"" << hull.name << "\"," << hull.hull->mesh.triangles.size() << ','
            << row.tolerance << ',' << row.medianError << ',' << row.largestError << ',' << row.medianBound
            << ',' << row.shareOver << ',' << row.medianTorque << ',' << row.largestTorque << ','
            << row.samples << ',' << row.microseconds << ',' << row.overFlat << '\n';
}

/// The mesh of a shape may be as fine as it likes: the water is asked no more often.
void printSamplesOfMeshes(const NamedSea& sea, double diameter, int poses, PressureModel pressure) {
    HydrostaticQuery query;
    query.pressure = pressure;
    query.tolerance = 1e-3;
    const StudyHull coarse = icosphere(diameter, 2), fine = icosphere(diameter, 5);
    const std::vector<StudyCase> cases = casesAcross(*sea.water, *coarse.hull, poses);
    const SampleCount few = countSamples(coarse, *sea.water, cases, query),
                      many = countSamples(fine, *sea.water, cases, query);
    std::printf(
        "\n%s, icosphere at a tolerance of %.0e: %.0f samples, %.1f us for 320 triangles, %.0f, %.1f us "
        "for 20480: %.2f times the samples, %.1f times the time\n",
        sea.name.c_str(), query.tolerance, few.samples, few.microseconds, many.samples, many.microseconds,
        many.samples / few.samples, many.microseconds / few.microseconds);
}

/// Some poses of each hull in each sea.
bool film(const std::vector<NamedSea>& seas, double length, const AccuracyOptions& options) {
    constexpr int slides = 5;
    recording::SlideShow show(options.film.film, length);
    for (const NamedSea& sea : seas)
        for (const StudyHull& hull : studyHulls(length))
            show.show(hull.name + ", " + sea.name, recording::Look::orange, hull.hull, *sea.water,
                      casesAcross(*sea.water, *hull.hull, slides), slides);
    return writeFilm(&show.film(), options.film, "wave_accuracy");
}

void printHull(const NamedSea& sea, const StudyHull& hull, const std::vector<ToleranceRow>& rows) {
    std::printf("\n%s, %s of %zu triangles\n", sea.name.c_str(), hull.name.c_str(),
                hull.hull->mesh.triangles.size());
    std::printf("  %9s %9s %9s %9s %7s %9s %9s %8s %9s %7s\n", "tolerance", "force err", "largest", "bound",
                "% over", "torque", "largest", "samples", "us", "of flat");
    for (const ToleranceRow& row : rows)
        printRow(row);
    std::fflush(stdout);
}

void studyAll(const std::vector<NamedSea>& seas, double length, const AccuracyOptions& options,
              std::vector<AccuracyRow>& all) {
    const PressureModel pressure = options.dynamic ? PressureModel::waveDynamic : PressureModel::hydrostatic;
    const std::vector<StudyHull> hulls = studyHulls(length);
    Progress progress(double(seas.size() * hulls.size()) * options.poses, "poses");
    double before = 0;  // poses
    for (const NamedSea& sea : seas)
        for (const StudyHull& hull : hulls) {
            const std::vector<StudyCase> cases = casesAcross(*sea.water, *hull.hull, options.poses);
            const auto reached = [&](std::size_t pose) {
                progress.reach(before + double(pose), hull.name + ", " + sea.name);
            };
            const std::vector<ToleranceRow> rows =
                studyTolerances(hull, *sea.water, cases, pressure, reached);
            before += options.poses;
            progress.clear();
            printHull(sea, hull, rows);
            for (const ToleranceRow& row : rows)
                all.push_back({sea.name, hull, row});
        }
    for (const NamedSea& sea : seas)
        printSamplesOfMeshes(sea, length, options.poses, pressure);
}

int run(const AccuracyOptions& options) {
    const double length = wavesInAHull * deepWaveLength(peakPeriod);
    std::printf(
        "Seas of 1 m and %.0f s; hulls of %.2f m, %.2f of the peak's waves; %d poses; %s pressure.\n"
        "Errors over the weight of water that the whole hull displaces, torques over that times its "
        "length.\n",
        peakPeriod, length, wavesInAHull, options.poses, options.dynamic ? "dynamic" : "hydrostatic");
    const std::vector<NamedSea> seas = allSeas();
    for (const NamedSea& sea : seas)
        std::printf("%s: steepness %.2f\n", sea.name.c_str(), sea.steepness);
    std::vector<AccuracyRow> rows;
    untilInterrupted([&] { studyAll(seas, length, options, rows); });
    const plots::Table table{"rows", [&](std::ostream& csv) { writeRows(csv, rows); }};
    if (!options.csv.empty() && !writeTable(table, "wave_accuracy", options.csv)) return 1;
    if (!options.plot.empty() && !rows.empty() && !plots::drawPlot("wave_accuracy", {table}, options.plot))
        return 1;
    if (options.film.isWanted() && !isInterrupted() && !film(seas, length, options)) return 1;
    int broken = 0;
    for (const AccuracyRow& row : rows)
        broken += row.row.brokenBounds;
    if (broken > 0) std::printf("\n%d bounds do not hold\n", broken);
    return broken > 0;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    int exitStatus = 0;
    const auto options = bullet_buoyancy::demo::parseAccuracyOptions(argc, argv, exitStatus);
    if (!options) return exitStatus;
    return bullet_buoyancy::scenes::runInterruptibly("wave_accuracy",
                                                     [&] { return bullet_buoyancy::demo::run(*options); });
}
