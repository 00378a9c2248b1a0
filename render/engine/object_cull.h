// Culling before clipping, in object space (S4-01, S4-13): finds the triangles that certainly face
// the wrong way.
//
// Only the area after snapping decides what a picture shows. So a triangle is removed here only if
// the value of the test exceeds everything that could still change its sign: its own rounding
// error, the error of the viewer's position, and how far snapping and float move the corners on the
// screen (back_face.h has the proof). Triangles in doubt are kept. So are triangles that a clip
// plane cuts, because clipping may leave slivers of them, for which the margin of the whole
// triangle does not hold. The picture has the same bytes as with culling by the snapped area alone.
#pragma once

#include <array>
#include <optional>

#include <glassbox/pipeline/back_face.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/clusters.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox {

// The culling test for one draw and one eye.
struct ObjectCull {
  ObjectViewer viewer;
  bool removes_fronts = false;  // otherwise it removes back faces
  // Margin of the test's value for each px^2 on the screen, where w is 1.
  double value_per_px2 = 0;

  // A row of clip_from_object, in double. The coordinate that the run computes for a point p
  // differs from the exact one by at most the dot product of `error` and (|p - anchor|, 1).
  struct Row {
    std::array<double, 4> exact{}, error{};
  };
  Row x, y, w;
  Vector<Object> anchor;
  double half_width_px = 0, half_height_px = 0;

  struct Evaluation {
    BackFaceTest test;
    // What the value must exceed because of snapping and float. It is infinite if it was not
    // computed, or if no bound is known.
    double margin = 0;
    bool removed = false;
  };
  // Evaluates the test for the triangle's three corners as modelled. If `removed` is set, all three
  // corners are in front of the eye. Before it removes the triangle, the caller must also check
  // that no clip plane cuts it.
  Evaluation evaluate(const std::array<Point<Object>, 3>& triangle) const;

  bool removes(const std::array<Point<Object>, 3>& triangle) const {
    return evaluate(triangle).removed;
  }

  // Whether all triangles of a cluster can be removed, found from the cone of their normals and
  // from their box. The caller must also check that no clip plane cuts any of them.
  bool removes_all(const Cluster& cluster) const;
};

// What --cull-stage object does for a draw: a test for its triangles, or none, and the reason.
struct ObjectCulling {
  std::optional<ObjectCull> test;  // absent: nothing is culled before clipping
  const char* because = "";        // why there is a test, or none
};
ObjectCulling object_culling(const Draw& draw, const View& view, const RenderSettings& settings);

// Makes the same decision as object_culling, for any --cull-stage.
ObjectCulling certain_culling(const Draw& draw, const View& view, Cull cull);

}  // namespace glassbox
