// For every fault of faults.cmake, the extreme case that is named for it must be drawn wrong by
// some engine, and docs/mutants.md must say so. A run plants one fault in four of every file, so
// that runs on four days cover all of them; the test tagged "[.page]" plants every fault.
#include <tests/support/catch.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "study/extremes/run_case.h"
#include "tests/mutants/planted.h"
#include "tests/support/daily_share.h"

namespace glassbox::study {
namespace {

struct Fault {
  int number;
  const char *file, *found_by, *what;
};

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all{
#define FAULT(number, file, found_by, what) {number, file, found_by, what},
#include <faults.inc>
#undef FAULT
  };
  return all;
}

// Switches a fault on for as long as the object exists.
class Planted {
public:
  explicit Planted(int number) { planted_fault = number; }
  ~Planted() { planted_fault = 0; }
  Planted(const Planted&) = delete;
  Planted& operator=(const Planted&) = delete;
};

// Whether the case is drawn wrong: by the reference, by the tile engine for the best target (the
// targets share their source), and without a plan.
std::vector<bool> drawn_wrong(const ExtremeCase& extreme) {
  const std::vector<TestedEngine>& all = tested_engines();
  std::vector<bool> wrong;
  for (const TestedEngine* engine : {&all[0], &all[all.size() - 2], &all[all.size() - 1]}) {
    wrong.push_back(!extreme.drawn(*engine).passes());
  }
  return wrong;
}
bool any(const std::vector<bool>& of) {
  return std::ranges::find(of, true) != of.end();
}

// Whether all cases are drawn right when no fault is planted.
bool all_drawn_right() {
  bool right = true;
  for (const ExtremeCase& extreme : extreme_cases()) {
    if (!extreme.drawn || !any(drawn_wrong(extreme))) continue;
    WARN(extreme.id << " is drawn wrong without a fault");
    right = false;
  }
  return right;
}

// "both": the reference draws it wrong, too; "tile": only the tile engine does.
const char* engines_of(const std::vector<bool>& wrong) {
  return wrong.front() ? "both" : "tile";
}

std::string row_of(const Fault& fault, const std::string& engines, const std::string& others) {
  return std::to_string(fault.number) + " | `" + fault.file + "` | " + fault.what + " | " +
         engines + " | " + fault.found_by + " | " + (others.empty() ? "-" : others) + " |";
}

std::string page() {
  std::ifstream file(GLASSBOX_SOURCE_DIR "/docs/mutants.md");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

constexpr std::size_t kDays = 4;

// The faults of every file whose turn it is today.
std::vector<const Fault*> faults_drawn(const test::DailyShare& share) {
  std::map<std::string, std::size_t> sizes, positions;
  for (const Fault& fault : faults()) ++sizes[fault.file];
  std::vector<const Fault*> all;
  for (const Fault& fault : faults()) {
    if (share.includes(positions[fault.file]++, sizes[fault.file])) all.push_back(&fault);
  }
  return all;
}

TEST_CASE("planted faults of every file are found by their cases, and the page has them") {
  const test::DailyShare share(kDays);
  const std::string text = page();
  std::set<const ExtremeCase*> seen;
  for (const Fault* fault : faults_drawn(share)) {
    const ExtremeCase* extreme = find_case(fault->found_by);
    INFO(fault->number << ", " << fault->file << ": " << fault->what << "; " << fault->found_by
                       << ", " << share.text());
    REQUIRE(extreme != nullptr);
    REQUIRE(extreme->drawn);
    // The expected picture is computed once, when the case is first drawn; it must be drawn without
    // a fault.
    if (seen.insert(extreme).second) REQUIRE_FALSE(any(drawn_wrong(*extreme)));
    const Planted planted(fault->number);
    const std::vector<bool> wrong = drawn_wrong(*extreme);
    CHECK(any(wrong));
    const std::string row = row_of(*fault, engines_of(wrong), "");
    CHECK(text.find(row.substr(0, row.rfind(" | -"))) != std::string::npos);
  }
}

TEST_CASE("four days have every planted fault, and every day some of every file") {
  CHECK(faults().size() >= 40);
  std::set<std::string> files;
  for (const Fault& fault : faults()) files.insert(fault.file);
  std::set<const Fault*> all;
  for (std::uint64_t seed = 20783; seed < 20783 + kDays; ++seed) {
    std::set<std::string> today;
    for (const Fault* fault : faults_drawn(test::DailyShare(kDays, seed))) {
      all.insert(fault);
      today.insert(fault->file);
    }
    CHECK(today == files);
  }
  CHECK(all.size() == faults().size());
}

// Whether the environment variable FAULTS, such as FAULTS=45-72, selects this fault. Unset, it
// selects all.
bool is_asked_for(const Fault& fault) {
  const char* const asked = std::getenv("FAULTS");
  int first = 0, last = 0;
  if (asked == nullptr) return true;
  REQUIRE(std::sscanf(asked, "%d-%d", &first, &last) == 2);
  return fault.number >= first && fault.number <= last;
}

// Draws all cases with every fault: test_mutants "[.page]" prints the table of docs/mutants.md and
// checks that the page has it.
TEST_CASE("the page says which other cases find a fault", "[.page]") {
  const std::string text = page();
  REQUIRE(all_drawn_right());
  for (const Fault& fault : faults()) {
    if (!is_asked_for(fault)) continue;
    std::string others, engines;
    const Planted planted(fault.number);
    for (const ExtremeCase& extreme : extreme_cases()) {
      if (!extreme.drawn) continue;
      const std::vector<bool> wrong = drawn_wrong(extreme);
      if (!any(wrong)) continue;
      if (extreme.id == fault.found_by) {
        engines = engines_of(wrong);
      } else {
        others += (others.empty() ? "" : " ") + extreme.id;
      }
    }
    CHECK_FALSE(engines.empty());
    const std::string row = "| " + row_of(fault, engines, others);
    std::printf("%s\n", row.c_str());
    std::fflush(stdout);
    INFO(row);
    CHECK(text.find(row) != std::string::npos);
  }
}

}  // namespace
}  // namespace glassbox::study
