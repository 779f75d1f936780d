// Compiled once for each instruction set: see core/lanes.h.

#include "bullet_buoyancy/core/body_lanes.h"
#include "bullet_buoyancy/hydrodynamics/calm_load_kernels.h"

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

namespace {

/// See wetRate.
Numbers wetRateOf(const Numbers& rate, const Numbers& share, const Outcomes& scales) {
    const Numbers none{};
    const Numbers ofWet = scales ? rate * share : rate;
    return share > none ? ofWet : none;
}

void loadOf(const LevelWater& water, const PoseRows& poses, const HullRows& hulls, const FloatingRows& bodies,
            const DisplacementRows& displaced, LoadRows& loads) {
    const Vectors up = spread(water.up), origin = spread(water.origin);
    const Numbers none{}, one = spread(1.0), weightDensity = spread(water.weightDensity);
    constexpr double operations = 16, epsilon = 0x1p-52;  // that round, about
    for (int lane = 0; lane < blockSize; lane += laneCount<double>) {
        const Vectors position = load(poses.position, lane), weight = load(bodies.weight, lane);
        const Vectors moment = Rotations(load(poses.orientation, lane)) * load(displaced.volumeMoment, lane);
        const Numbers volume = load(displaced.volume, lane);
        store(weightDensity * volume * up + weight, loads.force, lane);
        store(weightDensity * moment.cross(up), loads.torque, lane);

        const Numbers ofWater = weightDensity * load(displaced.headVolume, lane),
                      ofWeight = -weight.dot(position - origin);
        store(ofWater + ofWeight, loads.potential, lane);
        store(operations * epsilon * (absolute(ofWater) + absolute(ofWeight)), loads.potentialRounding, lane);

        const Numbers share = volume / load(hulls.volume, lane);
        const Numbers wet = share < one ? share : one;
        const Outcomes scales = load(bodies.scales, lane) > none;
        store(wetRateOf(load(bodies.linearDrag, lane), wet, scales) + load(bodies.airRate, lane),
              loads.dragRate, lane);
        store(wetRateOf(load(bodies.angularDamping, lane), wet, scales), loads.dampingRate, lane);

        const Outcomes isWet = volume != none;
        const Numbers perVolume = 1.0 / (isWet ? volume : one);
        store(volume, loads.displacement, lane);
        store(perVolume * moment, loads.centreFromCom, lane);
        store(weightDensity * load(displaced.error, lane), loads.forceErrorBound, lane);
    }
}

}  // namespace

extern const CalmLoadKernels calmLoadKernels;

const CalmLoadKernels calmLoadKernels = {loadOf};

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
