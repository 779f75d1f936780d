#include "bullet_buoyancy/bullet/shared_hulls.h"

#include "bullet_buoyancy/bullet/hull_from_shape.h"

namespace bullet_buoyancy {

HullResult SharedHulls::of(const btCollisionShape& shape) {
    const auto known = m_known.find(&shape);
    if (known != m_known.end() && known->second.scaling == shape.getLocalScaling())
        if (auto hull = known->second.hull.lock()) return {std::move(hull), known->second.status};
    HullResult result = hullFromShape(shape);
    if (!result.hull) return result;
    if (m_known.size() >= m_nextLook) forgetWhatIsGone();
    m_known[&shape] = {result.hull, result.status, shape.getLocalScaling()};
    return result;
}

void SharedHulls::forgetWhatIsGone() {
    for (auto known = m_known.begin(); known != m_known.end();)
        known = known->second.hull.expired() ? m_known.erase(known) : std::next(known);
    m_nextLook = 2 * m_known.size() + 16;
}

}  // namespace bullet_buoyancy
