#pragma once

#include <optional>
#include <string>

#include "recording/film_options.h"

namespace bullet_buoyancy::demo {

struct AccuracyOptions {
    int poses = 200;       ///< of each hull in each sea
    bool dynamic = false;  ///< pressure of the undisturbed waves, instead of hydrostatic under the surface
    std::string csv;       ///< file for the table; empty: none
    std::string plot;      ///< PNG or SVG file; empty: none
    recording::FilmOptions film;
};

/// Reads the command line. No options if the program is to end now, with `exitStatus`: after --help, or on an
/// error, which has been printed.
std::optional<AccuracyOptions> parseAccuracyOptions(int argc, char** argv, int& exitStatus);

}  // namespace bullet_buoyancy::demo
