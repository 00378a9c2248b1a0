// Options that have no effect on a picture: every ignored option is reported, and every option
// reported as ignored changes nothing.
#include <string>
#include <utility>
#include <vector>

#include "tests/app/text.h"

namespace glassbox::test {
namespace {

struct RunWithOptions {
  std::string bytes, err;
};

RunWithOptions run_with_options(const std::string& words) {
  const WorkingDirectory here;
  const Outcome outcome = here.run("render " + words + " --size 48x32 -o p.ppm");
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return {here.read("p.ppm"), outcome.err};
}

TEST_CASE("an option that changes no byte of a quantity's picture is named, and no other") {
  const std::vector<std::string> options{"--samples 8",        "--shade flat",    "--shade gouraud",
                                         "--shade unlit",      "--transfer none", "--wireframe",
                                         "--background 1,0,0", "--cull front"};
  for (const char* show : {"", "depth", "normal", "uv", "id", "overdraw"}) {
    const std::string shown = *show ? std::string(" --show ") + show : "";
    // The room has texture and fills the picture; the teapot has smooth faces and leaves
    // background.
    const std::string room = run_with_options("room" + shown).bytes;
    const std::string teapot = run_with_options("teapot:2" + shown).bytes;
    for (const std::string& option : options) {
      const RunWithOptions of_room = run_with_options("room" + shown + " " + option);
      const RunWithOptions of_teapot = run_with_options("teapot:2" + shown + " " + option);
      const bool changes = of_room.bytes != room || of_teapot.bytes != teapot;
      INFO((*show ? show : "colours") << " with " << option);
      CHECK(contains(of_room.err, "note: " + option + " is ignored: ") == !changes);
      CHECK(of_teapot.err == of_room.err);
    }
  }
}

TEST_CASE("the default given in words is no reason for a note about samples") {
  CHECK(run_with_options("cube --show depth --samples 1").err.empty());
}

TEST_CASE("a window without parallax is ignored with a note") {
  const std::string plain = "forest --stereo pair --eye-separation 0";
  const RunWithOptions with = run_with_options(plain + " --window 3");
  CHECK(contains(with.err, "note: --window 3 is ignored"));
  CHECK(with.bytes == run_with_options(plain).bytes);
  CHECK(run_with_options("forest --stereo pair --eye-separation 0.1 --window 3").err.empty());
}

TEST_CASE("step names what points and what triangles have no use for") {
  const WorkingDirectory here;
  here.write("p.txt", "1 0 0 0  0 1 0 0  0 0 -1.02 -0.202  0 0 -1 0");
  const std::string point = "step --point 0,0,-5 --proj p.txt --size 64x64";
  const Outcome plain = here.run(point);
  CHECK(plain.err.empty());
  for (const char* option : {"--eye 1,2,3", "--shade flat", "--samples 4", "--vertex 1"}) {
    const Outcome with = here.run(point + " " + option);
    INFO(option << ": " << with.err);
    CHECK(with.exit_code == 0);
    CHECK(with.out == plain.out);
    CHECK(contains(with.err, "note: " + std::string(option).substr(0, 4)));
    CHECK(contains(with.err, "is ignored"));
  }
  const std::string triangle = "step cube --triangle 0 --size 64x64";
  CHECK(here.run(triangle + " --shade flat").err.empty());
  const Outcome with = here.run(triangle + " --expect 32,32");
  CHECK(with.out == here.run(triangle).out);
  CHECK(contains(with.err, "note: --expect is ignored"));
}

// Removes the line with the time in milliseconds.
std::string without_time(std::string text) {
  const std::size_t ms = text.find(" ms on ");
  if (ms == text.npos) return text;
  const std::size_t start = text.rfind('\n', ms);
  return text.erase(start, text.find('\n', ms) - start);
}

TEST_CASE("what pictures around a scene have no use for is named, and changes nothing") {
  const WorkingDirectory here;
  REQUIRE(here.run("views ring cube -o ring --views 5 --size 32x32").exit_code == 0);
  REQUIRE(here.run("info cube --write cube.glb").exit_code == 0);
  const auto check = [&](const std::string& words, const std::vector<std::string>& options) {
    const Outcome plain = here.run(words);
    INFO(words << ": " << plain.err);
    REQUIRE(plain.exit_code == 0);
    CHECK(plain.err.empty());
    for (const std::string& option : options) {
      const Outcome with = here.run(words + " " + option);
      INFO(option << ": " << with.err);
      CHECK(with.exit_code == 0);
      const std::string name = option.substr(0, option.find(' '));
      CHECK(contains(with.err, "note: " + name + " is ignored: "));
      CHECK(without_time(with.out) == without_time(plain.out));
    }
  };
  const std::string voxels = "views voxels ring --resolution 12";
  check(voxels, {"--k1 1", "--k2 1", "--noise 3", "--significance 0.5", "--lightness 1",
                 "--slack 5", "--shape points"});
  check(voxels + " --test ratio", {"--threshold 1", "--k1 1"});
  check(voxels + " --test adaptive", {"--threshold 1", "--noise 3"});
  CHECK(here.run(voxels + " --test adaptive --k1 1 --space lab --lightness 1").err.empty());
  check("views texture cube.glb ring",
        {"--neighbours 2", "--texels 4", "--eye 1,2,3", "--size 9x9"});
  check("views texture cube.glb ring --leave-out 1 --blend nearest", {"--neighbours 2"});
  CHECK(here.run("views texture cube.glb ring --each --neighbours 2").err.empty());
  check("views glyphs sheet -o wall.glb", {"--panel 2"});
}

}  // namespace
}  // namespace glassbox::test
