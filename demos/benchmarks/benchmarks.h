#pragma once

namespace bullet_buoyancy::demo {

/// Register their benchmarks.
void addEvaluators();
void addWaters();
void addAction();

}  // namespace bullet_buoyancy::demo
