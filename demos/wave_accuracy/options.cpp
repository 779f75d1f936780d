#include "wave_accuracy/options.h"

#include "scenes/command_line.h"

namespace bullet_buoyancy::demo {

std::optional<AccuracyOptions> parseAccuracyOptions(int argc, char** argv, int& exitStatus) {
    AccuracyOptions options;
    CLI::App app{
        "Puts hulls a fifth as long as the waves across the surface of irregular seas, at random, and "
        "measures\n"
        "what a tolerance buys: the true error of force and torque, against adaptive quadrature under the\n"
        "true surface, beside the bound that the evaluation states; points at which the water was asked; "
        "and\n"
        "time, beside that of the same hull in flat water. Exit status 1 if a force is farther off than its\n"
        "bound says.",
        "wave_accuracy"};
    app.option_defaults()->always_capture_default();
    app.add_option("--poses", options.poses, "poses of each hull in each sea")->check(CLI::Range(1, 100000));
    app.add_flag("--dynamic", options.dynamic, "pressure of the undisturbed waves, instead of hydrostatic");
    app.add_option("--csv", options.csv, "write the table to this file");
    app.add_option("--plot", options.plot,
                   "draw errors, bounds, samples and time against the tolerance into this .png or .svg file")
        ->check(scenes::isPicture);
    recording::addFilmOptions(app, options.film);
    if (!scenes::parse(app, argc, argv, exitStatus)) return std::nullopt;
    return options;
}

}  // namespace bullet_buoyancy::demo
