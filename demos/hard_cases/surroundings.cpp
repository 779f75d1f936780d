#include "hard_cases/hard_case.h"

namespace bullet_buoyancy::demo {

void addSurroundings(std::vector<HardCase>&) {}

}  // namespace bullet_buoyancy::demo
