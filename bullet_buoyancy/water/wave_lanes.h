#pragma once

#include <vector>

#include "bullet_buoyancy/core/sin_cos.h"
#include "bullet_buoyancy/water/wave_component.h"

namespace bullet_buoyancy {

/// Wave components that are summed side by side, by vector instructions.
inline constexpr int laneCount = 8;
using Lanes = Eigen::Array<double, laneCount, 1>;

/// So many wave components side by side. Those that fill up the last ones have no amplitude and wavenumber.
///
/// Not aligned: a user's compiler flags may ask Eigen for another alignment than ours did.
struct WaveLanes {
    using Stored = Eigen::Array<double, laneCount, 1, Eigen::DontAlign>;

    Stored amplitude = Stored::Zero();
    Stored wavenumber = Stored::Zero();
    Stored wavenumberX = Stored::Zero(), wavenumberY = Stored::Zero();
    Stored amplitudeX = Stored::Zero(), amplitudeY = Stored::Zero();  ///< times the direction of travel
    Stored frequency = Stored::Zero();
    Stored phase = Stored::Zero();

    /// Sine and cosine of the phase at a place (m) and time (s).
    void sinCosAt(double x, double y, double time, Lanes& sine, Lanes& cosine) const {
        const Lanes angle = wavenumberX * x + wavenumberY * y + (phase - frequency * time);
        sinCos<laneCount>(angle, sine, cosine);
    }
};

std::vector<WaveLanes> waveLanes(const std::vector<WaveComponent>& components);

/// Sum over the components of amplitude * wavenumber^power, m^(1 - power).
double waveMoment(const std::vector<WaveComponent>& components, int power);

}  // namespace bullet_buoyancy
