#include "boat_in_waves/read_mesh.h"

#include <cstdio>

#ifdef BUOYANCY_HAS_ASSIMP
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#endif

namespace bullet_buoyancy::demo {

#ifdef BUOYANCY_HAS_ASSIMP

namespace {

void append(TriangleMesh& result, const aiMesh& mesh) {
    const auto first = std::uint32_t(result.vertices.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        result.vertices.emplace_back(double(mesh.mVertices[i].x), double(mesh.mVertices[i].y),
                                     double(mesh.mVertices[i].z));
    for (unsigned i = 0; i < mesh.mNumFaces; ++i)
        if (const aiFace& face = mesh.mFaces[i]; face.mNumIndices == 3)
            result.triangles.push_back(
                {first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
}

}  // namespace

bool canReadMeshes() {
    return true;
}

std::optional<TriangleMesh> readMesh(const std::string& file) {
    Assimp::Importer importer;
    // assimp's other steps take for granted what is validated: that faces have corners, and those vertices.
    const aiScene* scene = importer.ReadFile(
        file, aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_PreTransformVertices |
                  aiProcess_DropNormals | aiProcess_JoinIdenticalVertices);
    if (!scene) {
        std::fprintf(stderr, "boat_in_waves: %s\n", importer.GetErrorString());
        return std::nullopt;
    }
    TriangleMesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
        append(mesh, *scene->mMeshes[i]);
    return mesh;
}

#else

bool canReadMeshes() {
    return false;
}

std::optional<TriangleMesh> readMesh(const std::string& file) {
    std::fprintf(stderr,
                 "boat_in_waves: cannot read %s: this build is without the library assimp (Debian: "
                 "libassimp-dev)\n",
                 file.c_str());
    return std::nullopt;
}

#endif

}  // namespace bullet_buoyancy::demo
