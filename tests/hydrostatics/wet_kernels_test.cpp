#include "bullet_buoyancy/hydrostatics/wet_kernels.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "bullet_buoyancy/hull/packed_mesh.h"
#include "support/bumpy_mesh.h"
#include "support/random_cases.h"

namespace bullet_buoyancy::test {
namespace {

void fill(PackRow<double>& row, double size, Random& random) {
    for (double& number : row.lane)
        number = random.uniform(-size, size);
}

void fill(QuadraticRows& rows, Random& random) {
    fill(rows.value, 1, random);
    for (PackRow<double>& row : rows.gradient)
        fill(row, 1, random);
    for (PackRow<double>& row : rows.bend)
        fill(row, 0.3, random);
}

/// No two triangles of a pack have the same.
PackWater randomWater(Random& random) {
    PackWater water;
    for (PackRow<double>& row : water.centre)
        fill(row, 1, random);
    fill(water.depth, random);
    fill(water.head, random);
    for (PackRow<double>& row : water.error)
        for (double& coefficient : row.lane)
            coefficient = random.uniform(0, 0.01);
    water.typicalDistance = random.uniform(0.1, 1);
    return water;
}

PackSea randomSea(bool isHydrostatic, Random& random) {
    const Vec3 up = random.direction();
    const double size = random.uniform(0.1, 1);
    return {{up.x(), up.y(), up.z()}, random.uniform(1, 9), {size, size, size}, 0.01, isHydrostatic};
}

struct Outcome {
    HeadRows rows{};
    std::vector<std::uint8_t> left;

    bool operator==(const Outcome& other) const {
        return left == other.left && std::memcmp(&rows, &other.rows, sizeof rows) == 0;
    }
};

Outcome outcomeOf(InstructionSet set, const PackedTriangles<double>& mesh, const PackWater& water,
                  const PackSea& sea, WetRowsAsked asked) {
    Outcome outcome;
    for (const TrianglePack<double>& pack : mesh.packs) {
        std::uint8_t left[packSize];
        const int count = wetKernels(set).addWet[int(asked)](pack, water, sea, outcome.rows, left);
        outcome.left.insert(outcome.left.end(), left, left + count);
    }
    return outcome;
}

TEST(WetKernels, AreTheSameToTheLastBit) {
    const PackedMesh mesh = packMesh(bumpyMesh(2), Vec3::Zero());
    Random random(1);
    std::size_t left = 0;
    double wet = 0;
    for (int i = 0; i < 400; ++i) {
        const PackWater water = randomWater(random);
        const PackSea sea = randomSea(i % 2 == 0, random);
        for (WetRowsAsked asked : {WetRowsAsked::pressure, WetRowsAsked::all}) {
            const Outcome portable = outcomeOf(InstructionSet::portable, mesh.full, water, sea, asked);
            for (InstructionSet set : {InstructionSet::avx2, InstructionSet::avx512}) {
                if (set > bestInstructionSet()) continue;
                EXPECT_TRUE(outcomeOf(set, mesh.full, water, sea, asked) == portable) << nameOf(set);
            }
            left += portable.left.size();
            for (double area : portable.rows.shadow.area.lane)
                wet += area;
        }
    }
    EXPECT_GT(left, 0u);
    EXPECT_GT(wet, 0);
}

}  // namespace
}  // namespace bullet_buoyancy::test
