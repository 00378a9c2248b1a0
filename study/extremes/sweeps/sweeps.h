// The sweeps, one file each.
#pragma once

#include "study/extremes/sweep.h"

namespace glassbox::study {

Sweep near_far_sweep();
Sweep world_offset_sweep();
Sweep field_of_view_sweep();
Sweep up_angle_sweep();
Sweep sliver_sweep();
Sweep viewport_sweep();
Sweep nesting_sweep();
Sweep separation_sweep();

}  // namespace glassbox::study
