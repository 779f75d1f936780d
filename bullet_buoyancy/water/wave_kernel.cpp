// Compiled once for each instruction set: see core/lanes.h.

#include <utility>

#include "bullet_buoyancy/core/exp.h"
#include "bullet_buoyancy/core/sin_cos.h"
#include "bullet_buoyancy/water/wave_kernels.h"

namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

namespace {

using Numbers = Lanes<double>;

constexpr double largestDepth = 0x1.fffffffffffffp1023;  // of those that are not infinite

/// As many components as fit into a register.
struct Waves {
    Numbers a, k, kx, ky, ax, ay, frequency, phase, evenShare, orbit;

    Waves(const WaveLanes& waves, int lane)
        : a(load(waves.amplitude.lane + lane)),
          k(load(waves.wavenumber.lane + lane)),
          kx(load(waves.wavenumberX.lane + lane)),
          ky(load(waves.wavenumberY.lane + lane)),
          ax(load(waves.amplitudeX.lane + lane)),
          ay(load(waves.amplitudeY.lane + lane)),
          frequency(load(waves.frequency.lane + lane)),
          phase(load(waves.phase.lane + lane)),
          evenShare(load(waves.evenShare.lane + lane)),
          orbit(load(waves.orbit.lane + lane)) {}

    SinCos at(double x, double y, double time) const {
        return sinCos(kx * x + ky * y + (phase - frequency * time));
    }
};

/// Sums over all components, to which `add(waves, sums)` adds those of a register. `index`: which of the sums
/// are asked for, spelled out so that the compiler keeps sums in registers.
template <int count, typename Add, int... index>
void sumUp(const WavesAtTime& waves, double (&result)[count], std::integer_sequence<int, index...>,
           const Add& add) {
    WaveRow rows[sizeof...(index)];
    for (int lane = 0; lane < waveLaneCount; lane += laneCount<double>) {
        Numbers sums[count] = {};
        for (int i = 0; i < waves.count; ++i)
            add(Waves(waves.lanes[i], lane), sums);
        (store<double>(sums[index], rows[index].lane + lane), ...);
    }
    ((result[index] = sumOfEight(rows[index].lane)), ...);
}

template <int used>
constexpr std::make_integer_sequence<int, used> first;

void surface(const WavesAtTime& waves, double x, double y, double (&result)[3]) {
    sumUp(waves, result, first<3>, [&](const Waves& wave, Numbers(&sums)[3]) {
        auto& [elevation, slopeX, slopeY] = sums;
        const auto [sine, cosine] = wave.at(x, y, waves.time);
        const Numbers height = wave.a * sine;
        elevation += wave.a * cosine;
        slopeX -= wave.kx * height;
        slopeY -= wave.ky * height;
    });
}

void bentSurface(const WavesAtTime& waves, double x, double y, double (&result)[10]) {
    sumUp(waves, result, first<10>, [&](const Waves& wave, Numbers(&sums)[10]) {
        auto& [elevation, slopeX, slopeY, xx, xy, yy, xxx, xxy, xyy, yyy] = sums;
        const auto [sine, cosine] = wave.at(x, y, waves.time);
        const Numbers up = wave.a * cosine, back = wave.a * sine;
        elevation += up;
        slopeX -= wave.kx * back;
        slopeY -= wave.ky * back;
        const Numbers squareX = wave.kx * wave.kx, product = wave.kx * wave.ky, squareY = wave.ky * wave.ky;
        xx -= squareX * up;
        xy -= product * up;
        yy -= squareY * up;
        xxx += squareX * wave.kx * back;
        xxy += squareX * wave.ky * back;
        xyy += squareY * wave.kx * back;
        yyy += squareY * wave.ky * back;
    });
}

/// cosh k(depth + s) / cosh(k depth) and sinh k(depth + s) / cosh(k depth).
struct Decay {
    Numbers even, odd;

