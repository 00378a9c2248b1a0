// The tile engine, compared with the staged reference on files: unusual ones, and real ones if they
// are present.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <glassbox/mesh/formats/load.h>
#include <glassbox/mesh/gltf/load.h>

#include "tests/render/tile/same_picture.h"
#include "tests/support/skip.h"

namespace glassbox {
namespace {

namespace fs = std::filesystem;

#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr std::uint64_t kMaxCorners = 1 << 20;
#else
constexpr std::uint64_t kMaxCorners = 1 << 14;
#endif

std::vector<fs::path> scene_files(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::exists(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".gltf" || extension == ".glb" || extension == ".obj" || extension.empty()) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

// Compares the engines' pictures of the scene. Returns whether there was a scene and a view.
bool check_scene(const Result<Scene>& scene, std::size_t number) {
  if (!scene) return false;
  const int width = 90 + int(number % 7), height = 70 - int(number % 5);
  Camera camera;
  if (!scene->cameras.empty()) {
    camera = scene->cameras.front();
  } else {
    const auto framed = framing_camera(bounds(*scene), double(width) / height);
    if (!framed) return false;
    camera = *framed;
  }
  const auto view = make_view(camera, width, height);
  if (!view) return false;
  RenderSettings settings;
  settings.want_depth = settings.want_distance = settings.want_id = true;
  constexpr Shading kShadings[] = {Shading::kPhong, Shading::kGouraud, Shading::kFlat,
                                   Shading::kUnlit};
  settings.shading = kShadings[number % 4];
  const std::vector<Target> targets = available_targets();
  TileOptions options;
  options.threads = 2;
  options.tile_side = 16 << (number % 3);
  options.target = targets[number % targets.size()];
  test::check_same(*scene, *view, settings, options);
  return true;
}

LoadLimits test_limits() {
  LoadLimits limits;
  limits.max_image_pixels = 1 << 22;
  limits.max_corners = kMaxCorners;
  return limits;
}

TEST_CASE("the tile engine draws the fuzzers' files as the staged reference does", "[tile]") {
  const fs::path corpus = fs::path(GLASSBOX_SOURCE_DIR) / "tests/fuzz/corpus";
  std::size_t number = 0, drawn = 0;
  for (const char* folder : {"gltf", "obj"}) {
    for (const fs::path& file : scene_files(corpus / folder)) {
      INFO(file.string());
      // Files found by a fuzzer have no extension; they are glTF.
      const Result<Scene> scene = file.extension() == ".obj"
                                      ? load_scene(file.string(), test_limits())
                                      : load_gltf(file.string(), test_limits());
      drawn += check_scene(scene, number++) ? 1u : 0u;
    }
  }
  CHECK(drawn > 20);
}

TEST_CASE("the tile engine draws real and malformed files as the staged reference does", "[tile]") {
  const fs::path assets = GLASSBOX_ASSETS_DIR;
  if (!fs::exists(assets)) SKIP_TEST("no assets at " << assets.string());
  std::size_t number = 0, drawn = 0;
  for (const char* folder : {"meshes", "malformed"}) {
    for (const fs::path& file : scene_files(assets / folder)) {
      if (file.extension().empty()) continue;
      INFO(file.string());
      drawn += check_scene(load_scene(file.string(), test_limits()), number++) ? 1u : 0u;
    }
  }
  CHECK(number > 0);
  CHECK(drawn > number / 3);
}

}  // namespace
}  // namespace glassbox
