// Tests glassbox render --frames FIRST-LAST/N: parts of a sequence, drawn on any machine, are equal
// to those of the whole run.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/text.h"

namespace glassbox::test {
namespace {

namespace fs = std::filesystem;

const std::string kSliceWalk = R"({"camera_path": 1, "interpolation": "smooth", "keyframes": [
  {"time": 0, "eye": [0, 2, 14], "look_at": [0, 1.5, 0]},
  {"time": 1, "eye": [3, 1.6, 6], "look_at": [0, 1.5, -2]},
  {"time": 3, "eye": [-1, 1.6, 2], "look_at": [0, 1.5, -6]}]})";

std::string draw(const WorkingDirectory& here, const std::string& options,
                 const std::string& frames) {
  const Outcome outcome = here.run("render forest " + options + " --frames " + frames +
                                   (contains(options, "--size") ? "" : " --size 96x64"));
  INFO(options << " " << frames << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return outcome.out;
}

void check_same_pictures(const WorkingDirectory& whole, const WorkingDirectory& parts) {
  std::vector<std::string> names;
  for (const std::string& name : sorted_names(whole)) {
    if (!name.ends_with(".svg")) names.push_back(name);
  }
  REQUIRE(sorted_names(parts) == names);
  for (const std::string& name : names) {
    INFO(name);
    CHECK(parts.read(name) == whole.read(name));
  }
}

// The eye separation of a frame depends on the frames before and after it, so a part must take all
// others into account.
TEST_CASE("slices of a sequence have the names and bytes of the whole run") {
  for (const char* options :
       {"--stereo anaglyph --path p.json -o f.png", "--stereo pair --path p.json -o f%02d.png",
        "--path p.json", "--turntable -o t.ppm", "--turntable --stereo interlaced"}) {
    const WorkingDirectory whole, parts;
    for (const WorkingDirectory* here : {&whole, &parts}) here->write("p.json", kSliceWalk);
    draw(whole, options, "12");
    for (const char* slice : {"6-6/12", "7-12/12", "1-5/12"}) draw(parts, options, slice);
    INFO(options);
    check_same_pictures(whole, parts);
  }
}

TEST_CASE("a slice that is everything is the whole run, and one frame needs no dash") {
  const WorkingDirectory whole, slice;
  for (const WorkingDirectory* here : {&whole, &slice}) here->write("p.json", kSliceWalk);
  const std::string options = "--stereo anaglyph --path p.json -o f.png";
  draw(whole, options, "3");
  draw(slice, options, "1-3/3");
  CHECK(sorted_names(whole) == sorted_names(slice));  // the plot too
  CHECK(whole.read("f.svg") == slice.read("f.svg"));
  const WorkingDirectory one;
  one.write("p.json", kSliceWalk);
  draw(one, options, "2/3");
  CHECK(one.read("f-0002.png") == whole.read("f-0002.png"));
  CHECK(sorted_names(one) == std::vector<std::string>{"f-0002.png", "p.json"});
}

TEST_CASE("names have as many digits as the whole sequence needs") {
  const WorkingDirectory here;
  draw(here, "--turntable --size 2x2 -o t.png", "99999-100000/100000");
  CHECK(sorted_names(here) == std::vector<std::string>{"t-099999.png", "t-100000.png"});
}

TEST_CASE("a slice says what it is part of") {
  const WorkingDirectory here;
  here.write("p.json", kSliceWalk);
  CHECK(contains(draw(here, "--path p.json -o f.png", "2-4/9"), "f-0002.png to f-0004.png"));
  CHECK(contains(draw(here, "--path p.json -o f.png", "2-4/9"), "3 frames of 9"));
  const auto json = nlohmann::json::parse(draw(here, "--path p.json -o f.png --json -", "2-4/9"));
  CHECK(json["slice"] == nlohmann::json{{"first", 2}, {"last", 4}, {"of", 9}});
  CHECK(json["frames"].size() == 3);
  CHECK(json["frames"][0]["frame"] == 2);
}

TEST_CASE("slices that cannot be are refused") {
  for (const char* frames : {"0-3/9", "3-2/9", "2-10/9", "1-2/", "/9", "1-/9", "-2/9", "1-2-3/9",
                             "1-2/0", "1-2", "1-2/9/9", "1-2/100001", "a-b/c", "1,2/9"}) {
    INFO(frames);
    check_refused(WorkingDirectory().run(std::string("render cube --turntable --frames=") + frames),
                  {"--frames"});
  }
  check_refused(WorkingDirectory().run(
                    "render forest --turntable --stereo anaglyph --frames 1-2/9 --plot p.svg"),
                {"--plot", "all frames"});
}

// ---- the recipes of docs/command_line.md ----

// Returns the block between ``` of the page that contains the word.
std::string block_with(const std::string& word) {
  std::ifstream page(std::string(GLASSBOX_SOURCE_DIR) + "/docs/command_line.md");
  REQUIRE(page);
  std::string block;
  bool in_block = false;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("```")) {
      if (in_block) block += line + "\n";
      continue;
    }
    in_block = !in_block;
    if (!in_block && contains(block, word)) return block;
    block.clear();
  }
  FAIL("no block of docs/command_line.md has " << word);
  return {};
}

