#pragma once

#include <iosfwd>
#include <vector>

#include "scenes/boat_in_waves.h"
#include "scenes/spectrum.h"

namespace bullet_buoyancy::demo {

/// A quantity's record, told by a few numbers.
struct Response {
    double significant;  ///< four standard deviations: from trough to crest
    double mean;
    double period;  ///< mean between upward passages of the mean, s
    scenes::Spectrum spectrum;
};

/// Of elevation and heave in m, of the angles in degrees.
struct Responses {
    Response elevation, heave, pitch, roll;
};

/// `peakPeriod` (s) decides how finely the spectra are resolved.
Responses respond(const scenes::Voyage& voyage, double step, double peakPeriod);

/// What evaluating the water took.
struct Effort {
    double meanSamples, mostSamples;  ///< of the water a step
    double medianBound, mostBound;    ///< of the force's error, over the weight
};

Effort effortOf(const scenes::Voyage& voyage);

/// Write CSV.
void writeSeries(std::ostream& csv, const scenes::Voyage& voyage);
void writeSpectra(std::ostream& csv, const Responses& responses, const scenes::Sea& sea);

}  // namespace bullet_buoyancy::demo
