// Draws that others hide, found before anything is drawn.
#pragma once

#include <vector>

#include <glassbox/render/plan/box_place.h>
#include <glassbox/render/plan/plan.h>

namespace glassbox {

// By draw: whether all of it lies behind what comes before it in the plan's order.
//
// A fragment is seen only if its depth code is smaller than the one that is there, and codes that are there only become smaller. So a
// draw may be left out if at each point of each pixel that its box reaches an opaque triangle of a draw before it has a code no
// greater than the least of its own; what is masked, blended or drawn in between does not matter, nor what comes after.
//
// Only draws of few and large triangles hide others here, and only until looking has cost a quarter of what it would save if all were
// hidden (docs/plan.md has the numbers). The plan has the codes of its draws, and their order. `margin_px`: as for place_box.
std::vector<bool> find_hidden(const PlannedEye& eye, const Plan& plan,
                              double margin_px = kOutsideMarginPx);

}  // namespace glassbox
