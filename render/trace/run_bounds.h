// The bounds of a run's records as they come, for sinks that keep nothing.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

class BoundsOfRun {
public:
  struct Known {
    TracedTriangle triangle;
    TriangleBounds bounds;
  };

  explicit BoundsOfRun(const View& view);

  // Draws come before their triangles, triangles before their fragments.
  const DrawBounds& draw(const TracedDraw& draw);
  const Known& triangle(const TracedTriangle& triangle);
  // The fragment's triangle; null where the run's filter has left it out, and for lines and points.
  const Known* of(const TracedFragment& fragment);

  // The view and the planes; nothing else.
  const Trace& trace() const { return trace_; }

private:
  Trace trace_;
  std::map<std::uint32_t, std::pair<TracedDraw, DrawBounds>> draws_;  // by instance
  // By number: the last triangles, whose fragments are still to come, and those before them.
  std::map<std::uint32_t, Known> latest_, earlier_;
  bool fragments_came_ = false;
};

// Of a fragment of that triangle.
FragmentBounds bounds_of(const BoundsOfRun::Known& known, const TracedFragment& fragment);

}  // namespace glassbox
