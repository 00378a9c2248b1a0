#include "app/info/info_stiffness.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/options/picture_options.h"
#include "study/commands/stiffness/report.h"

#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/vertex_stage.h>
#include <glassbox/render/trace/numbering.h>

#include "study/stiffness/stiffness.h"

namespace glassbox::app {

namespace {

// The check takes about four microseconds per triangle.
constexpr std::uint64_t kMostTriangles = 200'000;
// The check takes about half a microsecond per fragment, and at most half of a triangle's bounding
// box is fragments.
constexpr double kMostBoxPixels = 1 << 25;

// The number of the picture's pixels in a triangle's bounding box; all pixels if a corner is not in
// front of the eye.
double box_pixels(const Draw& draw, const Triangle& triangle, const Viewport& viewport) {
  float left = viewport.right, right = viewport.left, top = viewport.bottom, bottom = viewport.top;
  for (const std::uint32_t corner : triangle.corners) {
    const auto clip = project_vertex(draw, draw.mesh->corners[corner].position);
    if (!(clip.w > 0)) return double(viewport.width()) * double(viewport.height());
    const auto at = to_screen(divide(clip), viewport).position;
    left = std::min(left, std::max(at.x, viewport.left));
    right = std::max(right, std::min(at.x, viewport.right));
    top = std::min(top, std::max(at.y, viewport.top));
    bottom = std::max(bottom, std::min(at.y, viewport.bottom));
  }
  return std::max(0.0, double(right - left)) * std::max(0.0, double(bottom - top));
}

double box_pixels(const Scene& scene, const View& view) {
  const PreparedScene prepared = prepare(scene, Transfer::kSrgb);
  const DrawList list = make_draw_list(scene, prepared, view);
  double sum = 0;
  for (const Draw& draw : list.draws) {
    for (const Triangle& triangle : draw.triangulation->triangles)
      sum += box_pixels(draw, triangle, view.viewport);
  }
  return sum;
}

std::vector<std::string> not_asked(const std::string& because) {
  return {fmt::format(
      "how exact the usual view is was not asked, because of {}; glassbox study stiffness does it",
      because)};
}

}  // namespace

std::vector<std::string> stiffness_of_framed(const Scene& scene) {
  const std::uint64_t triangles = count_triangles(scene);
  if (triangles > kMostTriangles) return not_asked(fmt::format("{} triangles", triangles));
  const PictureOptions usual;
  const Result<ChosenView> chosen = choose_view(scene, usual);
  if (!chosen) return {};
  if (!(box_pixels(scene, chosen->view) <= kMostBoxPixels))
    return not_asked("how often its triangles cover each other");
  return study::stiffness_warnings(scene, study::stiffness_of(scene, chosen->view, usual.settings,
                                                              study::up_of(scene, usual.camera)));
}

}  // namespace glassbox::app
