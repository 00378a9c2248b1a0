// Tests glassbox views polygons and texture: a surface from pictures, its colours seen from other
// places, and what is refused.
#include "tests/support/catch.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/app/working_directory.h"

namespace glassbox::test {
namespace {

using SurfaceJson = nlohmann::json;

SurfaceJson surface_answer(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("views " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return SurfaceJson::parse(outcome.out);
}

}  // namespace

TEST_CASE(
    "a ring of a scene gives a closed surface, which is drawn, textured and looked at from "
    "elsewhere") {
  const WorkingDirectory here;
  surface_answer(here, "ring cube -o ring --views 9 --elevation 40 --size 96x96");
  const SurfaceJson found =
      surface_answer(here,
                     "polygons ring --resolution 32 --leave-out 3 --left-out-output left.png "
                     "--truth cube -o cube.glb --html cube.html --threads 2");
  CHECK(found["pictures"] == 8);
  CHECK(found["closed"] == true);
  CHECK(found["degenerate"] == 0);
  CHECK(found["duplicates"] == 0);
  CHECK(found["polygons"] > 1000);
  CHECK(found["left_out"]["picture"] == "view002.png");
  // Voxels on the cube's edges have two colours and are lost (voxels_test.cpp); the surface
  // encloses the others.
  CHECK(found["left_out"]["covered"] > 0.8);
  CHECK(found["truth"]["iou"] > 0.5);
  CHECK(here.read("cube.html").find("id=\"places\"") != std::string::npos);
  // The surface, with or without its texture, can be rendered like any scene.
  CHECK(here.run("render cube.glb --size 64x64 -o again.png").exit_code == 0);
  CHECK(here.run("views polygons ring --resolution 20 -o cube.ply --half-way --no-carving")
            .exit_code == 0);
  CHECK(here.run("render cube.ply --size 64x64 -o again.png").exit_code == 0);

  const SurfaceJson textured = surface_answer(
      here,
      "texture cube.glb ring --leave-out 3 --left-out-output view.png "
      "--eye 3,3,3 --look-at 0,0,0 -o eye.png --fixed fixed.glb --html texture.html");
  CHECK(textured["blend"] == "barycentric");
  CHECK(textured["drawn"]["surface"] > 500);
  CHECK(textured["left_out"]["psnr"] > 15);
  CHECK(here.read("texture.html").find("id=\"seen\"") != std::string::npos);
  CHECK(here.run("render fixed.glb --size 64x64 -o again.png").exit_code == 0);
  const SurfaceJson each = surface_answer(here, "texture cube.glb ring --each --neighbours 3");
  CHECK(each["each"].size() == 27);
  for (const char* blend : {"nearest", "barycentric", "neighbours"})
    CHECK(each["psnr"][blend] > 12);
}

TEST_CASE("from a picture's own place a textured surface is that picture") {
  const WorkingDirectory here;
  surface_answer(here, "ring sphere -o ring --views 7 --elevation 20 --size 64x64");
  surface_answer(here, "polygons ring --resolution 24 --threshold 200 -o ball.glb");
  // The set has the first picture twice: when one is left out, it is predicted from the other.
  std::string cameras = here.read("ring/ring_par.txt");
  REQUIRE(cameras.starts_with("7\n"));
  const std::string first = cameras.substr(2, cameras.find('\n', 2) - 1);
  std::ofstream(here.file("ring/ring_par.txt")) << "8\n" << cameras.substr(2) << first;
  const SurfaceJson made = surface_answer(here, "texture ball.glb ring --leave-out 8");
  CHECK(made["left_out"]["psnr"].is_null());  // infinite: the pictures are equal
  CHECK(made["left_out"]["rms"] == 0);
  CHECK(made["left_out"]["covered"] > 0.5);
}

TEST_CASE(
    "surfaces that do not fit into memory are refused, before they are begun if that is known") {
  const WorkingDirectory here;
  REQUIRE(here.run("views ring cube -o ring --views 3 --size 64x64").exit_code == 0);
  REQUIRE(here.run("views polygons ring --resolution 96 -o cube.glb --threshold 200").exit_code ==
          0);
  const auto refusal = [&](const std::string& words) {
    const Outcome outcome = here.run("views " + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK_FALSE(std::ifstream(here.file("a.glb")).good());
    return outcome.err;
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  // The voxels alone would fit into the memory.
  CHECK(here.run("views voxels ring --resolution 96 --max-mb 16").exit_code == 0);
  CHECK(has(refusal("polygons ring --resolution 96 --max-mb 16"),
            "--resolution: 96 x 96 x 96 voxels, their polygons and the layered images of 3 "
            "pictures would need"));
  const SurfaceJson found = surface_answer(here, "polygons ring --resolution 96 --threshold 200");
  const auto megabytes = std::to_string(found["bytes"].get<std::int64_t>() / 1048576);
  CHECK(has(refusal("polygons ring --resolution 96 --threshold 200 --max-mb " + megabytes),
            " would need "));
  // The memory for what each picture sees counts too.
  CHECK(here.run("views texture cube.glb ring -o a.png").exit_code == 0);
  CHECK(has(refusal("texture cube.glb ring -o b.png --max-mb 3"),
            "--max-mb: the surface, and what each picture sees of it, would need"));
  CHECK_FALSE(std::ifstream(here.file("b.png")).good());
}

TEST_CASE("surfaces and textures that cannot be made are refused in a line, and no file is left") {
  const WorkingDirectory here;
  REQUIRE(here.run("views ring cube -o ring --views 3 --size 16x16").exit_code == 0);
  for (const char* words : {"polygons nowhere -o a.glb",
                            "polygons ring -o a.obj",
                            "polygons ring --threshold -1 -o a.glb",
                            "polygons ring --polygon-threshold nan -o a.glb",
                            "polygons ring --resolution 0 -o a.glb",
                            "polygons ring --resolution 4000 --max-mb 64 -o a.glb",
                            "polygons ring --leave-out 9 -o a.glb",
                            "polygons ring --leave-out 0 -o a.glb",
                            "polygons ring --left-out-output a.png",
                            "polygons ring --box 0,0,0,0,1,1 -o a.glb",
                            "polygons ring --box 5,5,5,6,6,6 -o a.glb",
                            "polygons ring --html a.txt",
                            "polygons ring --no-mattes --matte-above 9 -o a.glb",
                            "texture nowhere.glb ring -o a.png",
                            "texture cube nowhere -o a.png",
                            "texture cube ring -o a.obj",
                            "texture cube ring --neighbours 0 -o a.png",
                            "texture cube ring --texels 3 --fixed a.glb",
                            "texture cube ring --fixed a.ply",
                            "texture sphere ring --texels 64 --fixed a.glb --max-mb 1",
                            "texture cube ring --each --leave-out 1",
                            "texture cube ring --left-out-output a.png",
                            "texture cube ring --ortho 3 -o a.png",
                            "texture cube ring --pictures 1 --each",
                            "texture cube ring --html a.txt"}) {
    const Outcome outcome = here.run(std::string("views ") + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    for (const char* file : {"a.glb", "a.png", "a.html"})
      CHECK_FALSE(std::ifstream(here.file(file)).good());
  }
}

}  // namespace glassbox::test
