#pragma once

#include <cstdint>
#include <limits>

#include "bullet_buoyancy/water/dispersion.h"
#include "bullet_buoyancy/water/wave_component.h"
#include "bullet_buoyancy/water/wave_spectrum.h"

namespace bullet_buoyancy {

/// A sea as sailors and forecasts describe it.
struct SeaStateDef {
    WaveSpectrum spectrum;  ///< height, period and peakedness
    double direction = 0;   ///< mean way the waves travel: from the frame's x towards its y, rad
    /// s of cos^2s(angle / 2) about the mean direction (Longuet-Higgins et al. 1963): some 10 in wind seas,
    /// 25 to 75 in swell, infinite where all crests are parallel; not negative.
    double spreading = std::numeric_limits<double>::infinity();
    WaterDepth water;     ///< gives the wavelengths; make the `AiryWaves` of the same depth
    int components = 64;  ///< above zero
    /// Frequencies run from half that of the peak to this times it: the tail left out beyond 4 has 0.4 % of
    /// the energy, which is given to the others. Above 1. Lower it for smoother or less steep seas.
    double highestFrequency = 4;
    std::uint64_t seed = 1;  ///< of the random phases, directions and frequencies
};

/// The waves of one sea.
struct SeaState {
    std::vector<WaveComponent> components;  ///< for `AiryWaves`, or for `GerstnerWaves` if not too steep
    WaterStatus status;                     ///< refused: there are no components
};

/// One sea of the sort that `def` describes: the same for the same seed on every machine, to rounding.
///
/// Each component has its own frequency and one direction (single summation), so that waves of one frequency
/// do not stand and every place sees the same significant height. Half of the components are spread evenly
/// over the energy, half over the frequencies, each at random within the middle of its bin: the sea does
/// not repeat itself. The sum of amplitude^2 / 2 is exactly the significant height's m0.
SeaState makeSeaState(const SeaStateDef& def);

}  // namespace bullet_buoyancy