    Decay(const Waves& waves, double s, double depth) : even(expOf(waves.k * s)), odd(even) {
        if (depth > largestDepth) return;
        const Numbers up = even, down = expOf(waves.k * (-2 * depth - s));
        even = (up + down) * waves.evenShare;
        odd = (up - down) * waves.evenShare;
    }
};

void head(const WavesAtTime& waves, double x, double y, double s, double (&result)[10]) {
    sumUp(waves, result, first<10>, [&](const Waves& wave, Numbers(&sums)[10]) {
        auto& [head, headX, headY, headS, xx, xy, yy, xs, ys, ss] = sums;
        const auto [sine, cosine] = wave.at(x, y, waves.time);
        const Decay decay(wave, s, waves.depth);
        const Numbers even = wave.a * decay.even, odd = wave.a * wave.k * decay.odd;
        const Numbers bend = cosine * even, tilt = sine * even, lift = sine * odd;
        head += bend;
        headX -= wave.kx * tilt;
        headY -= wave.ky * tilt;
        headS += cosine * odd;
        xx -= wave.kx * wave.kx * bend;
        xy -= wave.kx * wave.ky * bend;
        yy -= wave.ky * wave.ky * bend;
        xs -= wave.kx * lift;
        ys -= wave.ky * lift;
        ss += wave.k * wave.k * bend;
    });
}

void velocity(const WavesAtTime& waves, double x, double y, double s, double (&result)[3]) {
    sumUp(waves, result, first<3>, [&](const Waves& wave, Numbers(&sums)[3]) {
        auto& [velocityX, velocityY, velocityZ] = sums;
        const auto [sine, cosine] = wave.at(x, y, waves.time);
        const Decay decay(wave, s, waves.depth);
        const Numbers along = wave.orbit * decay.even * cosine;
        velocityX += wave.ax * along;
        velocityY += wave.ay * along;
        velocityZ += wave.a * wave.orbit * decay.odd * sine;
    });
}

template <bool withThird>
void trochoid(const WavesAtTime& waves, double restX, double restY, double (&result)[24]) {
    constexpr int used = withThird ? 24 : 15;
    sumUp(waves, result, first<used>, [&](const Waves& wave, Numbers(&sums)[24]) {
        auto& [x, y, z, dx, dy, sagXX, sagXY, sagYY, xx, xy, yy, xxx, xxy, xyy, yyy, fallsXXX, fallsXXY,
               fallsXYY, fallsYYY, xxxx, xxxy, xxyy, xyyy, yyyy] = sums;
        const auto [sine, cosine] = wave.at(restX, restY, waves.time);
        const Numbers kx = wave.kx, ky = wave.ky, height = wave.a * cosine, back = wave.a * sine;
        z += height;
        const Numbers steepX = kx * back, steepY = ky * back;
        dx -= steepX;
        dy -= steepY;
        const Numbers sagX = kx * height, sagY = ky * height;
        sagXX += kx * sagX;
        sagXY += ky * sagX;
        sagYY += ky * sagY;
        const Numbers alongX = wave.ax * cosine, alongY = wave.ay * cosine;
        const Numbers shiftX = wave.ax * sine, shiftY = wave.ay * sine;
        x += shiftX;
        y += shiftY;
        const Numbers squeezeX = kx * alongX, squeezeY = ky * alongY;
        xx += squeezeX;
        xy += ky * alongX;
        yy += squeezeY;
        const Numbers bendX = kx * shiftX, bendY = ky * shiftY;
        xxx += kx * bendX;
        xxy += ky * bendX;
        xyy += kx * bendY;
        yyy += ky * bendY;
        if constexpr (withThird) {
            const Numbers kxx = kx * kx, kxy = kx * ky, kyy = ky * ky;
            fallsXXX += kxx * steepX;
            fallsXXY += kxy * steepX;
            fallsXYY += kxy * steepY;
            fallsYYY += kyy * steepY;
            xxxx += kxx * squeezeX;
            xxxy += kxy * squeezeX;
            xxyy += kyy * squeezeX;
            xyyy += kxy * squeezeY;
            yyyy += kyy * squeezeY;
        }
    });
}

void particle(const WavesAtTime& waves, double restX, double restY, double restZ, double (&result)[16]) {
    sumUp(waves, result, first<16>, [&](const Waves& wave, Numbers(&sums)[16]) {
        auto& [x, y, z, xx, xy, yy, xz, yz, u, v, w, ux, uy, vy, uz, vz] = sums;
        const auto [sineOnTop, cosineOnTop] = wave.at(restX, restY, waves.time);
        const Numbers decay = expOf(wave.k * restZ), sine = sineOnTop * decay, cosine = cosineOnTop * decay;
        const Numbers kx = wave.kx, ky = wave.ky, up = wave.a * cosine, back = wave.a * sine;
        const Numbers backX = wave.ax * sine, backY = wave.ay * sine, upX = wave.ax * cosine,
                      upY = wave.ay * cosine;
        x -= backX;
        y -= backY;
        z += up;
        xx -= kx * upX;
        xy -= ky * upX;
        yy -= ky * upY;
        xz -= kx * back;
        yz -= ky * back;
        u += wave.frequency * upX;
        v += wave.frequency * upY;
        w += wave.frequency * back;
        const Numbers rateX = wave.frequency * kx, rateY = wave.frequency * ky;
        ux -= rateX * backX;
        uy -= rateY * backX;
        vy -= rateY * backY;
        uz += rateX * up;
        vz += rateY * up;
    });
}

void sinCosOfEach(const WaveRow& angles, WaveRow& sines, WaveRow& cosines) {
    for (int lane = 0; lane < waveLaneCount; lane += laneCount<double>) {
        const auto [sine, cosine] = sinCos(load(angles.lane + lane));
        store<double>(sine, sines.lane + lane);
        store<double>(cosine, cosines.lane + lane);
    }
}

void expOfEach(const WaveRow& numbers, WaveRow& powers) {
    for (int lane = 0; lane < waveLaneCount; lane += laneCount<double>)
        store<double>(expOf(load(numbers.lane + lane)), powers.lane + lane);
}

}  // namespace

extern const WaveKernels waveKernels;

const WaveKernels waveKernels = {surface,        bentSurface, head,         velocity, trochoid<false>,
                                 trochoid<true>, particle,    sinCosOfEach, expOfEach};

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
