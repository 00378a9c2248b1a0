// Finds where the whole of a draw is from its box alone, so that stages can be left out for a whole
// object at once.
#pragma once

#include <array>

#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/draw_list.h>

namespace glassbox {

struct BoxClassification {
  // The name of a plane that the whole draw is beyond, so that no pixel shows it; null: none.
  const char* outside_of = nullptr;
  bool inside = false;         // every vertex is inside all planes that rendering clips by
  bool in_picture = false;     // inside the picture, or outside it by at most the margin
  bool in_guard_band = false;  // none of the four planes of the guard band cuts anything
  bool of_group = false;       // the box is that of the draw's group of instances
  // In clip units: how far the box is from the first two being different.
  double distance = 0;
};

// A box must be this far outside the edges of the picture to count as outside. Triangles cover only
// pixels whose centres they contain, and they are snapped by at most 2^-9 px. Lines colour pixels
// up to one away from them. The rounding errors of divide and viewport are at most 3 u 16384 px <
// 0.003 px.
inline constexpr double kOutsideMarginPx = 2;

// The edges of the picture, moved outwards as clip planes. In front of the eye |x| > (1 + 2 margin
// / W) w is more than `margin_px` pixels outside.
std::array<ClipPlane, 4> picture_edges(const Viewport& viewport, double margin_px);

// Finds the place of a draw. The rounding of the vertices is taken into account (PlaneOverBoxes of
// clip.h). For a mesh with a position that is not finite, nothing is known.
BoxClassification classify_draw_box(const Draw& draw, const View& view,
                                    double margin_px = kOutsideMarginPx);

// The draw's box relative to the anchor, as its positions are transformed; the subtraction is exact
// (anchor_for).
Box<Object> anchored_box(const Draw& draw);

}  // namespace glassbox
