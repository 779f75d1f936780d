#pragma once

#include <cmath>
#include <vector>

#include "bullet_buoyancy/water/dispersion.h"
#include "bullet_buoyancy/water/wave_component.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {

/// Waves of 4 to 60 m in all directions, whose amplitudes times wavenumbers add up to `steepness`.
inline std::vector<WaveComponent> randomWaves(int count, double steepness, Random& random,
                                              const WaterDepth& water = {}) {
    std::vector<WaveComponent> waves;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        WaveComponent wave;
        wave.wavenumber = std::exp(random.uniform(std::log(0.1), std::log(1.6)));
        wave.amplitude = random.uniform(0.1, 1) / wave.wavenumber;
        wave.direction = random.uniform(-pi, pi);
        wave.frequency = frequencyOfWavenumber(wave.wavenumber, water);
        wave.phase = random.uniform(-pi, pi);
        sum += wave.amplitude * wave.wavenumber;
        waves.push_back(wave);
    }
    for (WaveComponent& wave : waves)
        wave.amplitude *= steepness / sum;
    return waves;
}

}  // namespace bullet_buoyancy::test
