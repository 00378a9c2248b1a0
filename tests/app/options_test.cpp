// Tests glassbox render and glassbox itself: every option, default names, sizes, help and wrong
// usage.
#include "tests/support/catch.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/text.h"

#include <glassbox/images/read.h>

namespace glassbox::test {
namespace {

Image<Rgba8> read_picture(const WorkingDirectory& here, const std::string& name) {
  const auto image = read_image(here.file(name));
  INFO(name);
  REQUIRE(image);
  return *image;
}

// Returns the bytes of the PPM that these options give. A PNG would contain the options.
std::string picture_bytes(const std::string& options) {
  const WorkingDirectory here;
  const Outcome outcome = here.run("render " + options + " --size 48x32 -o p.ppm");
  INFO(options << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return here.read("p.ppm");
}

TEST_CASE("a picture is named after its scene and written where the user stands") {
  const WorkingDirectory here;
  const WorkingDirectory elsewhere;
  elsewhere.write("a.b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::map<std::string, std::string> names{
      {"teapot", "teapot.png"}, {"sphere:4", "sphere.png"}, {elsewhere.file("a.b.obj"), "a.b.png"}};
  for (const auto& [scene, name] : names) {
    INFO(scene);
    CHECK(here.run("render " + scene + " --size 8x8").exit_code == 0);
    CHECK(read_picture(here, name).width == 8);
  }
  CHECK(here.names().size() == 3);
}

TEST_CASE("without options a picture has 1280 x 720 pixels") {
  const WorkingDirectory here;
  REQUIRE(here.run("render cube").exit_code == 0);
  const Image<Rgba8> image = read_picture(here, "cube.png");
  CHECK(image.width == 1280);
  CHECK(image.height == 720);
}

TEST_CASE("pictures have the size asked for, from 1x1 to 16384 wide or high") {
  for (const auto& [width, height] :
       std::vector<std::pair<int, int>>{{1, 1}, {16384, 1}, {1, 16384}, {3, 7}}) {
    const WorkingDirectory here;
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    REQUIRE(here.run("render room --size " + size).exit_code == 0);
    const Image<Rgba8> image = read_picture(here, "room.png");
    CHECK(image.width == width);
    CHECK(image.height == height);
    const Rgba8 background{26, 31, 38, 255};
    CHECK(std::count(image.pixels.begin(), image.pixels.end(), background) <
          std::ptrdiff_t(image.pixels.size()));
  }
}

TEST_CASE("whole numbers are decimal, with leading zeros too, and in no other base") {
  const WorkingDirectory here;
  const std::string ring = "views ring cube -o ring --size 8x8 --json - --views ";
  const auto pictures = [&](const std::string& number) {
    return nlohmann::json::parse(here.run(ring + number).out)["pictures"].get<int>();
  };
  CHECK(pictures("012") == 12);
  CHECK(pictures("0008") == 8);
  CHECK(pictures("3") == 3);
  for (const char* number : {"0x10", "1x", "3.5", "0.5", "many", "0b11"}) {
    const Outcome outcome = here.run(ring + number);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, "--views: needs a whole number, not '" + std::string(number)));
  }
  // Numbers with limits are converted to decimal before the limits are checked; names that look
  // like numbers stay as they are.
  CHECK(contains(here.run("views voxels ring --resolution 010").out, "10 x"));
  CHECK(here.run("render cube --size 8x8 -o 007.png").exit_code == 0);
  CHECK(std::ranges::count(here.names(), "007.png") == 1);
}

TEST_CASE("PNG and PPM hold the same pixels, in either case of the extension") {
  const WorkingDirectory here;
  for (const char* name : {"a.png", "b.ppm", "c.PNG", "d.PPM"}) {
    REQUIRE(here.run(std::string("render f-glyph --size 31x17 -o ") + name).exit_code == 0);
    CHECK(read_picture(here, name) == read_picture(here, "a.png"));
  }
  CHECK(here.read("b.ppm").substr(0, 2) == "P6");
}

TEST_CASE("every value of a choice is taken, in either case, and gives a picture of its own") {
  // Each choice is tested with a scene in which it matters.
  const std::vector<std::pair<std::string, std::vector<std::string>>> choices{
      {"teapot:2 --shade", {"unlit", "flat", "gouraud", "phong"}},
      {"room --show", {"depth", "normal", "uv", "id", "overdraw"}},
      {"f-glyph --eye 4,3,8 --cull", {"back", "front"}},
      {"room --transfer", {"srgb", "none"}},
      {"depth-ladder --depth", {"d32r", "d24", "d16"}},
      {"f-glyph --samples", {"1", "2", "4", "8", "16"}}};
  for (const auto& [option, values] : choices) {
    std::set<std::string> pictures;
    for (const std::string& value : values) {
      pictures.insert(picture_bytes(option + " " + value));
      std::string upper = value;
      for (char& c : upper) c = char(std::toupper(static_cast<unsigned char>(c)));
      CHECK(pictures.count(picture_bytes(option + " " + upper)) == 1);
    }
    INFO(option);
    CHECK(pictures.size() == values.size());
  }
}

TEST_CASE("every other option of render changes the picture as it says") {
  const std::string plain = picture_bytes("f-glyph");
  for (const char* option :
       {"--wireframe", "--background 0,0.5,1", "--eye 1,2,9", "--look-at 1,2,0", "--up 1,1,0",
        "--fov 20", "--ortho 6", "--frustum -0.2,0.3,-0.1,0.2 --near 0.5", "--near 11", "--far 7.5",
        "--cull front"}) {
    INFO(option);
    CHECK(picture_bytes(std::string("f-glyph ") + option) != plain);
  }
  for (const char* option : {"--shade phong", "--cull back", "--transfer srgb", "--depth d32",
                             "--samples 1", "--depth d32r", "--background 0.1,0.12,0.15"}) {
    INFO(option << " is the default");
    CHECK(picture_bytes(std::string("f-glyph ") + option) == plain);
  }
}

TEST_CASE("the background is the colour as displayed") {
  const WorkingDirectory here;
  REQUIRE(here.run("render cube --size 8x8 --background 0,0.5,1 --fov 170").exit_code == 0);
  CHECK(read_picture(here, "cube.png").at(0, 0) == Rgba8{0, 128, 255, 255});
}

TEST_CASE("--json - prints JSON and nothing else; --json FILE leaves the summary where it was") {
  const WorkingDirectory here;
  const Outcome alone = here.run("render cube --size 16x8 --stats --json -");
  REQUIRE(alone.exit_code == 0);
  CHECK(alone.err.empty());
  const nlohmann::json json = nlohmann::json::parse(alone.out);
  CHECK(json["scene"] == "cube");
  CHECK(json["image"] == "cube.png");
  CHECK(json["width"] == 16);
  CHECK(json["height"] == 8);
  CHECK(json["stages"]["triangles"] == 12);
  CHECK(json["camera"]["projection"] == "perspective");
  CHECK(json["camera"]["world_from_eye_rows"].size() == 16);

  const Outcome beside = here.run("render cube --size 16x8 --ortho 4 --json out.json");
  REQUIRE(beside.exit_code == 0);
  CHECK(contains(beside.out, "cube.png (16 x 8)"));
  CHECK(nlohmann::json::parse(here.read("out.json"))["camera"]["projection"] == "parallel");
}

TEST_CASE("the counts of the stages add up") {
  for (const char* scene : {"room", "forest", "teapot:4 --eye 0.2,0.6,0.1 --look-at -1,0.7,-0.4"}) {
    const WorkingDirectory here;
    const Outcome outcome = here.run(std::string("render ") + scene + " --size 64x36 --json -");
    REQUIRE(outcome.exit_code == 0);
    const nlohmann::json s = nlohmann::json::parse(outcome.out)["stages"];
    const auto n = [&](const char* key) { return s[key].get<std::uint64_t>(); };
    INFO(scene);
    CHECK(n("after_clipping") == n("zero_area") + n("culled") + n("set_up"));
    CHECK(n("covered") == n("depth_failed") + n("discarded") + n("written"));
    CHECK(n("triangles") - n("degenerate") >= n("rejected") + n("clipped_away") + n("clipped"));
    CHECK(n("written") > 0);
  }
}

TEST_CASE("--stats prints one line for every stage") {
  const Outcome outcome = WorkingDirectory().run("render cube --size 16x16 --stats");
  for (const char* stage : {"clip", "viewport", "cull", "coverage", "depth test", "write", " ms"}) {
    INFO(stage);
    CHECK(contains(outcome.out, stage));
  }
}

TEST_CASE("without arguments the teapot is rendered and the next steps are named") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("");
  CHECK(outcome.exit_code == 0);
  CHECK(here.names() == std::vector<std::string>{"teapot.png"});
  CHECK(contains(outcome.out, "try next"));
  CHECK(contains(outcome.out, "glassbox render"));
  REQUIRE(here.run("render teapot -o x.png").exit_code == 0);
  // double parentheses: a failure does not print the bytes
  CHECK((here.read("teapot.png") == here.read("x.png")));
}

