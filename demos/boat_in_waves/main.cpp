#include <cstdio>
#include <optional>

#include "boat_in_waves/options.h"
#include "boat_in_waves/plot.h"
#include "boat_in_waves/read_mesh.h"
#include "boat_in_waves/responses.h"
#include "boat_in_waves/summary.h"
#include "recording/world_film.h"

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

bool write(const Options& options, const Voyage& voyage, const Responses& responses, const Sea& sea) {
    const auto wrote = [](bool done, const std::string& file) {
        if (!done) std::fprintf(stderr, "boat_in_waves: cannot write %s\n", file.c_str());
        return done;
    };
    return (options.csv.empty() || wrote(writeSeries(voyage, options.csv), options.csv)) &&
           (options.spectra.empty() || wrote(writeSpectra(responses, sea, options.spectra), options.spectra));
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
    const Voyage voyage = sail(boat, sea, options.voyage, [&](const BoatInWaves& scene) {
        if (options.film.isWanted())
            film.look({scene.world(), sea.water(), scene.time(),
                       [&](const btRigidBody&) { return scene.report(); }});
    });
    if (voyage.mishap != Mishap::none) {
        std::fprintf(stderr, "boat_in_waves: %s after %zu steps of the record\n", describe(voyage.mishap),
                     voyage.samples.size());
        return 1;
    }
    const Responses responses = respond(voyage, options.voyage.step, options.sea.period);
    printSummary(options, boat, sea, voyage, responses);
    if (!write(options, voyage, responses, sea)) return 1;
    if (!options.plot.empty() && !plot({boat, sea, voyage, responses}, options.plot)) return 1;
    if (options.film.isWanted() && !writeFilm(film.film(), options.film, "boat_in_waves")) return 1;
    return 0;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    int exitStatus = 0;
    const auto options = bullet_buoyancy::demo::parseOptions(argc, argv, exitStatus);
    return options ? bullet_buoyancy::demo::run(*options) : exitStatus;
}
