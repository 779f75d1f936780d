#include "bullet_buoyancy/hydrostatics/clip_kernels.h"

#include <gtest/gtest.h>

#include <cstring>

#include "bullet_buoyancy/hull/packed_mesh.h"
#include "support/bumpy_mesh.h"
#include "support/instruction_sets.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

PackPlane randomPlane(Random& random) {
    const Vec3 up = random.direction();
    return {{up.x(), up.y(), up.z()}, random.uniform(-1, 1)};
}

template <typename Real>
struct Outcome {
    WetRows<Real> rows{};
    std::vector<std::uint8_t> cut;

    bool operator==(const Outcome& other) const {
        return cut == other.cut && std::memcmp(&rows, &other.rows, sizeof rows) == 0;
    }
};

/// All that the kernels of a set make of a mesh: every pack clipped, every cluster opened.
template <typename Real>
Outcome<Real> outcomeOf(InstructionSet set, const PackedTriangles<Real>& mesh, const PackPlane& plane,
                        WetRowsAsked asked) {
    const ClipKernels<Real>& kernels = clipKernels<Real>(set);
    Outcome<Real> outcome;
    kernels.clip[int(asked)](mesh.packs.data(), nullptr, int(mesh.packs.size()), plane, outcome.rows);
    for (const auto& level : mesh.levels)
        for (const Cluster<Real>& cluster : level) {
            std::uint8_t cut[packSize + 1];
            const int count = kernels.open[int(asked)](cluster, plane, outcome.rows, cut);
            outcome.cut.insert(outcome.cut.end(), cut, cut + count);
        }
    return outcome;
}

template <typename Real>
void expectTheSameFromAllSets() {
    const PackedMesh mesh = packMesh(bumpyMesh(2), Vec3::Zero());
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const PackPlane plane = randomPlane(random);
        for (WetRowsAsked asked : {WetRowsAsked::pressure, WetRowsAsked::all}) {
            const auto portable = outcomeOf(InstructionSet::portable, mesh.in<Real>(), plane, asked);
            for (InstructionSet set : setsOfThisMachine())
                EXPECT_TRUE(outcomeOf(set, mesh.in<Real>(), plane, asked) == portable) << nameOf(set);
        }
    }
}

TEST(ClipKernels, AreTheSameToTheLastBitInSinglePrecision) {
    expectTheSameFromAllSets<float>();
}

TEST(ClipKernels, AreTheSameToTheLastBitInFullPrecision) {
    expectTheSameFromAllSets<double>();
}

/// Corners exactly at the surface, planes along faces, and depths whose products underflow.
TEST(ClipKernels, StayFiniteWhereTheSurfaceGrazesCorners) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    const PackedMesh packed = packMesh(mesh, Vec3::Zero());
    for (double tilt : {0.0, 1e-300, 1e-160, 1e-30, 1e-19, 1e-9})
        for (double height : {0.0, 1e-300, -1e-30, 1e-20, -1e-12, 1.0}) {
            const PackPlane plane{{tilt, -tilt, 1}, height};
            WetRows<float> single{};
            clipKernels<float>().clip[1](packed.single.packs.data(), nullptr, 1, plane, single);
            WetRows<double> full{};
            clipKernels<double>().clip[1](packed.full.packs.data(), nullptr, 1, plane, full);
            float sumSingle = 0;
            double sumFull = 0;
            for (int lane = 0; lane < packSize; ++lane) {
                sumSingle -= single.pressure.depth.lane[lane];
                sumFull -= full.pressure.depth.lane[lane];
            }
            // Of volume 1/6, wholly under water from height 1 on; up to 1e-9 of it below the others.
            const double expected = height == 1 ? 1.0 / 6 : 0;
            EXPECT_NEAR(sumSingle, expected, 1e-7) << tilt << " " << height;
            EXPECT_NEAR(sumFull, expected, 2e-9) << tilt << " " << height;
        }
}

}  // namespace
}  // namespace bullet_buoyancy::test
