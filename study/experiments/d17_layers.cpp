// Measures how many layers of how many eyes contain what another eye sees, and how much memory they
// need (D-17).
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/LU>

#include <glassbox/mesh/builtin/scenes.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d17_leaves.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/memoize.h"
#include "views/layers/depth_peeling.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_builder.h"

namespace glassbox::study {

namespace d17 {

using views::Layer;

constexpr const char *kStorage = "storage", *kMerged = "merged";
// enough for the leaves: with 3 leaves on average, one line of sight in a million meets more
constexpr int kAllLayers = 14;

// The depth-peeled layers seen from some eyes, and the picture of another eye, in which surfaces
// may be visible that the layers lack.
struct LayerTestScene {
  std::string name;
  std::vector<View> eyes;
  std::vector<std::vector<Layer>> peeled;  // one list per eye
  View other;
  Layer seen;
  double tolerance = 0;  // relative to the distance; 0: surfaces are identified by their colour
};

RenderSettings plain() {
  RenderSettings settings;
  settings.transfer = Transfer::kNone;
  settings.background = {0, 0, 0, 255};
  settings.want_distance = true;
  return settings;
}

LayerTestScene make_test_scene(std::string name, const Scene& scene, std::vector<View> eyes,
                               const View& other, int layers, double tolerance) {
  LayerTestScene test_scene{std::move(name), std::move(eyes), {}, other, {}, tolerance};
  for (const View& eye : test_scene.eyes)
    test_scene.peeled.push_back(views::peel(scene, eye, plain(), layers));
  test_scene.seen = views::peel(scene, other, plain(), 1).front();
  return test_scene;
}

views::LayeredImage build_layers(const LayerTestScene& test_scene, int layers, int eyes,
                                 double epsilon) {
  views::LayerBuilder builder(views::layer_camera(test_scene.eyes.front()), epsilon);
  for (std::size_t i = 0; i < std::size_t(eyes); ++i) {
    for (std::size_t k = 0; k < std::min(std::size_t(layers), test_scene.peeled[i].size()); ++k)
      builder.add_picture(test_scene.eyes[i], test_scene.peeled[i][k].color,
                          test_scene.peeled[i][k].distance);
  }
  return builder.pack();
}

// Whether one of the first `layers` layers of an eye contains the surface that is seen at a point
// of the world, in the pixel of that point or the nearest neighbouring pixel. The surface is
// identified by its colour, or by its distance if surfaces are shaded. Returns nothing if the point
// is outside the picture.
std::optional<bool> contains_surface(const LayerTestScene& test_scene, std::size_t eye, int layers,
                                     const Eigen::Vector4d& world, const Rgba8& color) {
  const views::LayerCamera camera = views::layer_camera(test_scene.eyes[eye]);
  const Eigen::Vector4d at = camera.screen_from_world * world;
  const double x = at.x() / at.w(), y = at.y() / at.w(), depth = at.z() / at.w();
  if (!(at.w() > 0) || !(x >= 1 && y >= 0 && x < camera.width - 1 && y < camera.height))
    return std::nullopt;
  const int column = int(x), row = int(y), beside = x - column < 0.5 ? column - 1 : column + 1;
  const auto count = std::min(std::size_t(layers), test_scene.peeled[eye].size());
  for (std::size_t k = 0; k < count; ++k) {
    const Layer& layer = test_scene.peeled[eye][k];
    for (const int u : {column, beside}) {
      const auto z = double(layer.distance.at(u, row));
      if (!std::isfinite(z)) continue;
      const double there = views::depth_of(test_scene.eyes[eye], z);
      if (test_scene.tolerance > 0 ? std::abs(there / depth - 1) < test_scene.tolerance
                                   : layer.color.at(u, row) == color)
        return true;
    }
  }
  return false;
}

// The fraction of pixels whose surface is in none of the layers, among the pixels of the other
// eye's picture that show something inside the pictures of all first eyes.
double missing(const LayerTestScene& test_scene, int layers, int eyes) {
  const views::LayerCamera camera = views::layer_camera(test_scene.other);
  const Eigen::Matrix4d back = camera.screen_from_world.inverse();
  double without = 0, seen = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const auto z = double(test_scene.seen.distance.at(x, y));
      if (!std::isfinite(z)) continue;
      const Eigen::Vector4d world =
          back * Eigen::Vector4d(x + 0.5, y + 0.5, views::depth_of(test_scene.other, z), 1);
      bool is_within = true, is_there = false;
      for (std::size_t eye = 0; eye < std::size_t(eyes); ++eye) {
        const auto found =
            contains_surface(test_scene, eye, layers, world, test_scene.seen.color.at(x, y));
        is_within = is_within && found;
        is_there = is_there || found.value_or(false);
      }
      seen += is_within;
      without += is_within && !is_there;
    }
  }
  return without / seen;
}

// The bytes for each pixel of the image: four for the colour and four for the depth of each sample,
// and four for the offset of the pixel's first sample.
double bytes_of(const views::LayeredImage& image) {
  return (8 * double(image.samples()) + 4 * double(image.first.size())) /
         double(image.first.size() - 1);
}

std::string series_of(int eyes) {
  return eyes == 1 ? "one eye's layers" : "two eyes' layers";
}

struct MissingShareLaw {
  double covered;  // T: mean number of surfaces on a line of sight
  std::optional<Finding> of_missing = {};
};

