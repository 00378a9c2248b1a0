// The violation of every sentence of every contract is planted in the solutions (faults.json): a check finds each, a report names a
// slip where it is one and none where it is not, and docs/lab_faults.md says which case finds it.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "labs/framework/slips.h"
#include "tests/labs/framework/bench.h"
#include "tests/labs/framework/planted.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

// What is planted while it lives, in programs that are started meanwhile.
class Chosen {
public:
  explicit Chosen(std::size_t number) { setenv(kPlanted, std::to_string(number).c_str(), 1); }
  ~Chosen() { unsetenv(kPlanted); }
  Chosen(const Chosen&) = delete;
  Chosen& operator=(const Chosen&) = delete;
};

// The first check of the task, those that a student is given before the others, that is not right.
const CheckResult* found_by(const LabResult& result, const Fault& fault, bool hidden_too = true) {
  for (const bool hidden : {false, true}) {
    for (const CheckResult& check : result.checks) {
      const bool asked = check.hidden == hidden && (!hidden || hidden_too);
      if (asked && check.task == fault.task && check.first) return &check;
    }
  }
  return nullptr;
}

std::string row_of(std::size_t number, const Fault& fault, const CheckResult& check) {
  // A bar would end the table's cell.
  const auto cell = [](std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
      text.replace(at, 1, "\\|");
    return text;
  };
  return fmt::format("| {} | {} | {} | {}, case {}{} | {} |", number, fault.task, cell(fault.name),
                     cell(check.name), check.first->index, check.hidden ? " (hidden)" : "",
                     fault.slip.empty() ? "-" : fault.slip);
}

struct Found {
  std::vector<std::string> rows;
  std::set<std::string> slips;  // that were named
  std::size_t faults = 0;
};

// Every fault of a lab, found or complained of.
Found find_all(const Lab& lab) {
  INFO("lab " << lab.folder);
  Bench& bench = Bench::of(lab);
  const auto header = read_text_file(bench.sources().labs / lab.folder / "student.h");
  REQUIRE(header);
  const std::vector<Fault> faults = faults_of(bench.sources(), lab);
  const BenchProgram program = bench.program(all_in_one(*header, bench.solution(), faults));
  {
    const LabResult result = bench.check(program);
    INFO(failures(result));
    CHECK(result.score == result.max_score);
  }
  Found all;
  std::set<std::string> headlines;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const Fault& fault = faults[i];
    const Chosen chosen(i + 1);
    const LabResult result = bench.check(program);
    INFO("fault " << i + 1 << ": " << fault.name << ", task " << fault.task);
    INFO(failures(result));
    const CheckResult* check = found_by(result, fault);
    CHECK(check != nullptr);
    if (check == nullptr) continue;
    bool named = fault.slip.empty();
    for (const CheckResult& each : result.checks) {
      for (const std::string& slip : each.slips) {
        CHECK(slip == fault.slip);
        all.slips.insert(slip);
        named = true;
      }
    }
    CHECK(named);
    if (fault.headline) {
      headlines.insert(fault.task);
      CHECK(found_by(result, fault, false) != nullptr);
    }
    all.rows.push_back(row_of(i + 1, fault, *check));
  }
  for (const Task& task : lab.tasks) {
    INFO("task " << task.id << " has a headline");
    CHECK(headlines.count(task.id) == 1);
  }
  all.faults = faults.size();
  return all;
}

std::string page() {
  const auto text = read_text_file(GLASSBOX_SOURCE_DIR "/docs/lab_faults.md");
  REQUIRE(text);
  return *text;
}

}  // namespace

TEST_CASE(
    "every sentence of a contract that is not kept is found, and the page says by which case") {
  const std::string text = page();
  std::size_t faults = 0;
  std::set<std::string> named;
  for (const Lab& lab : all_labs()) {
    const Found found = find_all(lab);
    faults += found.faults;
    named.insert(found.slips.begin(), found.slips.end());
    for (const std::string& row : found.rows) {
      INFO(row);
      CHECK(text.find(row) != std::string::npos);
    }
  }
  CHECK(faults >= 300);
  for (const Slip& slip : known_slips()) {
    if (slip.id == "normal-as-vector") continue;  // no lab asks for normals; slips_test.cpp
    INFO(slip.id << " is named of some fault");
    CHECK(named.count(slip.id) == 1);
  }
}

// test_all_labs "[.page]" prints the tables of docs/lab_faults.md, or of the lab that the environment variable LAB names.
TEST_CASE("the tables of the page of faults", "[.page]") {
  const char* only = std::getenv("LAB");
  for (const Lab& lab : all_labs()) {
    if (only != nullptr && lab.number != std::atoi(only)) continue;
    const Found found = find_all(lab);
    std::printf("\n## Lab %d: %s\n\n| | task | what is wrong | found by | slip |\n", lab.number,
                lab.title.c_str());
    std::printf("| --- | --- | --- | --- | --- |\n");
    for (const std::string& row : found.rows) std::printf("%s\n", row.c_str());
    std::fflush(stdout);
  }
}
