#include "floating_cube/options.h"

#include "scenes/command_line.h"

namespace bullet_buoyancy::demo {

std::optional<Options> parseOptions(int argc, char** argv, int& exitStatus) {
    Options options;
    CLI::App app{
        "Drops a cube into water in a headless Bullet world, floats square logs of many density ratios and\n"
        "flat slabs, and compares what it sees with closed forms. Exit status 1 if any deviation is past "
        "its\n"
        "tolerance.",
        "floating_cube"};
    app.option_defaults()->always_capture_default();
    app.add_option("--dt", options.stepping.dt, "length of a step, s")->check(CLI::Range(1e-4, 0.1));
    app.add_option("--substeps", options.stepping.substeps, "substeps that a step is cut into")
        ->check(CLI::Range(1, 1000));
    app.add_option("--ratio", options.cube.ratio, "density of the cube over the water's")
        ->check(CLI::Range(0.01, 0.99));
    app.add_option("--size", options.cube.size, "edge of the cube, m")->check(CLI::Range(0.05, 100.0));
    app.add_option("--drop", options.cube.dropHeight,
                   "height from which the cube falls, edges above the water")
        ->check(CLI::Range(0.0, 100.0));
    app.add_option("--drag", options.cube.linearDrag, "linear drag of the cube under water, 1/s")
        ->check(CLI::Range(0.0, 1000.0));
    app.add_option("--damping", options.cube.angularDamping, "angular damping of the cube under water, 1/s")
        ->check(CLI::Range(0.0, 1000.0));
    app.add_option("--seconds", options.cube.seconds, "simulated time that the cube is given to settle, s")
        ->check(CLI::Range(1.0, 36000.0));
    app.add_option("--ratio-step", options.ratioStep,
                   "step of the log's sweep of density ratios from 0.05 to 0.95")
        ->check(CLI::Range(0.001, 0.45));
    app.add_option("--csv", options.csv, "write the tables to this file");
    app.add_option("--logs", options.logs, "write how the logs float to this file");
    app.add_option("--fall", options.fall, "write the cube's fall, over time, to this file");
    app.add_option("--plot", options.plot,
                   "draw the cube's fall and the log's tilts into this .png or .svg file")
        ->check(scenes::isPicture);
    recording::addFilmOptions(app, options.film);
    if (!scenes::parse(app, argc, argv, exitStatus)) return std::nullopt;
    return options;
}

}  // namespace bullet_buoyancy::demo
