// points.json: what it changes, and what it warns of.
#include "labs/framework/points.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <tuple>

#include "labs/framework/sources.h"
#include "tests/support/catch.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;

Lab two_tasks() {
  Lab lab;
  lab.tasks = {{"1.1", "first", 6}, {"1.2", "second", 4}};
  for (const auto& [name, task, hidden] : {std::tuple{"a", "1.1", false},
                                           {"b", "1.1", false},
                                           {"secret", "1.1", true},
                                           {"c", "1.2", false}}) {
    Check check;
    check.name = name;
    check.task = task;
    check.hidden = hidden;
    lab.checks.push_back(check);
  }
  return lab;
}

Result<Shares> shares_of(const std::string& text) {
  const fs::path file = fs::temp_directory_path() / ("glassbox-points-" + std::to_string(getpid()));
  std::ofstream(file) << text;
  auto shares = read_shares(two_tasks(), file);
  fs::remove(file);
  return shares;
}

}  // namespace

TEST_CASE(
    "points.json gives tasks points, visible checks weights, and hidden ones a weight together") {
  const auto shares = shares_of(
      R"({"points": 20, "tasks": {"1.1": 12, "1.2": 8}, "checks": {"b": 3}, "hidden": {"1.1": 2}})");
  REQUIRE(shares);
  CHECK(shares->warnings.empty());
  const Lab& lab = shares->lab;
  CHECK(points_of_case(lab, lab.checks[0], 2) == 1);  // 12 * 1 / 6 / 2
  CHECK(points_of_case(lab, lab.checks[1], 1) == 6);  // 12 * 3 / 6
  CHECK(points_of_case(lab, lab.checks[2], 4) == 1);  // 12 * 2 / 6 / 4
  CHECK(points_of_case(lab, lab.checks[3], 1) == 8);
}

TEST_CASE(
    "points.json is warned of where it does not sum to what it says, or names what is not there") {
  CHECK(shares_of("{}")->warnings.empty());
  CHECK(read_shares(two_tasks(), "/nowhere/points.json")->warnings.empty());
  for (const char* text :
       {R"({"points": 100})", R"({"points": 10, "tasks": {"1.1": 7, "1.2": 4}})",
        R"({"tasks": {"1.1": 6}})", R"({"tasks": {"1.1": 6, "1.2": 4, "1.3": 1}})",
        R"({"checks": {"d": 1}})", R"({"checks": {"secret": 1}})", R"({"hidden": {"1.2": 1}})",
        R"({"checks": {"c": 0}})"}) {
    INFO(text);
    const auto shares = shares_of(text);
    REQUIRE(shares);
    CHECK(shares->warnings.size() == 1);
  }
  for (const char* text : {"[]", "{", R"({"point": 1})", R"({"tasks": {"1.1": "6"}})",
                           R"({"checks": {"a": -1}})", R"({"checks": 1})"}) {
    INFO(text);
    CHECK_FALSE(shares_of(text));
  }
}

TEST_CASE("every lab's points.json sums to 100 and names no hidden check") {
  const Sources sources = find_sources().value();
  for (const Lab& lab : all_labs()) {
    INFO(lab.folder);
    const fs::path file = sources.folder_of(lab.folder) / "points.json";
    CHECK(fs::exists(file));
    const auto shares = read_shares(lab, file);
    REQUIRE(shares);
    CHECK(shares->warnings.empty());
    double sum = 0;
    for (const Task& task : shares->lab.tasks) sum += task.points;
    CHECK(sum == 100);
  }
}

TEST_CASE(
    "one visible check of a task weighs 2, the others 1, and the hidden ones as much together") {
  const Sources sources = find_sources().value();
  for (const Lab& lab : all_labs()) {
    const auto shares = read_shares(lab, sources.folder_of(lab.folder) / "points.json");
    REQUIRE(shares);
    for (const Task& task : lab.tasks) {
      INFO("task " << task.id);
      double visible = 0, hidden = 0;
      std::size_t checks = 0, headlines = 0;
      for (const Check& check : shares->lab.checks) {
        if (check.task != task.id) continue;
        (check.hidden ? hidden : visible) += check.weight;
        if (check.hidden) continue;
        ++checks;
        headlines += check.weight == 2 ? 1 : 0;
        CHECK((check.weight == 1 || check.weight == 2));
      }
      if (hidden == 0) continue;  // 4.3: three dialects, headlines alike
      CHECK(headlines == (checks > 1 ? 1u : 0u));
      CHECK(hidden == visible);
    }
  }
}
