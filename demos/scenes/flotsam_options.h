#pragma once

#include <CLI/CLI.hpp>

#include "scenes/flotsam.h"
#include "scenes/sea.h"

namespace bullet_buoyancy::scenes {

/// Flotsam in a short-crested JONSWAP sea, as demos leave it to the user.
struct FlotsamOptions {
    FlotsamDef scene;
    SeaDef sea;
    double dt = 1.0 / 60;  ///< length of a step, s

    FlotsamOptions() {
        scene.buoyancy.tolerance = 1e-2;
        sea.spreading = 10;
        sea.components = 64;
    }
};

inline void addFlotsamOptions(CLI::App& app, FlotsamOptions& options) {
    app.add_option("--bodies", options.scene.bodies, "pieces")->check(CLI::Range(1, 10000));
    app.add_option("--seed", options.scene.seed, "of the pieces");
    app.add_option("--height", options.sea.height, "significant height of the waves, m")
        ->check(CLI::Range(0.0, 20.0));
    app.add_option("--period", options.sea.period, "of the spectrum's peak, s")->check(CLI::Range(0.5, 30.0));
    app.add_option("--sea-seed", options.sea.seed, "of the waves");
    app.add_option("--dt", options.dt, "length of a step, s")->check(CLI::Range(1e-4, 0.1));
}

}  // namespace bullet_buoyancy::scenes
