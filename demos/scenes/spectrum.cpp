#include "scenes/spectrum.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <unsupported/Eigen/FFT>

#include "bullet_buoyancy/core/constants.h"

namespace bullet_buoyancy::scenes {

namespace {

/// The power of two that is not below `count`, but not above what there is.
std::size_t segmentLength(double count, std::size_t available) {
    std::size_t length = 1;
    while (double(length) < count && 2 * length <= available)
        length *= 2;
    return length;
}

std::vector<double> hannWindow(std::size_t length) {
    std::vector<double> window(length);
    for (std::size_t i = 0; i < length; ++i)
        window[i] = (1 - std::cos(2 * pi * double(i) / double(length))) / 2;
    return window;
}

std::vector<double> windowed(const double* signal, const std::vector<double>& window) {
    const double mean = std::accumulate(signal, signal + window.size(), 0.0) / double(window.size());
    std::vector<double> result(window.size());
    for (std::size_t i = 0; i < window.size(); ++i)
        result[i] = window[i] * (signal[i] - mean);
    return result;
}

}  // namespace

double Spectrum::variance() const {
    return resolution * std::accumulate(density.begin(), density.end(), 0.0);
}

double Spectrum::peakFrequency() const {
    const auto highest = std::max_element(density.begin(), density.end());
    if (density.size() < 3 || highest == density.begin() || highest + 1 == density.end())
        return std::numeric_limits<double>::quiet_NaN();
    const double before = *(highest - 1), after = *(highest + 1);
    const double curvature = before - 2 * *highest + after;
    const double offset = curvature < 0 ? (before - after) / (2 * curvature) : 0;
    return (double(highest - density.begin()) + offset) * resolution;
}

Spectrum spectrumOf(const std::vector<double>& signal, double step, double segment) {
    const std::size_t length = segmentLength(segment / step, signal.size());
    Spectrum result;
    if (length < 4) return result;
    const std::vector<double> window = hannWindow(length);
    const double power = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
    result.resolution = 1 / (double(length) * step);
    result.density.assign(length / 2 + 1, 0);

    Eigen::FFT<double> transform;
    transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    std::vector<std::complex<double>> waves;
    const std::size_t segments = (signal.size() - length) / (length / 2) + 1;
    for (std::size_t s = 0; s < segments; ++s) {
        transform.fwd(waves, windowed(signal.data() + s * (length / 2), window));
        for (std::size_t i = 0; i < result.density.size(); ++i) {
            const bool isOnBothSides = i > 0 && 2 * i < length;
            result.density[i] +=
                (isOnBothSides ? 2 : 1) * std::norm(waves[i]) * step / (power * double(segments));
        }
    }
    return result;
}

double meanOf(const std::vector<double>& signal) {
    return std::accumulate(signal.begin(), signal.end(), 0.0) / double(signal.size());
}

double deviationOf(const std::vector<double>& signal) {
    const double mean = meanOf(signal);
    double sum = 0;
    for (double value : signal)
        sum += (value - mean) * (value - mean);
    return std::sqrt(sum / double(signal.size()));
}

double meanPeriod(const std::vector<double>& signal, double step) {
    const double mean = meanOf(signal);
    double first = 0, last = 0;
    int passages = 0;
    for (std::size_t i = 1; i < signal.size(); ++i) {
        const double before = signal[i - 1] - mean, now = signal[i] - mean;
        if (!(before < 0 && now >= 0)) continue;
        last = (double(i) - now / (now - before)) * step;
        if (++passages == 1) first = last;
    }
    return passages < 2 ? std::numeric_limits<double>::quiet_NaN() : (last - first) / (passages - 1);
}

}  // namespace bullet_buoyancy::scenes
