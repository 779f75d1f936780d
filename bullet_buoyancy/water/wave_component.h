#pragma once

#include <vector>

#include "bullet_buoyancy/water/water_status.h"

namespace bullet_buoyancy {

/// One long-crested wave: elevation amplitude * cos(k . x - frequency * time + phase), with the vector
/// k = wavenumber * (cos direction, sin direction) in the water's frame.
struct WaveComponent {
    double amplitude = 0;   ///< half the height from trough to crest, m; not negative
    double wavenumber = 1;  ///< 2 pi over the wavelength, 1/m; above zero
    double direction = 0;   ///< the way it travels: from the frame's x towards its y, rad
    double frequency = 0;   ///< angular: 2 pi over the period, rad/s; see dispersion.h
    double phase = 0;       ///< rad; 0: there is a crest at the origin at time 0
};

/// Whether each of them is a wave (see `WaveComponent`).
WaterStatus checkComponents(const std::vector<WaveComponent>& components);

/// Sum over the components of amplitude * wavenumber^power, m^(1 - power).
double waveMoment(const std::vector<WaveComponent>& components, int power);

}  // namespace bullet_buoyancy
