#include "boat_in_waves/summary.h"

#include <cmath>
#include <cstdio>

namespace bullet_buoyancy::demo {

using namespace scenes;

namespace {

void printRow(const char* name, const Response& response, const char* unit) {
    std::printf("  %-10s %10.3f %-4s %10.3f %-4s %8.2f s\n", name, response.significant, unit, response.mean,
                unit, response.period);
}

void printSea(const Options& options, const Sea& sea) {
    const SeaDef& def = sea.def();
    std::printf(
        "Sea: %s, height %.2f m, period %.2f s, waves travel %.0f degrees off the bow (180: head sea)",
        nameOf(def.kind), def.height, def.period, options.heading);
    if (!sea.isRegular()) std::printf(", seed %llu", static_cast<unsigned long long>(def.seed));
    if (sea.gridNodes() > 0)
        std::printf("\n  on a grid of %d x %d nodes, %.2f m apart, that goes with the boat", sea.gridNodes(),
                    sea.gridNodes(), sea.gridSpacing());
    if (def.currentSpeed != 0) std::printf("\n  and a current of %.2f m/s", def.currentSpeed);
    const bool decays = def.kind == SeaKind::airy || def.kind == SeaKind::jonswap;
    std::printf("\n  pressure %s\n",
                decays ? nameOf(options.voyage.buoyancy.pressure) : "hydrostatic: this sea knows no other");
}

}  // namespace

void printSetting(const Options& options, const Boat& boat, const Sea& sea) {
    std::printf(
        "Boat: %.2f m x %.2f m, draft %.2f m, depth %.2f m, %.0f kg; GM %.3f m in roll, %.2f m in pitch\n",
        boat.size.x(), boat.size.y(), boat.draft, boat.size.z(), boat.mass, boat.metacentricHeight,
        boat.longitudinalMetacentric);
    std::printf("  natural periods without added mass: heave %.2f s, pitch %.2f s, roll %.2f s\n",
                boat.heavePeriod(), boat.pitchPeriod(), boat.rollPeriod());
    printSea(options, sea);
    if (options.drifts)
        std::printf("The boat drifts freely.\n");
    else
        std::printf("Springs of a period of %.0f s hold the boat in surge, sway and yaw.\n",
                    options.voyage.mooringPeriod);
    std::printf(
        "Not modelled: radiation damping and added mass. Near resonance the responses depend on the drag\n"
        "(%.2f 1/s) and damping (%.2f 1/s) chosen.\n",
        options.voyage.linearDrag, options.voyage.angularDamping);
}

void printSummary(const Options& options, const Boat& boat, const Sea& sea, const Voyage& voyage,
                  const Responses& responses) {
    const VoyageSample& last = voyage.samples.back();
    std::printf("\n%.0f s recorded, in steps of %.4f s\n", last.time, options.voyage.step);
    std::printf("  %-10s %15s %15s %10s\n", "", "significant", "mean", "period");
    printRow("elevation", responses.elevation, "m");
    printRow("heave", responses.heave, "m");
    printRow("pitch", responses.pitch, "deg");
    printRow("roll", responses.roll, "deg");
    std::printf("  (significant: four standard deviations, from trough to crest)\n");

    const double asked = sea.significantHeight();
    std::printf("Sea at the probe: 4 sigma %.3f m, asked for %.3f m%s; peak at %.2f s, asked for %.2f s\n",
                responses.elevation.significant, asked, sea.isRegular() ? " (sqrt(2) heights of a sine)" : "",
                1 / responses.elevation.spectrum.peakFrequency(), sea.def().period);
    if (!sea.isRegular())
        std::printf("  (chance alone scatters the height of such a record by %.1f %%)\n",
                    100 * sea.scatterOfHeight(options.voyage.duration));
    std::printf("Heave over the sea: %.3f; its mean %+.4f m from the draft at rest\n",
                responses.heave.significant / responses.elevation.significant,
                responses.heave.mean - responses.elevation.mean);
    std::printf("In the end at surge %.2f m, sway %.2f m, yaw %.2f degrees\n", last.surge, last.sway,
                last.yaw * 180 / pi);

    const Effort effort = effortOf(voyage);
    std::printf("Water samples a step: mean %.1f, most %.0f\n", effort.meanSamples, effort.mostSamples);
    std::printf("Error bound of the water's force over the weight: median %.1e, most %.1e\n",
                effort.medianBound, effort.mostBound);
    std::printf("  (tolerance %.1e of what the whole hull displaces: %.1e of the weight)\n",
                options.voyage.buoyancy.tolerance,
                options.voyage.buoyancy.tolerance * boat.hull->moments.volume / boat.displacement);
    std::printf("Real time: %.1f microseconds a step\n", 1e6 * voyage.clockPerStep);
}

}  // namespace bullet_buoyancy::demo
