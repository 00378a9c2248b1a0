// Shapes computed from rings of pictures of any object: `views ring`, `voxels`, `polygons` and
// `texture`.
#include <algorithm>

#include "tests/render/tile/generated_case.h"
#include "tests/same_bytes/configurations.h"
#include "tests/same_bytes/generated_object.h"
#include "views/polygons/coloring.h"
#include "views/polygons/mesh_scene.h"
#include "views/rings/draw_ring.h"
#include "views/texture/static_texture.h"
#include "views/texture/textured_surface.h"
#include "views/voxels/draw_voxels.h"
#include "views/voxels/voxel_file.h"

namespace glassbox {
namespace {

using test::Configuration;
using test::RunResult;
using namespace views;

template <class Enum>
Enum any_of(Random& random, int count) {
  return Enum(random.integer(0, count - 1));
}

PictureSet ring_around(const Scene& scene, std::uint64_t seed, Random& random) {
  RingOptions options;
  options.views = int(random.integer(3, 7));
  options.elevations = {random.between(5, 60)};
  options.arc_degrees = random.integer(0, 1) == 0 ? 360 : 120;
  options.width = int(random.integer(20, 50));
  options.height = int(random.integer(20, 50));
  RenderSettings settings;
  settings.shading = Shading(seed % 2 == 0 ? Shading::kUnlit : Shading::kPhong);
  settings.samples = seed % 3 == 0 ? 4 : 1;
  settings.background = {0, 0, 40, 255};
  const auto matte = any_of<Matte>(random, 3);
  return draw_ring(scene, ring_views(scene, options).value(), settings, matte);
}

ColoringRequest any_request(const PictureSet& set, Random& random) {
  ColoringRequest request;
  request.box = *set.box;
  request.voxel_size = size_for(request.box, int(random.integer(4, 14)));
  request.order = random.integer(0, 2) == 0 ? ColoringOrder::kCarve : ColoringOrder::kSweep;
  ColoringSettings& settings = request.settings;
  settings.consistency = any_of<Consistency>(random, 3);
  settings.threshold = random.between(5, 90);
  settings.space = any_of<ColorSpace>(random, 2);
  settings.edge = random.integer(0, 2) == 0 ? 10 : 0;
  settings.sampled = any_of<Footprint>(random, 3);
  settings.hidden = any_of<Footprint>(random, 3);
  settings.update = any_of<OcclusionUpdate>(random, 2);
  settings.alone = any_of<SingleViewPolicy>(random, 2);
  if (request.order == ColoringOrder::kSweep && random.integer(0, 2) == 0) request.levels = 1;
  return request;
}

void add(RunResult& made, const PictureSet& set) {
  for (const CalibratedPicture& picture : set.pictures) {
    made.add("picture", picture.color);
    made.add("matte", picture.matte);
  }
}

// Returns how many coloured voxels and polygons there were.
std::size_t check_shapes(std::uint64_t seed) {
  const Scene scene = test::generate_object(seed);
  Random random(seed);
  const Random before_ring = random;
  const PictureSet set = ring_around(scene, seed, random);
  const ColoringRequest request = any_request(set, random);
  const std::size_t beside = std::size_t(random.integer(0, std::int64_t(set.pictures.size()) - 1));
  std::size_t count = 0;
  test::check_same_result(seed, [&](const Configuration& configuration) {
    RunResult made;
    Random again = before_ring;
    const PictureSet drawn = ring_around(scene, seed, again);
    add(made, drawn);
    ColoringRequest voxels = request;
    voxels.settings.target = configuration.target;
    voxels.settings.threads = configuration.threads;
    const auto plan = plan_coloring(drawn, voxels);
    if (!plan) {
      made.add("refusal", plan.error().message());
      return made;
    }
    Occupancy solid(plan->grid);
    const Coloring coloring =
        color_voxels(drawn, voxels, *plan,
                     [&](int, std::span<const VoxelRun> runs, std::span<const Verdict> verdicts) {
                       made.add("verdicts", std::as_bytes(verdicts));
                       solid.fill(runs, verdicts);
                     });
    for (const VoxelRun& run : coloring.solid) solid.fill(run);
    made.add("voxels", voxels_ply(coloring.grid, coloring.voxels, VoxelShape::kCubes));
    for (const ColoredVoxel& voxel : coloring.voxels) made.add_number("deviation", voxel.deviation);
    const CalibratedPicture& first = drawn.pictures[beside];
    const VoxelPicture seen = draw_voxels(coloring.grid, coloring.voxels, first.camera,
                                          first.color.width, first.color.height, {9, 9, 9, 255});
    made.add("voxels' picture", seen.color);
    made.add("voxels' distances", seen.distance);

    PolygonColoringSettings settings;
    settings.threads = configuration.threads;
    settings.threshold = 40;
    const auto polygons = color_polygons(drawn, solid, settings);
    if (!polygons) {
      made.add("refusal of polygons", polygons.error().message());
      return made;
    }
    made.add("polygons", polygons_ply(*polygons).value());
    count = coloring.voxels.size() + polygons->mesh.polygons.size();
    const Scene surface = scene_of(*polygons).value();
    const auto textured = TexturedSurface::create(surface, drawn, Blend(seed % 3), 2);
    if (!textured) {
      made.add("refusal of texture", textured.error().message());
      return made;
    }
    const auto picture = textured->draw(first.camera, 40, 30, {1, 2, 3, 255});
    if (picture) {
      made.add("texture", picture->color);
      made.add("texture's polygons", picture->id);
    }
    const auto fixed = with_static_texture(surface, *textured, kMinTexels, 1e8);
    if (fixed) {
      for (const Image<Rgba8>& image : fixed->images) made.add("texture for all eyes", image);
    }
    return made;
  });
  return count;
}

TEST_CASE("rings, voxels, polygons and textures have the same bytes in every way", "[shapes]") {
  CHECK(test::sum_over_seeds(5 / test::kCaseDivisor + 1, check_shapes) > 300 / test::kCaseDivisor);
}

TEST_CASE("some hundred rings, voxels, polygons and textures", "[.same-bytes]") {
  CHECK(test::sum_over_seeds(300, check_shapes) > 0);
}

}  // namespace
}  // namespace glassbox
