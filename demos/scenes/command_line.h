#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace bullet_buoyancy::scenes {

/// Reads the command line. False if the program is to end now, with `exitStatus`: after --help, or on an
/// error, which has been printed.
inline bool parse(CLI::App& app, int argc, char** argv, int& exitStatus) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        exitStatus = app.exit(error);
        return false;
    }
    return true;
}

/// A check of the name of a file to draw into: empty if it is right, else what is wrong.
inline std::string isPicture(const std::string& name) {
    const auto endsWith = [&](const std::string& end) {
        return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
    };
    return endsWith(".png") || endsWith(".svg") ? "" : "the name must end in .png or .svg";
}

}  // namespace bullet_buoyancy::scenes
