// Tests --engine, --threads, --target and --no-plan, which choose how a picture is drawn. Every
// choice writes the same bytes.
#include "tests/support/catch.h"

#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include <glassbox/images/read.h>
#include <glassbox/raster/lanes/target.h>

#include "tests/app/text.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

// Returns all files that a command writes, by name, except JSON, which has times.
std::vector<std::pair<std::string, std::string>> files_of(const std::string& words) {
  const WorkingDirectory here;
  here.write("walk.json", R"({"camera_path": 1, "keyframes": [
      {"time": 0, "eye": [0, 2, 14], "look_at": [0, 1.5, 0]},
      {"time": 1, "eye": [3, 1.6, 6], "look_at": [0, 1.5, -2]}]})");
  const Outcome outcome = here.run(words);
  INFO(words << ": " << outcome.err);
  REQUIRE(outcome.exit_code == 0);
  std::vector<std::pair<std::string, std::string>> files;
  for (const std::string& name : here.names()) files.emplace_back(name, here.read(name));
  return files;
}

const std::vector<std::string> kPictures{
    "render room --size 97x61 --depth-out d.pfm --id-out i.pfm",
    "render forest --size 96x54 --depth d32r --show id",
    "render teapot:6 --size 64x64 --shade gouraud --cull none",
    "render cube --size 64x36 --wireframe",
    "render room --size 97x61 --samples 4 --depth-out d.pfm --id-out i.pfm",
    "render forest --size 96x54 --samples 2 --stereo anaglyph --eye-separation 0.1 --window 9",
    "render forest --size 80x45 --samples 8 --frames 2 --path walk.json -o walk.png",
    "render f-glyph --size 80x45 --eye-separation 0.1 --seen-by right",
    "render forest --size 96x54 --stereo anaglyph",
    "render forest --size 96x54 --stereo anaglyph --show depth",
    "render room --size 96x54 --stereo anaglyph --anaglyph dubois --eye-separation 0.1",
    "render room --size 96x54 --stereo pair --stereo-cull centre --eye-separation 0.3 --window 3",
    "render teapot --size 96x54 --stereo interlaced --eye-separation 0",
    "render forest --size 80x45 --frames 3 --path walk.json -o walk.png",
    "render forest --size 80x45 --stereo anaglyph --frames 3 --path walk.json -o walk.png",
};

TEST_CASE("the engines write the same files, recipes and maps included") {
  for (const std::string& words : kPictures) {
    INFO(words);
    const auto staged = files_of(words + " --engine staged");
    CHECK(files_of(words) == staged);
    CHECK(files_of(words + " --engine tile --threads 3 --no-plan --target scalar") == staged);
  }
}

TEST_CASE("no target and no number of threads changes a byte") {
  const std::string words = "render room --size 101x57";
  const auto staged = files_of(words + " --engine staged");
  for (const Target target : available_targets()) {
    for (const char* threads : {"1", "2", "5"}) {
      const std::string options =
          " --target " + std::string(name_of(target)) + " --threads " + threads;
      INFO(options);
      CHECK(files_of(words + options) == staged);
    }
  }
}

// Runs the program and returns the largest number of threads that was seen until it has written the
// file `last`.
std::size_t most_threads(const WorkingDirectory& here, const std::string& words, const char* last) {
  namespace fs = std::filesystem;
  std::size_t most = 0;
  const Outcome outcome = here.run(words, [&](pid_t process) {
    const fs::path tasks = "/proc/" + std::to_string(process) + "/task";
    const auto end =
        // if the file is never written
        std::chrono::steady_clock::now() + std::chrono::seconds(60);
    std::error_code gone;
    while (!fs::exists(here.file(last)) && std::chrono::steady_clock::now() < end) {
      const auto seen =
          std::distance(fs::directory_iterator(tasks, gone), fs::directory_iterator());
      most = std::max(most, std::size_t(seen));
    }
  });
  REQUIRE(outcome.exit_code == 0);
  return most;
}

TEST_CASE("a picture is drawn and compressed on no more threads than --threads says") {
  const std::string words = "render room --size 1600x900 -o x.png --json done.json --threads ";
  const WorkingDirectory alone;
  CHECK(most_threads(alone, words + "1", "done.json") == 1);
  const WorkingDirectory together;
  CHECK(most_threads(together, words + "4", "done.json") > 1);
}

TEST_CASE("glassbox stereo finds the same with either engine, but for what it took") {
  const WorkingDirectory here;
  const auto findings = [&](const std::string& options) {
    const Outcome outcome = here.run("stereo room --size 96x54 --json - " + options);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    Json json = Json::parse(outcome.out);
    REQUIRE(json.contains("cost"));
    CHECK(json["cost"]["ratio"].get<double>() > 0);
    json.erase("cost");
    auto& verdicts = json["verdicts"];
    verdicts.erase(std::remove_if(verdicts.begin(), verdicts.end(),
                                  [](const Json& verdict) { return verdict["about"] == "cost"; }),
                   verdicts.end());
    return json;
  };
  CHECK(findings("--engine staged") == findings("--engine tile --threads 2"));
}

