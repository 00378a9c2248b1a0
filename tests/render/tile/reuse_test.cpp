// One engine draws many pictures: each is the picture that a new engine would draw, and the memory
// stops growing.
#include <unistd.h>

#include <cstdio>

#include "tests/render/tile/generated_case.h"
#include "tests/render/tile/same_picture.h"

namespace glassbox {
namespace {

using test::GeneratedCase;

constexpr int kFrames = test::kCaseDivisor == 1 ? 1000 : 200;
constexpr int kCases = 50;  // drawn again and again

// How many bytes of this process are resident in memory.
std::size_t resident_bytes() {
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (file == nullptr) return 0;
  unsigned long pages = 0, resident = 0;
  const int read = std::fscanf(file, "%lu %lu", &pages, &resident);
  std::fclose(file);
  return read == 2 ? resident * std::size_t(::sysconf(_SC_PAGESIZE)) : 0;
}

TEST_CASE("an engine draws a thousand frames of changing scenes and sizes as one made for each",
          "[tile]") {
  Random random(31);
  std::vector<GeneratedCase> cases;
  std::vector<PreparedScene> prepared;
  cases.reserve(kCases);
  for (int i = 0; i < kCases; ++i) {
    cases.push_back(test::generate_case(random, 60, 200));
    prepared.push_back(prepare_scene(cases.back().scene, cases.back().settings.transfer));
  }
  TileOptions options;
  options.threads = 3;
  options.tile_side = 32;
  options.round_size = 100;
  TileEngine engine(options);
  Rendering into;
  [[maybe_unused]] std::size_t resident = 0;  // unused with sanitizers, which allocate more
  std::size_t smallest_plane = 0, drawn_since = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    const auto i = std::size_t(frame % kCases);
    const GeneratedCase& c = cases[i];
    engine.render(c.scene, prepared[i], c.view, c.settings, into);
    if (frame % 10 == frame / kCases % 10) {  // each case once in ten rounds
      INFO("frame " << frame);
      const Rendering staged = render_staged(c.scene, c.view, c.settings);
      test::check_same_planes(staged.buffers, into.buffers, c.settings.want_depth);
      test::check_same_counts(staged.statistics, into.statistics);
    }
    // By now all cases have been drawn twice, so every table has its final size.
    if (frame == 2 * kCases) resident = resident_bytes();
    if (frame > 2 * kCases) {
      ++drawn_since;
      smallest_plane += into.buffers.color.pixels.size() * sizeof(Rgba8);
    }
  }
  REQUIRE(drawn_since > 0);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  // If every frame kept one plane of its picture, the memory would have grown by the sum of these
  // planes.
  const std::size_t grown = std::max(resident_bytes(), resident) - resident;
  INFO("grown by " << grown << " bytes; the planes have " << smallest_plane);
  CHECK(grown < smallest_plane / 4);
#endif
}

TEST_CASE("what a picture before has left behind is not seen in an empty one", "[tile]") {
  Scene scene = test::scene_of(Mesh{});
  TileEngine engine{TileOptions{}};
  Rendering into;
  const View view = *make_view({"front", PerspectiveLens{}, {}}, 40, 30);
  Scene full = scene;
  full.meshes[0].positions = {{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}};
  test::add_face(full.meshes[0], {0, 1, 2});
  for (const Show show :
       {Show::kColor, Show::kDepth, Show::kNormal, Show::kUv, Show::kId, Show::kOverdraw}) {
    RenderSettings settings;
    settings.show = show;
    settings.want_depth = settings.want_distance = settings.want_id = true;
    for (const bool no_instances : {false, true}) {
      INFO("show " << int(show));
      engine.render(full, prepare_scene(full, settings.transfer), view, settings, into);
      Scene empty = scene;
      if (no_instances) empty.instances.clear();
      engine.render(empty, prepare_scene(empty, settings.transfer), view, settings, into);
      test::check_same_planes(render_staged(empty, view, settings).buffers, into.buffers);
    }
  }
}

}  // namespace
}  // namespace glassbox
