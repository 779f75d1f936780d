#pragma once

#include <cstdint>

namespace bullet_buoyancy::fuzz {

/// What the bytes of the evaluators' fuzzer choose among.
enum EvaluatedPart : std::uint8_t {
    cloudPart,
    boxPart,
    ringPart,
    bumpyPart,
    spherePart,
    cylinderPart,
    conePart,
    capsulePart,
    evaluatedParts,
};
enum EvaluatedWater : std::uint8_t { stillWater, airyWater, gerstnerWater, evaluatedWaters };

/// What those of the shapes' fuzzer choose among.
enum ShapeKind : std::uint8_t {
    boxShape,
    sphereShape,
    capsuleShape,
    cylinderShape,
    coneShape,
    multiSphereShape,
    convexHullShape,
    pointCloudShape,
    tetrahedronShape,
    triangleShape,
    convexMeshShape,
    bvhMeshShape,
    scaledMeshShape,
    gimpactMeshShape,
    compoundShape,
    gimpactCompoundShape,
    uniformScalingShape,
    minkowskiShape,
    planeShape,
    emptyShape,
    box2dShape,
    shapeKinds,
};

}  // namespace bullet_buoyancy::fuzz
