#pragma once

#include "bullet_buoyancy/core/body_rows.h"
#include "bullet_buoyancy/core/lane_vector.h"

// Only kernels include this: see core/lanes.h.
namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL {

using Numbers = Lanes<double>;
using Vectors = LaneVector<double>;
using Outcomes = Truths<double>;

inline Numbers load(const BodyRow& row, int lane) {
    return load(row.lane + lane);
}

inline Vectors load(const VectorRows& rows, int lane) {
    return {load(rows.x, lane), load(rows.y, lane), load(rows.z, lane)};
}

inline void store(const Numbers& numbers, BodyRow& row, int lane) {
    store<double>(numbers, row.lane + lane);
}

inline void store(const Vectors& vectors, VectorRows& rows, int lane) {
    store(vectors.x, rows.x, lane);
    store(vectors.y, rows.y, lane);
    store(vectors.z, rows.z, lane);
}

/// The same for all lanes.
inline Vectors spread(const double (&vector)[3]) {
    return {spread(vector[0]), spread(vector[1]), spread(vector[2])};
}

inline Numbers absolute(const Numbers& numbers) {
    return numbers < Numbers{} ? -numbers : numbers;
}

inline Numbers larger(const Numbers& a, const Numbers& b) {
    return a > b ? a : b;
}

inline Numbers largest(const Vectors& v) {
    return larger(larger(absolute(v.x), absolute(v.y)), absolute(v.z));
}

/// All three; NaN is not.
inline Outcomes areWithin(const Vectors& v, const Numbers& limit) {
    const Outcomes x = absolute(v.x) <= limit, y = absolute(v.y) <= limit, z = absolute(v.z) <= limit;
    return x & y & z;
}

/// NaN and infinity survive every sum.
inline Outcomes areFinite(const Vectors& v) {
    return absolute(v.x + v.y + v.z) <= spread(0x1.fffffffffffffp1023);
}

/// Of unit length.
struct Quaternions {
    Vectors vec;
    Numbers w;

    Quaternions conjugate() const { return {{-vec.x, -vec.y, -vec.z}, w}; }
    Quaternions operator*(const Quaternions& o) const {
        return {{w * o.vec.x + vec.x * o.w + vec.y * o.vec.z - vec.z * o.vec.y,
                 w * o.vec.y + vec.y * o.w + vec.z * o.vec.x - vec.x * o.vec.z,
                 w * o.vec.z + vec.z * o.w + vec.x * o.vec.y - vec.y * o.vec.x},
                w * o.w - vec.x * o.vec.x - vec.y * o.vec.y - vec.z * o.vec.z};
    }
};

inline Quaternions load(const QuaternionRows& rows, int lane) {
    return {{load(rows.x, lane), load(rows.y, lane), load(rows.z, lane)}, load(rows.w, lane)};
}

inline void store(const Quaternions& q, QuaternionRows& rows, int lane) {
    store(q.vec.x, rows.x, lane);
    store(q.vec.y, rows.y, lane);
    store(q.vec.z, rows.z, lane);
    store(q.w, rows.w, lane);
}

/// The matrix of a rotation, by rows.
struct Rotations {
    Vectors x, y, z;

    explicit Rotations(const Quaternions& q) {
        const Numbers tx = 2.0 * q.vec.x, ty = 2.0 * q.vec.y, tz = 2.0 * q.vec.z;
        const Numbers twx = tx * q.w, twy = ty * q.w, twz = tz * q.w;
        const Numbers txx = tx * q.vec.x, txy = ty * q.vec.x, txz = tz * q.vec.x;
        const Numbers tyy = ty * q.vec.y, tyz = tz * q.vec.y, tzz = tz * q.vec.z;
        x = {1.0 - (tyy + tzz), txy - twz, txz + twy};
        y = {txy + twz, 1.0 - (txx + tzz), tyz - twx};
        z = {txz - twy, tyz + twx, 1.0 - (txx + tyy)};
    }

    Vectors operator*(const Vectors& v) const { return {x.dot(v), y.dot(v), z.dot(v)}; }
    Vectors transposed(const Vectors& v) const {
        return {x.x * v.x + y.x * v.y + z.x * v.z, x.y * v.x + y.y * v.y + z.y * v.z,
                x.z * v.x + y.z * v.y + z.z * v.z};
    }
};

}  // namespace bullet_buoyancy::BULLET_BUOYANCY_KERNEL
