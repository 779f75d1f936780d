#pragma once

#include <optional>
#include <string>

#include "recording/film_options.h"
#include "scenes/floating_cube.h"

namespace bullet_buoyancy::demo {

struct Options {
    scenes::CubeDef cube;
    scenes::Stepping stepping;
    double ratioStep = 0.05;      ///< of the log's sweep from 0.05 to 0.95
    std::string csv;              ///< file for the tables; empty: none
    std::string logs, fall;       ///< files for the logs and for the cube's fall; empty: none
    std::string plot;             ///< PNG or SVG file; empty: none
    recording::FilmOptions film;  ///< of the cube
};

/// Reads the command line. No options if the program is to end now, with `exitStatus`: after --help, or on an
/// error, which has been printed.
std::optional<Options> parseOptions(int argc, char** argv, int& exitStatus);

}  // namespace bullet_buoyancy::demo
