// Where all of a draw lies, from its box alone: what may be left out for a whole object at once.
#pragma once

#include <array>

#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/draw_list.h>

namespace glassbox {

struct BoxPlace {
  const char* outside_of =
      nullptr;                 // a plane that everything lies beyond: no pixel shows any of it
  bool inside = false;         // of every plane that rendering clips by, each vertex
  bool in_picture = false;     // or at most the margin beside it
  bool in_guard_band = false;  // nothing is cut by the four planes of the guard band
  bool of_group = false;       // the box is that of the draw's group of instances
  // Clip units: how far the box is from where the first two would be otherwise.
  double distance = 0;
};

// Beyond the edges of the picture the box has to lie this far to count as outside: triangles reach no pixel whose centre they do
// not contain and are snapped by 2^-9 px; lines colour pixels up to one away from them; and the roundings of divide and
// viewport add at most 3 u 16384 px < 0.003 px.
inline constexpr double kOutsideMarginPx = 2;

// The edges of the picture, moved outwards. In front of the eye |x| > (1 + 2 margin / W) w is more than `margin_px` pixels beyond.
std::array<ClipPlane, 4> picture_edges(const Viewport& viewport, double margin_px);

// The rounding of the vertices is taken into account (PlaneOverBoxes of clip.h). A mesh with a position that is not finite lies
// nowhere.
BoxPlace place_box(const Draw& draw, const View& view, double margin_px = kOutsideMarginPx);

// The draw's box as its positions are carried: relative to the anchor, which is exact (anchor_for).
Box<Object> anchored_box(const Draw& draw);

}  // namespace glassbox
