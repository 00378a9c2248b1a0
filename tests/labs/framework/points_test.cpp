// Tests points.json: what it changes, and what it warns about.
#include "labs/framework/lab_points.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <tuple>

#include "labs/framework/judge_check.h"
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

Result<LabPoints> lab_points_of(const std::string& text) {
  const fs::path file = fs::temp_directory_path() / ("glassbox-points-" + std::to_string(getpid()));
  std::ofstream(file) << text;
  auto lab_points = read_lab_points(two_tasks(), file);
  fs::remove(file);
  return lab_points;
}

}  // namespace

TEST_CASE(
    "points.json gives tasks points, visible checks weights, and hidden ones a weight together") {
  const auto lab_points = lab_points_of(
      R"({"points": 20, "tasks": {"1.1": 12, "1.2": 8}, "checks": {"b": 3}, "hidden": {"1.1": 2}})");
  REQUIRE(lab_points);
  CHECK(lab_points->warnings.empty());
  const Lab& lab = lab_points->lab;
  CHECK(points_of_case(lab, lab.checks[0], 2) == 1);  // 12 * 1 / 6 / 2
  CHECK(points_of_case(lab, lab.checks[1], 1) == 6);  // 12 * 3 / 6
  CHECK(points_of_case(lab, lab.checks[2], 4) == 1);  // 12 * 2 / 6 / 4
  CHECK(points_of_case(lab, lab.checks[3], 1) == 8);
}

TEST_CASE(
    "a check that counts as a whole gives its points where every case is right, and none "
    "elsewhere") {
  const auto lab_points = lab_points_of(R"({"whole": ["b"]})");
  REQUIRE(lab_points);
  CHECK(lab_points->warnings.empty());
  const Lab& lab = lab_points->lab;
  CHECK_FALSE(lab.checks[0].all_or_nothing);
  CHECK(lab.checks[1].all_or_nothing);
  const std::vector<Case> cases{{"", "", {numbers("y", {1})}}, {"", "", {numbers("y", {2})}}};
  CheckAnswers answers;
  answers.cases.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    answers.cases[i].state = CaseAnswer::State::kAnswered;
    answers.cases[i].answer.emit("y", {double(i) + 1});
  }
  CHECK(judge_check(lab.checks[1], cases, answers, 3).score == 6);
  answers.cases[1].answer = {};
  answers.cases[1].answer.emit("y", {3});
  const CheckResult whole = judge_check(lab.checks[1], cases, answers, 3);
  CHECK(whole.right == 1);
  CHECK(whole.score == 0);
  CHECK(judge_check(lab.checks[0], cases, answers, 3).score == 3);
}

TEST_CASE("a far plane that is forgotten costs more than the one case that shows it") {
  const Sources sources = find_sources().value();
  const Lab& lab = *std::find_if(all_labs().begin(), all_labs().end(),
                                 [](const Lab& l) { return l.number == 5; });
  const Lab shared =
      read_lab_points(lab, sources.folder_of(lab.folder) / "points.json").value().lab;
  const auto clipper = std::find_if(shared.checks.begin(), shared.checks.end(), [](const Check& c) {
    return c.name == "a triangle and the frustum";
  });
  REQUIRE(clipper != shared.checks.end());
  CHECK(clipper->all_or_nothing);
  for (const Check& check : shared.checks) {
    if (check.name != "which planes a point is outside of") continue;
    const std::vector<Case> cases = check.cases();
    CheckAnswers answers;
    answers.cases.resize(cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
      constexpr int kFar = 2;  // lab_05::kFar
      answers.cases[i].state = CaseAnswer::State::kAnswered;
      answers.cases[i].answer.emit("outcode",
                                   {double(int(cases[i].expected[0].values[0]) & ~kFar)});
    }
    const double points = points_of_case(shared, check, cases.size());
    const CheckResult result = judge_check(check, cases, answers, points);
    CHECK(result.right >= cases.size() / 2);
    CHECK(result.score == 0);
    CHECK(result.max_score == 3.75);  // 15 points for weights of 1 + 1 + 2
    return;
  }
  FAIL("the check has another name");
}

TEST_CASE(
    "points.json is warned of where it does not sum to what it says, or names what is not there") {
  CHECK(lab_points_of("{}")->warnings.empty());
  CHECK(read_lab_points(two_tasks(), "/nowhere/points.json")->warnings.empty());
  for (const char* text :
       {R"({"points": 100})", R"({"points": 10, "tasks": {"1.1": 7, "1.2": 4}})",
        R"({"tasks": {"1.1": 6}})", R"({"tasks": {"1.1": 6, "1.2": 4, "1.3": 1}})",
        R"({"checks": {"d": 1}})", R"({"checks": {"secret": 1}})", R"({"hidden": {"1.2": 1}})",
        R"({"checks": {"c": 0}})", R"({"whole": ["d"]})", R"({"whole": ["secret"]})"}) {
    INFO(text);
    const auto lab_points = lab_points_of(text);
    REQUIRE(lab_points);
    CHECK(lab_points->warnings.size() == 1);
  }
  for (const char* text :
       {"[]", "{", R"({"point": 1})", R"({"tasks": {"1.1": "6"}})", R"({"checks": {"a": -1}})",
        R"({"checks": 1})", R"({"whole": "a"})", R"({"whole": [1]})"}) {
    INFO(text);
    CHECK_FALSE(lab_points_of(text));
  }
}

TEST_CASE("every lab's points.json sums to 100 and names no hidden check") {
  const Sources sources = find_sources().value();
  for (const Lab& lab : all_labs()) {
    INFO(lab.folder);
    const fs::path file = sources.folder_of(lab.folder) / "points.json";
    CHECK(fs::exists(file));
    const auto lab_points = read_lab_points(lab, file);
    REQUIRE(lab_points);
    CHECK(lab_points->warnings.empty());
    double sum = 0;
    for (const Task& task : lab_points->lab.tasks) sum += task.points;
    CHECK(sum == 100);
  }
}

TEST_CASE(
    "one visible check of a task weighs 2, the others 1, and the hidden ones as much together") {
  const Sources sources = find_sources().value();
  for (const Lab& lab : all_labs()) {
    const auto lab_points = read_lab_points(lab, sources.folder_of(lab.folder) / "points.json");
    REQUIRE(lab_points);
    for (const Task& task : lab.tasks) {
      INFO("task " << task.id);
      double visible = 0, hidden = 0;
      std::size_t checks = 0, headlines = 0;
      for (const Check& check : lab_points->lab.checks) {
        if (check.task != task.id) continue;
        if (check.generated) {  // another part of the task's points
          CHECK(check.weight == 1);
          continue;
        }
        (check.hidden ? hidden : visible) += check.weight;
        if (check.hidden) continue;
        ++checks;
        headlines += check.weight == 2 ? 1 : 0;
        CHECK((check.weight == 1 || check.weight == 2));
      }
      if (hidden == 0) continue;  // task 4.3: three dialects, with equal headlines
      CHECK(headlines == (checks > 1 ? 1u : 0u));
      CHECK(hidden == visible);
    }
  }
}
