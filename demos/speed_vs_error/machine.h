#pragma once

#include <string>

namespace bullet_buoyancy::demo {

/// What figures of speed depend on: processor, compiler with its flags, precision of Bullet; one a line.
std::string describeMachine();

}  // namespace bullet_buoyancy::demo
