// Tests that the pictures of the handouts show typical mistakes (slips): each fault that has a slip
// is planted in the solution, and drawn by the command of the lab's handout, or by another one.
// docs/lab_faults.md says how many pixels then differ from the reference's picture.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "tests/labs/framework/plant_faults.h"
#include "tests/support/catch.h"
#include "tests/support/daily_share.h"
#include "tests/support/run_program.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// Pictures that show what the handout's picture does not: of another scene, or with these options.
const std::map<int, std::vector<Words>>& other_pictures() {
  static const std::map<int, std::vector<Words>> all{
      {1, {{"one-face-turned.obj"}, {"teapot:2", "--shade", "phong"}}},
      {3, {{"cube", "--view-from", "axis-angle"}, {"mirror.gltf"}}},
      {4,
       {{"cube", "--ortho", "4"},
        {"cube", "--depth", "d32r"},
        {"cube", "--show", "depth"},
        {"depth-ladder"}}},
      {7, {{"depth-ladder", "--show", "depth"}}},
      {8, {{"checker"}}},
      {9, {{"depth-ladder"}, {"room", "--near", "4"}}}};
  return all;
}

// The words of the handout's command after "glassbox lab render .", without the name of the output.
Words words_of_handout(const Sources& sources, const Lab& lab) {
  std::string text = read_text_file(sources.labs / lab.folder / "handout.md").value();
  const std::string begin = "    glassbox lab render . ";
  const std::size_t at = text.find(begin);
  REQUIRE(at != std::string::npos);
  text = text.substr(at + begin.size());
  Words words;
  std::istringstream in(text);
  for (std::string word; in >> word && word != "-o";) {
    if (word != "\\") words.push_back(word);
  }
  REQUIRE(words.size() > 1);
  return words;
}

// A student's folder in which faults are planted.
class PlantedFolder {
public:
  PlantedFolder(const Sources& sources, const Lab& lab)
      : solution_(solution_text(sources, lab.folder).value()) {
    fs::remove_all(path_);
    fs::create_directories(path_);
    REQUIRE(run({"lab", "start", std::to_string(lab.number), "mine"}).exit_code == 0);
  }
  ~PlantedFolder() { fs::remove_all(path_); }
  PlantedFolder(const PlantedFolder&) = delete;
  PlantedFolder& operator=(const PlantedFolder&) = delete;

  void plant(const Fault& fault) const {
    std::ofstream(path_ / "mine/student.cpp") << with_fault(solution_, fault);
  }

  // How many pixels of the picture differ from the reference's.
  std::int64_t differing_pixels(Words picture) const {
    Words words{"lab", "render", "."};
    words.insert(words.end(), picture.begin(), picture.end());
    words.insert(words.end(), {"-o", "picture.png", "--json", "-"});
    const auto outcome = test::run_program(GLASSBOX_PROGRAM, words, (path_ / "mine").string());
    CAPTURE(words, outcome.out, outcome.err);
    REQUIRE(outcome.exit_code < 2);
    const auto json = nlohmann::json::parse(outcome.out, nullptr, false);
    REQUIRE(json.is_object());
    return json["differing_pixels"].get<std::int64_t>();
  }

private:
  test::Outcome run(const Words& words) const {
    return test::run_program(GLASSBOX_PROGRAM, words, path_.string());
  }

  const std::string solution_;
  const fs::path path_ = fs::temp_directory_path() / fmt::format("glassbox-slips-{}", getpid());
};

// A fault that has a slip, with its number in faults.json, counted from 1.
struct PlantedSlip {
  const Lab& lab;
  std::size_t number;
  Fault fault;
};

std::vector<PlantedSlip> planted_slips(const Sources& sources) {
  std::vector<PlantedSlip> all;
  for (const Lab& lab : all_labs()) {
    const std::vector<Fault> faults = faults_of(sources, lab);
    for (std::size_t i = 0; i < faults.size(); ++i) {
      if (!faults[i].slip.empty()) all.push_back({lab, i + 1, faults[i]});
    }
  }
  return all;
}

// The row of the page for a fault: in which picture pixels differ, and how many.
std::string row_of(const Sources& sources, const PlantedSlip& slip) {
  const auto& [lab, number, fault] = slip;
  const PlantedFolder folder(sources, lab);
  folder.plant(fault);
  std::string shown_by = "the handout's picture";
  std::int64_t pixels = folder.differing_pixels(words_of_handout(sources, lab));
  if (const auto others = other_pictures().find(lab.number); others != other_pictures().end()) {
    for (const Words& words : others->second) {
      if (pixels > 0) break;
      pixels = folder.differing_pixels(words);
      shown_by = fmt::format("`{}`", fmt::join(words, " "));
    }
  }
  CAPTURE(fault.name, pixels, fault.unseen);
  CHECK((pixels == 0) == !fault.unseen.empty());
  if (pixels == 0) shown_by = "none: " + fault.unseen;
  return fmt::format("| {} | {} | {} | {} | {} | {} |", lab.number, number, fault.name, fault.slip,
                     pixels, shown_by);
}

// The rows of the faults in the share.
std::vector<std::string> rows(const test::DailyShare& share) {
  const Sources sources = find_sources().value();
  const std::vector<PlantedSlip> all = planted_slips(sources);
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (share.includes(i, all.size())) rows.push_back(row_of(sources, all[i]));
  }
  return rows;
}

std::size_t rows_in_page(const test::DailyShare& share) {
  INFO(share.text());
  const std::string page = read_text_file(GLASSBOX_SOURCE_DIR "/docs/lab_faults.md").value();
  const std::vector<std::string> expected = rows(share);
  for (const std::string& row : expected) {
    INFO(row);
    CHECK(page.find(row) != std::string::npos);
  }
  return expected.size();
}

}  // namespace

TEST_CASE("a picture shows each slip, a few every day, as docs/lab_faults.md says") {
  CHECK(rows_in_page(test::DailyShare(24)) >= 4);
}

TEST_CASE("a picture shows each slip, as docs/lab_faults.md says", "[.faults]") {
  CHECK(rows_in_page(test::DailyShare::everything()) >= 100);
}

// test_lab_drawings "[.page]" prints the table of docs/lab_faults.md, or only the rows of the lab
// that the environment variable LAB names.
TEST_CASE("the table of slips and pixels", "[.page]") {
  const char* const only = std::getenv("LAB");
  const Sources sources = find_sources().value();
  for (const PlantedSlip& slip : planted_slips(sources)) {
    if (only != nullptr && std::to_string(slip.lab.number) != only) continue;
    std::printf("%s\n", row_of(sources, slip).c_str());
    std::fflush(stdout);
  }
}
