#pragma once

#include "boat_in_waves/options.h"
#include "boat_in_waves/responses.h"

namespace bullet_buoyancy::demo {

/// Prints what floats, on what, and how it is held.
void printSetting(const Options& options, const scenes::Boat& boat, const scenes::Sea& sea);

/// Prints the responses and what they took.
void printSummary(const Options& options, const scenes::Boat& boat, const scenes::Sea& sea,
                  const scenes::Voyage& voyage, const Responses& responses);

}  // namespace bullet_buoyancy::demo
