#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/airy_waves.h"
#include "bullet_buoyancy/water/current.h"
#include "bullet_buoyancy/water/gerstner_waves.h"
#include "bullet_buoyancy/water/height_grid.h"
#include "bullet_buoyancy/water/sea_state.h"
#include "bullet_buoyancy/water/water_sum.h"

namespace bullet_buoyancy::scenes {

enum class SeaKind {
    airy,      ///< one regular linear wave
    gerstner,  ///< one regular trochoidal wave
    jonswap,   ///< irregular: the sum of many linear waves
    grid,      ///< heights and rates of that sum on a grid, set anew in each step, as by a game's own ocean
};

struct SeaDef {
    SeaKind kind = SeaKind::jonswap;
    double height = 1;      ///< significant, or from trough to crest of a regular wave, m
    double period = 6;      ///< of the peak, or of the regular wave, s
    double direction = pi;  ///< the way the waves travel: from x towards y, rad
    double spreading = std::numeric_limits<double>::infinity();  ///< see `SeaStateDef`
    std::uint64_t seed = 1;
    /// Of an irregular sea: twice the library's own, so that their lines are close enough for a smooth
    /// spectrum.
    int components = 128;
    double currentSpeed = 0;           ///< of a uniform current the way the waves travel, m/s
    double density = seaWaterDensity;  ///< kg/m^3
    double gridReach = 20;             ///< of the grid to each side of what floats on it, m
};

/// A sea in deep water, z up.
class Sea {
public:
    explicit Sea(const SeaDef& def);

    /// Why it was refused; a refused sea is flat.
    const WaterStatus& status() const { return m_status; }

    const WaterField& water() const { return *m_water; }
    const SeaDef& def() const { return m_def; }
    bool isRegular() const { return m_def.kind == SeaKind::airy || m_def.kind == SeaKind::gerstner; }

    /// Velocity of the current, m/s.
    Vec3 current() const;

    /// Four standard deviations of the elevation that was asked for, m: of a regular wave sqrt(2) heights, if
    /// it is a sine.
    double significantHeight() const;

    /// Density of the variance of elevation that was asked for at a frequency (Hz), m^2/Hz; 0 for regular
    /// waves.
    double spectralDensity(double frequency) const;

    /// The relative standard deviation of the significant height measured over so many seconds, by chance;
    /// 0 for regular waves.
    double scatterOfHeight(double seconds) const;

    /// To be called before the water is asked for anything near `place` (m) at a time (s): the grid is then
    /// given the heights of that moment. The others need no telling.
    void showAt(const Vec2& place, double time);

    /// Elevation at a place (m) at the time last shown, or any for seas other than the grid's, m.
    double elevation(const Vec2& place, double time) const;

    int gridNodes() const { return m_gridDef.nodesX; }        ///< along either side; 0: no grid
    double gridSpacing() const { return m_gridDef.spacing; }  ///< m

private:
    void makeRegular();
    void makeIrregular();
    void makeGrid();

    SeaDef m_def;
    WaterStatus m_status;
    std::unique_ptr<WaterField> m_waves, m_current, m_sum;
    std::unique_ptr<HeightGrid> m_grid;
    HeightGridDef m_gridDef;
    std::vector<double> m_heights, m_rates;
    const WaterField* m_water = nullptr;
};

}  // namespace bullet_buoyancy::scenes
