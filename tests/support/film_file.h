#pragma once

#include <assimp/scene.h>

#include <Eigen/Geometry>
#include <assimp/Importer.hpp>
#include <string>
#include <vector>

#include "bullet_buoyancy/core/math_types.h"
#include "bullet_buoyancy/core/pose.h"
#include "bullet_buoyancy/hull/triangle_mesh.h"

namespace bullet_buoyancy::tests {

/// A .glb file as assimp reads it, which shares no code with what writes it.
class FilmFile {
public:
    explicit FilmFile(const std::string& file) : m_scene(m_importer.ReadFile(file, 0)) {}

    bool isRead() const { return m_scene != nullptr; }
    std::string error() const { return m_importer.GetErrorString(); }
    const aiScene& scene() const { return *m_scene; }

    /// Null where there is none.
    const aiAnimation* animation() const {
        return m_scene->mNumAnimations == 1 ? m_scene->mAnimations[0] : nullptr;
    }
    double secondsOf(double ticks) const { return ticks / animation()->mTicksPerSecond; }
    const aiNode* node(const std::string& name) const { return m_scene->mRootNode->FindNode(name.c_str()); }
    const aiNodeAnim* channel(const std::string& name) const {
        for (unsigned i = 0; i < animation()->mNumChannels; ++i)
            if (name == animation()->mChannels[i]->mNodeName.C_Str()) return animation()->mChannels[i];
        return nullptr;
    }
    const aiMesh& meshOf(const aiNode& node) const { return *m_scene->mMeshes[node.mMeshes[0]]; }

private:
    Assimp::Importer m_importer;
    const aiScene* m_scene;
};

inline Vec3 toVec3(const aiVector3D& v) {
    return {double(v.x), double(v.y), double(v.z)};
}

inline Eigen::Quaterniond toQuaternion(const aiQuaternion& q) {
    return {double(q.w), double(q.x), double(q.y), double(q.z)};
}

/// Of key `key`, where translation and rotation have the same keys.
inline Pose poseAt(const aiNodeAnim& channel, unsigned key) {
    return {toVec3(channel.mPositionKeys[key].mValue), toQuaternion(channel.mRotationKeys[key].mValue)};
}

inline TriangleMesh trianglesOf(const aiMesh& mesh) {
    TriangleMesh result;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
        result.vertices.push_back(toVec3(mesh.mVertices[i]));
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const unsigned* corners = mesh.mFaces[i].mIndices;
        result.triangles.push_back({corners[0], corners[1], corners[2]});
    }
    return result;
}

/// By the divergence theorem, m^3.
inline double volumeOf(const TriangleMesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles)
        sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6;
    return sum;
}

}  // namespace bullet_buoyancy::tests
