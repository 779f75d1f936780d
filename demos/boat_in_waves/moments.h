#pragma once

#include <iosfwd>

#include "scenes/boat_in_waves.h"

namespace bullet_buoyancy::demo {

/// CSV of four moments of a voyage, a quarter of the sea's period apart, from that of the highest crest at
/// the probe on: the surface along the boat, the boat's outline from the side, and what of it is below the
/// waterline at rest; by distances ahead of its centre of mass and heights above still water, m.
void writeMoments(std::ostream& csv, const scenes::Boat& boat, scenes::Sea& sea,
                  const scenes::Voyage& voyage);

}  // namespace bullet_buoyancy::demo
