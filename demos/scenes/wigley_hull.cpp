#include "scenes/wigley_hull.h"

#include <algorithm>
#include <cassert>

namespace bullet_buoyancy::scenes {

namespace {

/// Vertices of the grid of stations and waterlines; port and starboard share those of keel and stems.
class WigleyGrid {
public:
    explicit WigleyGrid(const WigleyDef& def) : m_def(def) {
        for (int side : {1, -1})
            for (int i = 0; i <= def.stations; ++i)
                for (int j = 0; j <= def.waterlines + 1; ++j)
                    m_indices.push_back(isShared(i, j) && side < 0 ? index(1, i, j) : add(side, i, j));
    }

    std::uint32_t index(int side, int i, int j) const {
        const int onOneSide = (m_def.stations + 1) * (m_def.waterlines + 2);
        return m_indices[std::size_t((side > 0 ? 0 : onOneSide) + i * (m_def.waterlines + 2) + j)];
    }

    std::vector<Vec3> vertices;

private:
    bool isShared(int i, int j) const { return i == 0 || i == m_def.stations || j == 0; }

    std::uint32_t add(int side, int i, int j) {
        const double x = double(2 * i - m_def.stations) / m_def.stations;
        const double z = std::min(0.0, double(j - m_def.waterlines) / m_def.waterlines);
        const double y = isShared(i, j) ? 0 : side * (1 - x * x) * (1 - z * z);
        vertices.emplace_back(x * m_def.length / 2, y * m_def.beam / 2,
                              j > m_def.waterlines ? m_def.freeboard : z * m_def.draft);
        return std::uint32_t(vertices.size() - 1);
    }

    WigleyDef m_def;
    std::vector<std::uint32_t> m_indices;
};

/// Counter-clockwise a, b, c on the port side.
void addTriangle(TriangleMesh& mesh, int side, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (side > 0)
        mesh.triangles.push_back({a, b, c});
    else
        mesh.triangles.push_back({a, c, b});
}

/// Diagonals run so that no triangle lies flat in the plane of symmetry, where port and starboard would
/// touch.
void addSide(TriangleMesh& mesh, const WigleyGrid& grid, const WigleyDef& def, int side) {
    for (int i = 0; i < def.stations; ++i)
        for (int j = 0; j <= def.waterlines; ++j) {
            const std::uint32_t a = grid.index(side, i, j), b = grid.index(side, i + 1, j),
                                c = grid.index(side, i + 1, j + 1), d = grid.index(side, i, j + 1);
            if (2 * i < def.stations) {
                addTriangle(mesh, side, a, c, b);
                addTriangle(mesh, side, a, d, c);
            } else {
                addTriangle(mesh, side, a, d, b);
                addTriangle(mesh, side, b, d, c);
            }
        }
}

void addDeck(TriangleMesh& mesh, const WigleyGrid& grid, const WigleyDef& def) {
    const int top = def.waterlines + 1;
    for (int i = 0; i < def.stations; ++i) {
        const std::uint32_t a = grid.index(-1, i, top), b = grid.index(-1, i + 1, top),
                            c = grid.index(1, i + 1, top), d = grid.index(1, i, top);
        if (b != c) mesh.triangles.push_back({a, b, c});
        if (a != d) mesh.triangles.push_back({a, c, d});
    }
}

}  // namespace

TriangleMesh wigleyMesh(const WigleyDef& def) {
    assert(def.stations > 0 && def.stations % 2 == 0 && def.waterlines > 0);
    const WigleyGrid grid(def);
    TriangleMesh mesh;
    mesh.vertices = grid.vertices;
    for (int side : {1, -1})
        addSide(mesh, grid, def, side);
    addDeck(mesh, grid, def);
    return mesh;
}

}  // namespace bullet_buoyancy::scenes
