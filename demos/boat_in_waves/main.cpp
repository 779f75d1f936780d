#include <cstdio>
#include <optional>

#include "boat_in_waves/moments.h"
#include "boat_in_waves/options.h"
#include "boat_in_waves/read_mesh.h"
#include "boat_in_waves/responses.h"
#include "boat_in_waves/summary.h"
#include "plots/draw_plot.h"
#include "recording/world_film.h"
#include "scenes/interruption.h"
#include "scenes/progress.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

/// Without a hull, and with a message, if the file's is of no use.
Boat boatOf(const Options& options) {
    LadingDef lading;
    lading.waterDensity = options.sea.density;
    TriangleMesh mesh;
    if (options.hull.empty()) {
        mesh = wigleyMesh(options.wigley);
        lading.displacement = displacementBelowOrigin(mesh);
    } else {
        const std::optional<TriangleMesh> read = readMesh(options.hull);
        if (!read) return {};
        mesh = *read;
        const HullResult result = makeHull(mesh);
        if (result.hull) lading.displacement = options.ratio * result.hull->moments.volume;
    }
    Boat boat = makeBoat(mesh, lading);
    const std::string remarks = boat.status.describe();
    if (remarks != "ok") std::fprintf(stderr, "boat_in_waves: hull: %s\n", remarks.c_str());
    return boat;
}

const char* describe(Mishap mishap) {
    switch (mishap) {
        case Mishap::none:
            return "";
        case Mishap::refused:
            return "the action refused the boat";
        case Mishap::notFinite:
            return "something is not finite";
        case Mishap::capsized:
            return "the boat has capsized";
        case Mishap::sunk:
            return "the boat has sunk";
    }
    return "";
}

bool write(const Options& options, const Boat& boat, Sea& sea, const Voyage& voyage,
           const Responses& responses) {
    const plots::Table series{"series", [&](std::ostream& csv) { writeSeries(csv, voyage); }};
    const plots::Table spectra{"spectra", [&](std::ostream& csv) { writeSpectra(csv, responses, sea); }};
    const plots::Table moments{"moments", [&](std::ostream& csv) { writeMoments(csv, boat, sea, voyage); }};
    const auto wrote = [](const plots::Table& table, const std::string& file) {
        return file.empty() || writeTable(table, "boat_in_waves", file);
    };
    return wrote(series, options.csv) && wrote(spectra, options.spectra) && wrote(moments, options.moments) &&
           (options.plot.empty() ||
            plots::drawPlot("boat_in_waves", {series, spectra, moments}, options.plot));
}

/// Films it, where that is wanted, and tells how far it is.
Voyage sail(const Options& options, const Boat& boat, Sea& sea, recording::WorldFilm& film) {
    const double settling = options.voyage.settling;
    Progress progress(settling + options.voyage.duration, "s");
    return scenes::sail(boat, sea, options.voyage, [&](const BoatInWaves& scene, bool isRecorded) {
        progress.countStep(options.voyage.step);
        progress.reach(settling + scene.time());
        if (isRecorded && options.film.isWanted())
            film.look({scene.world(), sea.water(), scene.time(),
                       [&](const btRigidBody&) { return scene.report(); }});
    });
}

int run(const Options& options) {
    const Boat boat = boatOf(options);
    if (!boat.hull) return 1;
    SeaDef seaDef = options.sea;
    seaDef.gridReach = 1.5 * boat.size.x();
    Sea sea(seaDef);
    if (!sea.status()) {
        std::fprintf(stderr, "boat_in_waves: sea: %s\n", sea.status().describe().c_str());
        return 1;
    }
    printSetting(options, boat, sea);

    const auto cast = [&](const btRigidBody&) {
        return recording::Cast{"boat", recording::Look::red, boat.hull};
    };
    recording::WorldFilm film(options.film.film, cast);
    const Voyage voyage = sail(options, boat, sea, film);
    if (voyage.mishap != Mishap::none) {
        std::fprintf(stderr, "boat_in_waves: %s after %zu steps of the record\n", describe(voyage.mishap),
                     voyage.samples.size());
        return 1;
    }
    constexpr std::size_t fewest = 4;  // samples that have a spectrum
    if (voyage.samples.size() < fewest) return 1;
    const Responses responses = respond(voyage, options.voyage.step, options.sea.period);
    printSummary(options, boat, sea, voyage, responses);
    if (!write(options, boat, sea, voyage, responses)) return 1;
    if (options.film.isWanted() && !writeFilm(film.film(), options.film, "boat_in_waves")) return 1;
    return 0;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    int exitStatus = 0;
    const auto options = bullet_buoyancy::demo::parseOptions(argc, argv, exitStatus);
    if (!options) return exitStatus;
    return bullet_buoyancy::scenes::runInterruptibly("boat_in_waves",
                                                     [&] { return bullet_buoyancy::demo::run(*options); });
}
