// Pictures made by glassbox: the command that shows the first differing pixel, and what happens
// with hostile recipes.
#include "tests/support/catch.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/picture_file_kinds.h"
#include "tests/compare/environment.h"

#include <glassbox/images/png_text.h>
#include <glassbox/images/read.h>
#include <glassbox/images/recipe.h>

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

// Returns the picture with the green of pixel (x, y) changed, and its text kept.
std::string altered(const std::string& path, int x, int y) {
  const auto bytes = value_of(read_file(path));
  StoredImage image = value_of(decode_stored(bytes));
  const double green = sample_at(image, x, y, 1);
  set_sample(image, x, y, 1, green < 128 ? green + 100 : green - 100);
  return png_of(image, value_of(read_png_text(bytes)));
}

std::string inspect_command(const std::string& out) {
  const std::string label = "  inspect: ";
  const auto start = out.find(label);
  if (start == std::string::npos) return "";
  return out.substr(start + label.size(), out.find('\n', start) - start - label.size());
}

TEST_CASE("the command that is printed runs, and shows the pixel that differs") {
  const EnvironmentVariable name("GLASSBOX_INVOKED_AS", GLASSBOX_PROGRAM);
  const std::vector<std::string> recipes{
      "teapot --size 40x30",
      "room --size 40x30 --shade flat --background 1,0.5,0.25 --depth d32r",
      "f-glyph --size 40x30 --eye -5,2,-7 --cull none --wireframe",
      "cube --size 40x30 --eye=-.5,2,7 --look-at=-0.1,0,0 --fov 30 --near 0.1 --far inf",
      "forest --size 40x30 --ortho 8 --show depth",
      "cube --size 40x30 --view 1,0,0,0,0,1,0,0,0,0,1,-4,0,0,0,1 "
      "--proj -2,0,0,0,0,2,0,0,0,0,-1.02,-0.202,0,0,-1,0"};
  for (const std::string& recipe : recipes) {
    const WorkingDirectory here;
    REQUIRE(here.run("render " + recipe + " -o a.png").exit_code == 0);
    here.write("b.png", altered(here.file("a.png"), 23, 14));
    const Outcome outcome = here.run("diff a.png b.png");
    INFO(outcome.out << outcome.err);
    REQUIRE(outcome.exit_code == 1);
    const std::string command = inspect_command(outcome.out);
    REQUIRE(!command.empty());
    const Outcome shown = run_program("/bin/sh", {"-c", command + " --json -"}, here.path());
    INFO(command << '\n' << shown.out << shown.err);
    REQUIRE(shown.exit_code == 0);
    const Json json = Json::parse(shown.out);
    CHECK(json["x"] == 23);
    CHECK(json["y"] == 14);
    // The command renders the picture as it should be.
    const StoredImage right = value_of(read_stored(here.file("a.png")));
    for (int c = 0; c < 3; ++c) CHECK(json["color"][std::size_t(c)] == sample_at(right, 23, 14, c));
    // The JSON has the same command.
    CHECK(
        Json::parse(here.run("diff a.png b.png --json -").out)["pictures"][0]["inspect_command"] ==
        command);
  }
}

TEST_CASE("names that a shell would take apart are quoted") {
  const WorkingDirectory here;
  const std::string odd = "a 'b' $(touch ran);.obj";
  here.write(odd, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::filesystem::create_symlink(GLASSBOX_PROGRAM, here.file("glass box"));
  const EnvironmentVariable name("GLASSBOX_INVOKED_AS", "./glass box");
  REQUIRE(
      run_program(GLASSBOX_PROGRAM, {"render", odd, "--size", "20x20", "-o", "a.png"}, here.path())
          .exit_code == 0);
  here.write("b.png", altered(here.file("a.png"), 4, 5));
  const std::string command = inspect_command(here.run("diff a.png b.png").out);
  REQUIRE(!command.empty());
  const Outcome shown = run_program("/bin/sh", {"-c", command}, here.path());
  INFO(command << '\n' << shown.out << shown.err);
  CHECK(shown.exit_code == 0);
  CHECK(contains(shown.out, "pixel (4, 5)"));
  CHECK(!std::filesystem::exists(here.file("ran")));
}

// Compares two pictures that differ in one pixel, both with this recipe as their text.
Outcome diff_of(const std::string& scene, const std::string& options) {
  const WorkingDirectory here;
  const std::vector<TextEntry> text{
      {"Software", "glassbox 0.1.0"}, {"glassbox scene", scene}, {"glassbox options", options}};
  StoredImage image = sample_picture({"", "", 3, Format::kBytes, {}});
  here.write("a.png", png_of(image, text));
  set_sample(image, 2, 2, 0, sample_at(image, 2, 2, 0) + 1);
  here.write("b.png", png_of(image, text));
  const Outcome outcome = here.run("diff a.png b.png");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.find_first_of("\x1b\x07") == std::string::npos);
  return outcome;
}

