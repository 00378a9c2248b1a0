// "A stage" of CONTRIBUTING.md: this is compiled with the stage of tone.patch in the sources. It
// maps all light to less than white.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/catch.h"

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/tile/tile_engine.h>

using namespace glassbox;

namespace {

struct Shown {
  Scene scene;
  View view;
  RenderSettings settings;
};

std::vector<Shown> all_shown() {
  std::vector<Shown> all;
  for (const char* name : {"room", "f-glyph"}) {
    Scene scene = make_builtin(name).value();
    const View view = make_view(framing_camera(scene, 1.5).value(), 48, 32).value();
    for (const Shading shading : {Shading::kPhong, Shading::kGouraud, Shading::kUnlit}) {
      all.push_back({scene, view, {}});
      all.back().settings.shading = shading;
    }
    // All have a light of their own; red and green alone are kept.
    for (Material& material : scene.materials) material.emission = {0.25f, 4, 0.5f};
    all.push_back({scene, view, {}});
    all.back().settings.mask = {true, true, false, false};
    all.push_back({scene, view, {}});
    all.back().settings.samples = 4;
  }
  return all;
}

// Takes the stage out again, and looks at what it did.
class Untoned : public Observer {
public:
  void toned(const std::array<float, 3>& light, std::array<float, 3>& seen) override {
    for (std::size_t i = 0; i < 3; ++i) {
      wrong += seen[i] != light[i] / (1.0f + light[i]);
      seen[i] = light[i];
    }
    ++fragments;
  }
  int fragments = 0, wrong = 0;
};

std::string text_of(const std::string& file) {
  std::ifstream in(GLASSBOX_SOURCE_DIR "/" + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("both engines draw the stage, and watchers see it") {
  for (const Shown& shown : all_shown()) {
    const auto& [scene, view, settings] = shown;
    CAPTURE(int(settings.shading), settings.samples, settings.mask.b);
    const Image<Rgba8> picture = render_staged(scene, view, settings).buffers.color;
    CHECK(render_tiled(scene, view, settings).buffers.color.pixels == picture.pixels);

    Untoned untoned;
    const Image<Rgba8> before = render_staged(scene, view, settings, &untoned).buffers.color;
    const bool is_lit = settings.shading != Shading::kUnlit;
    CHECK((untoned.fragments > 0) == is_lit);
    CHECK(untoned.wrong == 0);
    CHECK((picture.pixels != before.pixels) == is_lit);
    int brighter = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
      const Rgba8 &now = picture.pixels[i], &then = before.pixels[i];
      brighter += now.r > then.r || now.g > then.g || now.b > then.b;
    }
    CHECK(brighter == 0);
  }
}

TEST_CASE("a stage is eight files at most, and the recipe names them") {
  const std::string contributing = text_of("CONTRIBUTING.md");
  const std::size_t begin = contributing.find("\n## A stage\n");
  REQUIRE(begin != std::string::npos);
  const std::string recipe =
      contributing.substr(begin, contributing.find("\n## ", begin + 1) - begin);
  std::istringstream patch(text_of("tests/stage/tone.patch"));
  int files = 0;
  for (std::string line; std::getline(patch, line);) {
    if (!line.starts_with("+++ b/")) continue;
    ++files;
    std::string file = line.substr(6, line.find('\t') - 6);
    if (file == "raster/formulas/tone.h") file = "raster/formulas/NAME.h";
    INFO(file);
    CHECK(recipe.find(file) != std::string::npos);
  }
  CHECK(files > 0);
  CHECK(files <= 8);
}
