// Tests glassbox views ring and voxels: pictures of a scene, its shape recovered from them, and
// what is refused.
#include "tests/support/catch.h"

#include <algorithm>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "tests/app/working_directory.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

Json voxels_answer(const WorkingDirectory& here, const std::string& words) {
  const Outcome outcome = here.run("views " + words + " --json -");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

}  // namespace

TEST_CASE("a ring of a scene gives its shape again, and a picture that was left out") {
  const WorkingDirectory here;
  const Json ring = voxels_answer(here, "ring cube -o ring --views 9 --elevation 40 --size 96x96");
  CHECK(ring["pictures"] == 9);
  CHECK(ring["unlit"] == true);
  const Json found = voxels_answer(here,
                                   "voxels ring --resolution 40 --leave-out 3 --left-out-output "
                                   "left.png --truth cube -o cube.ply "
                                   "--html cube.html --threads 2");
  CHECK(found["pictures"] == 8);
  CHECK(found["traversal"] == "half-space");
  CHECK(found["coloured"] > 2000);
  CHECK(found["left_out"]["picture"] == "view002.png");
  CHECK(found["left_out"]["covered"] > 0.8);
  // A face has one colour, but a voxel at an edge has two and is lost: there the background is seen
  // through the faces.
  CHECK(found["left_out"]["rms"] < 60);
  CHECK(found["truth"]["iou"] > 0.6);
  CHECK(here.read("cube.html").find("id=\"verdicts\"") != std::string::npos);
  // The cubes can be rendered like any scene.
  CHECK(here.run("render cube.ply --shade unlit --size 64x64 -o again.png").exit_code == 0);
  CHECK(here.run("views voxels ring --resolution 20 -o points.ply --shape points").exit_code == 0);
  CHECK(here.read("points.ply").find("element face") == std::string::npos);
}

TEST_CASE("carving, coarse to fine and the other tests of consistency are asked for by options") {
  const WorkingDirectory here;
  voxels_answer(here, "ring cube -o ring --views 8 --elevation 35 --size 64x64 --matte alpha");
  const std::string voxels = "voxels ring --resolution 32 ";
  CHECK(voxels_answer(here, voxels + "--order carve")["order"] == "carve");
  const Json coarse = voxels_answer(here, voxels + "--levels 2 --against-full");
  CHECK(coarse["judged_coarse"] > 0);
  CHECK(coarse["against_full"]["iou"] > 0.8);
  for (const char* test : {"--test ratio", "--test adaptive --edges 30", "--space lab",
                           "--footprint hull --hides hull", "--footprint box --update voxel",
                           "--alone keep", "--no-mattes", "--matte-above 5", "--direction -y"}) {
    CHECK(voxels_answer(here, voxels + test)["coloured"] > 100);
  }
  CHECK(voxels_answer(here, voxels + "--threshold 0")["coloured"] == 0);
  CHECK(voxels_answer(here, voxels)["along"] == "-y");
  CHECK(voxels_answer(here, voxels + "--direction x")["along"] == "x");
  // A picture is left out of four chosen ones.
  CHECK(voxels_answer(here, voxels + "--pictures 1-4 --leave-out 2")["left_out"]["picture"] ==
        "view001.png");
  CHECK(voxels_answer(here, voxels + "--pictures 1-4 --leave-out 2")["pictures"] == 3);
  CHECK(voxels_answer(here, "voxels ring --total 20000")["judged"] > 15000);
  CHECK(voxels_answer(here, "voxels ring --pictures 1-3,7 --voxel 0.1")["pictures"] == 4);
}

