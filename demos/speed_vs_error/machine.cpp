#include "speed_vs_error/machine.h"

#include <LinearMath/btScalar.h>

#include <fstream>

#include "bullet_buoyancy/bullet/precision.h"

namespace bullet_buoyancy::demo {

namespace {

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
    return "unknown";
}

}  // namespace

std::string describeMachine() {
    return "Processor: " + processor() +
           "\nCompiler:  " BUOYANCY_COMPILER "\nBullet:    " + (sizeof(btScalar) == 8 ? "double" : "single") +
           " precision\n";
}

}  // namespace bullet_buoyancy::demo
