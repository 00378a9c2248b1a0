// A built-in scene that is written as GLB and read back gives the same picture.
#include "tests/support/catch.h"

#include <string>

#include "tests/images/temporary_directory.h"
#include "tests/support/run_program.h"

#include <glassbox/images/read.h>
#include <glassbox/mesh/builtin/scenes.h>

namespace glassbox::test {
namespace {

Image<Rgba8> render(const TemporaryDirectory& directory, const std::string& scene,
                    const std::string& shade) {
  const std::string picture = directory.file("picture.png");
  const Outcome outcome = run_program(
      GLASSBOX_PROGRAM, {"render", scene, "--size", "320x180", "--shade", shade, "-o", picture},
      directory.path().string());
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const auto image = read_image(picture);
  REQUIRE(image);
  return *image;
}

// Whether the scene has polygons that are planar only up to round-off. GLB has triangles only: the
// normals of such a polygon's triangles differ a little from the polygon's one normal, and flat
// shading shows it.
bool has_rounded_polygons(const std::string& name) {
  return name == "sphere" || name == "room" || name == "thicket";
}

TEST_CASE("every built-in scene written as GLB renders to the same bytes") {
  REQUIRE(builtin_scenes().size() >= 8);
  for (const BuiltinScene& scene : builtin_scenes()) {
    const TemporaryDirectory directory;
    const std::string name(scene.name);
    const std::string glb = directory.file(name + ".glb");
    const Outcome written =
        run_program(GLASSBOX_PROGRAM, {"info", name, "--write", glb}, directory.path().string());
    INFO(name << ": " << written.err);
    REQUIRE(written.exit_code == 0);
    for (const char* shade : {"unlit", "flat", "gouraud", "phong"}) {
      INFO("--shade " << shade);
      if (std::string(shade) == "flat") {
        if (has_rounded_polygons(name)) continue;
      }
      CHECK(render(directory, name, shade) == render(directory, glb, shade));
    }
  }
}

}  // namespace
}  // namespace glassbox::test
