#pragma once

#include <array>

#include "bullet_buoyancy/hydrostatics/pack_rows.h"
#include "bullet_buoyancy/water/water_patch.h"

namespace bullet_buoyancy {

/// Those of `MomentRows` of one child.
struct ChildMoments {
    Vec3 normal;
    Mat3 first;
    std::array<Mat3, 3> second;  // second[k](i, j): of x_i x_j n_k

    ChildMoments(const MomentRows<double>& rows, int lane) : normal(vectorOf(rows.normal, lane)) {
        for (int i = 0; i < 3; ++i)
            first.row(i) = vectorOf(rows.first[i], lane);
        int row = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j, ++row)
                for (int k = 0; k < 3; ++k)
                    second[std::size_t(k)](i, j) = second[std::size_t(k)](j, i) =
                        rows.second[row][k].lane[lane];
    }
};

/// A quadratic about the middle of a child's box.
struct LocalQuadratic {
    double value;
    Vec3 gradient;
    const Mat3& bend;
    double reach;   // of the linear part over the box, either way
    double excess;  // the most that the bend adds to it

    LocalQuadratic(const Quadratic& q, const Vec3& offset, const Vec3& halfExtents) : bend(q.bend) {
        const Vec3 turn = q.bend * offset;
        value = q.value + offset.dot(q.gradient + turn / 2);
        gradient = q.gradient + turn;
        reach = gradient.cwiseAbs().dot(halfExtents);
        excess = halfExtents.dot(q.bend.cwiseAbs() * halfExtents) / 2;
    }
};

/// Integrals of a quadratic f over the surface of a child. Third moments, which the bend asks for, are those
/// of a surface that is all in the middle of the box.
struct WeightedMoments {
    double atMiddle;  // f there
    double atOrigin;  // its linear part there
    Vec3 gradient;
    Vec3 normal;  // of f n
    Mat3 first;   // of f x n^T
    Vec3 byBend;  // of (f - its linear part) n

    WeightedMoments(const LocalQuadratic& f, const Vec3& centre, const ChildMoments& moments)
        : atMiddle(f.value), atOrigin(f.value - f.gradient.dot(centre)), gradient(f.gradient) {
        const Vec3 turn = f.bend * centre;
        const double bendOfCentre = turn.dot(centre);
        first = atOrigin * moments.first;
        for (Eigen::Index k = 0; k < 3; ++k) {
            const Mat3& second = moments.second[std::size_t(k)];
            first.col(k) += second * gradient;
            byBend[k] = f.bend.cwiseProduct(second).sum() / 2 - turn.dot(moments.first.col(k)) +
                        bendOfCentre * moments.normal[k] / 2;
        }
        normal = atOrigin * moments.normal + moments.first.transpose() * gradient + byBend;
        first += centre * byBend.transpose();
    }

    Vec3 torque() const {
        return {first(1, 2) - first(2, 1), first(2, 0) - first(0, 2), first(0, 1) - first(1, 0)};
    }
};

}  // namespace bullet_buoyancy
