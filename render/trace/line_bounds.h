// Running error bounds of lines, points and edges of triangles: from the clipper to the screen, and
// of their fragments.
//
// A line is treated as a triangle whose vertex 0 has weight 0 (raster/interpolate.h). So what holds
// for fragments of triangles holds for the fragments of a line, which represent points of the
// snapped line. A point's one fragment has the numbers of its vertex.
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

// Whether the exact line might not cover the fragment's pixel. The exact ends may be up to `moved`
// px from the snapped ones, along x and along y.
bool line_may_miss(const std::array<SnappedVertex, 2>& ends, const Fragment& fragment,
                   double moved);
// Whether the exact point may be in another pixel than the fragment's. `moved` is as for lines.
bool point_may_miss(const SnappedVertex& point, const Fragment& fragment, double moved);

class LineBounds {
public:
  struct LineEnd {
    TracedVertex vertex;
    VertexBounds bounds;
  };

  // `triangle`: for an edge, the triangle that the edge belongs to (required). The draw, lighting
  // and settings of `stage` must outlive the object.
  LineBounds(const CornerStage& stage, const Trace& trace, const TracedDraw& draw,
             const FragmentSource& source, const BoundsOfRun::KnownTriangle* triangle);

  // Returns the ends of what clipping left of the line: two, or one for a point.
  std::span<const LineEnd> ends() const { return std::span(ends_).first(is_point_ ? 1 : 2); }

  FragmentBounds of_fragment(const Fragment& fragment) const;
  ColorBounds colors(const TracedFragment& fragment, const FragmentBounds& bounds) const;

  // Whether the exact line or point might not cover the fragment's pixel: line_may_miss() or
  // point_may_miss() with the bounds of this line's ends.
  bool may_miss(const Fragment& fragment) const;

private:
  bool is_point_ = false;
  std::array<LineEnd, 2> ends_;
  double moved_ = 0;  // the largest distance of the snapped ends from the exact ones, in pixels
  TriangleSetup setup_;
  SetupBounds setup_bounds_;
  std::optional<PieceColors> colors_;
};

}  // namespace glassbox