TEST_CASE("help and version are printed on standard output, with examples for each subcommand") {
  const WorkingDirectory here;
  for (const char* words : {"render --help", "info --help", "render -h"}) {
    const Outcome outcome = here.run(words);
    INFO(words);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.err.empty());
    CHECK(contains(outcome.out, "Examples:\n  glassbox "));
    CHECK(contains(outcome.out, "depth-ladder"));
  }
  const Outcome all = here.run("--help");
  CHECK(all.exit_code == 0);
  for (const char* command : {"render", "info"}) CHECK(contains(all.out, command));
  const Outcome version = here.run("--version");
  CHECK(version.exit_code == 0);
  CHECK(contains(version.out, "glassbox "));
  CHECK(here.names().empty());
}

TEST_CASE("a picture in which nothing is seen is written, with a note") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("render cube --size 8x8 --eye 0,0,9 --look-at 0,0,20");
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.err, "no part of the scene"));
  CHECK(read_picture(here, "cube.png") == Image<Rgba8>(8, 8, Rgba8{26, 31, 38, 255}));
}

TEST_CASE("a scene whose faces all lack area says so, and names quads in Z order") {
  const WorkingDirectory here;
  const std::string grid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 2 0\nv 1 2 0\n";
  const auto note = [&](const std::string& faces) {
    here.write("a.obj", grid + faces);
    const Outcome outcome = here.run("render a.obj --size 8x8");
    CHECK(outcome.exit_code == 0);
    return outcome.err;
  };
  CHECK(contains(note("f 1 2 3 4\nf 3 4 5 6\nf 1 3 5\n"),
                 "note: nothing is drawn, because all 3 faces of the scene have no area; 2 are "
                 "quads listed in Z order: exchange the last two corners"));
  CHECK(note("f 1 3 5\n").ends_with("because the only face of the scene has no area\n"));
  CHECK_FALSE(contains(note("f 1 2 3\nf 1 3 5\n"), "nothing is drawn"));
}

