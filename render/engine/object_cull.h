// Culling before clipping, in object space (S4-01, S4-13): which triangles face the wrong way for certain.
//
// The snapped area alone decides what a picture shows (DESIGN 2). So a triangle is removed here only where the test's value
// exceeds all that may still turn it round: its own rounding, the viewer's, and what snapping and float move its corners by on
// the screen (back_face.h has the proof). What is in doubt goes on, and so does what a plane cuts: the pieces of a cut may be
// slivers that no margin of the whole triangle speaks for. The bytes are those of culling by the snapped area alone.
#pragma once

#include <array>
#include <optional>

#include <glassbox/pipeline/back_face.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/clusters.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox {

// The test for one draw and one eye.
struct ObjectCull {
  ObjectViewer viewer;
  bool removes_fronts = false;  // otherwise backs
  double value_per_px2 = 0;     // margin of the test's value for each px^2 of area, where w is 1

  // A row of clip_from_object that the screen depends on, in double, and how far the run's own
  // coordinate may be from what the row
  // gives for p: error . (|p - anchor|, 1).
  struct Row {
    std::array<double, 4> exact{}, error{};
  };
  Row x, y, w;
  Vector<Object> anchor;
  double half_width_px = 0, half_height_px = 0;

  struct Judgement {
    BackFaceTest test;
    // Of snapping and float; infinite where it is not asked for, and where nothing can be said.
    double margin = 0;
    bool removed = false;
  };
  // Three corners as modelled. What is removed has them in front of the eye; that no plane cuts it is for the caller to see.
  Judgement judge(const std::array<Point<Object>, 3>& triangle) const;

  bool removes(const std::array<Point<Object>, 3>& triangle) const {
    return judge(triangle).removed;
  }

  // Each triangle of a cluster at once, by the cone of their normals and the box; what was said of planes holds here, too.
  bool removes_all(const Cluster& cluster) const;
};

// What --cull-stage object does for a draw.
struct ObjectCulling {
  std::optional<ObjectCull> test;  // absent: nothing is removed early
  const char* because = "";        // why there is a test, or none
};
ObjectCulling object_culling(const Draw& draw, const View& view, const RenderSettings& settings);

// The same, asked for or not.
ObjectCulling certain_culling(const Draw& draw, const View& view, Cull cull);

}  // namespace glassbox
