#pragma once

/// All that a user of Bullet includes.

#include "bullet_buoyancy/bullet/precision.h"
#include "bullet_buoyancy/version.h"

#include "bullet_buoyancy/bullet/buoyancy_action.h"
#include "bullet_buoyancy/bullet/hull_from_shape.h"
#include "bullet_buoyancy/bullet/rigid_body_state.h"
#include "bullet_buoyancy/hydrostatics/evaluate.h"
#include "bullet_buoyancy/hydrostatics/evaluate_batch.h"
#include "bullet_buoyancy/hydrostatics/evaluate_clustered.h"
#include "bullet_buoyancy/hydrostatics/evaluate_exact.h"
#include "bullet_buoyancy/hydrostatics/evaluate_reference.h"
#include "bullet_buoyancy/motion/damping.h"
#include "bullet_buoyancy/water/airy_waves.h"
#include "bullet_buoyancy/water/current.h"
#include "bullet_buoyancy/water/flat_water.h"
#include "bullet_buoyancy/water/function_water.h"
#include "bullet_buoyancy/water/gerstner_waves.h"
#include "bullet_buoyancy/water/height_grid.h"
#include "bullet_buoyancy/water/sea_state.h"
#include "bullet_buoyancy/water/water_sum.h"
