#include "plots/draw_plot.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#ifdef _WIN32
#define popen _popen
#define pclose _pclose
#endif

namespace bullet_buoyancy::plots {

namespace {

/// In gnuplot's single quotes.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (char c : text)
        result += c == '\'' ? "''" : std::string(1, c);
    return result + '\'';
}

bool isInstalled() {
#ifdef _WIN32
    return std::system("gnuplot --version > NUL 2>&1") == 0;
#else
    return std::system("gnuplot --version > /dev/null 2>&1") == 0;
#endif
}

/// The tables as data blocks, by whose names the plot reads them as it would read files.
std::string scriptOf(const std::string& demo, const std::vector<Table>& tables, const std::string& file) {
    std::ostringstream script;
    script.precision(9);
    for (const Table& table : tables) {
        script << '$' << table.name << " << END_OF_TABLE\n";
        table.write(script);
        script << "END_OF_TABLE\n" << table.name << " = '$" << table.name << "'\n";
    }
    script << "picture = " << quoted(file) << "\nset loadpath " << quoted(BUOYANCY_PLOTS) << "\nload "
           << quoted(demo + ".gp") << '\n';
    return script.str();
}

}  // namespace

bool writeTable(const Table& table, const std::string& demo, const std::string& file) {
    std::ofstream csv(file);
    csv.precision(9);
    table.write(csv);
    if (csv.flush()) return true;
    std::fprintf(stderr, "%s: cannot write %s\n", demo.c_str(), file.c_str());
    return false;
}

bool drawPlot(const std::string& demo, const std::vector<Table>& tables, const std::string& file) {
    if (!isInstalled()) {
        std::fprintf(stderr, "%s: no plot, since gnuplot is not installed (Debian: gnuplot-nox)\n",
                     demo.c_str());
        return false;
    }
    std::FILE* gnuplot = popen("gnuplot -", "w");
    if (!gnuplot) return false;
    std::fputs(scriptOf(demo, tables, file).c_str(), gnuplot);
    if (pclose(gnuplot) == 0) return true;
    std::fprintf(stderr, "%s: gnuplot could not draw %s\n", demo.c_str(), file.c_str());
    return false;
}

}  // namespace bullet_buoyancy::plots
