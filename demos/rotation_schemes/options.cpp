#include "rotation_schemes/options.h"

#include "scenes/command_line.h"

namespace bullet_buoyancy::demo {

std::optional<RotationOptions> parseRotationOptions(int argc, char** argv, int& exitStatus) {
    RotationOptions options;
    CLI::App app{
        "Spins boxes on which no torque acts by several schemes, and compares their time a step with their\n"
        "errors: of the orientation, against Taylor series in long double; of the energy and of the length\n"
        "of the angular momentum, against those at the start. Exit status 1 if the library's own scheme,\n"
        "turnFreely, is off by more than 0.001 rad or 1e-6 of the energy.",
        "rotation_schemes"};
    app.option_defaults()->always_capture_default();
    app.add_option("--dt", options.dt, "length of a step, s")->check(CLI::Range(1e-4, 0.1));
    app.add_option("--seconds", options.seconds, "simulated time, s")->check(CLI::Range(0.1, 3600.0));
    app.add_option("--block", options.stepsInABlock, "steps in each of the nine blocks that are timed")
        ->check(CLI::Range(1, 100000000));
    app.add_option("--csv", options.csv, "write the table to this file");
    recording::addFilmOptions(app, options.film);
    if (!scenes::parse(app, argc, argv, exitStatus)) return std::nullopt;
    return options;
}

}  // namespace bullet_buoyancy::demo
