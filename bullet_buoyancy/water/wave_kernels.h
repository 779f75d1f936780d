#pragma once

#include "bullet_buoyancy/core/instruction_set.h"
#include "bullet_buoyancy/water/wave_lanes.h"

namespace bullet_buoyancy {

/// The loops that the time goes into: sums over all components at a place (x, y in m). Each instruction set
/// sums the same numbers in the same order: results are the same to the last bit.
struct WaveKernels {
    /// Of linear waves: elevation and its slopes x, y.
    void (*surface)(const WavesAtTime& waves, double x, double y, double (&sums)[3]);

    /// The same, and the elevation's derivatives xx, xy, yy, xxx, xxy, xyy, yyy.
    void (*bentSurface)(const WavesAtTime& waves, double x, double y, double (&sums)[10]);

    /// Head at the height s (m) above the surface, its derivatives x, y, s, xx, xy, yy, xs, ys, ss.
    void (*head)(const WavesAtTime& waves, double x, double y, double s, double (&sums)[10]);

    /// Velocity x, y, z at the height s (m) above the surface.
    void (*velocity)(const WavesAtTime& waves, double x, double y, double s, double (&sums)[3]);

    /// Of trochoids, by the place at which a particle of the surface rests: what it is displaced by against
    /// the waves' travel, x and y; elevation; its derivatives x, y, and minus those xx, xy, yy; derivatives
    /// of the displacement xx, xy, yy and minus those xxx, xxy, xyy, yyy. The others are left alone.
    void (*trochoid)(const WavesAtTime& waves, double x, double y, double (&sums)[24]);

    /// The same, and minus the elevation's derivatives xxx, xxy, xyy, yyy and the displacement's xxxx, xxxy,
    /// xxyy, xyyy, yyyy.
    void (*bentTrochoid)(const WavesAtTime& waves, double x, double y, double (&sums)[24]);

    /// Of trochoids at a particle that rests at the height z (m): displacement x, y, z, its derivatives xx,
    /// xy, yy, xz, yz; velocity x, y, z and its derivatives xx, xy, yy, xz, yz.
    void (*particle)(const WavesAtTime& waves, double x, double y, double z, double (&sums)[16]);

    /// Each of eight numbers by itself.
    void (*sinCos)(const WaveRow& angles, WaveRow& sines, WaveRow& cosines);
    void (*exp)(const WaveRow& numbers, WaveRow& powers);
};

const WaveKernels& waveKernels(InstructionSet set = bestInstructionSet());

}  // namespace bullet_buoyancy
