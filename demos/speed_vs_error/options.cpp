#include "speed_vs_error/options.h"

#include "scenes/command_line.h"

namespace bullet_buoyancy::demo {

std::optional<SpeedOptions> parseSpeedOptions(int argc, char** argv, int& exitStatus) {
    SpeedOptions options;
    CLI::App app{
        "Time against error: evaluates the pressure on hulls that lie across flat water and three seas, at\n"
        "random, by the library's evaluators and by what a game would take instead: the closed form in a\n"
        "plain loop, pressure at centroids, pontoons, voxels. Processor time of one evaluation, median of\n"
        "interleaved blocks, and speed in multiples of the plain loop's; errors of force and torque against\n"
        "the reference. Then the action's share of a substep in worlds of 1,000 bodies. It ends with a hash\n"
        "of the library's results; exit status 1 if any is farther off than its evaluator states.",
        "speed_vs_error"};
    app.option_defaults()->always_capture_default();
    app.add_flag("--quick", options.quick, "fewer hulls, poses and rounds: some seconds");
    app.add_option("--csv", options.csv, "write the table to this file");
    app.add_option("--plot", options.plot, "draw times against errors into this .png or .svg file")
        ->check(scenes::isPicture);
    recording::addFilmOptions(app, options.film);
    if (!scenes::parse(app, argc, argv, exitStatus)) return std::nullopt;
    return options;
}

}  // namespace bullet_buoyancy::demo
