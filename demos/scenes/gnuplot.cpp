#include "scenes/gnuplot.h"

#include <cstdio>
#include <cstdlib>

#ifdef _WIN32
#define popen _popen
#define pclose _pclose
#endif

namespace bullet_buoyancy::scenes {

namespace {

/// For gnuplot's single quotes.
std::string quoted(const std::string& text) {
    std::string result;
    for (char c : text)
        result += c == '\'' ? "''" : std::string(1, c);
    return result;
}

bool isInstalled() {
#ifdef _WIN32
    return std::system("gnuplot --version > NUL 2>&1") == 0;
#else
    return std::system("gnuplot --version > /dev/null 2>&1") == 0;
#endif
}

}  // namespace

std::string gnuplotOutput(const std::string& file, int width, int height, int points) {
    const bool svg = file.back() == 'g' && file[file.size() - 2] == 'v';
    return std::string("set terminal ") + (svg ? "svg" : "pngcairo") + " size " + std::to_string(width) +
           ',' + std::to_string(height) + " background rgb 'white' font 'Sans," + std::to_string(points) +
           "'\nset output '" + quoted(file) + "'\n";
}

bool runGnuplot(const std::string& script, const std::string& demo, const std::string& file) {
    if (!isInstalled()) {
        std::fprintf(stderr, "%s: no plot, since gnuplot is not installed (Debian: gnuplot-nox)\n",
                     demo.c_str());
        return false;
    }
    std::FILE* gnuplot = popen("gnuplot -", "w");
    if (!gnuplot) return false;
    std::fputs(script.c_str(), gnuplot);
    if (pclose(gnuplot) == 0) return true;
    std::fprintf(stderr, "%s: gnuplot could not draw %s\n", demo.c_str(), file.c_str());
    return false;
}

}  // namespace bullet_buoyancy::scenes
