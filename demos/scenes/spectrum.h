#pragma once

#include <vector>

namespace bullet_buoyancy::scenes {

/// One-sided spectrum: density of a signal's variance over frequency.
struct Spectrum {
    double resolution = 0;        ///< from one frequency to the next, Hz; 0: the signal was too short
    std::vector<double> density;  ///< at 0, resolution, 2 resolution ...: signal's unit squared per Hz

    double frequency(std::size_t i) const { return double(i) * resolution; }

    /// The integral: the signal's variance.
    double variance() const;

    /// Where the density is highest, from the parabola through its three highest values, Hz.
    double peakFrequency() const;
};

/// By the method of Welch (1967): mean of the periodograms of segments of about `segment` (s), or less if
/// the signal is shorter, which overlap by half, each without its mean, under a Hann window. `step`: between
/// the samples, s.
Spectrum spectrumOf(const std::vector<double>& signal, double step, double segment);

double meanOf(const std::vector<double>& signal);
double deviationOf(const std::vector<double>& signal);  ///< standard

/// Mean period between upward passages of the mean, s; NaN with fewer than two of them.
double meanPeriod(const std::vector<double>& signal, double step);

}  // namespace bullet_buoyancy::scenes
