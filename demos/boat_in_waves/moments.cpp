#include "boat_in_waves/moments.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "boat_in_waves/profile.h"

namespace bullet_buoyancy::demo {

using namespace scenes;

namespace {

constexpr int moments = 4;
constexpr double reach = 3.6;  // of the water at either side of the boat's place, boat lengths

/// The sample with the highest crest at the probe, far enough from the ends of the record.
const VoyageSample& highestCrest(const Voyage& voyage) {
    const auto margin = std::ptrdiff_t(voyage.samples.size() / 10);
    return *std::max_element(voyage.samples.begin() + margin, voyage.samples.end() - margin,
                             [](const auto& a, const auto& b) { return a.elevation < b.elevation; });
}

const VoyageSample& sampleNear(const Voyage& voyage, double time) {
    return *std::min_element(voyage.samples.begin(), voyage.samples.end(), [&](const auto& a, const auto& b) {
        return std::abs(a.time - time) < std::abs(b.time - time);
    });
}

/// A part of the picture at a moment.
struct Part {
    int moment;
    double time;
    const char* name;

    void writePoint(std::ostream& csv, double ahead, double height) const {
        csv << moment << ',' << time << ',' << name << ',' << ahead << ',' << height << '\n';
    }
};

void writeOutline(std::ostream& csv, const Part& part, const std::vector<Vec2>& polygon,
                  const VoyageSample& sample, double heightAtRest) {
    const double c = std::cos(sample.pitch), s = std::sin(sample.pitch);
    for (const Vec2& p : polygon)
        part.writePoint(csv, c * p.x() - s * p.y(), heightAtRest + sample.heave + s * p.x() + c * p.y());
}

void writeWater(std::ostream& csv, const Part& part, double farthest, Sea& sea, const VoyageSample& sample) {
    constexpr int points = 100;  // to either side
    const Vec2 place(sample.surge, sample.sway), bow(std::cos(sample.yaw), std::sin(sample.yaw));
    sea.showAt(place, sample.time);
    for (int i = -points; i <= points; ++i) {
        const double ahead = farthest * i / points;
        part.writePoint(csv, ahead, sea.elevation(place + ahead * bow, sample.time));
    }
}

}  // namespace

void writeMoments(std::ostream& csv, const Boat& boat, Sea& sea, const Voyage& voyage) {
    const double height = boat.heightAtRest;
    const double farthest = sea.gridNodes() > 0 ? sea.def().gridReach : reach * boat.size.x();
    const std::vector<Vec2> outline = profileOf(boat.hull->mesh), bottom = below(outline, -height);
    const double start = highestCrest(voyage).time;
    csv << "moment,time_s,part,ahead_m,height_m\n";
    for (int i = 0; i < moments; ++i) {
        const VoyageSample& sample = sampleNear(voyage, start + i * sea.def().period / moments);
        writeOutline(csv, {i, sample.time, "hull"}, outline, sample, height);
        writeOutline(csv, {i, sample.time, "bottom"}, bottom, sample, height);
        writeWater(csv, {i, sample.time, "water"}, farthest, sea, sample);
    }
}

}  // namespace bullet_buoyancy::demo
