#include "recording/write_gltf.h"

namespace bullet_buoyancy::recording {

std::string writeGltf(const Film&, const std::string& file) {
    return "cannot write " + file + ": this build is without the library TinyGLTF (Debian: libtinygltf-dev)";
}

}  // namespace bullet_buoyancy::recording
