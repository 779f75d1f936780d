#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

#include "recording/draw_picture.h"
#include "recording/write_gltf.h"

namespace bullet_buoyancy::recording {

/// What of a demo is to be seen, and where to.
struct FilmOptions {
    FilmDef film;
    std::string record, picture;  ///< files; empty: none
    double pictureTime = 1e9;     ///< s, by the film's times; beyond them: the last frame

    bool isWanted() const { return !record.empty() || !picture.empty(); }
};

inline void addFilmOptions(CLI::App& app, FilmOptions& options) {
    const auto endsIn = [](const std::string& end) {
        return [end](const std::string& name) {
            const bool right = name.size() > end.size() && name.substr(name.size() - end.size()) == end;
            return right ? std::string() : "the name must end in " + end;
        };
    };
    app.add_option("--record", options.record, "film the scene into this .glb file (glTF 2.0, animated)")
        ->check(endsIn(".glb"));
    app.add_option("--record-rate", options.film.rate, "frames a second of the film, at most")
        ->check(CLI::Range(0.1, 1000.0));
    app.add_option("--record-seconds", options.film.seconds, "length of the film at most, s")
        ->check(CLI::Range(0.0, 3600.0));
    app.add_flag("--record-forces", options.film.forces,
                 "film the centres of buoyancy as well, and the forces of the water");
    app.add_option("--picture", options.picture, "draw the scene into this .png file, by POV-Ray")
        ->check(endsIn(".png"));
    app.add_option("--picture-time", options.pictureTime,
                   "moment of the film that the picture shows, s; the last one if that is later");
}

/// Writes what is wanted of a film. False, with a message to standard error that begins with the name of the
/// `demo`, if there is no film or it cannot be written.
inline bool writeFilm(const Film* film, const FilmOptions& options, const std::string& demo) {
    std::string error = film && !film->times().empty() ? "" : "there is nothing to film";
    if (error.empty() && !options.record.empty()) error = writeGltf(*film, options.record);
    if (error.empty() && !options.picture.empty())
        error = drawPicture(*film, film->frameAt(options.pictureTime), options.picture);
    if (!error.empty()) std::fprintf(stderr, "%s: %s\n", demo.c_str(), error.c_str());
    return error.empty();
}

}  // namespace bullet_buoyancy::recording
