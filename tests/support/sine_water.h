#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/water_field.h"

namespace bullet_buoyancy::test {

/// amplitude * cos(waveVector . (x, y) - frequency * t + phase)
struct SineWave {
    double amplitude;  ///< m
    Vec2 waveVector;   ///< rad/m
    double frequency;  ///< rad/s
    double phase;      ///< rad
};

/// A sum of cosines written out term by term, to test evaluators with before any fast wave field is trusted.
/// The head of each decays as on deep water, e^{k s}.
class SineWater final : public WaterField {
public:
    explicit SineWater(std::vector<SineWave> waves, const WaterFrame& frame = WaterFrame::zUp())
        : WaterField(frame, freshWaterDensity), m_waves(std::move(waves)) {}

    WaterBounds bounds() const override {
        WaterBounds bounds;
        bounds.curvatureChange = 0;
        bounds.still = false;
        for (const SineWave& wave : m_waves) {
            const double a = std::abs(wave.amplitude), k = wave.waveVector.norm();
            bounds.elevation += a;
            bounds.slope += a * k;
            bounds.curvature += a * k * k;
            bounds.curvatureChange += a * k * k * k;
        }
        return bounds;
    }

    void sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const override {
        samples.setZero();
        for (Eigen::Index i = 0; i < points.rows(); ++i)
            for (const SineWave& wave : m_waves) {
                const double angle = wave.waveVector.x() * points(i, 0) + wave.waveVector.y() * points(i, 1) -
                                     wave.frequency * time + wave.phase;
                const double slope = -wave.amplitude * std::sin(angle);
                samples(i, 0) += wave.amplitude * std::cos(angle);
                samples(i, 1) += slope * wave.waveVector.x();
                samples(i, 2) += slope * wave.waveVector.y();
            }
    }

    void expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const override {
        sampleSurface(points, time, expansions.leftCols<3>());
        expansions.middleCols<3>(3).setZero();
        expansions.col(6) = bounds().curvatureChange;
        for (Eigen::Index i = 0; i < points.rows(); ++i)
            for (const SineWave& wave : m_waves) {
                const Vec2& k = wave.waveVector;
                const double height = wave.amplitude * std::cos(k.x() * points(i, 0) + k.y() * points(i, 1) -
                                                                wave.frequency * time + wave.phase);
                expansions(i, 3) -= height * k.x() * k.x();
                expansions(i, 4) -= height * k.x() * k.y();
                expansions(i, 5) -= height * k.y() * k.y();
            }
    }

    void expandWaveHead(WaterPoints points, double time, HeadExpansions expansions) const override {
        expansions.setZero();
        for (Eigen::Index i = 0; i < points.rows(); ++i)
            for (const SineWave& wave : m_waves) {
                const double kx = wave.waveVector.x(), ky = wave.waveVector.y(), k = wave.waveVector.norm();
                const double angle =
                    kx * points(i, 0) + ky * points(i, 1) - wave.frequency * time + wave.phase;
                const double decayed = wave.amplitude * std::exp(k * points(i, 2));
                const double f = decayed * std::cos(angle), g = -decayed * std::sin(angle);
                expansions.row(i) +=
                    Eigen::Array<double, 1, 10>{{f, g * kx, g * ky, f * k, -f * kx * kx, -f * kx * ky,
                                                 -f * ky * ky, g * kx * k, g * ky * k, f * k * k}};
            }
    }

    double headCurvatureChange(double above) const override {
        double bound = 0;
        for (const SineWave& wave : m_waves) {
            const double k = wave.waveVector.norm();
            // Along a direction with the horizontal part h and the vertical v it is k |v + i h|: not above k.
            bound += std::abs(wave.amplitude) * k * k * k * std::exp(k * above);
        }
        return bound;
    }

    void sampleVelocity(WaterPoints, double, WaterVelocities velocities) const override {
        velocities.setZero();
    }

private:
    std::vector<SineWave> m_waves;
};

/// One wave along the frame's x.
inline SineWave waveAlongX(double amplitude, double waveNumber, double phase = 0) {
    return {amplitude, {waveNumber, 0}, std::sqrt(standardGravity * waveNumber), phase};
}

}  // namespace bullet_buoyancy::test
