#include "bullet_buoyancy/water/sea_state.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace bullet_buoyancy {

namespace {

/// The part of the frequency range below the peak that has energy: below half the peak's frequency there is
/// 2e-9 of it.
constexpr double lowestFrequency = 0.5;

/// Intervals in which distributions are integrated; the narrowest peak has some hundred of them.
constexpr int intervals = 4096;

/// The integral of a function, table and inverse.
class Cumulative {
public:
    template <typename Density>
    Cumulative(double begin, double end, const Density& density)
        : m_begin(begin), m_end(end), m_sums(1, 0.0) {
        for (int i = 0; i < intervals; ++i)
            m_sums.push_back(m_sums.back() + density(at(i + 0.5)));
        for (double& sum : m_sums)
            sum /= m_sums.back();
    }

    /// Share of the integral up to x.
    double share(double x) const {
        const double place = (x - m_begin) / (m_end - m_begin) * intervals;
        const int i = std::clamp(int(place), 0, intervals - 1);
        return m_sums[std::size_t(i)] + (place - i) * (m_sums[std::size_t(i) + 1] - m_sums[std::size_t(i)]);
    }

    double ofShare(double share) const {
        const auto above = std::upper_bound(m_sums.begin() + 1, m_sums.end() - 1, share);
        const double low = *(above - 1), step = *above - low;
        return at(double(above - m_sums.begin() - 1) + (step > 0 ? (share - low) / step : 0));
    }

private:
    double at(double place) const { return m_begin + (m_end - m_begin) * place / intervals; }

    double m_begin, m_end;
    std::vector<double> m_sums;
};

/// The engine is specified by the standard, its distributions are not.
class Random {
public:
    explicit Random(std::uint64_t seed) : m_engine(seed) {}

    /// From 0 up to and without 1.
    double share() { return double(m_engine() >> 11) * 0x1p-53; }

private:
    std::mt19937_64 m_engine;
};

WaterStatus check(const SeaStateDef& def) {
    const WaveSpectrum& spectrum = def.spectrum;
    WaterStatus status;
    if (!std::isfinite(spectrum.significantHeight) || !std::isfinite(spectrum.peakPeriod) ||
        !std::isfinite(spectrum.peakEnhancement) || !std::isfinite(def.direction) ||
        !std::isfinite(def.highestFrequency) || std::isnan(def.spreading))
        status.error = WaterError::notFinite;
    else if (!(def.water.depth > 0 && def.water.gravity > 0) || std::isinf(def.water.gravity))
        status.error = WaterError::badDepth;
    else if (spectrum.significantHeight < 0 || spectrum.peakPeriod <= 0 || spectrum.peakEnhancement < 1 ||
             spectrum.peakEnhancement > 20 || def.spreading < 0 || def.components < 1 ||
             def.highestFrequency <= 1)
        status.error = WaterError::badSpectrum;
    return status;
}

/// Angles from the mean direction, as far as the spreading leaves them any probability.
Cumulative directions(double spreading) {
    // cos^2s(angle / 2) is nearly a Gaussian with a deviation of sqrt(2 / s).
    const double widest = std::min(pi, 8 * std::sqrt(2 / std::max(spreading, 0.1)));
    return {-widest, widest, [&](double angle) { return std::pow(std::cos(angle / 2), 2 * spreading); }};
}

}  // namespace

SeaState makeSeaState(const SeaStateDef& def) {
    SeaState sea;
    sea.status = check(def);
    if (!sea.status.accepted()) return sea;

    const double peak = def.spectrum.peakFrequency();
    const double lowest = lowestFrequency * peak, highest = def.highestFrequency * peak;
    WaveSpectrum unit = def.spectrum;
    unit.significantHeight = 1;
    const Cumulative energy(lowest, highest, [&](double w) { return unit.density(w); });
    const Cumulative place(lowest, highest, [&](double w) {
        return (energy.share(w + (highest - lowest) / intervals / 2) -
                energy.share(w - (highest - lowest) / intervals / 2)) +
               1.0 / intervals;
    });
    const bool parallel = std::isinf(def.spreading);
    const Cumulative spread = directions(parallel ? 1 : def.spreading);

    Random random(def.seed);
    const double m0 = def.spectrum.significantHeight * def.spectrum.significantHeight / 16;
    for (int i = 0; i < def.components; ++i) {
        const double jitter = random.share(), turn = random.share(), phase = random.share();
        const double share = energy.share(place.ofShare((i + 1.0) / def.components)) -
                             energy.share(place.ofShare(double(i) / def.components));
        WaveComponent wave;
        wave.frequency = place.ofShare((i + 0.25 + 0.5 * jitter) / def.components);
        wave.wavenumber = wavenumberOfFrequency(wave.frequency, def.water);
        wave.amplitude = std::sqrt(2 * m0 * std::max(share, 0.0));
        wave.direction = def.direction + (parallel ? 0 : spread.ofShare(turn));
        wave.phase = 2 * pi * phase;
        sea.components.push_back(wave);
    }
    return sea;
}

}  // namespace bullet_buoyancy
