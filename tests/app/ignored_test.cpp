// Options that are right for other pictures: what is ignored is said, and what is said to be ignored is.
#include <string>
#include <utility>
#include <vector>

#include "tests/app/text.h"

namespace glassbox::test {
namespace {

struct Rendered {
  std::string bytes, err;
};

Rendered rendered(const std::string& words) {
  const Workplace here;
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
    // One has texture and fills the picture, the other smooth faces and background.
    const std::string room = rendered("room" + shown).bytes;
    const std::string teapot = rendered("teapot:2" + shown).bytes;
    for (const std::string& option : options) {
      const Rendered of_room = rendered("room" + shown + " " + option);
      const Rendered of_teapot = rendered("teapot:2" + shown + " " + option);
      const bool changes = of_room.bytes != room || of_teapot.bytes != teapot;
      INFO((*show ? show : "colours") << " with " << option);
      CHECK(contains(of_room.err, "note: " + option + " is ignored: ") == !changes);
      CHECK(of_teapot.err == of_room.err);
    }
  }
}

TEST_CASE("the default given in words is no reason for a note about samples") {
  CHECK(rendered("cube --show depth --samples 1").err.empty());
}

TEST_CASE("a window without parallax is ignored with a note") {
  const std::string plain = "forest --stereo pair --eye-separation 0";
  const Rendered with = rendered(plain + " --window 3");
  CHECK(contains(with.err, "note: --window 3 is ignored"));
  CHECK(with.bytes == rendered(plain).bytes);
  CHECK(rendered("forest --stereo pair --eye-separation 0.1 --window 3").err.empty());
}

TEST_CASE("step names what points and what triangles have no use for") {
  const Workplace here;
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
  const Outcome with = here.run(triangle + " --proj p.txt");
  CHECK(with.out == here.run(triangle).out);
  CHECK(contains(with.err, "note: --proj is ignored"));
}

}  // namespace
}  // namespace glassbox::test
