#include "bullet_buoyancy/water/pack_waves.h"

#include <cmath>

namespace bullet_buoyancy {

std::vector<WaveLanes> packWaves(const std::vector<WaveComponent>& components, double depth) {
    std::vector<WaveLanes> packed((components.size() + waveLaneCount - 1) / waveLaneCount);
    for (std::size_t i = 0; i < components.size(); ++i) {
        const WaveComponent& wave = components[i];
        WaveLanes& waves = packed[i / waveLaneCount];
        const std::size_t lane = i % waveLaneCount;
        const double x = std::cos(wave.direction), y = std::sin(wave.direction);
        waves.amplitude.lane[lane] = wave.amplitude;
        waves.wavenumber.lane[lane] = wave.wavenumber;
        waves.wavenumberX.lane[lane] = wave.wavenumber * x;
        waves.wavenumberY.lane[lane] = wave.wavenumber * y;
        waves.amplitudeX.lane[lane] = wave.amplitude * x;
        waves.amplitudeY.lane[lane] = wave.amplitude * y;
        waves.frequency.lane[lane] = wave.frequency;
        waves.phase.lane[lane] = wave.phase;
        waves.evenShare.lane[lane] = 1 / (1 + std::exp(-2 * wave.wavenumber * depth));
        waves.orbit.lane[lane] = wave.frequency / std::tanh(wave.wavenumber * depth);
    }
    return packed;
}

}  // namespace bullet_buoyancy
