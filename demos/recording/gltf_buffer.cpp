#include "recording/gltf_buffer.h"

#include <algorithm>
#include <cstring>

namespace bullet_buoyancy::recording {

namespace {

/// The smallest and largest of each component, which positions and times must have.
void setBounds(tinygltf::Accessor& accessor, const std::vector<float>& numbers, std::size_t width) {
    for (std::size_t component = 0; component < width; ++component) {
        float least = numbers[component], most = least;
        for (std::size_t i = component; i < numbers.size(); i += width) {
            least = std::min(least, numbers[i]);
            most = std::max(most, numbers[i]);
        }
        accessor.minValues.push_back(double(least));
        accessor.maxValues.push_back(double(most));
    }
}

}  // namespace

/// All numbers have four bytes, as glTF wants them aligned.
int GltfBuffer::add(const void* data, std::size_t bytes, int target) {
    std::vector<unsigned char>& buffer = m_model.buffers.front().data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = buffer.size();
    view.byteLength = bytes;
    view.target = target;
    buffer.resize(buffer.size() + bytes);
    std::memcpy(buffer.data() + view.byteOffset, data, bytes);
    m_model.bufferViews.push_back(view);
    return int(m_model.bufferViews.size()) - 1;
}

int GltfBuffer::addFloats(const std::vector<float>& numbers, int type, int target) {
    const auto width = std::size_t(tinygltf::GetNumComponentsInType(std::uint32_t(type)));
    tinygltf::Accessor accessor;
    accessor.bufferView = add(numbers.data(), numbers.size() * sizeof(float), target);
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_FLOAT;
    accessor.type = type;
    accessor.count = numbers.size() / width;
    setBounds(accessor, numbers, width);
    m_model.accessors.push_back(accessor);
    return int(m_model.accessors.size()) - 1;
}

int GltfBuffer::addIndices(const std::vector<std::uint32_t>& indices) {
    tinygltf::Accessor accessor;
    accessor.bufferView =
        add(indices.data(), indices.size() * sizeof(std::uint32_t), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.count = indices.size();
    m_model.accessors.push_back(accessor);
    return int(m_model.accessors.size()) - 1;
}

}  // namespace bullet_buoyancy::recording
