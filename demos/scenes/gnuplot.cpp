#include "scenes/gnuplot.h"

#include <cstdlib>

namespace bullet_buoyancy::scenes {

std::string quotedForGnuplot(const std::string& text) {
    std::string result;
    for (char c : text)
        result += c == '\'' ? "''" : std::string(1, c);
    return result;
}

bool gnuplotIsInstalled() {
#ifdef _WIN32
    return std::system("gnuplot --version > NUL 2>&1") == 0;
#else
    return std::system("gnuplot --version > /dev/null 2>&1") == 0;
#endif
}

}  // namespace bullet_buoyancy::scenes