TEST_CASE("an engine, a target or a number of threads that cannot be is refused") {
  const WorkingDirectory here;
  const auto available = available_targets();
  std::string names;
  for (const Target target : available)
    names += (names.empty() ? "" : "|") + std::string(name_of(target));
  std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {"--engine gpu", {"--engine", "tile|staged", "gpu"}},
      {"--target mmx", {"--target", names, "mmx"}},
      {"--threads 0", {"--threads", "1 to 1024"}},
      {"--threads -2", {"--threads", "1 to 1024"}},
      {"--threads 1.5", {"--threads", "whole number"}},
      {"--threads 1000000", {"--threads", "1 to 1024"}},
      {"--threads nan", {"--threads", "1 to 1024"}},
      {"--threads many", {"--threads", "many"}},
      {"--engine staged --threads 2", {"--threads", "--engine staged"}},
      {"--engine staged --target scalar", {"--target", "--engine staged"}},
      {"--engine staged --no-plan", {"--no-plan", "--engine staged"}},
  };
  for (const Target target : {Target::kSse4, Target::kAvx2, Target::kAvx512, Target::kNeon}) {
    if (std::find(available.begin(), available.end(), target) != available.end()) continue;
    const std::string name(name_of(target));
    cases.push_back({"--target " + name, {name, "is not available here", "scalar"}});
  }
  for (const auto& [options, parts] : cases) {
    for (const char* command : {"render", "stereo"}) {
      INFO(command << " " << options);
      check_refused(here.run(std::string(command) + " cube --size 8x8 " + options), parts);
    }
  }
  CHECK(here.names().empty());
}

TEST_CASE("--help says what the engine options are") {
  const Outcome outcome = WorkingDirectory().run("render --help");
  for (const char* word : {"--engine", "--threads", "--target", "--no-plan", "scalar"}) {
    INFO(word);
    CHECK(contains(outcome.out, word));
  }
}

TEST_CASE("--json says which engine drew") {
  const WorkingDirectory here;
  const auto engine = [&](const std::string& options) {
    const Outcome outcome = here.run("render cube --size 16x9 --json - " + options);
    REQUIRE(outcome.exit_code == 0);
    return Json::parse(outcome.out)["engine"];
  };
  const Json tile = engine("--threads 2 --target scalar --no-plan");
  CHECK(tile["name"] == "tile");
  CHECK(tile["threads"] == 2);
  CHECK(tile["target"] == "scalar");
  CHECK(tile["plan"] == false);
  CHECK(engine("")["target"] == name_of(best_target()));
  CHECK(engine("--engine staged") == Json{{"name", "staged"}});
}

// ---- Ctrl-C ----

// Returns how many pictures are in the folder. Each must be whole, and there may be no other files
// except those in `known`.
std::size_t whole_pictures(const WorkingDirectory& here, const std::vector<std::string>& known) {
  std::size_t count = 0;
  for (const std::string& name : here.names()) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    INFO(name);
    CHECK(std::filesystem::path(name).extension() == ".png");
    CHECK(read_image(here.file(name)));
    ++count;
  }
  return count;
}

TEST_CASE("a render that is interrupted at any time leaves the whole picture or none") {
  for (const int after_ms : {0, 5, 10, 20, 30, 40, 60, 80, 120, 160, 240, 320}) {
    const WorkingDirectory here;
    const Outcome outcome =
        here.run("render teapot:24 --size 1280x720 -o t.png", [&](pid_t process) {
          std::this_thread::sleep_for(std::chrono::milliseconds(after_ms));
          ::kill(process, SIGINT);
        });
    INFO(after_ms << " ms: " << outcome.exit_code << ", " << outcome.err);
    const std::size_t pictures = whole_pictures(here, {});
    if (outcome.exit_code == 0) {
      CHECK(pictures == 1);
    } else {
      CHECK((outcome.exit_code == 1 || outcome.exit_code == 128 + SIGINT));
    }
  }
}

TEST_CASE("a sequence that is interrupted ends with a whole frame, and says how many there are") {
  for (const char* engine : {"tile --threads 2", "staged"}) {
    INFO(engine);
    const WorkingDirectory here;
    here.write("walk.json", R"({"camera_path": 1, "keyframes": [
        {"time": 0, "eye": [0, 2, 14], "look_at": [0, 1.5, 0]},
        {"time": 1, "eye": [3, 1.6, 6], "look_at": [0, 1.5, -2]}]})");
    const Outcome outcome =
        here.run("render forest --size 320x180 --frames 400 --path walk.json -o f.png --engine " +
                     std::string(engine),
                 [&](pid_t process) {
                   while (!std::filesystem::exists(here.file("f-0003.png"))) {
                     if (::kill(process, 0) != 0) return;
                     std::this_thread::sleep_for(std::chrono::milliseconds(5));
                   }
                   ::kill(process, SIGINT);
                 });
    CHECK(outcome.exit_code == 1);
    const std::size_t pictures = whole_pictures(here, {"walk.json"});
    CHECK(pictures >= 3);
    CHECK(pictures < 400);
    CHECK(contains(outcome.err, "stopped: " + std::to_string(pictures) + " of 400 frames"));
  }
}

}  // namespace
}  // namespace glassbox::test
