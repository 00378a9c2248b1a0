// Finds from the bounding box of a draw whether all of it is outside the view or inside the clip
// planes, so that stages can be left out for a whole object at once.
#pragma once

#include <array>

#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/draw_list.h>

namespace glassbox {

struct BoxClassification {
  // The name of a plane that the whole draw is outside of, so that no pixel shows it; null: none.
  const char* outside_of = nullptr;
  bool inside = false;         // every vertex is inside all planes that rendering clips by
  bool in_picture = false;     // inside the picture, or outside it by at most the margin
  bool in_guard_band = false;  // none of the four planes of the guard band cuts anything
  bool of_group = false;       // the box is that of the draw's group of instances
  // In clip space: the distance of the box from the plane `outside_of`, or, if `inside` is set,
  // from the nearest of the near, eye and far planes.
  double distance = 0;
};

// A box counts as outside only if it is this far outside the edges of the picture. Lines colour
// pixels up to one pixel away from them. Triangles cover only pixels whose centres they contain,
// and their vertices are snapped by at most 2^-9 px. The rounding errors of divide and viewport are
// at most 3 u 16384 px < 0.003 px (u is the unit roundoff, 2^-24).
inline constexpr double kOutsideMarginPx = 2;

// Returns the edges of the picture, moved outwards by `margin_px`, as clip planes. A point in front
// of the eye is more than `margin_px` outside a picture that is W pixels wide if
// |x| > (1 + 2 margin_px / W) w.
std::array<ClipPlane, 4> picture_edges(const Viewport& viewport, double margin_px);

// Classifies the box of a draw. The rounding of the vertices is taken into account (PlaneOverBoxes
// of clip.h). If a position of the mesh is not finite, nothing is known and the defaults are
// returned.
BoxClassification classify_draw_box(const Draw& draw, const View& view,
                                    double margin_px = kOutsideMarginPx);

// Returns the draw's box relative to its anchor, like the positions that are transformed; the
// subtraction is exact (anchor_for).
Box<Object> anchored_box(const Draw& draw);

}  // namespace glassbox
