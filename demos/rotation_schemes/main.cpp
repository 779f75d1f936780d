#include <cmath>
#include <cstdio>
#include <ostream>
#include <vector>

#include "bullet_buoyancy/hull/hull.h"
#include "plots/draw_plot.h"
#include "rotation_schemes/measure.h"
#include "rotation_schemes/options.h"
#include "scenes/interruption.h"
#include "scenes/progress.h"
#include "scenes/study_hulls.h"

namespace bullet_buoyancy::demo {
namespace {

struct Row {
    SpinCase spin;
    Scheme scheme;
    double time;  ///< of a step, ns
    SchemeError error;

    bool passes() const {
        constexpr double orientation = 1e-3;  // rad: what could be seen
        constexpr double energy = 1e-6;       // what single precision keeps of it in these steps
        return scheme.step != ours().step || (error.orientation <= orientation && error.energy <= energy);
    }
};

const std::vector<SpinCase>& spinCases() {
    static const std::vector<SpinCase> cases{
        {"A box that flips about its middle axis", {0.1, 0.3, 0.5}, {0.01, 5, 0.01}},
        {"A rod that tumbles", {0.05, 0.05, 1}, {3, 0, 6}},
        {"A box that turns by 0.6 rad in 1/60 s", {0.1, 0.3, 0.5}, {20, 23, 19}}};
    return cases;
}

void measure(const RotationOptions& options, std::vector<Row>& rows) {
    scenes::Progress progress(double(spinCases().size() * schemes().size()), "spins");
    for (const SpinCase& spin : spinCases())
        for (const Scheme& scheme : schemes()) {
            scenes::throwIfInterrupted();
            progress.reach(double(rows.size()), scheme.name);
            rows.push_back({spin, scheme, measureTime(scheme, spin, options.dt, options.stepsInABlock),
                            measureError(scheme, spin, options.dt, options.seconds)});
        }
}

void print(const std::vector<Row>& rows, const RotationOptions& options) {
    std::printf("Largest errors in %g s with steps of %.6f s\n", options.seconds, options.dt);
    const std::string* last = nullptr;
    for (const Row& row : rows) {
        if (!last || *last != row.spin.name) {
            const Vec3 &size = row.spin.halfExtents, &spin = row.spin.spin;
            std::printf("\n%s: half extents %g x %g x %g m, spin %g, %g, %g rad/s\n", row.spin.name.c_str(),
                        size.x(), size.y(), size.z(), spin.x(), spin.y(), spin.z());
            std::printf("  %-34s %10s %16s %17s %15s\n", "", "ns a step", "orientation, rad",
                        "energy, relative", "|L|, relative");
        }
        last = &row.spin.name;
        std::printf("  %-34s %10.0f %16.1e %17.1e %15.1e%s\n", row.scheme.name, row.time,
                    row.error.orientation, row.error.energy, row.error.momentum,
                    row.passes() ? "" : "  FAILS");
    }
}

void writeRows(std::ostream& csv, const std::vector<Row>& rows) {
    csv << "case,scheme,ns_a_step,orientation_error_rad,relative_energy_error,relative_momentum_error,"
           "passes\n";
    for (const Row& row : rows)
        csv << '"' << row.spin.name << "\",\"" << row.scheme.name << "\"," << row.time << ','
            << row.error.orientation << ',' << row.error.energy << ',' << row.error.momentum << ','
            << row.passes() << '\n';
}

/// A box that spins by one scheme, where it is seen in the film.
struct FilmedSpin {
    const Scheme& scheme;
    Vec3 principal;
    Tumbler tumbler;
    Vec3 place;  // m
    std::size_t number;
};

/// A row of boxes for each case, a column for each scheme; the library's own is white.
std::vector<FilmedSpin> castOf(recording::Film& film) {
    constexpr double distance = 2.2;  // m
    std::vector<FilmedSpin> spins;
    for (std::size_t row = 0; row < spinCases().size(); ++row) {
        const SpinCase& spin = spinCases()[row];
        const auto hull = makeHull(scenes::boxMesh(2 * spin.halfExtents)).hull;
        for (std::size_t column = 0; column < schemes().size(); ++column) {
            const Scheme& scheme = schemes()[column];
            const auto look = scheme.step == ours().step ? recording::Look::white : recording::Look::wood;
            spins.push_back({scheme, spin.principal(), spin.start(),
                             distance * Vec3(double(column), double(row), 0),
                             film.addBody(spin.name + ": " + scheme.name, look, hull)});
        }
    }
    return spins;
}

bool film(const RotationOptions& options) {
    recording::Film film(options.film.film, WaterFrame::zUp());
    std::vector<FilmedSpin> spins = castOf(film);
    for (long i = 0; i <= std::lround(options.seconds / options.dt) && !scenes::isInterrupted(); ++i) {
        if (const double time = double(i) * options.dt; film.isDue(time)) {
            film.beginFrame(time);
            for (const FilmedSpin& spin : spins)
                film.show(spin.number, {spin.place, spin.tumbler.orientation});
        }
        for (FilmedSpin& spin : spins)
            spin.scheme.step(spin.principal, spin.tumbler, options.dt);
    }
    return writeFilm(&film, options.film, "rotation_schemes");
}

int run(const RotationOptions& options) {
    std::vector<Row> rows;
    scenes::untilInterrupted([&] { measure(options, rows); });
    print(rows, options);
    const plots::Table table{"rows", [&](std::ostream& csv) { writeRows(csv, rows); }};
    if (!options.csv.empty() && !writeTable(table, "rotation_schemes", options.csv)) return 1;
    if (options.film.isWanted() && !scenes::isInterrupted() && !film(options)) return 1;
    for (const Row& row : rows)
        if (!row.passes()) return 1;
    return 0;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    int exitStatus = 0;
    const auto options = bullet_buoyancy::demo::parseRotationOptions(argc, argv, exitStatus);
    if (!options) return exitStatus;
    return bullet_buoyancy::scenes::runInterruptibly("rotation_schemes",
                                                     [&] { return bullet_buoyancy::demo::run(*options); });
}
