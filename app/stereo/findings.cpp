#include "app/stereo/findings.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <glassbox/base/elapsed.h>
#include <glassbox/render/visible_depth_span.h>

namespace glassbox::app {

namespace {

using Clock = std::chrono::steady_clock;

// Returns the result of `draw` and its time. The second call is timed, when the engine already has
// its threads and memory.
template <class Draw>
auto timed_second_run(const Draw& draw, double& ms) {
  draw();
  const Clock::time_point start = Clock::now();
  auto drawn = draw();
  ms = elapsed_ms(start);
  return drawn;
}

// ---- depth ----

std::optional<DepthSpan> visible_span(const Framebuffer& left, const Framebuffer& right) {
  const auto a = depth_span(left.distance), b = depth_span(right.distance);
  if (!a || !b) return a ? a : b;
  return DepthSpan{std::min(a->nearest, b->nearest), std::max(a->farthest, b->farthest)};
}

DepthFindings find_depth(const Scene& scene, const ChosenEyes& chosen,
                         const StereoRendering& rendering, const StereoCriteria& criteria) {
  const View& centre = chosen.centre;
  const StereoPair& pair = chosen.eyes.pair;
  const Framebuffer &left = rendering.left, &right = rendering.right;
  DepthFindings found;
  const double budget = criteria.budget_percent / 100 * double(centre.viewport.width());
  found.budget = {budget, budget};
  found.planes = parallax_table(centre, pair);
  found.seen = visible_span(left, right);
  if (found.seen) {
    found.nearest = parallax_at(centre, pair, found.seen->nearest);
    found.farthest = parallax_at(centre, pair, found.seen->farthest);
  }
  found.nearest_displayed = displayed_parallax(found.nearest, criteria.display);
  found.farthest_displayed = displayed_parallax(found.farthest, criteria.display);
  found.disparity = {disparity_map(centre, pair, left.distance),
                     disparity_map(centre, pair, right.distance)};
  found.summary = {summarise_disparity(found.disparity.left, found.budget),
                   summarise_disparity(found.disparity.right, found.budget)};
  found.histogram = histogram_of(found.disparity.left);
  found.monocular = monocular_maps(found.disparity.left, found.disparity.right);
  found.monocular_counts = {count_monocular(found.monocular.left),
                            count_monocular(found.monocular.right)};
  found.violations =
      window_violations(scene, {left, found.disparity.left}, {right, found.disparity.right});
  return found;
}

// ---- vertical parallax ----

// The eye-space point that is visible at a pixel's centre in the picture of the camera between the
// eyes.
Point<Eye, double> eye_point(const View& centre, int x, int y, double distance) {
  const auto& m = centre.clip_from_eye;
  const double w = centre.perspective ? distance : 1;
  const double x_ndc = 2 * (x + 0.5) / double(centre.viewport.width()) - 1;
  const double y_ndc = 1 - 2 * (y + 0.5) / double(centre.viewport.height());
  const auto solved = [&](double ndc, int row) {
    return (ndc * w - m.at(row, 2) * -distance - m.at(row, 3)) / m.at(row, row);
  };
  return {solved(x_ndc, 0), solved(y_ndc, 1), -distance};
}

// The y of a point in an eye's picture, in px, upwards.
double picture_y(const View& eye, const Point<Eye, double>& p) {
  const auto& m = eye.clip_from_eye;
  const auto row = [&](int i) {
    return m.at(i, 0) * p.x + m.at(i, 1) * p.y + m.at(i, 2) * p.z + m.at(i, 3);
  };
  return row(1) / row(3) * double(eye.viewport.height()) / 2;
}

VerticalFindings find_vertical(const ChosenEyes& chosen, const Image<float>& distances) {
  const View& centre = chosen.centre;
  const View left = eye_view(centre, chosen.eyes.pair, Side::kLeft);
  const View right = eye_view(centre, chosen.eyes.pair, Side::kRight);
  VerticalFindings found;
  for (int y = 0; y < distances.height; ++y) {
    for (int x = 0; x < distances.width; ++x) {
      const double distance = double(distances.at(x, y));
      if (!std::isfinite(distance)) continue;
      const Point<Eye, double> point = eye_point(centre, x, y, distance);
      const double skewed = std::abs(picture_y(left, point) - picture_y(right, point));
      found.skewed_px = std::max(found.skewed_px, skewed);
      const double toed_in = std::abs(toe_in_vertical_parallax_px(centre, chosen.eyes.pair, point));
      if (!std::isfinite(toed_in) || toed_in <= found.toed_in_px) continue;
      found.toed_in_px = toed_in;
      found.x = x;
      found.y = y;
    }
  }
  return found;
}

// ---- colour ----

struct MapSizes {
  double mean = 0, largest = 0;
};

MapSizes sizes_of(Image<float> map) {
  double largest = 0;
  for (float& value : map.pixels) {
    value = std::abs(value);
    largest = std::max(largest, double(value));
  }
  return {mean_of(map), largest};
}

Result<MethodFindings> find_method(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                   AnaglyphMethod method, Glasses glasses) {
  const Result<AnaglyphViewing> seen = anaglyph_viewing(method, glasses);
  if (!seen) return tl::unexpected(seen.error());
  const Result<GhostMaps> ghosts = ghost_maps(left, right, *seen);
  if (!ghosts) return tl::unexpected(ghosts.error());
  return MethodFindings{
      method, (mean_of(rivalry_map(left, *seen)) + mean_of(rivalry_map(right, *seen))) / 2,
      (sizes_of(ghosts->left).mean + sizes_of(ghosts->right).mean) / 2};
}

Result<ColourFindings> find_colour(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                   const StereoCriteria& criteria) {
  const Result<AnaglyphViewing> seen = anaglyph_viewing(criteria.method, criteria.glasses);
  if (!seen) return tl::unexpected(seen.error());
  Result<Image<Rgba8>> anaglyph = make_anaglyph(left, right, criteria.method, criteria.glasses);
  if (!anaglyph) return tl::unexpected(anaglyph.error());
  Result<GhostMaps> ghosts = ghost_maps(left, right, *seen);
  if (!ghosts) return tl::unexpected(ghosts.error());

  ColourFindings found;
  found.anaglyph = std::move(*anaglyph);
  found.rivalry = {rivalry_map(left, *seen), rivalry_map(right, *seen)};
  const MapSizes of_left = sizes_of(found.rivalry.left), of_right = sizes_of(found.rivalry.right);
  found.mean_rivalry = (of_left.mean + of_right.mean) / 2;
  found.worst_rivalry = std::max(of_left.largest, of_right.largest);
  found.ghosts = std::move(*ghosts);
  const MapSizes in_left = sizes_of(found.ghosts.left), in_right = sizes_of(found.ghosts.right);
  found.mean_ghost = {in_left.mean, in_right.mean};
  found.worst_ghost = {in_left.largest, in_right.largest};
  found.white_leak = white_leak(*seen);
  found.measured_lenses = seen->lenses.measured;
  for (const auto& method : all_anaglyph_methods()) {
    // Methods that were published for other glasses are skipped.
    if (const auto one = find_method(left, right, method.value, criteria.glasses)) {
      found.methods.push_back(*one);
    }
  }
  if (found.mean_rivalry > criteria.target_rivalry) {
    Result<Suggestion> suggestion = suggest_recolour(left, right, *seen, criteria.target_rivalry);
    if (!suggestion) return tl::unexpected(suggestion.error());
    found.suggestion = std::move(*suggestion);
  }
  return found;
}

// ---- culling ----

std::uint64_t differing_pixels(const Framebuffer& a, const Framebuffer& b) {
  std::uint64_t differing = 0;
  for (std::size_t i = 0; i < a.id.pixels.size(); ++i) {
    differing += a.id.pixels[i] != b.id.pixels[i] || a.color.pixels[i] != b.color.pixels[i];
  }
  return differing;
}

CullingFindings find_culling(Renderer& renderer, const ChosenEyes& chosen,
                             const RenderSettings& settings, const StereoRendering& whole) {
  const StereoRendering culled =
      renderer.render_pair(chosen.centre, chosen.eyes.pair, {settings, StereoCulling::kCentre});
  return {culled.lost,
          {differing_pixels(whole.left, culled.left), differing_pixels(whole.right, culled.right)}};
}

}  // namespace

double DepthFindings::share_beyond_budget() const {
  const std::uint64_t drawn = summary.left.drawn + summary.right.drawn;
  const std::uint64_t beyond =
      summary.left.too_near + summary.left.too_far + summary.right.too_near + summary.right.too_far;
  return drawn == 0 ? 0 : double(beyond) / double(drawn);
}

double DepthFindings::largest_percent() const {
  return std::max(std::abs(nearest.percent), std::abs(farthest.percent));
}

Result<StereoFindings> find_stereo(const Scene& scene, Renderer& renderer, const ChosenEyes& chosen,
                                   const RenderSettings& picture, const StereoCriteria& criteria) {
  RenderSettings settings = picture;
  settings.want_distance = settings.want_id = true;
  StereoFindings found;
  found.chosen = chosen;
  found.criteria = criteria;

  const Rendering one =
      timed_second_run([&] { return renderer.render(chosen.centre, settings); }, found.cost.one_ms);
  found.rendering = timed_second_run(
      [&] { return renderer.render_pair(chosen.centre, chosen.eyes.pair, {settings}); },
      found.cost.both_ms);
  found.culling = find_culling(renderer, chosen, settings, found.rendering);

  found.depth = find_depth(scene, chosen, found.rendering, criteria);
  found.vertical = find_vertical(chosen, one.buffers.distance);
  const Image<Rgba8>&left = found.rendering.left.color, &right = found.rendering.right.color;
  Result<ColourFindings> colour = find_colour(left, right, criteria);
  if (!colour) return tl::unexpected(colour.error());
  found.colour = std::move(*colour);

  const Image<float>& disparity = found.depth.disparity.left;
  const auto marks = information_map(left, disparity);
  if (!marks) return tl::unexpected(marks.error());
  found.information_map = *marks;
  found.information = *stereo_information(left, disparity);
  const auto pair = pair_order(left, right, disparity);
  if (!pair) return tl::unexpected(pair.error());
  found.pair_order = *pair;
  const auto anaglyph = anaglyph_order(found.colour.anaglyph, criteria.glasses, disparity);
  if (!anaglyph) return tl::unexpected(anaglyph.error());
  found.anaglyph_order = *anaglyph;
  return found;
}

}  // namespace glassbox::app
