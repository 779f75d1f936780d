#pragma once

namespace bullet_buoyancy::demo {

/// How much of the program is in memory, bytes; 0 where the system does not tell in /proc.
double residentMemory();

}  // namespace bullet_buoyancy::demo
