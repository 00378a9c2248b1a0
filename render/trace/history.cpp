#include <glassbox/render/trace/history.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <glassbox/raster/blend.h>
#include <glassbox/render/engine/distance.h>

namespace glassbox {

namespace {

// ---- what clipping cut off ----

double determinant(const std::array<double, 3>& a, const std::array<double, 3>& b,
                   const std::array<double, 3>& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
         c[0] * (a[1] * b[2] - a[2] * b[1]);
}

bool mirrored(const Trace& trace, std::uint32_t instance) {
  return std::any_of(trace.draws.begin(), trace.draws.end(), [&](const TracedDraw& draw) {
    return draw.instance == instance && draw.mirrored;
  });
}

struct SeenPoint {
  Point<Clip, double> clip;
  bool counter_clockwise = true;  // winding of the corners as seen at the pixel
};

// Finds the point of the unclipped triangle that is seen through the pixel's centre, in front of
// the eye: the combination of its corners, with non-negative weights, whose x, y and w are a
// multiple of (x, y, 1) for the centre's x and y in NDC (Olano and Greer 1997). Returns nothing if
// the triangle does not cover that centre.
std::optional<SeenPoint> unclipped_point_at(const TracedTriangle& triangle, const Viewport& window,
                                            int x, int y) {
  const std::array<double, 3> centre{
      2 * (x + 0.5 - double(window.left)) / double(window.width()) - 1,
      1 - 2 * (y + 0.5 - double(window.top)) / double(window.height()), 1};
  std::array<std::array<double, 3>, 3> c;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point<Clip>& p = triangle.corners[k].clip;
    c[k] = {p.x, p.y, p.w};
  }
  const double whole = determinant(c[0], c[1], c[2]);
  const std::array<double, 3> parts{determinant(centre, c[1], c[2]),
                                    determinant(c[0], centre, c[2]),
                                    determinant(c[0], c[1], centre)};
  if (whole == 0 || !std::isfinite(whole)) return std::nullopt;
  double sum = 0;
  for (const double part : parts) {
    if (!(part / whole >= 0)) return std::nullopt;
    sum += part / whole;
  }
  if (!(sum > 0)) return std::nullopt;
  Point<Clip, double> point{0, 0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point<Clip>& p = triangle.corners[k].clip;
    const double weight = parts[k] / whole / sum;
    point.x += weight * p.x;
    point.y += weight * p.y;
    point.z += weight * p.z;
    point.w += weight * p.w;
  }
  return SeenPoint{point, whole > 0};
}

std::optional<PixelEvent> clipped_event(const TracedTriangle& triangle, const Trace& trace, int x,
                                        int y) {
  const auto seen = unclipped_point_at(triangle, trace.view.viewport, x, y);
  if (!seen) return std::nullopt;
  const Point<Clip, double>& point = seen->clip;
  for (const ClipPlane& plane : trace.planes) {
    const double inside =
        plane.a * point.x + plane.b * point.y + plane.c * point.z + plane.d * point.w + plane.e;
    if (inside >= 0) continue;
    PixelEvent event;
    event.kind = PixelEventKind::kClipped;
    event.plane = plane.name;
    event.inside = inside;
    event.front = seen->counter_clockwise != mirrored(trace, triangle.instance);
    event.distance = distance_along_gaze(trace.view, float(point.z / point.w), float(1 / point.w));
    return event;
  }
  return std::nullopt;
}

// ---- triangles ----

bool was_cut(const TracedTriangle& triangle) {
  return triangle.pieces.empty() || !triangle.clipping.empty();
}

// Returns the effect of a triangle that has no fragment at the pixel: a triangle of its fan that
// covers the pixel was culled, or a clipping plane cut off the part that would cover it.
std::optional<PixelEvent> event_without_fragment(const TracedTriangle& triangle, const Trace& trace,
                                                 int x, int y) {
  for (std::uint32_t i = 0; i < triangle.pieces.size(); ++i) {
    const TracedPiece& piece = triangle.pieces[i];
    if (!piece.setup || miss_at(*piece.setup, x, y)) continue;
    if (!piece.culled) return std::nullopt;  // it has a fragment
    PixelEvent event;
    event.kind = PixelEventKind::kTurnedAway;
    event.source.piece = i;
    const double area = double(piece.setup->double_area) / (2.0 * kSubpixels * kSubpixels);
    event.area_px2 = piece.setup->clockwise ? -area : area;
    event.front = piece.front;
    return event;
  }
  return was_cut(triangle) ? clipped_event(triangle, trace, x, y) : std::nullopt;
}

bool reaches(const TracedPiece& piece, int x, int y) {
  return contains(pixels_touched(piece.vertices), x, y);
}

// Returns the smallest distance by which the triangles of the fan miss the pixel's centre; nothing
// if one of them covers it, or if none has a box that reaches into the pixel.
std::optional<CentreMiss> miss_of(const TracedTriangle& triangle, int x, int y) {
  std::optional<CentreMiss> nearest;
  for (const TracedPiece& piece : triangle.pieces) {
    if (!piece.setup || piece.culled || !reaches(piece, x, y)) continue;
    const auto miss = miss_at(*piece.setup, x, y);
    if (!miss) return std::nullopt;
    if (!nearest || miss->subpixels < nearest->subpixels) nearest = miss;
  }
  return nearest;
}

bool has_no_area_at(const TracedTriangle& triangle, int x, int y) {
  return std::any_of(triangle.pieces.begin(), triangle.pieces.end(),
                     [&](const TracedPiece& piece) { return reaches(piece, x, y); }) &&
         std::none_of(triangle.pieces.begin(), triangle.pieces.end(),
                      [](const TracedPiece& piece) { return piece.setup.has_value(); });
}

// ---- fragments ----

bool masks_all_channels(const ColorMask& mask) {
  return !mask.r && !mask.g && !mask.b && !mask.a;
}

PixelEventKind kind_of_event(FragmentResult result, const ColorMask& mask) {
  if (result == FragmentResult::kHidden) return PixelEventKind::kHidden;
  if (result == FragmentResult::kDiscarded) return PixelEventKind::kDiscarded;
  if (masks_all_channels(mask)) return PixelEventKind::kMasked;
  return result == FragmentResult::kBlended ? PixelEventKind::kBlended : PixelEventKind::kWritten;
}

PixelEvent fragment_event(const Scene& scene, const Trace& trace, const TracedFragment& traced) {
  PixelEvent event;
  event.kind = kind_of_event(traced.result, trace.settings.mask);
  event.source = traced.source;
  event.instance = traced.instance;
  event.distance =
      distance_along_gaze(trace.view, traced.fragment.depth, traced.fragment.inverse_w);
  event.code = traced.code;
  event.stored = traced.stored;
  event.writes_depth = traced.result == FragmentResult::kWritten;
  event.alpha = traced.surface.a;
  event.cutoff =
      scene.materials[scene.meshes[scene.instances[traced.instance].mesh].material].alpha_cutoff;
  event.light = traced.light;
  event.before = event.after = traced.before;
  if (event.kind >= PixelEventKind::kMasked)
    write_masked(trace.settings.mask, traced.after, event.after);
  return event;
}

// ---- the order of the events ----

// The place of an event in the run: the index of the draw, the number of the triangle, and the
// index in its fan. Lines and points come after the triangles of their draw.
using Place = std::tuple<std::size_t, std::uint32_t, std::uint32_t>;

std::vector<PixelEvent> sorted_events(std::vector<std::pair<Place, PixelEvent>> placed) {
  std::stable_sort(placed.begin(), placed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<PixelEvent> events;
  for (const auto& [place, event] : placed) events.push_back(event);
  return events;
}

// Finds which event wrote the depth that a fragment was compared with, and which event overwrote
// which.
void link_overwritten(std::vector<PixelEvent>& events) {
  std::optional<std::size_t> nearest;
  std::vector<std::size_t> showing;
  for (std::size_t i = 0; i < events.size(); ++i) {
    PixelEvent& event = events[i];
    if (!is_fragment(event)) continue;
    event.stored_by = nearest;
    const bool opaque = event.kind == PixelEventKind::kWritten ||
                        (event.kind == PixelEventKind::kBlended && event.alpha >= 1);
    if (opaque) {
      for (const std::size_t under : showing) events[under].overwritten_by = i;
      showing.clear();
    }
    if (event.kind >= PixelEventKind::kBlended) showing.push_back(i);
    if (event.writes_depth) nearest = i;
  }
}

}  // namespace

const char* name_of(PixelEventKind kind) {
  constexpr const char* kNames[] = {"clipped", "turned-away", "hidden", "discarded",
                                    "masked",  "blended",     "written"};
  return kNames[std::size_t(kind)];
}

PixelHistory pixel_history(const Scene& scene, const TracedRun& run, int x, int y) {
  const Trace& trace = run.trace;
  PixelHistory history;
  history.x = x;
  history.y = y;
  history.cleared = trace.settings.background;
  history.shown = run.rendering.buffers.color.at(x, y);
  history.complete = trace.complete;
  const Show show = trace.settings.show;
  history.shows_bytes = show == Show::kColor || show == Show::kNormal || show == Show::kUv;

  // The place of each instance among the draws.
  std::vector<std::size_t> turn(scene.instances.size());
  for (std::size_t i = 0; i < trace.draws.size(); ++i) turn[trace.draws[i].instance] = i;

  std::vector<std::pair<Place, PixelEvent>> placed;
  // The number and the face of each traced triangle.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> faces;
  for (const TracedTriangle& triangle : trace.triangles) {
    faces.emplace_back(triangle.number, triangle.face);
    if (auto event = event_without_fragment(triangle, trace, x, y)) {
      event->source.number = triangle.number;
      event->instance = triangle.instance;
      event->face = triangle.face;
      placed.push_back({{turn[triangle.instance], triangle.number, event->source.piece}, *event});
    } else if (const auto miss = miss_of(triangle, x, y)) {
      history.misses.push_back({triangle.number, triangle.instance, triangle.face, *miss});
    } else {
      history.without_area += has_no_area_at(triangle, x, y) ? 1u : 0u;
    }
  }
  std::sort(faces.begin(), faces.end());
  for (const TracedFragment& traced : trace.fragments) {
    if (traced.fragment.x != x || traced.fragment.y != y) continue;
    PixelEvent event = fragment_event(scene, trace, traced);
    std::uint32_t number = std::numeric_limits<std::uint32_t>::max();
    if (traced.source.is_triangle) {
      number = traced.source.number;
      const auto found = std::lower_bound(faces.begin(), faces.end(), std::pair{number, 0u});
      if (found != faces.end() && found->first == number) event.face = found->second;
    }
    placed.push_back({{turn[traced.instance], number, traced.source.piece}, event});
  }
  std::stable_sort(
      history.misses.begin(), history.misses.end(),
      [](const PixelMiss& a, const PixelMiss& b) { return a.miss.subpixels < b.miss.subpixels; });
  history.events = sorted_events(std::move(placed));
  link_overwritten(history.events);
  for (std::size_t i = 0; i < history.events.size(); ++i) {
    if (survives(history.events[i])) history.shows = i;
  }
  return history;
}

PixelHistory pixel_history(const Scene& scene, const View& view, const RenderSettings& settings,
                           int x, int y, Rendering* rendering) {
  TraceFilter filter;
  filter.pixels = PixelRect{x, y, x + 1, y + 1};
  TracedRun run = trace(scene, view, settings, filter);
  PixelHistory history = pixel_history(scene, run, x, y);
  if (rendering != nullptr) *rendering = std::move(run.rendering);
  return history;
}

}  // namespace glassbox
