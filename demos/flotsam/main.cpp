#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "bullet_buoyancy/bullet/convert.h"
#include "recording/film_options.h"
#include "recording/flotsam_cast.h"
#include "recording/shaded_mesh.h"
#include "scenes/command_line.h"
#include "scenes/flotsam.h"
#include "scenes/flotsam_options.h"
#include "scenes/interruption.h"
#include "scenes/progress.h"
#include "scenes/sea.h"
#include "scenes/stopwatch.h"
#include "scenes/study_cases.h"

namespace bullet_buoyancy::demo {
namespace {

using namespace scenes;

struct Options : FlotsamOptions {
    double duration = 30;  // s
    recording::FilmOptions film;
};

/// How far the lowest point of a piece is below the surface above its centre, m.
double draughtOf(const FlotsamScene& scene, const FlotsamPiece& piece) {
    const WaterFrame& frame = scene.water().frame();
    const Pose pose = toPose(piece.body->getWorldTransform());
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec3& vertex : recording::trianglesOf(*piece.hull).vertices)
        lowest = std::min(lowest, frame.pointFromWorld(pose.position + pose.orientation * vertex).z());
    const Vec3 centre = frame.pointFromWorld(pose.position);
    return elevationAt(scene.water(), centre.head<2>(), scene.time()) - lowest;
}

/// Of all pieces of a kind.
struct KindSummary {
    int pieces = 0, wet = 0;
    double ratio = 0, wetFraction = 0, draught = 0;  // sums
};

/// False if anything is not as a sea would leave it.
bool printSummary(const FlotsamScene& scene) {
    KindSummary kinds[flotsamKinds];
    int lost = 0;
    for (const FlotsamPiece& piece : scene.pieces()) {
        const BodyReport report = scene.buoyancy().report(*piece.body);
        lost += report.state != BodyState::floating && report.state != BodyState::submerged &&
                report.state != BodyState::dry;
        KindSummary& kind = kinds[int(piece.kind)];
        ++kind.pieces;
        kind.wet += report.wetFraction > 0;
        kind.ratio += piece.ratio;
        kind.wetFraction += report.wetFraction;
        kind.draught += draughtOf(scene, piece);
    }
    std::printf("\n%-10s %6s %6s %14s %12s %12s\n", "", "pieces", "wet", "density ratio", "under water",
                "draught, m");
    for (int i = 0; i < flotsamKinds; ++i)
        if (const KindSummary& kind = kinds[i]; kind.pieces > 0)
            std::printf("%-10s %6d %6d %14.3f %12.3f %12.3f\n", nameOf(Flotsam(i)), kind.pieces, kind.wet,
                        kind.ratio / kind.pieces, kind.wetFraction / kind.pieces, kind.draught / kind.pieces);
    std::printf("\n%d of %zu bodies lost\n", lost, scene.pieces().size());
    return lost == 0;
}

/// Upward force of the water over the weight of all.
double carriedNow(const FlotsamScene& scene) {
    double force = 0, weight = 0;
    for (const FlotsamPiece& piece : scene.pieces()) {
        force +=
            toEigen(scene.buoyancy().report(*piece.body).forceWorld).dot(scene.water().frame().upWorld());
        weight += standardGravity / double(piece.body->getInvMass());
    }
    return force / weight;
}

int run(const Options& options) {
    Sea sea(options.sea);
    if (!sea.status()) {
        std::fprintf(stderr, "flotsam: sea: %s\n", sea.status().describe().c_str());
        return 1;
    }
    FlotsamScene scene(options.scene, sea.water());
    recording::WorldFilm film(options.film.film,
                              [&](const btRigidBody& body) { return recording::castOf(scene, body); });
    const auto look = [&] {
        if (options.film.isWanted()) film.look(recording::viewOf(scene));
    };
    look();
    const long steps = std::lround(options.duration / options.dt);
    Progress progress(options.duration, "s");
    double clock = 0, carried = 0;
    long carriedSteps = 0;
    for (long i = 0; i < steps && !isInterrupted(); ++i) {
        const double start = wallTime();
        scene.step(options.dt);
        clock += wallTime() - start;
        if (i >= steps / 2) carried += carriedNow(scene), ++carriedSteps;
        look();
        progress.reach(scene.time());
        progress.countStep(options.dt);
    }
    progress.clear();
    std::printf("%d bodies in a JONSWAP sea of %g m and %g s: %g s in %.2f s, %.1f simulated s a s\n",
                options.scene.bodies, options.sea.height, options.sea.period, scene.time(), clock,
                scene.time() / clock);
    const bool allThere = printSummary(scene);
    if (carriedSteps > 0)
        std::printf("The water carries %.3f of their weight, mean of the last half\n",
                    carried / double(carriedSteps));
    if (options.film.isWanted() && !writeFilm(film.film(), options.film, "flotsam")) return 1;
    return allThere ? 0 : 1;
}

}  // namespace
}  // namespace bullet_buoyancy::demo

int main(int argc, char** argv) {
    bullet_buoyancy::demo::Options options;
    CLI::App app{
        "Drops crates, barrels, buoys, fenders, spars, planks, lumps, rafts and a boat into an irregular "
        "sea, "
        "and\ntells how they float. Exit status 1 if any is lost.",
        "flotsam"};
    app.option_defaults()->always_capture_default();
    bullet_buoyancy::scenes::addFlotsamOptions(app, options);
    app.add_option("--duration", options.duration, "simulated time, s")->check(CLI::Range(0.1, 1e6));
    bullet_buoyancy::recording::addFilmOptions(app, options.film);
    int exitStatus = 0;
    if (!bullet_buoyancy::scenes::parse(app, argc, argv, exitStatus)) return exitStatus;
    return bullet_buoyancy::scenes::runInterruptibly("flotsam",
                                                     [&] { return bullet_buoyancy::demo::run(options); });
}
