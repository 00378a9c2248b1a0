// Every lab against itself: the solution gets all points and the starter none. Faults are followed
// through all steps: one in every lab, another one every day, and with "[.faults]" each that has a
// stage.
#include <algorithm>
#include <filesystem>

#include "labs/framework/strip_solution.h"
#include "tests/labs/framework/bench.h"
#include "tests/labs/framework/plant_faults.h"
#include "tests/support/daily_share.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;

void expect_found(const LabResult& result, const Fault& fault) {
  bool staged = false, slipped = fault.slip.empty();
  for (const CheckResult& check : result.checks) {
    if (check.task != fault.task || !check.first) continue;
    CHECK(check.score < check.max_score);
    staged = staged || check.stage == fault.stage;
    slipped = slipped || (!check.slips.empty() && check.slips.front() == fault.slip);
  }
  CHECK(staged);
  CHECK(slipped);
}

}  // namespace

TEST_CASE("every lab's solution has full marks, its starter none") {
  REQUIRE_FALSE(all_labs().empty());
  for (const Lab& lab : all_labs()) {
    INFO("lab " << lab.folder);
    Bench& bench = Bench::for_lab(lab);
    const std::string& solution = bench.solution();
    {
      const LabResult result = bench.check(solution);
      INFO(failures(result));
      CHECK(result.score == result.max_score);
      CHECK(result.max_score > 0);
      CHECK(result.hidden_points == 0);
      double points = 0;
      for (const Task& task : lab.tasks) points += task.points;
      CHECK(result.max_score == Approx(points));
    }
    const auto starter = strip_solution(solution, lab.folder);
    REQUIRE(starter);
    CHECK(find_leaks(solution, *starter).empty());
    for (const bool hidden : {true, false}) {
      const LabResult result = bench.check(bench.starter(hidden));
      INFO(failures(result));
      CHECK(result.score == 0);
    }
  }
}

namespace {

// Faults that have a stage, at least two in every lab, go through all steps. The others are found
// in faults_test.cpp, without a compilation of their own.
void find_whole_faults(const test::DailyShare& share) {
  for (const Lab& lab : all_labs()) {
    INFO("lab " << lab.folder << ", " << share.text());
    Bench& bench = Bench::for_lab(lab);
    std::vector<Fault> whole = faults_of(bench.sources(), lab);
    std::erase_if(whole, [](const Fault& fault) { return fault.stage.empty(); });
    CHECK(whole.size() >= 2);
    for (std::size_t i = 0; i < whole.size(); ++i) {
      if (!share.includes(i, whole.size())) continue;
      INFO("fault: " << whole[i].name);
      const LabResult result = bench.check(with_fault(bench.solution(), whole[i]));
      INFO(failures(result));
      expect_found(result, whole[i]);
    }
  }
}

}  // namespace

TEST_CASE("a fault of every lab is found in a student.cpp of its own, at its stage") {
  find_whole_faults(test::DailyShare(4));
}

TEST_CASE("every fault that has a stage is found in a student.cpp of its own", "[.faults]") {
  find_whole_faults(test::DailyShare::everything());
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
      for (const Case& each : check.cases())
        CHECK((each.judge || each.generated || !each.expected.empty()));
    }
    for (const Task& task : lab.tasks) {
      INFO("task: " << task.id);
      CHECK(std::any_of(lab.checks.begin(), lab.checks.end(), [&](const Check& check) {
        return check.task == task.id && !check.hidden;
      }));
    }
  }
}
