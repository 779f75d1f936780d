#include <cstdio>
#include <fstream>

#include "recording/slide_show.h"
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

void writeRow(std::ofstream& csv, const std::string& sea, const StudyHull& hull, const ToleranceRow& row) {
    csv << '"' << sea << "\",\"" << hull.name << "\"," << hull.hull->mesh.triangles.size() << ','
        << row.tolerance << ',' << row.medianError << ',' << row.largestError << ',' << row.medianBound << ','
        << row.shareOver << ',' << row.medianTorque << ',' << row.largestTorque << ',' << row.samples << ','
        << row.microseconds << ',' << row.overFlat << '\n';
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

int run(const AccuracyOptions& options) {
    const PressureModel pressure = options.dynamic ? PressureModel::waveDynamic : PressureModel::hydrostatic;
    const double length = wavesInAHull * deepWaveLength(peakPeriod);
    std::ofstream csv;
    if (!options.csv.empty()) {
        csv.open(options.csv);
        csv << "sea,hull,triangles,tolerance,median_error,largest_error,median_bound,share_over_tolerance,"
               "median_torque_error,largest_torque_error,samples,us,of_flat\n";
    }
    std::printf(
        "Seas of 1 m and %.0f s; hulls of %.2f m, %.2f of the peak's waves; %d poses; %s pressure.\n"
        "Errors over the weight of water that the whole hull displaces, torques over that times its "
        "length.\n",
        peakPeriod, length, wavesInAHull, options.poses, options.dynamic ? "dynamic" : "hydrostatic");
    const std::vector<NamedSea> seas = allSeas();
    for (const NamedSea& sea : seas)
        std::printf("%s: steepness %.2f\n", sea.name.c_str(), sea.steepness);
    int broken = 0;
    for (const NamedSea& sea : seas)
        for (const StudyHull& hull : studyHulls(length)) {
            std::printf("\n%s, %s of %zu triangles\n", sea.name.c_str(), hull.name.c_str(),
                        hull.hull->mesh.triangles.size());
            std::printf("  %9s %9s %9s %9s %7s %9s %9s %8s %9s %7s\n", "tolerance", "force err", "largest",
                        "bound", "% over", "torque", "largest", "samples", "us", "of flat");
            const std::vector<StudyCase> cases = casesAcross(*sea.water, *hull.hull, options.poses);
            for (const ToleranceRow& row : studyTolerances(hull, *sea.water, cases, pressure)) {
                printRow(row);
                if (csv) writeRow(csv, sea.name, hull, row);
                broken += row.brokenBounds;
            }
            std::fflush(stdout);
        }
    for (const NamedSea& sea : seas)
        printSamplesOfMeshes(sea, length, options.poses, pressure);
    if (options.film.isWanted() && !film(seas, length, options)) return 1;
    if (broken > 0) std::printf("\n%d bounds do not hold\n", broken);
    if (options.csv.empty() || csv.flush()) return broken > 0;
    std::fprintf(stderr, "wave_accuracy: cannot write %s\n", options.csv.c_str());
    return 1;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    int exitStatus = 0;
    const auto options = bullet_buoyancy::demo::parseAccuracyOptions(argc, argv, exitStatus);
    return options ? bullet_buoyancy::demo::run(*options) : exitStatus;
}
