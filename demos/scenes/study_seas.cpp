#include "scenes/study_seas.h"

#include <cassert>

#include "bullet_buoyancy/core/constants.h"
#include "bullet_buoyancy/water/airy_waves.h"
#include "bullet_buoyancy/water/gerstner_waves.h"
#include "bullet_buoyancy/water/sea_state.h"
#include "bullet_buoyancy/water/wave_component.h"

namespace bullet_buoyancy::scenes {

namespace {

std::vector<WaveComponent> componentsOf(const StudySeaDef& def) {
    SeaStateDef sea;
    sea.spectrum.significantHeight = def.significantHeight;
    sea.spectrum.peakPeriod = def.peakPeriod;
    sea.components = def.components;
    sea.spreading = def.spreading;
    sea.highestFrequency = def.highestFrequency;
    const SeaState state = makeSeaState(sea);
    assert(state.status);
    return state.components;
}

}  // namespace

NamedSea airySea(const std::string& name, const StudySeaDef& def) {
    AiryWavesDef waves;
    waves.components = componentsOf(def);
    return {name, std::make_shared<AiryWaves>(WaterFrame::zUp(), waves), waveMoment(waves.components, 1)};
}

NamedSea gerstnerSea(const std::string& name, const StudySeaDef& def) {
    GerstnerWavesDef waves;
    waves.components = componentsOf(def);
    const auto water = std::make_shared<GerstnerWaves>(WaterFrame::zUp(), waves);
    assert(water->status());
    return {name, water, water->steepness()};
}

std::vector<NamedSea> threeSeas() {
    StudySeaDef smooth;
    smooth.components = 16;
    smooth.spreading = 10;
    smooth.highestFrequency = 2;
    StudySeaDef irregular;
    irregular.spreading = 10;
    return {gerstnerSea("16 Gerstner waves from 14 m on", smooth),
            airySea("16 Airy waves from 14 m on", smooth),
            airySea("JONSWAP of 64 waves from 3.5 m on", irregular)};
}

double deepWaveLength(double period) {
    return 2 * pi / wavenumberOfFrequency(2 * pi / period);
}

}  // namespace bullet_buoyancy::scenes
