#include "soak/resident_memory.h"

#ifdef __linux__
#include <unistd.h>

#include <fstream>
#endif

namespace bullet_buoyancy::demo {

#ifdef __linux__

double residentMemory() {
    double all = 0, resident = 0;  // pages
    std::ifstream("/proc/self/statm") >> all >> resident;
    return resident * double(sysconf(_SC_PAGESIZE));
}

#else

double residentMemory() {
    return 0;
}

#endif

}  // namespace bullet_buoyancy::demo
