#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy::test {

namespace detail {

inline void addPolygon(const std::vector<std::uint32_t>& corners, TriangleMesh& mesh) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

inline TriangleMesh readObj(std::istream& file) {
    TriangleMesh mesh;
    for (std::string line, keyword; std::getline(file, line);) {
        std::istringstream words(line);
        words >> keyword;
        if (keyword == "v") {
            Vec3 vertex;
            words >> vertex.x() >> vertex.y() >> vertex.z();
            mesh.vertices.push_back(vertex);
        } else if (keyword == "f") {
            std::vector<std::uint32_t> corners;
            for (std::string corner; words >> corner;)
                corners.push_back(std::uint32_t(std::stoul(corner) - 1));  // what follows a slash is left
            addPolygon(corners, mesh);
        }
        keyword.clear();
    }
    return mesh;
}

inline TriangleMesh readOff(std::istream& file) {
    TriangleMesh mesh;
    std::string magic;
    std::size_t vertices = 0, faces = 0, edges = 0;
    file >> magic >> vertices >> faces >> edges;
    for (Vec3 vertex; mesh.vertices.size() < vertices && file >> vertex.x() >> vertex.y() >> vertex.z();)
        mesh.vertices.push_back(vertex);
    for (std::size_t face = 0, count = 0; face < faces && file >> count; ++face) {
        std::vector<std::uint32_t> corners(count);
        for (std::uint32_t& corner : corners)
            file >> corner;
        addPolygon(corners, mesh);
    }
    return mesh;
}

inline void addCorner(const Vec3& vertex, TriangleMesh& mesh) {
    mesh.vertices.push_back(vertex);
    const auto count = std::uint32_t(mesh.vertices.size());
    if (count % 3 == 0) mesh.triangles.push_back({count - 3, count - 2, count - 1});
}

inline TriangleMesh readAsciiStl(std::istream& file) {
    TriangleMesh mesh;
    for (std::string word; file >> word;) {
        if (word != "vertex") continue;
        Vec3 vertex;
        file >> vertex.x() >> vertex.y() >> vertex.z();
        addCorner(vertex, mesh);
    }
    return mesh;
}

/// 80 bytes of anything, the number of triangles, and 50 bytes for each: normal, three corners, two spare
/// bytes.
inline TriangleMesh readBinaryStl(const std::string& bytes) {
    TriangleMesh mesh;
    for (std::size_t triangle = 84; triangle + 50 <= bytes.size(); triangle += 50)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            float xyz[3];
            std::memcpy(xyz, bytes.data() + triangle + 12 * (1 + corner), sizeof xyz);
            addCorner({xyz[0], xyz[1], xyz[2]}, mesh);
        }
    return mesh;
}

inline TriangleMesh readStl(std::istream& file) {
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    std::uint32_t triangles = 0;
    if (bytes.size() >= 84) std::memcpy(&triangles, bytes.data() + 80, sizeof triangles);
    if (bytes.size() >= 84 && bytes.size() == 84 + 50 * std::size_t(triangles)) return readBinaryStl(bytes);
    std::istringstream text(bytes);
    return readAsciiStl(text);
}

}  // namespace detail

/// Reads .obj, .off and .stl (binary or text) files; polygons as fans. Empty if there is no such file.
inline TriangleMesh readMeshFile(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (path.extension() == ".obj") return detail::readObj(file);
    if (path.extension() == ".off") return detail::readOff(file);
    return detail::readStl(file);
}

}  // namespace bullet_buoyancy::test
