// Running error bounds of lines, points and edges of triangles: from the clipper to the screen, and of their fragments.
//
// A line is a triangle whose vertex 0 has no weight (raster/interpolate.h): what holds for fragments of triangles holds for its
// fragments, which stand for points of the snapped line. A point's one fragment has the numbers of its vertex.
#pragma once

#include <array>
#include <optional>
#include <span>

#include <glassbox/raster/bounds.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/color_bounds.h>
#include <glassbox/render/trace/corner_bounds.h>

namespace glassbox {

// Whether a line from one place to the other, as it really lies, may have no fragment there: `moved` px is how far the ends may be from
// where they were snapped to, along x and along y each.
bool line_may_miss(const std::array<SnappedVertex, 2>& ends, const Fragment& fragment,
                   double moved);
// Whether a point may lie in another pixel than the fragment's.
bool point_may_miss(const SnappedVertex& point, const Fragment& fragment, double moved);

class LineBounds {
public:
  struct End {
    TracedVertex vertex;
    VertexBounds bounds;
  };

  // `triangle`: whose edge it is, of edges, which must have one. The stage's draw, lighting and settings must stay.
  LineBounds(const CornerStage& stage, const Trace& trace, const TracedDraw& draw,
             const FragmentSource& source, const BoundsOfRun::Known* triangle);

  // Of what clipping left of it: two, of a point one.
  std::span<const End> ends() const { return std::span(ends_).first(is_point_ ? 1 : 2); }

  FragmentBounds of(const Fragment& fragment) const;
  ColorBounds colors(const TracedFragment& fragment, const FragmentBounds& bounds) const;

  // As line_may_miss, its ends as far away as their bounds say; of a point, whether it may lie in another pixel.
  bool may_miss(const Fragment& fragment) const;

private:
  bool is_point_ = false;
  std::array<End, 2> ends_;
  double moved_ = 0;  // how far the snapped ends may be from the exact ones, in pixels
  TriangleSetup setup_;
  SetupBounds setup_bounds_;
  std::optional<PieceColors> colors_;
};

}  // namespace glassbox
