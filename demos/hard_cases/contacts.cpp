#include "hard_cases/hard_case.h"

namespace bullet_buoyancy::demo {

void addContacts(std::vector<HardCase>&) {}

}  // namespace bullet_buoyancy::demo
