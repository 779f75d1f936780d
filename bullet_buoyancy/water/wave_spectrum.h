#pragma once

namespace bullet_buoyancy {

/// Energy of a sea's waves over their frequency: JONSWAP (Hasselmann et al. 1973) in the form of
/// DNV-RP-C205 (3.5.5), and at a peak enhancement of 1 that of Pierson and Moskowitz (1964).
struct WaveSpectrum {
    double significantHeight = 1;  ///< m; not negative
    double peakPeriod = 5;         ///< s; above zero
    double peakEnhancement = 3.3;  ///< gamma: 1 for a fully developed sea, 3.3 for a growing one; at least 1

    /// Of the peak, rad/s.
    double peakFrequency() const;

    /// Density of the variance of elevation at an angular frequency (rad/s), m^2 s. Its integral m0 gives the
    /// significant height as 4 sqrt(m0), to 0.2 % for peak enhancements up to 5.
    double density(double frequency) const;
};

}  // namespace bullet_buoyancy
