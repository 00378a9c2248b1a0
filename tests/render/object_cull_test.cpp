// Back-face culling before clipping, in object space (S4-01): no byte changes, in either engine,
// for one eye and for two.
#include <algorithm>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/raster/triangle_setup.h>
#include <glassbox/render/engine/object_cull.h>
#include <glassbox/render/renderer.h>
#include <glassbox/render/staged/vertex_stage.h>

#include "tests/render/stereo/pairs.h"
#include "tests/render/tile/generated_case.h"
#include "tests/render/tile/same_picture.h"

namespace glassbox {
namespace {

using test::GeneratedCase;
using test::kCaseDivisor;

RenderSettings with_object_culling(RenderSettings settings = {}) {
  settings.cull_stage = CullStage::kObject;
  return settings;
}

View view_of_size(const Scene& scene, int width, int height) {
  return make_view(test::camera_for(scene, double(width) / height), width, height).value();
}

// Where the picture with early culling differs from the one without, in either engine; empty if it
// does not.
std::string early_difference(const GeneratedCase& c) {
  RenderSettings late = c.settings;
  late.cull_stage = CullStage::kScreen;
  const Rendering expected = render_staged(c.scene, c.view, late);
  const Rendering staged = render_staged(c.scene, c.view, with_object_culling(c.settings));
  const Rendering tiled = render_tiled(c.scene, c.view, with_object_culling(c.settings), c.options);
  return test::planes_differ(expected.buffers, staged.buffers, true) +
         test::planes_differ(expected.buffers, tiled.buffers, c.settings.want_depth);
}

TEST_CASE("culling in object space first changes no byte of any picture, in either engine") {
  std::uint64_t removed = 0, culled = 0;
  for (std::uint64_t seed = 0; seed < 600 / kCaseDivisor; ++seed) {
    Random random(1000 + seed);
    GeneratedCase c = test::generate_case(random, 200, 130);
    if (seed % 4 != 0) c.settings.cull = seed % 4 == 1 ? Cull::kFront : Cull::kBack;
    test::check_no_difference(1000 + seed, c, early_difference);
    const Statistics s = render_staged(c.scene, c.view, with_object_culling(c.settings)).statistics;
    removed += s.culled_early;
    culled += s.culled;
  }
  WARN("removed early " << removed << ", culled by the area " << culled);
  CHECK(removed > culled / 3);
}

TEST_CASE("both engines cull the same triangles early, and the counts still add up") {
  for (const BuiltinScene& builtin : builtin_scenes()) {
    INFO(builtin.name);
    const Scene scene = test::built_in(std::string(builtin.name));
    const View view = view_of_size(scene, 160, 90);
    for (const Cull cull : {Cull::kMaterial, Cull::kBack, Cull::kFront, Cull::kNone}) {
      RenderSettings settings = with_object_culling();
      settings.cull = cull;
      TileOptions unplanned;
      unplanned.plan = false;
      const Statistics s = render_staged(scene, view, settings).statistics;
      CHECK(render_tiled(scene, view, settings, unplanned).statistics.culled_early ==
            s.culled_early);
      test::check_same(scene, view, settings, unplanned);
      CHECK(s.after_clipping == s.zero_area + s.culled + s.set_up);
      const std::uint64_t clip_input = s.triangles - s.degenerate - s.culled_early;
      CHECK(s.after_clipping >= clip_input - s.rejected - s.clipped_away);
      if (cull == Cull::kNone) CHECK(s.culled_early == 0);
      settings.cull_stage = CullStage::kScreen;
      CHECK(render_staged(scene, view, settings).statistics.culled_early == 0);
    }
  }
}

TEST_CASE("nearly half of a closed surface goes before clipping (S4-19)") {
  const Scene scene = test::built_in("teapot:16");
  RenderSettings settings = with_object_culling();
  settings.cull = Cull::kBack;
  const Statistics s = render_staged(scene, view_of_size(scene, 640, 360), settings).statistics;
  const std::uint64_t backs = s.culled_early + s.culled;
  CHECK(backs > s.triangles / 3);
  CHECK(double(s.culled_early) > 0.9 * double(backs));
}

TEST_CASE("a parallel view culls early, too") {
  const Scene scene = test::built_in("sphere");
  Camera parallel = test::camera_for(scene, 1);
  parallel.lens = OrthographicLens{3, 0.1, 10};
  const View view = make_view(parallel, 400, 400).value();
  test::check_same(scene, view, with_object_culling());
  const Statistics s = render_staged(scene, view, with_object_culling()).statistics;
  CHECK(double(s.culled_early) > 0.4 * double(s.triangles));
}

TEST_CASE("each eye of a pair culls for itself, and has the bytes of late culling") {
  for (const PairCase& c : pair_cases()) {
    INFO(c.name);
    for (const EngineKind engine : {EngineKind::kStaged, EngineKind::kTile}) {
      Renderer renderer(c.scene, Transfer::kSrgb, engine);
      RenderSettings settings;
      settings.cull = Cull::kBack;
      const StereoRendering late = renderer.render_pair(c.centre, c.pair, {settings});
      const StereoRendering both =
          renderer.render_pair(c.centre, c.pair, {with_object_culling(settings)});
      CHECK(both.left.color == late.left.color);
      CHECK(both.right.color == late.right.color);
      if (c.name == "teapot") CHECK(both.right_statistics.culled_early > 0);
    }
  }
}

// How many triangles `cull` removes although their snapped area shows their front.
int removed_fronts(const Draw& draw, const View& view, const ObjectCull& cull) {
  const ClipTable table = project_vertices(draw, view);
  int count = 0;
  for (const Triangle& triangle : draw.triangulation->triangles) {
    std::array<Point<Object>, 3> modelled;
    std::array<ScreenVertex, 3> placed;
    bool whole = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t index = draw.mesh->corners[triangle.corners[k]].position;
      modelled[k] = draw.mesh->positions[index];
      placed[k] = to_screen(divide({table.positions[index], {}}), view.viewport);
      whole = whole && table.outcodes[index] == 0;
    }
    if (!whole || !cull.removes(modelled)) continue;
    const auto setup = setup_triangle(placed);
    count += setup && setup->clockwise == draw.mirrored;
  }
  return count;
}

TEST_CASE("without the margin of the snap fronts are thrown away, and with it none (DESIGN 2)") {
  Random random(3);
  int with_margin = 0, without = 0;
  for (int i = 0; i < 40 / kCaseDivisor + 4; ++i) {
    // Triangles of about one pixel.
    const Scene scene = test::scene_of(test::star_shaped_surface(30, 0.02, random));
    const Camera camera =
        framing_camera(scene, 1,
                       {random.between(0, 360), random.between(-80, 80), {0, 1, 0}, 45, 1.1})
            .value();
    const View view = make_view(camera, 70, 70).value();
    const PreparedScene prepared = prepare_scene(scene, Transfer::kSrgb);
    const DrawList list = make_draw_list(scene, prepared, view);
    ObjectCull cull = object_culling(list.draws[0], view, with_object_culling()).test.value();
    with_margin += removed_fronts(list.draws[0], view, cull);
    cull.value_per_px2 = 0;
    without += removed_fronts(list.draws[0], view, cull);
  }
  CHECK(with_margin == 0);
  CHECK(without > 0);
}

TEST_CASE("a triangle that a plane cuts is left to the snapped area") {
  // A back face that reaches behind the eye.
  Mesh mesh;
  mesh.positions = {{-1, -1, -2}, {-1, 1, -2}, {-1, 0, 3}};
  test::add_face(mesh, {0, 1, 2});
  const Scene scene = test::scene_of(mesh);
  const View view = make_view({"front", PerspectiveLens{1.2, 0.1, 10.0}, {}}, 64, 64).value();
  RenderSettings settings = with_object_culling();
  for (const Cull cull : {Cull::kBack, Cull::kFront}) {
    settings.cull = cull;
    CHECK(render_staged(scene, view, settings).statistics.culled_early == 0);
    CHECK(render_tiled(scene, view, settings).statistics.culled_early == 0);
    test::check_same(scene, view, settings);
  }
}

TEST_CASE("where the test cannot be made, the reason is given") {
  Scene scene = test::built_in("cube");
  const View view = view_of_size(scene, 64, 64);
  const auto because = [&](const View& seen, const RenderSettings& settings) {
    const PreparedScene prepared = prepare_scene(scene, Transfer::kSrgb);
    const DrawList list = make_draw_list(scene, prepared, seen);
    const ObjectCulling culling = object_culling(list.draws[0], seen, settings);
    CHECK_FALSE(culling.test);
    return std::string(culling.because);
  };
  CHECK(because(view, {}) == "not requested");
  RenderSettings none = with_object_culling();
  none.cull = Cull::kNone;
  CHECK(because(view, none) == "both sides of its faces are drawn");
  Camera parallel = test::camera_for(scene, 1);
  parallel.lens = OrthographicLens{2, 0.1, 10};
  const View centre = make_view(parallel, 64, 64).value();
  CHECK(because(eye_view(centre, {0.1, 4}, Side::kLeft), with_object_culling()).find("oblique") !=
        std::string::npos);
  scene.nodes[scene.instances[0].node].world_from_node = scale<World, Object>(1, 1, 0);
  CHECK(because(view, with_object_culling()).find("singular") != std::string::npos);
}

}  // namespace
}  // namespace glassbox
