#include "bullet_buoyancy/water/wave_lanes.h"

#include <cmath>

namespace bullet_buoyancy {

std::vector<WaveLanes> waveLanes(const std::vector<WaveComponent>& components) {
    std::vector<WaveLanes> lanes((components.size() + laneCount - 1) / laneCount);
    for (std::size_t i = 0; i < components.size(); ++i) {
        const WaveComponent& wave = components[i];
        WaveLanes& group = lanes[i / laneCount];
        const auto lane = Eigen::Index(i % laneCount);
        const double x = std::cos(wave.direction), y = std::sin(wave.direction);
        group.amplitude[lane] = wave.amplitude;
        group.wavenumber[lane] = wave.wavenumber;
        group.wavenumberX[lane] = wave.wavenumber * x;
        group.wavenumberY[lane] = wave.wavenumber * y;
        group.amplitudeX[lane] = wave.amplitude * x;
        group.amplitudeY[lane] = wave.amplitude * y;
        group.frequency[lane] = wave.frequency;
        group.phase[lane] = wave.phase;
    }
    return lanes;
}

double waveMoment(const std::vector<WaveComponent>& components, int power) {
    double sum = 0;
    for (const WaveComponent& wave : components)
        sum += wave.amplitude * std::pow(wave.wavenumber, power);
    return sum;
}

}  // namespace bullet_buoyancy
