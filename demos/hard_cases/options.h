#pragma once

#include <optional>
#include <string>

#include "recording/film_options.h"

namespace bullet_buoyancy::demo {

struct Options {
    std::string csv;       ///< file for all rows; empty: none
    std::string plot;      ///< PNG or SVG file; empty: none
    std::string only;      ///< run the cases whose name contains this
    bool list = false;     ///< print the names, run nothing
    bool quick = false;    ///< a thinned grid
    bool verbose = false;  ///< a row for each case of a group
    recording::FilmOptions film;
};

/// Reads the command line. No options if the program is to end now, with `exitStatus`: after --help, or on an
/// error, which has been printed.
std::optional<Options> parseOptions(int argc, char** argv, int& exitStatus);

}  // namespace bullet_buoyancy::demo
