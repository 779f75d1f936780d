#pragma once

#include "bullet_buoyancy/hull/tessellate.h"
#include "fuzz/input.h"
#include "support/edit_mesh.h"
#include "support/known_solids.h"

namespace bullet_buoyancy::fuzz {

/// What a mesh begins as, and what is done with it then: all that files and modellers do, and more.
enum MeshStart : std::uint8_t { nothing, aBox, aRing, aBall, meshStarts };
enum MeshEdit : std::uint8_t {
    addVertex,
    addTriangle,
    addBox,
    moveVertex,
    splitVertex,  ///< a triangle gets a corner of its own where it was
    turnTriangle,
    removeTriangle,
    repeatTriangle,
    turnAll,
    breakUp,  ///< every triangle gets corners of its own
    scaleAll,
    moveAll,
    strayIndex,
    meshEdits,
};

inline constexpr int mostMeshEdits = 64;
inline constexpr std::size_t mostTriangles = 600;

inline TriangleMesh meshStart(Input& input) {
    switch (input.index(meshStarts)) {
        case aBox:
            return test::boxMesh({1, 1, 1});
        case aRing:
            return test::ringMesh(0.5, 1, 0.5, 3 + input.index(8));
        case aBall:
            return tessellate(Sphere{Vec3::Zero(), 1}, 1);
    }
    return {};
}

inline bool hasStrayIndex(const TriangleMesh& mesh) {
    for (const Triangle& triangle : mesh.triangles)
        for (std::uint32_t corner : triangle)
            if (corner >= mesh.vertices.size()) return true;
    return false;
}

inline void edit(TriangleMesh& mesh, Input& input) {
    const int edit = input.index(meshEdits);
    std::vector<Vec3>& vertices = mesh.vertices;
    std::vector<Triangle>& triangles = mesh.triangles;
    const auto aVertex = [&] { return std::uint32_t(input.bits<std::uint16_t>() % vertices.size()); };
    const auto aTriangle = [&] { return input.bits<std::uint16_t>() % triangles.size(); };
    if (edit == addVertex) vertices.push_back(input.vector());
    if (edit == addBox) {
        const Vec3 size = input.vector();
        mesh = test::joined(std::move(mesh), test::boxMesh(size, input.vector()));
    }
    if (edit == breakUp && !hasStrayIndex(mesh)) mesh = test::soup(mesh);
    if (edit == turnAll) mesh = test::inverted(std::move(mesh));
    if (edit == scaleAll || edit == moveAll) {
        const Vec3 by = input.vector();
        for (Vec3& vertex : vertices)
            vertex = edit == moveAll ? Vec3(vertex + by) : vertex.cwiseProduct(by);
    }
    if (vertices.empty()) return;
    if (edit == addTriangle) {
        const std::uint32_t a = aVertex(), b = aVertex();
        triangles.push_back({a, b, aVertex()});
    }
    if (edit == moveVertex) {
        const std::uint32_t vertex = aVertex();
        vertices[vertex] = input.vector();
    }
    if (triangles.empty()) return;
    const std::size_t at = aTriangle();
    if (edit == splitVertex) {
        std::uint32_t& corner = triangles[at][std::size_t(input.index(3))];
        if (corner < vertices.size()) vertices.push_back(Vec3(vertices[corner]));
        corner = std::uint32_t(vertices.size() - 1);
    }
    if (edit == turnTriangle) triangles[at] = test::turned(triangles[at]);
    if (edit == removeTriangle) triangles.erase(triangles.begin() + std::ptrdiff_t(at));
    if (edit == repeatTriangle) triangles.push_back(Triangle(triangles[at]));
    if (edit == strayIndex) triangles[at][std::size_t(input.index(3))] = input.bits<std::uint32_t>();
}

/// Any mesh.
inline TriangleMesh readMesh(Input& input) {
    TriangleMesh mesh = meshStart(input);
    const int edits = input.index(mostMeshEdits);
    for (int i = 0; i < edits && !input.isAtEnd(); ++i) {
        edit(mesh, input);
        if (mesh.triangles.size() > mostTriangles) mesh.triangles.resize(mostTriangles);
    }
    return mesh;
}

}  // namespace bullet_buoyancy::fuzz
