#pragma once

#include <optional>
#include <string>

#include "recording/film_options.h"

namespace bullet_buoyancy::demo {

struct RotationOptions {
    double dt = 1.0 / 60;       ///< s
    double seconds = 10;        ///< simulated time
    int stepsInABlock = 20000;  ///< of which the time is taken
    std::string csv;            ///< file for the table; empty: none
    recording::FilmOptions film;
};

/// Reads the command line. No options if the program is to end now, with `exitStatus`: after --help, or on an
/// error, which has been printed.
std::optional<RotationOptions> parseRotationOptions(int argc, char** argv, int& exitStatus);

}  // namespace bullet_buoyancy::demo
