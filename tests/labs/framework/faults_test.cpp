// For every sentence of every contract, a violation of it is planted in the solution (faults.json):
// a check must find it, a report must name a slip exactly if there is one, and docs/lab_faults.md
// states which case finds it. Every run checks one in eight faults of every task, so eight days
// cover all of them; "[.faults]" checks all of them at once (./glassbox test faults).
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

#include "labs/framework/slips.h"
#include "tests/labs/framework/bench.h"
#include "tests/labs/framework/plant_faults.h"
#include "tests/support/daily_share.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

// Chooses the planted fault for programs that are started during its lifetime.
class ScopedFault {
public:
  explicit ScopedFault(std::size_t number) { setenv(kPlanted, std::to_string(number).c_str(), 1); }
  ~ScopedFault() { unsetenv(kPlanted); }
  ScopedFault(const ScopedFault&) = delete;
  ScopedFault& operator=(const ScopedFault&) = delete;
};

// Returns the task's first check that is not right. The cases that a student is given come first,
// then the hidden ones, then generated inputs.
const CheckResult* found_by(const LabResult& result, const Fault& fault,
                            bool visible_only = false) {
  const auto rank = [](const CheckResult& check) {
    return check.generated ? 2 : check.hidden ? 1 : 0;
  };
  for (const int wanted : {0, 1, 2}) {
    for (const CheckResult& check : result.checks) {
      const bool asked = rank(check) == wanted && !(visible_only && check.hidden);
      if (asked && check.task == fault.task && check.first) return &check;
    }
  }
  return nullptr;
}

// Escapes bars, which would end the table's cell.
std::string in_cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\\|");
  return text;
}

std::string row_of(std::size_t number, const Fault& fault, const CheckResult& check) {
  return fmt::format("| {} | {} | {} | {}, case {}{} | {} |", number, fault.task,
                     in_cell(fault.name), in_cell(check.name), check.first->index,
                     check.hidden ? " (hidden)" : "", fault.slip.empty() ? "-" : fault.slip);
}

struct Found {
  std::vector<std::string> rows;
  std::set<std::string> slips;  // the slips that were named
  std::size_t faults = 0;
};

// A fault with its number in faults.json, counted from 1.
struct Numbered {
  std::size_t number;
  Fault fault;
};

// Returns the faults of every task that belong to the share.
std::vector<Numbered> faults_in_share(const std::vector<Fault>& faults,
                                      const test::DailyShare& share) {
  std::map<std::string, std::size_t> sizes, positions;
  for (const Fault& fault : faults) ++sizes[fault.task];
  std::vector<Numbered> all;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    if (share.includes(positions[faults[i].task]++, sizes[faults[i].task]))
      all.push_back({i + 1, faults[i]});
  }
  return all;
}

