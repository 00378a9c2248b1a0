#include "app/step/stepped_triangle.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/options/arguments.h"

#include <glassbox/render/staged/staged.h>

namespace glassbox::app {

namespace {

// The same view with the usual formulation of its matrices; nothing if the options choose the usual
// formulation.
std::optional<View> usual_view(const Scene& scene, const PictureOptions& picture) {
  if (picture.camera.formulation == Formulation{}) return std::nullopt;
  PictureOptions usual = picture;
  usual.camera.formulation = {};
  const Result<ChosenView> chosen = choose_view(scene, usual);
  return chosen ? std::optional(chosen->view) : std::nullopt;
}

std::optional<ObjectCulling> culling_of(const Scene& scene, const View& view,
                                        const RenderSettings& settings, std::uint32_t instance) {
  if (settings.cull_stage == CullStage::kScreen) return std::nullopt;
  const PreparedScene prepared = prepare_scene(scene, settings.transfer);
  const DrawList list = make_draw_list(scene, prepared, view);
  const auto draw = std::ranges::find(list.draws, instance, &Draw::instance);
  return object_culling(*draw, view, settings);
}

// The number of the triangle that is visible in a pixel.
Result<std::uint32_t> pick(const Scene& scene, const PictureOptions& picture, PixelPosition pixel) {
  const Result<ChosenView> chosen = choose_view(scene, picture);
  if (!chosen) return tl::unexpected(chosen.error());
  RenderSettings settings = with_one_sample(picture.settings);
  settings.want_id = true;
  const Rendering rendering = render_staged(scene, chosen->view, settings);
  const std::uint32_t id = rendering.buffers.id.at(pixel.x, pixel.y);
  if (id == 0) {
    return fail(fmt::format("--pick {},{}", pixel.x, pixel.y),
                "no triangle is visible in this pixel",
                "glassbox pixel shows what was drawn there; --triangle N chooses a triangle");
  }
  return id - 1;
}

}  // namespace

Result<SteppedTriangle> step_through(const Scene& scene, const PictureOptions& picture,
                                     std::uint32_t triangle) {
  const Result<ChosenView> chosen = choose_view(scene, picture);
  if (!chosen) return tl::unexpected(chosen.error());
  TraceFilter filter;
  filter.triangle = triangle;
  RenderSettings settings = picture.settings;
  settings.want_id = true;
  TracedRun run = trace(scene, chosen->view, settings, filter);

  SteppedTriangle stepped;
  stepped.chosen = *chosen;
  stepped.formulation = picture.camera.formulation;
  stepped.usual_view = usual_view(scene, picture);
  stepped.trace = std::move(run.trace);
  stepped.place = *find_triangle(scene, triangle);
  const auto& ids = run.rendering.buffers.id.pixels;
  stepped.visible_pixels = int(std::count(ids.begin(), ids.end(), triangle + 1));
  if (stepped.trace.triangles.empty()) return stepped;
  stepped.triangle = stepped.trace.triangles.front();
  stepped.draw_bounds = bounds_of(draw_of(stepped), chosen->view);
  stepped.bounds =
      bounds_of(stepped.trace, *stepped.triangle, draw_of(stepped), stepped.draw_bounds);
  stepped.object_culling =
      culling_of(scene, chosen->view, picture.settings, stepped.place.instance);
  return stepped;
}

Result<void> set_step_target(StepTarget& target, const Scene& scene, const PictureOptions& picture,
                             std::optional<std::uint32_t> triangle,
                             std::optional<PixelPosition> pixel, const std::string& dashes) {
  if (triangle) {
    const auto legal = check_triangle(dashes + "triangle", scene, *triangle);
    if (!legal) return legal;
    target.triangle = *triangle;
    target.pixel.reset();
  }
  if (pixel) {
    const auto legal = check_pixel(dashes + "pick", *pixel, picture.size);
    if (!legal) return legal;
    const Result<std::uint32_t> picked = pick(scene, picture, *pixel);
    if (!picked) return tl::unexpected(picked.error());
    target.triangle = *picked;
    target.pixel = pixel;
  }
  return {};
}

const TracedDraw& draw_of(const SteppedTriangle& stepped) {
  const auto& draws = stepped.trace.draws;
  return *std::find_if(draws.begin(), draws.end(), [&](const TracedDraw& draw) {
    return draw.instance == stepped.place.instance;
  });
}

}  // namespace glassbox::app
