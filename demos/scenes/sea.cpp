#include "scenes/sea.h"

#include <cmath>

#include "bullet_buoyancy/water/dispersion.h"

namespace bullet_buoyancy::scenes {

namespace {

/// The grid takes no waves shorter than four of its spacings, at this times the frequency of the peak.
constexpr double gridHighestFrequency = 3;
constexpr double spacingsInShortestWave = 4;

WaveSpectrum spectrumOf(const SeaDef& def) {
    WaveSpectrum spectrum;
    spectrum.significantHeight = def.height;
    spectrum.peakPeriod = def.period;
    return spectrum;
}

}  // namespace

Sea::Sea(const SeaDef& def) : m_def(def) {
    m_gridDef.nodesX = m_gridDef.nodesY = 0;
    if (isRegular())
        makeRegular();
    else
        makeIrregular();
    if (def.kind == SeaKind::grid && m_status) makeGrid();

    const WaterField* waves = m_grid ? static_cast<const WaterField*>(m_grid.get()) : m_waves.get();
    m_water = waves;
    if (def.currentSpeed == 0) return;
    CurrentDef current;
    current.velocityWorld = this->current();
    m_current = std::make_unique<Current>(WaterFrame::zUp(), current);
    m_sum = std::make_unique<WaterSum>(std::vector<const WaterField*>{waves, m_current.get()}, def.density);
    m_water = m_sum.get();
}

void Sea::makeRegular() {
    WaveComponent wave;
    wave.amplitude = m_def.height / 2;
    wave.frequency = 2 * pi / m_def.period;
    wave.wavenumber = wavenumberOfFrequency(wave.frequency);
    wave.direction = m_def.direction;
    if (m_def.kind == SeaKind::airy) {
        auto waves = std::make_unique<AiryWaves>(
            WaterFrame::zUp(), AiryWavesDef{{wave}, std::numeric_limits<double>::infinity(), m_def.density});
        m_status = waves->status();
        m_waves = std::move(waves);
    } else {
        auto waves =
            std::make_unique<GerstnerWaves>(WaterFrame::zUp(), GerstnerWavesDef{{wave}, m_def.density});
        m_status = waves->status();
        m_waves = std::move(waves);
    }
}

void Sea::makeIrregular() {
    SeaStateDef def;
    def.spectrum = spectrumOf(m_def);
    def.direction = m_def.direction;
    def.spreading = m_def.spreading;
    def.components = m_def.components;
    def.seed = m_def.seed;
    if (m_def.kind == SeaKind::grid) def.highestFrequency = gridHighestFrequency;
    const SeaState state = makeSeaState(def);
    auto waves = std::make_unique<AiryWaves>(
        WaterFrame::zUp(),
        AiryWavesDef{state.components, std::numeric_limits<double>::infinity(), m_def.density});
    m_status = state.status ? waves->status() : state.status;
    m_waves = std::move(waves);
}

void Sea::makeGrid() {
    const double shortest = 2 * pi / wavenumberOfFrequency(gridHighestFrequency * 2 * pi / m_def.period);
    m_gridDef.spacing = shortest / spacingsInShortestWave;
    m_gridDef.nodesX = m_gridDef.nodesY = 2 * int(std::ceil(m_def.gridReach / m_gridDef.spacing)) + 4;
    m_gridDef.density = m_def.density;
    const std::size_t nodes = std::size_t(m_gridDef.nodesX) * std::size_t(m_gridDef.nodesY);
    m_heights.resize(nodes);
    m_rates.resize(nodes);
    m_grid = std::make_unique<HeightGrid>(WaterFrame::zUp(), m_gridDef);
    m_status = m_grid->status();
}

Vec3 Sea::current() const {
    return m_def.currentSpeed * Vec3(std::cos(m_def.direction), std::sin(m_def.direction), 0);
}

double Sea::significantHeight() const {
    return isRegular() ? std::sqrt(2.0) * m_def.height : m_def.height;
}

double Sea::spectralDensity(double frequency) const {
    return isRegular() ? 0 : 2 * pi * spectrumOf(m_def).density(2 * pi * frequency);
}

/// Of a Gaussian sea the variance of the measured m0 is the integral of S(f)^2 over the time.
double Sea::scatterOfHeight(double seconds) const {
    if (isRegular()) return 0;
    const double step = 0.002 / m_def.period;
    double m0 = 0, squares = 0;
    for (double f = step; f < 10 / m_def.period; f += step) {
        const double density = spectralDensity(f);
        m0 += step * density;
        squares += step * density * density;
    }
    return std::sqrt(squares / seconds) / m0 / 2;
}

/// Its nodes stay where they are in the world, so that what floats does not feel the grid follow it.
void Sea::showAt(const Vec2& place, double time) {
    if (!m_grid) return;
    const int nodes = m_gridDef.nodesX;
    const double spacing = m_gridDef.spacing;
    const Vec2 origin = spacing * ((place / spacing).array().round() - double(nodes / 2)).matrix();
    if (origin != m_gridDef.origin) {
        m_gridDef.origin = origin;
        *m_grid = HeightGrid(WaterFrame::zUp(), m_gridDef);
    }
    Eigen::ArrayX3d points(nodes, 3), samples(nodes, 3), velocities(nodes, 3);
    for (int y = 0; y < nodes; ++y) {
        for (int x = 0; x < nodes; ++x)
            points.row(x) << origin.x() + x * spacing, origin.y() + y * spacing, 0;
        m_waves->sampleSurface(points.leftCols<2>(), time, samples);
        points.col(2) = samples.col(0);
        m_waves->sampleVelocity(points, time, velocities);
        // In linear waves the surface rises as fast as the water at it.
        const std::size_t row = std::size_t(y) * std::size_t(nodes);
        Eigen::Map<Eigen::ArrayXd>(m_heights.data() + row, nodes) = samples.col(0);
        Eigen::Map<Eigen::ArrayXd>(m_rates.data() + row, nodes) = velocities.col(2);
    }
    m_grid->setHeights(m_heights.data(), m_rates.data());
}

double Sea::elevation(const Vec2& place, double time) const {
    const Eigen::ArrayX2d point = place.transpose().array();
    Eigen::ArrayX3d sample(1, 3);
    m_water->sampleSurface(point, time, sample);
    return sample(0, 0);
}

}  // namespace bullet_buoyancy::scenes
