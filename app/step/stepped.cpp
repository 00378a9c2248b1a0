#include "app/step/stepped.h"

#include <algorithm>

#include <fmt/format.h>

#include <glassbox/render/staged.h>

namespace glassbox::app {

Result<SteppedTriangle> step_through(const Scene& scene, const PictureOptions& picture,
                                     std::uint32_t triangle) {
  const Result<ChosenView> chosen = choose_view(scene, picture);
  if (!chosen) return tl::unexpected(chosen.error());
  TraceFilter filter;
  filter.triangle = triangle;
  RenderSettings settings = picture.settings;
  settings.want_id = true;
  TracedRun run = trace(scene, chosen->view, settings, filter);

  SteppedTriangle stepped{
      *chosen, std::move(run.trace), *find_triangle(scene, triangle), {}, {}, {}, 0};
  const auto& ids = run.rendering.buffers.id.pixels;
  stepped.seen = int(std::count(ids.begin(), ids.end(), triangle + 1));
  if (stepped.trace.triangles.empty()) return stepped;
  stepped.triangle = stepped.trace.triangles.front();
  stepped.draw_bounds = bounds_of(draw_of(stepped), chosen->view);
  stepped.bounds =
      bounds_of(stepped.trace, *stepped.triangle, draw_of(stepped), stepped.draw_bounds);
  return stepped;
}

Result<std::uint32_t> pick(const Scene& scene, const PictureOptions& picture, int x, int y) {
  const Result<ChosenView> chosen = choose_view(scene, picture);
  if (!chosen) return tl::unexpected(chosen.error());
  RenderSettings settings = at_centres(picture.settings);
  settings.want_id = true;
  const Rendering rendering = render_staged(scene, chosen->view, settings);
  const std::uint32_t id = rendering.buffers.id.at(x, y);
  if (id == 0) {
    return fail(fmt::format("--pick {},{}", x, y), "no triangle is seen in this pixel",
                "glassbox pixel tells what passes there; --triangle N names a triangle");
  }
  return id - 1;
}

const TracedDraw& draw_of(const SteppedTriangle& stepped) {
  const auto& draws = stepped.trace.draws;
  return *std::find_if(draws.begin(), draws.end(), [&](const TracedDraw& draw) {
    return draw.instance == stepped.place.instance;
  });
}

}  // namespace glassbox::app
