#include "bullet_buoyancy/water/wave_spectrum.h"

#include <cmath>

#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy {

double WaveSpectrum::peakFrequency() const {
    return 2 * pi / peakPeriod;
}

double WaveSpectrum::density(double frequency) const {
    if (!(frequency > 0)) return 0;
    const double peak = peakFrequency(), ratio = frequency / peak;
    const double width = ratio <= 1 ? 0.07 : 0.09;
    const double offset = (ratio - 1) / width;
    const double enhancement = std::pow(peakEnhancement, std::exp(-offset * offset / 2));
    return (1 - 0.287 * std::log(peakEnhancement)) * 5.0 / 16 * significantHeight * significantHeight / peak *
           std::pow(ratio, -5) * std::exp(-1.25 * std::pow(ratio, -4)) * enhancement;
}

}  // namespace bullet_buoyancy
