#pragma once

namespace bullet_buoyancy {

/// Wave components that are summed side by side: as many as the widest register has lanes.
inline constexpr int waveLaneCount = 8;

/// One number of each.
struct alignas(64) WaveRow {
    double lane[waveLaneCount];
};

/// So many wave components side by side, in SI units. Those that fill up the last ones have no amplitude and
/// wavenumber.
struct WaveLanes {
    WaveRow amplitude, wavenumber;
    WaveRow wavenumberX, wavenumberY;
    WaveRow amplitudeX, amplitudeY;  ///< times the direction of travel
    WaveRow frequency, phase;
    WaveRow evenShare;  ///< 1 / (1 + e^(-2 k depth))
    WaveRow orbit;      ///< frequency / tanh(k depth)
};

/// Waves at a time, in water of a depth.
struct WavesAtTime {
    const WaveLanes* lanes;
    int count;     ///< of `lanes`
    double time;   ///< s
    double depth;  ///< m; may be infinite
};

}  // namespace bullet_buoyancy
