#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "support/film_file.h"

namespace bullet_buoyancy::tests {
namespace {

int failures = 0;

void expect(bool holds, const std::string& what) {
    if (holds) return;
    std::fprintf(stderr, "not so: %s\n", what.c_str());
    ++failures;
}

bool isFinite(const aiVector3D& v) {
    return toVec3(v).allFinite();
}

/// Of a body: closed, turned outward, lit from all sides.
void checkBody(const aiMesh& mesh, const std::string& name) {
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const unsigned* corners = mesh.mFaces[i].mIndices;
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
            return expect(false, name + " has no triangles of no size");
    }
    expect(volumeOf(trianglesOf(mesh)) > 0, name + " encloses something");
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        if (!isFinite(mesh.mVertices[i]) || std::abs(toVec3(mesh.mNormals[i]).norm() - 1) > 1e-5)
            return expect(false, name + " has finite vertices and unit normals");
}

void checkWater(const aiMesh& mesh) {
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        if (!isFinite(mesh.mVertices[i]) || !(mesh.mNormals[i].y > 0) ||
            std::abs(toVec3(mesh.mNormals[i]).norm() - 1) > 1e-5)
            return expect(false, "the water is finite, its normals upward and of unit length");
}

void checkMotion(const FilmFile& file, const aiNodeAnim& channel) {
    const std::string name = channel.mNodeName.C_Str();
    double before = -1;
    for (unsigned i = 0; i < channel.mNumPositionKeys; ++i) {
        const aiVectorKey& key = channel.mPositionKeys[i];
        expect(isFinite(key.mValue), name + " is somewhere");
        expect(key.mTime > before && key.mTime <= file.animation()->mDuration, name + " has keys in order");
        before = key.mTime;
    }
    for (unsigned i = 0; i < channel.mNumRotationKeys; ++i)
        expect(std::abs(toQuaternion(channel.mRotationKeys[i].mValue).norm() - 1) < 1e-5,
               name + " has unit quaternions");
}

void check(const FilmFile& file, unsigned bodies, double seconds) {
    const aiNode& root = *file.scene().mRootNode;
    unsigned waters = 0;
    for (unsigned i = 0; i < root.mNumChildren; ++i) {
        const aiNode& node = *root.mChildren[i];
        const std::string name = node.mName.C_Str();
        const bool isWater = name == "water";
        waters += isWater;
        if (isWater)
            checkWater(file.meshOf(node));
        else
            checkBody(file.meshOf(node), name);
    }
    expect(root.mNumChildren - waters == bodies, "there are " + std::to_string(bodies) + " bodies, but " +
                                                     std::to_string(root.mNumChildren - waters));
    if (!file.animation()) return expect(false, "it moves");
    const double duration = file.secondsOf(file.animation()->mDuration);
    expect(std::abs(duration - seconds) < 1e-3,
           "it lasts " + std::to_string(seconds) + " s, but " + std::to_string(duration));
    for (unsigned i = 0; i < file.animation()->mNumChannels; ++i)
        checkMotion(file, *file.animation()->mChannels[i]);
}

}  // namespace
}  // namespace bullet_buoyancy::tests

/// check_film <file> <bodies> <seconds>: whether a demo's film is sound, as another library reads it.
int main(int argc, char** argv) {
    using namespace bullet_buoyancy::tests;
    if (argc != 4) return 2;
    const FilmFile file(argv[1]);
    if (!file.isRead()) {
        std::fprintf(stderr, "%s\n", file.error().c_str());
        return 1;
    }
    check(file, unsigned(std::atoi(argv[2])), std::atof(argv[3]));
    return failures > 0 ? 1 : 0;
}