// Checks that every fault of a lab in the share is found.
Found find_all(const Lab& lab, const test::DailyShare& share) {
  INFO("lab " << lab.folder << ", " << share.text());
  Bench& bench = Bench::for_lab(lab);
  const auto header = read_text_file(bench.sources().labs / lab.folder / "student.h");
  REQUIRE(header);
  const std::vector<Numbered> chosen = faults_in_share(faults_of(bench.sources(), lab), share);
  std::vector<Fault> faults;
  for (const Numbered& each : chosen) faults.push_back(each.fault);
  const BenchProgram program =
      bench.program(solution_with_all_faults(*header, bench.solution(), faults));
  {
    const LabResult result = bench.check(program);
    INFO(failures(result));
    CHECK(result.score == result.max_score);
  }
  Found all;
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const Fault& fault = faults[i];
    const ScopedFault planted(i + 1);
    LabResult result = bench.check(program, Inputs::kCases);
    if (found_by(result, fault) == nullptr) result = bench.check(program);
    INFO("fault " << chosen[i].number << ": " << fault.name << ", task " << fault.task);
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
    if (fault.headline) CHECK(found_by(result, fault, true) != nullptr);
    all.rows.push_back(row_of(chosen[i].number, fault, *check));
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

namespace {

// Finds the share's faults in all labs, each by the case that the page names. Returns how many
// there were, and which slips were named.
Found find_in_all_labs(const test::DailyShare& share) {
  const std::string text = page();
  Found all;
  for (const Lab& lab : all_labs()) {
    const Found found = find_all(lab, share);
    all.faults += found.faults;
    all.slips.insert(found.slips.begin(), found.slips.end());
    for (const std::string& row : found.rows) {
      INFO(row);
      CHECK(text.find(row) != std::string::npos);
    }
  }
  return all;
}

constexpr std::size_t kDays = 8;

}  // namespace

// Checks all faults for every seed: a fault whose code in the solution has changed would otherwise
// be noticed only on its day.
TEST_CASE(
    "the code that a fault replaces stands in the solution once, and the page has a row for it") {
  const std::string text = page();
  std::size_t faults = 0;
  for (const Lab& lab : all_labs()) {
    const Bench& bench = Bench::for_lab(lab);
    const std::vector<Fault> all = faults_of(bench.sources(), lab);
    for (std::size_t i = 0; i < all.size(); ++i) {
      INFO("lab " << lab.folder << ", fault " << i + 1 << ": " << all[i].name);
      const std::string& solution = bench.solution();
      const std::size_t at = solution.find(all[i].find);
      CHECK(at != std::string::npos);
      CHECK(at == solution.rfind(all[i].find));
      CHECK(text.find(fmt::format("| {} | {} | {} |", i + 1, all[i].task, in_cell(all[i].name))) !=
            std::string::npos);
    }
    faults += all.size();
  }
  CHECK(faults > 1000);
}

TEST_CASE("a sentence of a contract that is not kept is found by the case that the page names") {
  // One in eight of a thousand faults, and at least one of each of the eighty tasks.
  CHECK(find_in_all_labs(test::DailyShare(kDays)).faults >= 120);
}

TEST_CASE("every sentence of a contract that is not kept is found by the case that the page names",
          "[.faults]") {
  const Found found = find_in_all_labs(test::DailyShare::everything());
  CHECK(found.faults >= 1200);
  for (const Slip& slip : known_slips()) {
    // no lab asks for normals; slips_test.cpp has this one
    if (slip.id == "normal-as-vector") continue;
    INFO(slip.id << " is named of some fault");
    CHECK(found.slips.count(slip.id) == 1);
  }
}

TEST_CASE("every task has a headline, every slip a fault, and every fault its row in the page") {
  const std::string text = page();
  std::set<std::string> slips;
  for (const Lab& lab : all_labs()) {
    INFO("lab " << lab.folder);
    std::set<std::string> headlines;
    std::size_t number = 0;
    for (const Fault& fault : faults_of(find_sources().value(), lab)) {
      const std::string row =
          fmt::format("\n| {} | {} | {} | ", ++number, fault.task, in_cell(fault.name));
      INFO(row);
      CHECK(text.find(row) != std::string::npos);
      if (fault.headline) headlines.insert(fault.task);
      slips.insert(fault.slip);
    }
    for (const Task& task : lab.tasks) {
      INFO("task " << task.id << " has a headline");
      CHECK(headlines.count(task.id) == 1);
    }
  }
  for (const Slip& slip : known_slips()) {
    if (slip.id == "normal-as-vector") continue;
    INFO(slip.id << " is the slip of some fault");
    CHECK(slips.count(slip.id) == 1);
  }
}

TEST_CASE("every day's share has a fault of every task, and eight days have every fault") {
  for (const Lab& lab : all_labs()) {
    INFO("lab " << lab.folder);
    const std::vector<Fault> faults = faults_of(find_sources().value(), lab);
    std::set<std::size_t> numbers;
    for (std::uint64_t seed = 20783; seed < 20783 + kDays; ++seed) {
      std::set<std::string> tasks;
      for (const Numbered& each : faults_in_share(faults, test::DailyShare(kDays, seed))) {
        tasks.insert(each.fault.task);
        numbers.insert(each.number);
      }
      CHECK(tasks.size() == lab.tasks.size());
    }
    CHECK(numbers.size() == faults.size());
  }
}

// test_all_labs "[.page]" prints the tables of docs/lab_faults.md, or only that of the lab named by
// the environment variable LAB.
TEST_CASE("the tables of the page of faults", "[.page]") {
  const char* only = std::getenv("LAB");
  for (const Lab& lab : all_labs()) {
    if (only != nullptr && lab.number != std::atoi(only)) continue;
    const Found found = find_all(lab, test::DailyShare::everything());
    std::printf("\n## Lab %d: %s\n\n| | task | what is wrong | found by | slip |\n", lab.number,
                lab.title.c_str());
    std::printf("| --- | --- | --- | --- | --- |\n");
    for (const std::string& row : found.rows) std::printf("%s\n", row.c_str());
    std::fflush(stdout);
  }
}