void add_layers(const std::shared_ptr<const LayerTestScene>& test_scene, int layers, int eyes,
                const MissingShareLaw& law, std::vector<Configuration>& all) {
  const auto image =
      memoize([=] { return build_layers(*test_scene, layers, eyes, views::kMergedDepths); });
  all.push_back({.series = series_of(eyes),
                 .parameter = double(layers),
                 .scene = test_scene->name,
                 .error = [=] { return missing(*test_scene, layers, eyes); },
                 .predicted_error = missing_share(law.covered, layers, eyes),
                 .finding = law.of_missing,
                 .work =
                     [=](int) {
                       views::LayerDrawing drawing;
                       drawing.splat = views::Splat::kPoint;
                       const auto to = views::layer_camera(test_scene->other);
                       do_not_optimize(views::draw_layers(image(), to, drawing));
                     }});
  if (eyes > 1) return;
  all.push_back({.series = series_of(eyes),
                 .parameter = double(layers),
                 .scene = test_scene->name,
                 .measure = kStorage,
                 .error = [=] { return bytes_of(image()); },
                 .predicted_error = 4 + 8 * kept_layers(law.covered, layers)});
}

void add_epsilon(const std::shared_ptr<const LayerTestScene>& test_scene, double epsilon,
                 std::vector<Configuration>& all) {
  all.push_back(
      {.series = series_of(1),
       .parameter = epsilon,
       .scene = test_scene->name,
       .measure = kMerged,
       .error =
           [=] {
             const auto left = build_layers(*test_scene, kAllLayers, 1, epsilon).samples(),
                        before = build_layers(*test_scene, kAllLayers, 1, 0).samples();
             return 1 - double(left) / double(before);
           },
       .predicted_error = merged_share(kCovered, epsilon),
       .work = [=](int) { do_not_optimize(build_layers(*test_scene, kAllLayers, 1, epsilon)); },
       .items = 1});
}

const Finding kLargeThings{
    "the theory assumes small objects, but walls and furniture are larger than the distance "
    "between the eyes: neighbouring lines of sight meet the same objects, so only strips beside "
    "edges come into view",
    0, 0.5};
const Finding kTrees{
    "the theory assumes small objects, but trees are as wide as the distance between the eyes, so "
    "the lines of sight of both eyes to a point often pass through the same tree",
    0.2, 1};

// A built-in scene: the eye of its camera, and another one a little to the side.
std::shared_ptr<const LayerTestScene> builtin_test_scene(const char* name, double aside) {
  const Scene scene = make_builtin(name).value();
  Camera camera = scene.cameras.at(0);
  const View eye = make_view(camera, 120, 90).value();
  for (int row = 0; row < 3; ++row)
    camera.world_from_eye.at(row, 3) += aside * camera.world_from_eye.at(row, 0);
  return std::make_shared<const LayerTestScene>(
      make_test_scene(name, scene, {eye}, make_view(camera, 120, 90).value(), 6, 0.02));
}

// The mean number of surfaces on a line of sight of the first eye.
double surfaces_on_a_line(const LayerTestScene& test_scene) {
  return double(build_layers(test_scene, kAllLayers, 1, 0).samples()) /
         double(test_scene.seen.color.pixels.size());
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  const auto slab = std::make_shared<const LayerTestScene>(make_test_scene(
      "leaves", leaves(), {eye_at_angle(0, kSourceWidth), eye_at_angle(-kAngle, kSourceWidth)},
      eye_at_angle(kAngle, kSeenWidth), kAllLayers, 0));
  for (const int layers : {1, 2, 3, 4, 6}) add_layers(slab, layers, 1, {kCovered}, all);
  for (const int layers : {1, 2, 3, 4}) add_layers(slab, layers, 2, {kCovered}, all);
  for (const double epsilon : {0x1p-6, 0x1p-4, 0x1p-2}) add_epsilon(slab, epsilon, all);
  if (effort == Effort::kFull) {
    for (const double epsilon : {0x1p-7, 0x1p-5, 0x1p-3}) add_epsilon(slab, epsilon, all);
  }
  const auto add_scene = [&](const char* name, double aside, const Finding& finding) {
    const auto test_scene = builtin_test_scene(name, aside);
    for (const int layers : {1, 2, 3, 4})
      add_layers(test_scene, layers, 1, {surfaces_on_a_line(*test_scene), finding}, all);
  };
  add_scene("room", 0.17, kLargeThings);
  add_scene("forest", 0.3, kTrees);
  return all;
}

}  // namespace d17

Experiment d17_layers() {
  using namespace d17;
  return {
      .id = "D-17",
      .name = "Layers: how many, and from how many eyes",
      .question =
          "How much of another eye's view do the layers contain, and how much memory do they take?",
      .axis = "layers of each eye",
      .logarithmic_axis = false,
      .error = "fraction of another eye's pixels with a surface that no layer has",
      .reference = "the scene as that eye sees it",
      .theory =
          "A line of sight meets randomly placed objects as a Poisson process, T objects on "
          "average. A point that one eye sees is behind t objects on average for the other eye, "
          "and t has the density e^-t. So k layers lack the fraction int e^-t P(N(t) >= k) dt, "
          "which is 2^-k for a scene of infinite depth; for the layers of two eyes, P is squared. "
          "A pixel stores E min(N, k) samples of 8 bytes, and an offset of 4 bytes. If samples "
          "within epsilon of the depth of another are merged with it, 1 - ln(1 + T epsilon)/(T "
          "epsilon) of the samples are lost",
      .item = "picture",
      .axis_is_chosen = true,
      .measures = {{kStorage, "bytes for each pixel", "bytes"},
                   {.name = kMerged,
                    .error = "fraction of the samples that are merged with one of another surface",
                    .error_unit = "",
                    .axis = "epsilon, as a fraction of the depth"}},
      .configurations = configurations};
}

}  // namespace glassbox::study
