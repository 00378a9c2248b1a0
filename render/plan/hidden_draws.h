// Finds draws that earlier draws hide completely, before anything is drawn.
#pragma once

#include <vector>

#include <glassbox/render/plan/box_classification.h>
#include <glassbox/render/plan/plan.h>

namespace glassbox {

// Returns for each draw whether all of it is behind earlier draws in the plan's order.
//
// A fragment is seen only if its depth code is smaller than the stored one, and stored codes only
// become smaller. So a draw may be left out if, at each sample point of each pixel that its box
// reaches, an opaque triangle of an earlier draw has a code no greater than the smallest code of
// the draw. Masked, blended or other draws in between do not matter, nor do later ones.
//
// Only draws of few and large triangles are used to hide others here, and the search stops when it
// has cost a quarter of what it would save if all draws were hidden (docs/plan.md has the numbers).
// The plan must have the codes of its draws, and their order. `margin_px`: as for
// classify_draw_box.
std::vector<bool> find_hidden_draws(const PlannedEye& eye, const Plan& plan,
                                    double margin_px = kOutsideMarginPx);

}  // namespace glassbox