TEST_CASE("rings and voxels that cannot be made are refused in a line, and no file is left") {
  const WorkingDirectory here;
  REQUIRE(here.run("views ring cube -o ring --views 3 --size 16x16").exit_code == 0);
  // The camera is finite, but its pixel coordinates exceed the floats.
  for (const char* k : {"100 0 40 0 100 40 0 0 1 1 0 0 0 1 0 0 0 1 0 0 1e300",
                        "1e300 0 40 0 100 40 0 0 1 1 0 0 0 1 0 0 0 1 0 0 1"}) {
    std::ofstream(here.file("ring/ring_par.txt")) << "1\nview000.png " << k << "\n";
    const Outcome outcome = here.run("views voxels ring --resolution 8 --no-mattes --order carve");
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("view000.png") != std::string::npos);
  }
  REQUIRE(here.run("views ring cube -o ring --views 3 --size 16x16").exit_code == 0);
  for (const char* words : {"ring cube -o no --views 0",
                            "ring cube -o no --arc 400",
                            "ring cube -o no --elevation 90",
                            "ring cube -o no --distance -1",
                            "ring cube -o no --pairs 0",
                            "ring nothing.glb -o no",
                            "ring cube -o no --fov 180",
                            "voxels nowhere -o a.ply",
                            "voxels ring -o a.obj",
                            "voxels ring --threshold -1 -o a.ply",
                            "voxels ring --voxel 0 -o a.ply",
                            "voxels ring --voxel 1e-9 -o a.ply",
                            "voxels ring --voxel 1 --resolution 9 -o a.ply",
                            "voxels ring --pictures 4 -o a.ply",
                            "voxels ring --pictures 0 -o a.ply",
                            "voxels ring --leave-out 9 -o a.ply",
                            "voxels ring --box 0,0,0,0,1,1 -o a.ply",
                            "voxels ring --left-out-output a.png",
                            "voxels ring --against-full",
                            "voxels ring --significance 1 -o a.ply",
                            "voxels ring --order carve --resolution 4000 --max-mb 64",
                            "voxels ring --direction w",
                            "voxels ring --order carve --levels 1 --against-full",
                            "voxels ring --order carve --direction x",
                            "voxels ring --max-mb 0",
                            "voxels ring --k1 nan",
                            "voxels ring --noise inf",
                            "voxels ring --pictures 1-2 --leave-out 7",
                            "ring cube -o no --start nan",
                            "ring cube -o no --up 1e200,0,0",
                            "voxels ring --html a.txt"}) {
    const Outcome outcome = here.run(std::string("views ") + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::ranges::count(outcome.err, '\n') == 1);
    CHECK_FALSE(std::ifstream(here.file("a.ply")).good());
  }
}

TEST_CASE("the numbers of a ring go to no file of its pictures") {
  const WorkingDirectory here;
  const std::string ring = "views ring cube -o ring --views 2 --size 16x16";
  REQUIRE(here.run(ring).exit_code == 0);
  for (const char* name : {"box.txt", "ring_par.txt", "view001.png", "masks/view000.png"}) {
    const std::string before = here.read("ring/" + std::string(name));
    const Outcome outcome = here.run(ring + " --json ring/" + name);
    INFO(name << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("two outputs would go to this file") != std::string::npos);
    CHECK(here.read("ring/" + std::string(name)) == before);
  }
  CHECK(here.run(ring + " --json ring/ring.json").exit_code == 0);
}

TEST_CASE("more voxels than fit into memory are refused by the option that asks for them") {
  const WorkingDirectory here;
  REQUIRE(here.run("views ring cube -o ring --views 3 --size 64x64").exit_code == 0);
  const auto refusal = [&](const std::string& words) {
    const Outcome outcome = here.run("views voxels ring -o a.ply " + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK_FALSE(std::ifstream(here.file("a.ply")).good());
    return outcome.err;
  };
  const auto has = [](const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  };
  CHECK(has(refusal("--total 1e30"), "--total: the box has"));
  CHECK(has(refusal("--voxel 1e-9"), "--voxel: the box has"));
  CHECK(has(refusal("--resolution 1000 --max-mb 64"), "--resolution: 1000 x 1000 x 1000 voxels"));
  CHECK(has(refusal("--total 1e9 --max-mb 64"), "--total: 1000 x 1000 x 1000 voxels"));
  CHECK(has(refusal("--voxel 0.002 --max-mb 64"), "--voxel: 1000 x 1000 x 1000 voxels"));
  // The memory for comparing the voxels and for the page counts too.
  const std::string small = "--resolution 96 --max-mb 3 ";
  CHECK(here.run("views voxels ring " + small).exit_code == 0);
  CHECK(
      has(refusal(small + "--truth cube"), "96 x 96 x 96 voxels and the requested outputs would"));
  CHECK(has(refusal(small + "--html a.html"), "voxels and the requested outputs would"));
}

}  // namespace glassbox::test
