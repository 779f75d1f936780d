#pragma once

#include "recording/film.h"

namespace bullet_buoyancy::recording {

/// A moving surface as a sum: in frame f it is `rest` + sum of weights(f, i) `modes[i]`, slopes included.
struct WaterModes {
    FilmedSurface rest;
    std::vector<FilmedSurface> modes;
    Eigen::ArrayXXf weights;  ///< frames by modes; 0 to 1, since not every player goes beyond
};

/// As few as it takes, greedily, for every elevation to be met within `tolerance` (m). A sea of n linear
/// waves has at most 2 n modes, however long it is filmed. At least one surface.
WaterModes findWaterModes(const std::vector<FilmedSurface>& surfaces, double tolerance);

}  // namespace bullet_buoyancy::recording
