#include "boat_in_waves/responses.h"

#include <algorithm>
#include <ostream>

namespace bullet_buoyancy::demo {

using namespace scenes;

namespace {

constexpr double degrees = 180 / pi;
constexpr double periodsInSegment = 16;  // of the spectra

}  // namespace

Responses respond(const Voyage& voyage, double step, double peakPeriod) {
    const auto of = [&](double VoyageSample::*quantity, double unit) {
        std::vector<double> values = series(voyage, quantity);
        for (double& value : values)
            value *= unit;
        return Response{4 * deviationOf(values), meanOf(values), meanPeriod(values, step),
                        spectrumOf(values, step, periodsInSegment * peakPeriod)};
    };
    return {of(&VoyageSample::elevation, 1), of(&VoyageSample::heave, 1), of(&VoyageSample::pitch, degrees),
            of(&VoyageSample::roll, degrees)};
}

Effort effortOf(const Voyage& voyage) {
    std::vector<double> bounds = series(voyage, &VoyageSample::errorBound);
    std::sort(bounds.begin(), bounds.end());
    double sum = 0, most = 0;
    for (const VoyageSample& sample : voyage.samples) {
        sum += sample.waterSamples;
        most = std::max(most, double(sample.waterSamples));
    }
    return {sum / double(voyage.samples.size()), most, bounds[bounds.size() / 2], bounds.back()};
}

void writeSeries(std::ostream& csv, const Voyage& voyage) {
    csv << "time_s,elevation_m,slope_deg,heave_m,roll_deg,pitch_deg,yaw_deg,surge_m,sway_m,water_samples,"
           "error_bound_over_weight\n";
    for (const VoyageSample& s : voyage.samples)
        csv << s.time << ',' << s.elevation << ',' << s.slope * degrees << ',' << s.heave << ','
            << s.roll * degrees << ',' << s.pitch * degrees << ',' << s.yaw * degrees << ',' << s.surge << ','
            << s.sway << ',' << s.waterSamples << ',' << s.errorBound << '\n';
}

void writeSpectra(std::ostream& csv, const Responses& responses, const Sea& sea) {
    csv << "frequency_hz,elevation_m2_per_hz,asked_m2_per_hz,heave_m2_per_hz,pitch_deg2_per_hz,"
           "roll_deg2_per_hz\n";
    const Spectrum& elevation = responses.elevation.spectrum;
    for (std::size_t i = 1; i < elevation.density.size(); ++i)
        csv << elevation.frequency(i) << ',' << elevation.density[i] << ','
            << sea.spectralDensity(elevation.frequency(i)) << ',' << responses.heave.spectrum.density[i]
            << ',' << responses.pitch.spectrum.density[i] << ',' << responses.roll.spectrum.density[i]
            << '\n';
}

}  // namespace bullet_buoyancy::demo
