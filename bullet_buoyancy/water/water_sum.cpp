#include "bullet_buoyancy/water/water_sum.h"

#include <algorithm>
#include <cassert>

namespace bullet_buoyancy {

namespace {

/// Points at once: their samples lie on the stack.
constexpr Eigen::Index blockSize = 32;

template <int columns>
using Block = Eigen::Array<double, blockSize, columns>;

/// Adds up what `sample(field, first row, rows, part)` fills in for each field.
template <int columns, typename Sums, typename Sample>
void addUp(const std::vector<const WaterField*>& fields, Sums& sums, const Sample& sample) {
    Block<columns> part;
    sums.setZero();
    for (Eigen::Index first = 0; first < sums.rows(); first += blockSize) {
        const Eigen::Index rows = std::min(blockSize, sums.rows() - first);
        for (const WaterField* field : fields) {
            sample(*field, first, rows, part);
            sums.middleRows(first, rows) += part.topRows(rows);
        }
    }
}

}  // namespace

WaterSum::WaterSum(const std::vector<const WaterField*>& fields, double density)
    : WaterField(fields.front()->frame(), density), m_fields(fields) {
    for ([[maybe_unused]] const WaterField* field : fields)
        assert(field->frame().originWorld() == frame().originWorld() &&
               field->frame().worldFromFrame() == frame().worldFromFrame());
}

WaterBounds WaterSum::bounds() const {
    WaterBounds sum;
    sum.curvatureChange = 0;
    for (const WaterField* field : m_fields) {
        const WaterBounds bounds = field->bounds();
        sum.elevation += bounds.elevation;
        sum.slope += bounds.slope;
        sum.curvature += bounds.curvature;
        sum.curvatureChange += bounds.curvatureChange;
        sum.curvatureChangeGrowth += bounds.curvatureChangeGrowth;
        sum.still = sum.still && bounds.still;
    }
    return sum;
}

double WaterSum::headCurvatureChangeUnder(const WaterBounds& surface, double above) const {
    double sum = 0;
    for (const WaterField* field : m_fields)
        sum += field->headCurvatureChangeUnder(surface, above);
    return sum;
}

void WaterSum::sampleSurface(HorizontalPoints points, double time, SurfaceSamples samples) const {
    addUp<3>(m_fields, samples,
             [&](const WaterField& field, Eigen::Index first, Eigen::Index rows, Block<3>& part) {
                 field.sampleSurface(points.middleRows(first, rows), time, part.topRows(rows));
             });
}

void WaterSum::expandSurface(HorizontalPoints points, double time, SurfaceExpansions expansions) const {
    addUp<7>(m_fields, expansions,
             [&](const WaterField& field, Eigen::Index first, Eigen::Index rows, Block<7>& part) {
                 field.expandSurface(points.middleRows(first, rows), time, part.topRows(rows));
             });
}

double WaterSum::curvatureNear(const Vec2& point, double radius, double time) const {
    double sum = 0;
    for (const WaterField* field : m_fields)
        sum += field->curvatureNear(point, radius, time);
    return sum;
}

void WaterSum::expandWaveHead(WaterPoints points, double time, HeadExpansions expansions) const {
    addUp<10>(m_fields, expansions,
              [&](const WaterField& field, Eigen::Index first, Eigen::Index rows, Block<10>& part) {
                  field.expandWaveHead(points.middleRows(first, rows), time, part.topRows(rows));
              });
}

/// A field measures depth from its own surface: it is asked at points moved so that they are as deep under
/// that as the given ones are under the common surface.
void WaterSum::sampleVelocity(WaterPoints points, double time, WaterVelocities velocities) const {
    Block<3> surface, moved;
    addUp<3>(m_fields, velocities,
             [&](const WaterField& field, Eigen::Index first, Eigen::Index rows, Block<3>& part) {
                 const auto block = points.middleRows(first, rows);
                 sampleSurface(block.leftCols<2>(), time, surface.topRows(rows));
                 field.sampleSurface(block.leftCols<2>(), time, part.topRows(rows));
                 moved.topRows(rows) = block;
                 moved.col(2).head(rows) += part.col(0).head(rows) - surface.col(0).head(rows);
                 field.sampleVelocity(moved.topRows(rows), time, part.topRows(rows));
             });
}

}  // namespace bullet_buoyancy