TEST_CASE("a picture of backs only says how to see them") {
  const WorkingDirectory here;
  here.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string from_behind = "render a.obj --size 8x8 --eye 0.3,0.3,-2 --look-at 0.3,0.3,0";
  CHECK(contains(here.run(from_behind + " --cull back").err, "--cull none"));
  CHECK(here.run(from_behind + " --cull none").err.empty());
  CHECK(here.run(from_behind).err.empty());  // faces of OBJ files are double-sided
}

TEST_CASE("no number between two limits is nan") {
  const WorkingDirectory here;
  for (const char* words :
       {"lab check 1 --time-limit nan", "views layers build room --epsilon nan -o a.ldi"}) {
    const Outcome outcome = here.run(words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find("nan not in range [") != std::string::npos);
  }
}

TEST_CASE("bad usage exits with 2, says on one line what is wrong, and writes nothing") {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"render", "SCENE"},
      {"bogus", "the subcommands are render, info, "},
      {"render cube another", "another"},
      {"render cube --bogus", "--bogus"},
      {"render cube --shade shiny", "--shade: needs one of unlit|flat|gouraud|phong, not 'shiny'"},
      {"render cube --shade 1", "--shade"},
      {"render cube --size 0x4", "--size"},
      {"render cube --size 4x-4", "--size"},
      {"render cube --size 16385x1", "16384"},
      {"render cube --size 99999999999999999999x1", "--size"},
      {"render cube --size 1.5x2", "--size"},
      {"render cube --size 7", "WxH"},
      {"render cube --size 7x", "WxH"},
      {"render cube --size 7x7x7", "WxH"},
      {"render cube --eye 1,2", "--eye"},
      {"render cube --eye 1,2,nan", "--eye"},
      {"render cube --up 0,inf,0", "--up"},
      {"render cube --fov wide", "--fov: needs a number, not 'wide'"},
      {"render cube --fov 45deg", "--fov"},
      {"render cube --near close", "--near"},
      {"render cube --far nan", "--far"},
      {"render cube --frustum 1,2,3", "--frustum"},
      {"render cube --samples 3", "--samples: needs one of 1|2|4|8|16, not '3'"},
      {"render cube --samples 0", "--samples"},
      {"render cube --samples -4", "--samples"},
      {"render cube --samples 32", "--samples"},
      {"render cube --samples four", "--samples"},
      {"render cube --background 0,0,256", "divide values of 0 to 255 by 255"},
      {"render cube --json", "--json"},
      {"info", "SCENE"},
      {"info cube --bogus", "--bogus"}};
  for (const auto& [words, message] : cases) {
    const WorkingDirectory here;
    const Outcome outcome = here.run(words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, message));
    CHECK(contains(outcome.err, "--help"));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK(outcome.out.empty());
    CHECK(here.names().empty());
  }
}

}  // namespace
}  // namespace glassbox::test
