#include "boat_in_waves/options.h"

#include <limits>
#include <map>

#include "boat_in_waves/read_mesh.h"
#include "scenes/command_line.h"

namespace bullet_buoyancy::demo {

namespace {

using scenes::SeaKind;

const std::map<std::string, SeaKind> seas{{"airy", SeaKind::airy},
                                          {"gerstner", SeaKind::gerstner},
                                          {"jonswap", SeaKind::jonswap},
                                          {"grid", SeaKind::grid}};
const std::map<std::string, PressureModel> pressures{{"hydrostatic", PressureModel::hydrostatic},
                                                     {"wave-dynamic", PressureModel::waveDynamic}};

template <typename Value>
const char* nameIn(const std::map<std::string, Value>& names, Value value) {
    for (const auto& [name, known] : names)
        if (known == value) return name.c_str();
    return "";
}

/// Choices are read as text, so that the help shows their names.
struct Choices {
    std::string sea = "jonswap", pressure = "wave-dynamic";
};

template <typename Value>
CLI::IsMember namesOf(const std::map<std::string, Value>& choices) {
    std::vector<std::string> names;
    for (const auto& choice : choices)
        names.push_back(choice.first);
    return CLI::IsMember(names);
}

void addSea(CLI::App& app, Options& options, Choices& choices) {
    app.add_option("--sea", choices.sea,
                   "airy: a regular linear wave; gerstner: a regular trochoidal wave; jonswap: an irregular "
                   "sea;\ngrid: the same as heights on a grid, as a game's own ocean has them")
        ->check(namesOf(seas));
    app.add_option("--hs", options.sea.height,
                   "significant wave height; of a regular wave that from trough to crest, m")
        ->check(CLI::Range(0.0, 30.0));
    app.add_option("--tp", options.sea.period, "period of the spectrum's peak, or of the regular wave, s")
        ->check(CLI::Range(0.5, 30.0));
    app.add_option("--seed", options.sea.seed, "of the irregular sea");
    app.add_option("--spreading", options.sea.spreading,
                   "s of cos^2s(angle / 2): how the waves spread about their mean direction; inf: not at all")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--current", options.sea.currentSpeed,
                   "speed of a current the way the waves travel; it carries the boat, not the waves, m/s")
        ->check(CLI::Range(-5.0, 5.0));
    app.add_option("--heading", options.heading,
                   "from the boat's bow to where the waves travel, counter-clockwise from above, degrees: "
                   "180\nhead sea, 0 following sea, 90 the waves come from starboard");
    app.add_option("--pressure", choices.pressure,
                   "under waves: hydrostatic, or wave-dynamic (that of the undisturbed waves: Froude-Krylov);"
                   "\nof use in the seas airy and jonswap")
        ->check(namesOf(pressures));
}

void addBoat(CLI::App& app, Options& options) {
    app.add_option("--length", options.length,
                   "of a Wigley hull with walls and a deck, its beam a quarter, draft and freeboard a tenth "
                   "of it, m")
        ->check(CLI::Range(0.5, 500.0));
    auto* hull = app.add_option(
        "--hull", options.hull,
        canReadMeshes() ? "OBJ, STL ... file of a closed hull to take instead: x to the bow, z up, metres"
                        : "not in this build: configure it where the library assimp is installed "
                          "(Debian: libassimp-dev)");
    app.add_option("--ratio", options.ratio, "of that hull: displacement at rest over its volume")
        ->check(CLI::Range(0.01, 0.95))
        ->needs(hull);
    app.add_flag("--free", options.drifts, "drift, without the soft springs in surge, sway and yaw");
    app.add_option("--drag", options.voyage.linearDrag,
                   "linear drag of the hull wholly under water, relative to the water, 1/s")
        ->check(CLI::Range(0.0, 100.0));
    app.add_option("--damping", options.voyage.angularDamping,
                   "angular damping of the hull wholly under water, 1/s")
        ->check(CLI::Range(0.0, 100.0));
}

void addRun(CLI::App& app, Options& options) {
    app.add_option("--duration", options.voyage.duration,
                   "of the record, which begins ten periods after the release, s")
        ->check(CLI::Range(1.0, 36000.0));
    app.add_option("--step", options.voyage.step, "of Bullet's world, s")->check(CLI::Range(1e-3, 0.1));
    app.add_option("--tolerance", options.voyage.buoyancy.tolerance,
                   "error that the water's force may have, over the weight of what the whole hull displaces")
        ->check(CLI::Range(0.0, 1.0));
    app.add_option("--csv", options.csv, "write the time series to this file");
    app.add_option("--spectra", options.spectra, "write the spectra to this file");
    app.add_option("--moments", options.moments,
                   "write the boat and the water, at four moments of the highest waves, to this file");
    app.add_option("--plot", options.plot, "draw motions and spectra into this .png or .svg file")
        ->check(scenes::isPicture);
}

void complete(Options& options, const Choices& choices) {
    options.sea.kind = seas.at(choices.sea);
    options.sea.direction = options.heading * pi / 180;
    options.voyage.buoyancy.pressure = pressures.at(choices.pressure);
    options.voyage.settling = options.voyage.mooringPeriod = 10 * options.sea.period;
    if (options.drifts) options.voyage.mooringPeriod = std::numeric_limits<double>::infinity();
    const double scale = options.length / options.wigley.length;
    options.wigley.length *= scale;
    options.wigley.beam *= scale;
    options.wigley.draft *= scale;
    options.wigley.freeboard *= scale;
}

}  // namespace

std::optional<Options> parseOptions(int argc, char** argv, int& exitStatus) {
    Options options;
    Choices choices;
    CLI::App app{
        "Lets a boat ride a sea in a headless Bullet world: motions, their spectra, and what the water was "
        "asked.\nExit status 1 if the boat capsizes or sinks or anything is not finite.",
        "boat_in_waves"};
    app.option_defaults()->always_capture_default();
    addSea(app, options, choices);
    addBoat(app, options);
    addRun(app, options);
    recording::addFilmOptions(app, options.film);
    if (!scenes::parse(app, argc, argv, exitStatus)) return std::nullopt;
    complete(options, choices);
    return options;
}

const char* nameOf(SeaKind kind) {
    return nameIn(seas, kind);
}

const char* nameOf(PressureModel pressure) {
    return nameIn(pressures, pressure);
}

}  // namespace bullet_buoyancy::demo
