// D-10: by which frustum a pair of eyes culls, and what is lost.
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
#include "study/experiments/d10_ways.h"

namespace glassbox::study {

namespace {

using namespace d10;

// ---- what is lost ----

// The scene of those triangles that are kept, each draw with a mesh of its own.
Scene subset(const Eyes& eyes, const std::vector<KeptOfDraw>& kept, bool left) {
  Scene scene = eyes.scene;
  scene.meshes.clear();
  scene.instances.clear();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Draw& draw = eyes.list.draws[i];
    const Kept& mine = left || kept[i].right.empty() ? kept[i].left : kept[i].right;
    Mesh mesh = *draw.mesh;
    mesh.faces.clear();
    mesh.corners.clear();
    for (std::size_t t = 0; t < mine.size(); ++t) {
      if (!mine[t]) continue;
      mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 3});
      for (const std::uint32_t corner : draw.triangulation->triangles[t].corners)
        mesh.corners.push_back(draw.mesh->corners[corner]);
    }
    if (mesh.faces.empty()) continue;
    scene.instances.push_back(
        {std::uint32_t(scene.meshes.size()), eyes.scene.instances[draw.instance].node});
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

RenderSettings distances_only() {
  RenderSettings settings;
  settings.mask = {false, false, false, false};
  settings.want_distance = settings.want_id = true;
  return settings;
}

Framebuffer draw(const Scene& scene, const View& view) {
  return render_tiled(scene, view, distances_only(), {.threads = 1}).buffers;
}

// Per row and eye.
double lost_columns(const Eyes& eyes, const Way& way) {
  const std::vector<KeptOfDraw> kept = cull(eyes, way);
  double lost = 0;
  for (const bool left : {true, false}) {
    const View& view = left ? eyes.left : eyes.right;
    const Image<float> all = draw(eyes.scene, view).distance,
                       drawn = draw(subset(eyes, kept, left), view).distance;
    for (std::size_t i = 0; i < all.pixels.size(); ++i) lost += all.pixels[i] != drawn.pixels[i];
  }
  return lost / (2 * kHeight);
}

// One rectangle each: ground and sky, which are never wholly outside.
bool is_backdrop(const Eyes& eyes, std::uint32_t id) {
  for (const Draw& draw : eyes.list.draws) {
    const std::uint32_t number = id - 1, count = draw.triangulation->numbered;
    if (number >= draw.first_number && number < draw.first_number + count) return count <= 2;
  }
  return false;
}

// Pixels whose point the centre camera has beside its picture, by the parallax of their distance, backdrops left out; per row
// and eye.
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

// ---- scenes ----

constexpr double kWindow = 12;

View centre_view() {
  Camera camera;
  camera.lens = PerspectiveLens{0.785398163397448309616, 0.5, 200.0};
  return make_view(camera, kWidth, kHeight).value();
}

// Thin upright strips, a quarter of a pixel wide, across more than the picture, `distance` away.
Scene strips(double distance) {
  Scene scene;
  add_material(scene, "flat", {1, 1, 1, 1});
  scene.materials.front().unlit = true;
  const double height = distance * tan_half_degrees(45), pixel = 2 * height / kHeight;
  Mesh mesh;
  for (int i = -4 * 220; i < 4 * 220; ++i)
    add_rectangle(mesh, {i * pixel / 4, -2 * height, -distance}, {pixel / 4, 0, 0},
                  {0, 4 * height, 0});
  add_object(scene, std::move(mesh));
  return scene;
}

void add_scene(const std::string& name, const std::shared_ptr<const Eyes>& eyes, double share,
               double predicted, const std::optional<Finding>& finding,
               std::vector<Configuration>& all) {
  double triangles = 0;
  for (const Draw& draw : eyes->list.draws)
    triangles += double(draw.triangulation->triangles.size());
  for (const Way& way : kWays) {
    const bool loses = way.cull == cull_by_centre;
    all.push_back({.series = way.name,
                   .parameter = 100 * share,
                   .scene = name,
                   .error = [=] { return lost_columns(*eyes, way); },
                   .predicted_error = loses ? predicted : 0,
                   .finding = loses ? finding : std::nullopt,
                   .work = [=](int) { cull(*eyes, way); },
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
        Finding{
            "a triangle that reaches into the centre's picture is drawn whole, and those of near "
            "trees are wider than the strip: less is lost, down to nothing",
            0, 1},
        all);
  }
  return all;
}

}  // namespace

Experiment d10_stereo_culling() {
  return {
      .id = "D-10",
      .name = "Stereo culling: by whose frustum",
      .question =
          "What do the eyes miss when one frustum culls for both, and what does it cost to miss "
          "nothing?",
      .axis = "half the separation of the eyes over the distance of the window",
      .axis_unit = "%",
      .error = "columns of the picture that show something else, per row and eye",
      .error_unit = "px",
      .reference = "both eyes' pictures with nothing culled",
      .theory =
          "The centre's frustum ends half the parallax short of each eye's at one side: (W/2)(d/h) "
          "s |1/z - 1/f| columns (S0-04); in the forest the pixels of trees for which that holds "
          "at their own distance. The others are conservative: 0.",
      .item = "triangle",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
