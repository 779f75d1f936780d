#pragma once

#include <optional>
#include <string>

#include "recording/film_options.h"
#include "scenes/boat_in_waves.h"
#include "scenes/wigley_hull.h"

namespace bullet_buoyancy::demo {

struct Options {
    scenes::SeaDef sea;
    double heading = 180;  ///< degrees; see --help
    scenes::VoyageDef voyage;
    scenes::WigleyDef wigley;  ///< proportions; scaled to `length`
    double length = 10;        ///< of the Wigley hull, m
    std::string hull;          ///< file of another hull; empty: the Wigley hull
    double ratio = 0.4;        ///< of the file's hull: displacement at rest over volume
    bool drifts = false;
    std::string csv, spectra, moments, plot;  ///< files; empty: none
    recording::FilmOptions film;
};

/// Reads the command line. No options if the program is to end now, with `exitStatus`: after --help, or on an
/// error, which has been printed.
std::optional<Options> parseOptions(int argc, char** argv, int& exitStatus);

const char* nameOf(scenes::SeaKind kind);
const char* nameOf(PressureModel pressure);

}  // namespace bullet_buoyancy::demo
