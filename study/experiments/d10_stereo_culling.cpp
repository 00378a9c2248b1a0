// Compares the frustum by which a stereo pair is culled, and what is lost (D-10).
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/forest.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>
#include <glassbox/pipeline/stereo/culling.h>
#include <glassbox/render/tile/tile_engine.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d10_lost_pixels.h"
#include "study/experiments/d10_methods.h"

namespace glassbox::study {

namespace d10 {

// ---- what is lost ----

// Whether the triangle belongs to a backdrop: ground and sky are single rectangles, which are never
// completely outside the picture.
bool is_backdrop(const Eyes& eyes, std::uint32_t id) {
  for (const Draw& draw : eyes.list.draws) {
    const std::uint32_t number = id - 1, count = draw.triangulation->numbered;
    if (number >= draw.first_number && number < draw.first_number + count) return count <= 2;
  }
  return false;
}

// Counts the pixels of both eyes that show a point outside the centre camera's picture; the
// parallax of the point's distance tells where the centre camera has it. Backdrops are not counted.
// Returns the number per row and eye.
double strip_columns(const Eyes& eyes) {
  double beside = 0;
  for (const bool left : {true, false}) {
    const Framebuffer all = draw(eyes.scene, left ? eyes.left : eyes.right);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double z = double(all.distance.at(x, y));
        if (!std::isfinite(z)) continue;
        const double half = parallax_at(eyes.centre, eyes.pair, z).px / 2;
        const double centre_x = x + 0.5 + (left ? half : -half);
        beside += (centre_x < 0 || centre_x > kWidth) && !is_backdrop(eyes, all.id.at(x, y));
      }
    }
  }
  return beside / (2 * kHeight);
}

// ---- the table ----

void add_scene(const std::string& name, const std::shared_ptr<const Eyes>& eyes, double share,
               double predicted, const std::optional<Finding>& finding,
               std::vector<Configuration>& all) {
  double triangles = 0;
  for (const Draw& draw : eyes->list.draws)
    triangles += double(draw.triangulation->triangles.size());
  for (const Method& method : kMethods) {
    const bool loses = method.cull == cull_by_centre;
    all.push_back({.series = method.name,
                   .parameter = 100 * share,
                   .scene = name,
                   .error = [=] { return lost_columns(*eyes, cull(*eyes, method)); },
                   .predicted_error = loses ? predicted : 0,
                   .finding = loses ? finding : std::nullopt,
                   .work = [=](int) { cull(*eyes, method); },
                   .items = triangles});
  }
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<double> shares{0.01, 0.03, 0.1};
  if (effort == Effort::kFull) shares = {0.01, 0.015, 0.02, 0.03, 0.05, 0.07, 0.1};
  std::vector<Configuration> all;
  const View view = centre_view();
  for (const double share : shares) {
    const StereoPair pair{share * kWindow, kWindow};
    for (const auto& [name, distance] :
         {std::pair{"strips in front of the window", 6.0}, {"strips behind the window", 60.0}})
      add_scene(name, make_eyes(strips(distance), view, pair), share,
                missing_strip_px(view, pair, distance), {}, all);
    Scene forest = make_forest();
    const View standing = make_view(forest.cameras.front(), kWidth, kHeight).value();
    const auto eyes = make_eyes(std::move(forest), standing, pair);
    add_scene(
        "forest", eyes, share, strip_columns(*eyes),
        Finding{"a triangle that reaches into the picture of the centre camera is drawn whole, and "
                "triangles of near trees are wider than the strip: less is lost, or nothing",
                0, 1},
        all);
  }
  return all;
}

}  // namespace d10

Experiment d10_stereo_culling() {
  using namespace d10;
  return {
      .id = "D-10",
      .name = "Stereo culling: with which frustum",
      .question =
          "How many pixels do the eyes lose if one frustum culls for both, and what does it cost "
          "to lose none?",
      .axis = "half the separation of the eyes over the distance of the window",
      .axis_unit = "%",
      .error = "pixels that show something else, per row and eye",
      .error_unit = "px",
      .reference = "both eyes' pictures with nothing culled",
      .theory =
          "At one side, the frustum of the centre camera lacks half of the parallax of each eye's "
          "frustum, (W/2)(d/h) s |1/z - 1/f| columns (S0-04 in docs/references.md). In the forest, "
          "the formula is applied to each tree's pixels at its own distance. The other ways never "
          "cull what an eye can see, so they lose 0 pixels.",
      .item = "triangle",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
