#include "hard_cases/options.h"

#include "scenes/command_line.h"

namespace bullet_buoyancy::demo {

std::optional<Options> parseOptions(int argc, char** argv, int& exitStatus) {
    Options options;
    CLI::App app{
        "Runs scenes that are hard on a buoyancy: bodies far lighter than water, small ones, long steps, "
        "fast\n"
        "spins, contacts, faulty meshes. Each is run twice: as most engines do it, by impulses of the "
        "water's\n"
        "force, and by the library. Exit status 1 if the library is past any limit.",
        "hard_cases"};
    app.add_option("--csv", options.csv, "write a row for each quantity of each case to this file");
    app.add_option("--plot", options.plot,
                   "draw every quantity over its limit, both ways, into this .png or .svg file")
        ->check(scenes::isPicture);
    app.add_option("--only", options.only, "run only cases whose name contains this");
    app.add_flag("--list", options.list, "print the names of the cases and end");
    app.add_flag("--quick", options.quick, "a thinned selection, for under a minute");
    app.add_flag("--verbose", options.verbose,
                 "print each case of a group, not only the worst of each quantity");
    recording::addFilmOptions(app, options.film);
    app.footer("Filmed is the first case of the run, and of all cases the barrels on a chain.");
    if (!scenes::parse(app, argc, argv, exitStatus)) return std::nullopt;
    return options;
}

}  // namespace bullet_buoyancy::demo
