// Every lab against itself: the solution has all points, the starter none, and every planted fault is found where it was planted.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include "labs/framework/check_lab.h"
#include "labs/framework/lab.h"
#include "labs/framework/slips.h"
#include "labs/framework/strip.h"
#include "tests/support/catch.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;

// A folder for a student's file and what is built from it; the runner is compiled once for all files put into it.
class Bench {
public:
  explicit Bench(const Lab& lab) : lab_(lab), sources_(find_sources().value()) {
    folder_ = fs::temp_directory_path() / fmt::format("glassbox-{}-{}", lab.folder, getpid());
    fs::create_directories(folder_);
  }
  ~Bench() { fs::remove_all(folder_); }

  const Sources& sources() const { return sources_; }

  LabResult check(const std::string& student, bool hidden = true) const {
    const fs::path file = folder_ / "student.cpp";
    std::ofstream(file) << student;
    CheckOptions options;
    options.with_hidden = hidden;
    options.limits.seconds = 60;  // of a machine that compiles other things meanwhile
    LocalRunner runner;
    BuildRequest request;
    request.folder = lab_.folder;
    request.student = file;
    request.build_dir = folder_ / (hidden ? "hidden" : "visible");
    request.seconds = 300;
    const auto result = check_lab(lab_, sources_, request, options, runner);
    REQUIRE(result);
    INFO(result->not_built);
    REQUIRE(result->not_built.empty());
    return *result;
  }

private:
  const Lab& lab_;
  Sources sources_;
  fs::path folder_;
};

std::string failures(const LabResult& result) {
  std::string text;
  for (const CheckResult& check : result.checks) {
    if (!check.first) continue;
    text += fmt::format("{} ({}, {}): {} {}", check.name, check.task, check.stage,
                        verdict_name(check.verdict), check.first->text);
    if (const auto& found = check.first->divergence)
      text += fmt::format(" case {} {} {} expected {} actual {} bound {} {}", check.first->index,
                          found->field, found->element, found->expected, found->actual,
                          found->bound, found->explanation);
    for (const std::string& slip : check.slips) text += " slip " + slip;
    text += "\n";
  }
  return text;
}

std::string with_fault(const std::string& solution, const nlohmann::json& fault) {
  const auto find = fault.at("find").get<std::string>();
  const std::size_t at = solution.find(find);
  REQUIRE(at != std::string::npos);
  REQUIRE(solution.find(find, at + 1) == std::string::npos);
  std::string changed = solution;
  return changed.replace(at, find.size(), fault.at("replace").get<std::string>());
}

void expect_found(const LabResult& result, const nlohmann::json& fault) {
  const auto task = fault.at("task").get<std::string>();
  const auto stage = fault.at("stage").get<std::string>();
  bool staged = false, slipped = fault.at("slip").is_null();
  for (const CheckResult& check : result.checks) {
    if (check.task != task || !check.first) continue;
    CHECK(check.score < check.max_score);
    staged = staged || check.stage == stage;
    if (!fault.at("slip").is_null()) {
      const auto slip = fault.at("slip").get<std::string>();
      CHECK_FALSE(slip_text(slip).empty());
      slipped =
          slipped || std::find(check.slips.begin(), check.slips.end(), slip) != check.slips.end();
    }
  }
  CHECK(staged);
  CHECK(slipped);
}

}  // namespace

TEST_CASE("every lab's solution has full marks, its starter none, and its faults are found") {
  REQUIRE_FALSE(all_labs().empty());
  for (const Lab& lab : all_labs()) {
    INFO("lab " << lab.folder);
    const Bench bench(lab);
    const auto solution = solution_text(bench.sources(), lab.folder);
    REQUIRE(solution);
    {
      const LabResult result = bench.check(*solution);
      INFO(failures(result));
      CHECK(result.score == result.max_score);
      CHECK(result.max_score > 0);
      CHECK(result.hidden_points == 0);
      double points = 0;
      for (const Task& task : lab.tasks) points += task.points;
      CHECK(result.max_score == Approx(points));
    }
    const auto starter = strip_solution(*solution, lab.folder);
    REQUIRE(starter);
    CHECK(find_leaks(*solution, *starter).empty());
    for (const bool hidden : {true, false}) {
      const LabResult result = bench.check(*starter, hidden);
      INFO(failures(result));
      CHECK(result.score == 0);
    }
    const auto text = read_text_file(bench.sources().labs / lab.folder / "faults.json");
    REQUIRE(text);
    const auto faults = nlohmann::json::parse(*text);
    CHECK(faults.size() >= 2);
    for (const auto& fault : faults) {
      INFO("fault: " << fault.at("name").get<std::string>());
      const LabResult result = bench.check(with_fault(*solution, fault));
      INFO(failures(result));
      expect_found(result, fault);
    }
  }
}

TEST_CASE("every lab has the files and the words that a student and the grader need") {
  for (const Lab& lab : all_labs()) {
    INFO("lab " << lab.folder);
    const auto sources = find_sources();
    REQUIRE(sources);
    for (const char* name : {"handout.md", "student.h", "student.cpp", "cases.h", "runner.cpp"})
      CHECK(fs::exists(sources->labs / lab.folder / name));
    CHECK(support_files(*sources, lab.folder, false));
    for (const Check& check : lab.checks) {
      INFO("check: " << check.name);
      CHECK_FALSE(check.stage.empty());
      CHECK(std::any_of(lab.tasks.begin(), lab.tasks.end(),
                        [&](const Task& task) { return task.id == check.task; }));
      CHECK(std::count_if(lab.checks.begin(), lab.checks.end(),
                          [&](const Check& other) { return other.name == check.name; }) == 1);
    }
    for (const Task& task : lab.tasks) {
      INFO("task: " << task.id);
      CHECK(std::any_of(lab.checks.begin(), lab.checks.end(), [&](const Check& check) {
        return check.task == task.id && !check.hidden;
      }));
    }
  }
}
