#include "bullet_buoyancy/water/water_field.h"

#include <cassert>
#include <cmath>

namespace bullet_buoyancy {

WaterField::WaterField(const WaterFrame& frame, double density) : m_frame(frame), m_density(density) {
    assert(std::isfinite(density) && density > 0);
}

}  // namespace bullet_buoyancy