TEST_CASE("a hostile recipe prints no command") {
  REQUIRE(!inspect_command(diff_of("teapot", R"(["--size","24x18"])").out).empty());
  REQUIRE(!inspect_command(diff_of("teapot", "[]").out).empty());
  for (const char* options : {R"(["-o","victim.png"])",
                              R"(["--output","victim.png"])",
                              R"(["--json","victim"])",
                              R"(["--json=victim"])",
                              R"(["--depth-out","x.pfm"])",
                              R"(["--id-out=x.pfm"])",
                              R"(["--at","1,1"])",
                              R"(["--help"])",
                              R"(["-h"])",
                              R"(["--version"])",
                              R"(["--stats"])",
                              R"(["--unknown"])",
                              R"(["word"])",
                              R"(["--size"])",
                              R"(["--size","big"])",
                              R"(["--size","24x18","--size","24x18"])",
                              R"(["--shade","flat","extra"])",
                              R"(["--shade=flat"])",
                              R"(["--"])",
                              R"(["--","x"])",
                              R"(["++"])",
                              R"(["++","-o","x"])",
                              R"(["++","render","cube"])",
                              R"(["--shade","flat","--"])",
                              R"([""])",
                              R"(["--camera","a\nb"])",
                              R"(["--camera","\u001b[2J"])",
                              R"(["--camera","\u202e"])",
                              R"(["--sha","flat"])",
                              R"(["--config","x"])",
                              R"(["/size","1"])",
                              R"([1])",
                              R"({"a":1})",
                              R"("--size")",
                              "nonsense",
                              ""}) {
    INFO(options);
    CHECK(inspect_command(diff_of("teapot", options).out).empty());
  }
  for (const char* scene :
       {"-", "--help", "-o", "--json=x", "a\nb", "a\x1b[2Jb", "a\xe2\x80\xaeg", ""}) {
    INFO(scene);
    CHECK(inspect_command(diff_of(scene, "[]").out).empty());
  }
}

TEST_CASE("a scene that a shell would obey is harmless in quotes") {
  const std::string command =
      inspect_command(diff_of("x; touch ran #`touch ran`$(touch ran)'", "[]").out);
  REQUIRE(!command.empty());
  const WorkingDirectory here;
  const Outcome outcome = run_program("/bin/sh", {"-c", command}, here.path());
  CHECK(outcome.exit_code != 0);
  CHECK(here.names().empty());
}

TEST_CASE("a long command is printed whole or not at all") {
  const std::string scene = std::string(3000, 'x') + ".obj";
  const std::string command = inspect_command(diff_of(scene, "[]").out);
  CHECK(contains(command, scene + " --at 2,2"));
}

TEST_CASE("recipes that differ are told, and so are versions") {
  const WorkingDirectory here;
  REQUIRE(here.run("render teapot:2 --size 40x30 -o a.png").exit_code == 0);
  REQUIRE(here.run("render teapot:2 --size 40x30 --shade flat -o b.png").exit_code == 0);
  const Outcome outcome = here.run("diff a.png b.png");
  INFO(outcome.out);
  CHECK(contains(outcome.out,
                 "with other options: the reference with \"teapot:2 --size 40x30\", the test with "
                 "\"teapot:2 --size 40x30 --shade flat\""));

  auto text = value_of(read_png_text(value_of(read_file(here.file("b.png")))));
  for (auto& [keyword, words] : text) {
    if (keyword == "Software") words = "glassbox 0.0.9";
  }
  here.write("old.png", png_of(value_of(read_stored(here.file("a.png"))), text));
  StoredImage image = value_of(read_stored(here.file("a.png")));
  set_sample(image, 1, 1, 0, sample_at(image, 1, 1, 0) + 1);
  here.write("old.png", png_of(image, text));
  CHECK(contains(here.run("diff a.png old.png").out, "rendered by glassbox"));
  CHECK(contains(here.run("diff a.png old.png").out, "0.0.9"));
}

TEST_CASE("other sizes are explained by the recipes, too, with a pixel of what both have") {
  const WorkingDirectory here;
  REQUIRE(here.run("render cube --size 40x30 -o a.png").exit_code == 0);
  REQUIRE(here.run("render cube --size 41x30 -o b.png").exit_code == 0);
  const Outcome outcome = here.run("diff a.png b.png");
  CHECK(contains(outcome.out, "the reference has 40 x 30 pixels, the test 41 x 30"));
  CHECK(contains(outcome.out, "\"cube --size 41x30\""));
  CHECK(contains(inspect_command(outcome.out), "glassbox pixel cube --size 41x30 --at "));
}

TEST_CASE("a picture without a recipe, or one that passes, has no command") {
  const WorkingDirectory here;
  REQUIRE(here.run("render cube --size 40x30 -o a.png").exit_code == 0);
  const StoredImage image = value_of(read_stored(here.file("a.png")));
  StoredImage other = image;
  set_sample(other, 0, 0, 0, sample_at(image, 0, 0, 0) + 1);
  here.write("bare.png", png_of(other));
  CHECK(inspect_command(here.run("diff a.png bare.png").out).empty());
  CHECK(inspect_command(here.run("diff bare.png a.png").out).empty());
  here.write("b.png", altered(here.file("a.png"), 3, 3));
  CHECK(!inspect_command(here.run("diff a.png b.png").out).empty());
  CHECK(inspect_command(here.run("diff a.png b.png --fuzzy 0-255;0-1").out).empty());
  // The comparison fails only because a difference was required.
  const Outcome demanded = here.run("diff a.png a.png --fuzzy 1;1");
  CHECK(demanded.exit_code == 1);
  CHECK(inspect_command(demanded.out).empty());
}

}  // namespace
}  // namespace glassbox::test
