#pragma once

#include <optional>
#include <string>

#include "recording/film_options.h"

namespace bullet_buoyancy::demo {

struct SpeedOptions {
    bool quick = false;  ///< a thinned selection
    std::string csv;     ///< file for the table; empty: none
    std::string plot;    ///< .png or .svg file for the plot; empty: none
    recording::FilmOptions film;
};

/// Reads the command line. No options if the program is to end now, with `exitStatus`: after --help, or on an
/// error, which has been printed.
std::optional<SpeedOptions> parseSpeedOptions(int argc, char** argv, int& exitStatus);

}  // namespace bullet_buoyancy::demo
