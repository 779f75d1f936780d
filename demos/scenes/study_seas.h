#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy::scenes {

/// What the seas are made of: JONSWAP spectra in deep water.
struct StudySeaDef {
    double significantHeight = 1;  ///< m
    double peakPeriod = 6;         ///< s
    int components = 64;
    double spreading = std::numeric_limits<double>::infinity();  ///< see `SeaStateDef`
    double highestFrequency = 4;                                 ///< over that of the peak
};

struct NamedSea {
    std::string name;
    std::shared_ptr<const WaterField> water;
    double steepness;  ///< sum of amplitude times wavenumber: the slope if all crests met
};

/// Linear waves, and trochoidal ones: the latter must not be too steep (asserted), see `GerstnerWaves`. The
/// frame is z up.
NamedSea airySea(const std::string& name, const StudySeaDef& def);
NamedSea gerstnerSea(const std::string& name, const StudySeaDef& def);

/// Trochoids and linear waves of a sea of 1 m and 6 s without the short ones, which as Gerstner waves would
/// loop; and a sea with all the short waves of its spectrum.
std::vector<NamedSea> threeSeas();

/// Of deep-water waves of a period (s), m.
double deepWaveLength(double period);

}  // namespace bullet_buoyancy::scenes
