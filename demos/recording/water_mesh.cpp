#include "recording/water_mesh.h"

namespace bullet_buoyancy::recording {

std::vector<Triangle> waterTriangles() {
    constexpr std::uint32_t nodes = Film::waterNodes;
    std::vector<Triangle> triangles;
    for (std::uint32_t y = 0; y + 1 < nodes; ++y)
        for (std::uint32_t x = 0; x + 1 < nodes; ++x) {
            const std::uint32_t a = y * nodes + x, b = a + 1, c = b + nodes, d = a + nodes;
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    return triangles;
}

Vec3 waterVertex(const Film& film, const FilmedSurface& surface, int node) {
    return film.waterNode(node) + double(surface(node, 0)) * Vec3::UnitY();
}

Vec3 waterNormal(const FilmedSurface& surface, int node) {
    return {-double(surface(node, 1)), 1, double(surface(node, 2))};
}

bool isFlat(const FilmedSurface& surface) {
    return (surface.col(0) == surface(0, 0)).all();
}

}  // namespace bullet_buoyancy::recording
