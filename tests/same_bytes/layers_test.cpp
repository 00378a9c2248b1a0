// The layered images that `views layers` builds, by peeling or by rays, and the pictures that it
// draws of them from other places.
#include <cmath>

#include <Eigen/Geometry>

#include "tests/same_bytes/configurations.h"
#include "tests/same_bytes/generated_pair.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_builder.h"
#include "views/layers/ray_layers.h"
#include "views/layers/triangle_normals.h"

namespace glassbox {
namespace {

using test::Configuration;
using test::GeneratedPair;
using test::RunResult;

void add(RunResult& made, const views::LayeredImage& image) {
  made.add("offsets", image.first);
  made.add("depths", image.depth);
  made.add("colours", image.color);
  made.add("normals", image.normal);
  made.add("triangles", image.triangle);
}

// The pair with only opaque and masked surfaces, shown in colours, as layers require.
GeneratedPair layered(GeneratedPair pair) {
  test::make_opaque_or_masked(pair.scene.scene);
  pair.scene.settings.wireframe = false;
  pair.scene.settings.samples = 1;
  return pair;
}

views::LayeredImage peeled(const test::GeneratedCase& c) {
  RenderSettings settings = c.settings;
  settings.want_distance = settings.want_id = true;
  views::LayerBuilder builder(views::layer_camera(c.view), views::kMergedDepths, {true, true});
  const std::vector<views::SampleNormal> normals = views::triangle_normals(c.scene);
  for (const views::Layer& layer : views::peel(c.scene, c.view, settings, 4))
    builder.add_layer(c.view, layer, normals);
  return builder.pack();
}

// The camera, moved a little and turned a little.
views::LayerCamera moved(const views::LayerCamera& camera, double by, Random& random) {
  const auto some = [&](double most) {
    const double x = random.between(-most, most), y = random.between(-most, most),
                 z = random.between(-most, most);
    return Eigen::Vector3d(x, y, z);
  };
  Eigen::Matrix4d moves = Eigen::Matrix4d::Identity();
  const Eigen::Vector3d turn = some(0.1);  // small angles, so a rotation to first order suffices
  moves.topLeftCorner<3, 3>() << 1, -turn.z(), turn.y(), turn.z(), 1, -turn.x(), -turn.y(),
      turn.x(), 1;
  moves.topRightCorner<3, 1>() = some(by);
  views::LayerCamera there = camera;
  there.screen_from_world = camera.screen_from_world * moves;
  there.width = int(random.integer(1, 2 * camera.width));
  there.height = int(random.integer(1, 2 * camera.height));
  return there;
}

views::LayerDrawing any_drawing(Random& random) {
  views::LayerDrawing drawing;
  drawing.order =
      random.integer(0, 1) == 0 ? views::LayerOrder::kDepth : views::LayerOrder::kOcclusion;
  const bool may_be_soft = drawing.order == views::LayerOrder::kOcclusion;
  drawing.splat = views::Splat(random.integer(0, may_be_soft ? 3 : 2));
  drawing.background = {std::uint8_t(random.integer(0, 255)), 9, 77, 255};
  return drawing;
}

std::size_t check_layers(std::uint64_t seed) {
  auto pair = test::generate_pair(seed, 90);
  if (!pair) return 0;
  *pair = layered(*pair);
  std::size_t samples = 0;
  test::check_same_result(seed, [&](const Configuration&) {
    const views::LayeredImage image = peeled(pair->scene);
    samples = image.samples();
    RunResult made;
    add(made, image);
    return made;
  });
  // Drawing from several places, which takes less time.
  const views::LayeredImage image = peeled(pair->scene);
  Random random(seed);
  for (int i = 0; i < 4; ++i) {
    views::LayerDrawing drawing = any_drawing(random);
    const views::LayerCamera there =
        moved(image.camera, pair->scene.view.near * random.unit(), random);
    test::check_same_result(seed, [&](const Configuration& configuration) {
      drawing.target = configuration.target;
      drawing.threads = configuration.threads;
      const views::LayerPicture picture = views::draw_layers(image, there, drawing);
      RunResult made;
      made.add("colour", picture.color);
      made.add("depth", picture.depth);
      made.add_number("drawn", picture.counts.drawn);
      made.add_number("behind", picture.counts.behind);
      made.add_number("beside", picture.counts.outside);
      made.add_number("cut", picture.counts.oversized);
      return made;
    });
  }
  return samples;
}

std::size_t check_rays(std::uint64_t seed) {
  auto pair = test::generate_pair(seed, 40);
  if (!pair || !pair->scene.view.perspective) return 0;
  *pair = layered(*pair);
  test::GeneratedCase& c = pair->scene;
  if (c.settings.shading != Shading::kUnlit) c.settings.shading = Shading::kPhong;
  std::size_t samples = 0;
  test::check_same_result(seed, [&](const Configuration& configuration) {
    views::RaySampling sampling{4, 16, c.view.near / 2, configuration.threads};
    views::RayCounts counts;
    const views::LayeredImage image = views::build_layers_by_rays(
        c.scene, c.view, c.settings, sampling, views::kMergedHits, counts, {true, true});
    samples = image.samples();
    RunResult made;
    add(made, image);
    made.add_number("followed", counts.followed);
    made.add_number("hits", counts.hits);
    return made;
  });
  return samples;
}

TEST_CASE("layers have the same bytes in every way, built and drawn", "[layers]") {
  CHECK(test::sum_over_seeds(20 / test::kCaseDivisor, check_layers) > 5000 / test::kCaseDivisor);
}

TEST_CASE("layers of rays have the same bytes in every way", "[layers]") {
  CHECK(test::sum_over_seeds(12 / test::kCaseDivisor, check_rays) > 100 / test::kCaseDivisor);
}

TEST_CASE("some hundred layered images", "[.same-bytes]") {
  CHECK(test::sum_over_seeds(600, check_layers) > 0);
  CHECK(test::sum_over_seeds(600, check_rays) > 0);
}

}  // namespace
}  // namespace glassbox
