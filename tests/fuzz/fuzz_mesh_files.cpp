// Any file as a mesh that the boat demo reads: an error, or a mesh of its own vertices.

#include <filesystem>
#include <fstream>
#include <random>

#include "boat_in_waves/read_mesh.h"
#include "fuzz/check_hull.h"

namespace bullet_buoyancy::fuzz {
namespace {

/// Chosen by the first byte. The readers of other formats are left to assimp's own fuzzers.
constexpr const char* endings[] = {".obj", ".stl", ".ply", ".off"};

/// For as long as it lives.
class TemporaryFile {
public:
    TemporaryFile(const char* ending, const char* bytes, std::size_t size)
        : m_path(std::filesystem::temp_directory_path() / (name() + ending)) {
        std::ofstream(m_path, std::ios::binary).write(bytes, std::streamsize(size));
    }
    ~TemporaryFile() { std::filesystem::remove(m_path); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    std::string path() const { return m_path.string(); }

private:
    /// Unlike that of another process.
    static const std::string& name() {
        static const std::string unlikely = "bullet_buoyancy_mesh_" + std::to_string(std::random_device()());
        return unlikely;
    }

    std::filesystem::path m_path;
};

}  // namespace
}  // namespace bullet_buoyancy::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace bullet_buoyancy;
    if (size == 0) return 0;
    const char* ending = fuzz::endings[bytes[0] % std::size(fuzz::endings)];
    const fuzz::TemporaryFile file(ending, reinterpret_cast<const char*>(bytes) + 1, size - 1);
    auto mesh = demo::readMesh(file.path());
    if (!mesh) return 0;
    for (const Triangle& triangle : mesh->triangles)
        for (std::uint32_t corner : triangle)
            BUOYANCY_EXPECT(corner < mesh->vertices.size(), "%u of %zu", corner, mesh->vertices.size());
    if (mesh->triangles.size() < 2000) fuzz::checkHull(makeHull(std::move(*mesh)));
    return 0;
}
