#include "bullet_buoyancy/water/wave_component.h"

#include <cmath>

namespace bullet_buoyancy {

WaterStatus checkComponents(const std::vector<WaveComponent>& components) {
    WaterStatus status;
    for (const WaveComponent& wave : components) {
        for (double number : {wave.amplitude, wave.wavenumber, wave.direction, wave.frequency, wave.phase})
            if (!std::isfinite(number)) status.error = WaterError::notFinite;
        if (wave.amplitude < 0 || wave.wavenumber <= 0) status.error = WaterError::badComponent;
        if (!status.accepted()) return status;
    }
    return status;
}

double waveMoment(const std::vector<WaveComponent>& components, int power) {
    double sum = 0;
    for (const WaveComponent& wave : components)
        sum += wave.amplitude * std::pow(wave.wavenumber, power);
    return sum;
}

}  // namespace bullet_buoyancy
