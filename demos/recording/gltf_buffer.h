#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <vector>

namespace bullet_buoyancy::recording {

/// Puts numbers into the one buffer of a glTF model; each function returns the number of the accessor.
class GltfBuffer {
public:
    explicit GltfBuffer(tinygltf::Model& model) : m_model(model) { model.buffers.emplace_back(); }

    /// Of `width` numbers an element (TINYGLTF_TYPE_...): vertices, or keys of an animation.
    int addFloats(const std::vector<float>& numbers, int type, int target = 0);

    int addIndices(const std::vector<std::uint32_t>& indices);

private:
    int add(const void* data, std::size_t bytes, int target);

    tinygltf::Model& m_model;
};

}  // namespace bullet_buoyancy::recording