// Puts the program's folder on the path, so that `glassbox` is found as after cmake --install.
std::string path_setting() {
  const std::string directory = fs::path(GLASSBOX_PROGRAM).parent_path().string();
  return "PATH='" + directory + "':$PATH\n";
}

WorkingDirectory& write_walk(WorkingDirectory& here) {
  here.write("walk.json", kSliceWalk);
  fs::create_directory(here.file("walk"));
  return here;
}

std::vector<std::string> pictures_in(const WorkingDirectory& here) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(here.file("walk"))) {
    if (entry.path().extension() == ".png") names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void check_recipe(const std::string& script) {
  const std::string single = block_with("--frames 60 ");
  WorkingDirectory whole, parts;
  write_walk(whole);
  write_walk(parts);
  REQUIRE(in_shell(whole, path_setting() + single).exit_code == 0);
  const Outcome outcome = in_shell(parts, path_setting() + script);
  INFO(script << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  REQUIRE(pictures_in(whole).size() == 60);
  REQUIRE(pictures_in(parts) == pictures_in(whole));
  for (const std::string& name : pictures_in(whole)) {
    INFO(name);
    CHECK(parts.read("walk/" + name) == whole.read("walk/" + name));
  }
}

TEST_CASE("the pipes and the turn of docs/command_line.md work as they stand") {
  const WorkingDirectory here;
  fs::create_directory(here.file("turn"));
  const Outcome pipes = in_shell(here, path_setting() + block_with("cat teapot.glb"));
  INFO(pipes.err);
  CHECK(pipes.exit_code == 0);
  CHECK(here.read("teapot.ppm").starts_with("P6\n320 180\n"));
  const Outcome turned = in_shell(here, path_setting() + block_with("--frames 36 --turntable"));
  INFO(turned.err);
  CHECK(turned.exit_code == 0);
  CHECK(fs::exists(here.file("turn/teapot-0036.png")));
}

TEST_CASE("GNU parallel draws a path as docs/command_line.md says") {
  REQUIRE(in_shell(WorkingDirectory(), "command -v parallel").exit_code == 0);
  check_recipe(block_with("| parallel"));
}

TEST_CASE("a job array draws a path as docs/command_line.md says") {
  const std::string script = block_with("SLURM_ARRAY_TASK_ID");
  std::string tasks;
  for (int task = 0; task < 3; ++task) {
    tasks += "(SLURM_ARRAY_TASK_ID=" + std::to_string(task) + "\n" + script + ") || exit\n";
  }
  check_recipe(tasks);
}

}  // namespace
}  // namespace glassbox::test
