// Mutation testing of the labs: each solution is changed by operators (mutate.h), and a check must
// find every change, unless equivalent_mutants.json says why the changed program does the same.
// Every run tries a share of the mutants of two labs; "[.mutation]" tries all of them and prints
// the table of docs/grading.md (./glassbox test faults).
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/framework/run_in_parallel.h"
#include "tests/labs/framework/bench.h"
#include "tests/labs/framework/mutate.h"
#include "tests/labs/framework/plant_faults.h"
#include "tests/support/daily_share.h"
#include "tests/support/run_program.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLabDays = 7;      // each lab has its mutants tried on one of so many days
constexpr std::size_t kMostAtOnce = 80;  // in one program; compiling it takes some 10 seconds

// A change that cannot be found, because the program does the same, and the reason.
struct Equivalent {
  int lab = 0;
  std::string before, after, why;
  // It goes beyond an array, so what it does is undefined; lab check --sanitize finds it.
  bool is_undefined = false;
};

std::vector<Equivalent> all_equivalents() {
  const auto text =
      read_text_file(GLASSBOX_SOURCE_DIR "/tests/labs/framework/equivalent_mutants.json");
  REQUIRE(text);
  std::vector<Equivalent> all;
  for (const auto& group : nlohmann::json::parse(*text)) {
    for (const auto& each : group.at("mutants"))
      all.push_back({group.at("lab"), each.at(0), each.at(1), group.at("why"),
                     group.value("undefined", false)});
  }
  return all;
}

// The entry of a mutant; null if it has none.
const Equivalent* find_entry(const std::vector<Equivalent>& all, int lab, const Mutant& mutant) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Equivalent& each) {
    return each.lab == lab && each.before == mutant.before && each.after == mutant.after;
  });
  return found == all.end() ? nullptr : &*found;
}

// Runs one variant of a program with many.
LimitedRunner runner_of_variant(std::size_t number) {
  return LimitedRunner(fmt::format("{}={}", kPlanted, number));
}

enum class Outcome { kNotCompiled, kByCase, kByGenerated, kSurvived };

// The variants with errors, by the lines that the compiler's messages name.
std::set<std::size_t> variants_with_errors(const std::string& program,
                                           const std::string& messages) {
  std::vector<std::size_t> variant_of_line{0};
  std::size_t variant = 0;
  static const std::regex begins("^struct Planted([0-9]+) :");
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    if (std::regex_search(line, found, begins)) variant = std::stoul(found[1]);
    if (line.starts_with("Student* made(")) variant = 0;
    variant_of_line.push_back(variant);
  }
  std::set<std::size_t> all;
  static const std::regex place("student\\.cpp:([0-9]+):");
  for (std::sregex_iterator at(messages.begin(), messages.end(), place), end; at != end; ++at) {
    const std::size_t line = std::stoul((*at)[1]);
    if (line < variant_of_line.size() && variant_of_line[line] > 0)
      all.insert(variant_of_line[line]);
  }
  return all;
}

// Tries mutants of one lab together. The outcomes are in their order.
std::vector<Outcome> try_mutants(const Lab& lab, std::vector<Mutant> mutants) {
  Bench& bench = Bench::for_lab(lab);
  const auto header = read_text_file(bench.sources().labs / lab.folder / "student.h");
  REQUIRE(header);
  std::vector<Outcome> outcomes(mutants.size());
  std::vector<std::size_t> left(mutants.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::optional<BenchProgram> program;
  while (!program && !left.empty()) {
    std::vector<Variant> variants;
    for (const std::size_t i : left) variants.push_back({mutants[i].after, mutants[i].source});
    const std::string text = solution_with_variants(*header, bench.solution(), variants);
    const auto made = bench.try_program(text);
    if (made) {
      program = *made;
      break;
    }
    const std::set<std::size_t> wrong = variants_with_errors(text, made.error().message());
    INFO(made.error().message());
    REQUIRE_FALSE(wrong.empty());
    for (auto at = wrong.rbegin(); at != wrong.rend(); ++at)
      left.erase(left.begin() + std::ptrdiff_t(*at) - 1);
  }
  if (program) {  // the solution itself is right when it is run like this
    LimitedRunner runner = runner_of_variant(0);
    REQUIRE(bench.first_wrong(runner, *program, "") == nullptr);
  }
  run_in_parallel(left.size(), [&](std::size_t k) {
    LimitedRunner runner = runner_of_variant(k + 1);
    const auto check = bench.first_wrong(runner, *program, mutants[left[k]].task);
    outcomes[left[k]] = !check             ? Outcome::kSurvived
                        : check->generated ? Outcome::kByGenerated
                                           : Outcome::kByCase;
  });
  return outcomes;
}

struct Counts {
  std::size_t mutants = 0, not_compiled = 0, by_case = 0, by_generated = 0, equivalent = 0;
  std::vector<std::string> survivors;      // that are not listed
  std::vector<std::string> wrong_entries;  // of the list: a check finds them
};

void count(Counts& counts, const Lab& lab, const Mutant& mutant, const Equivalent* entry,
           Outcome outcome) {
  const bool does_the_same = outcome == Outcome::kSurvived;
  const std::string text = fmt::format("lab {}, line {}, task {}:\n  {}\n  {}", lab.number,
                                       mutant.line, mutant.task, mutant.before, mutant.after);
  if (entry != nullptr) {
    ++counts.equivalent;
    if (!does_the_same && !entry->is_undefined) counts.wrong_entries.push_back(text);
    return;
  }
  if (does_the_same) counts.survivors.push_back(text);
  counts.not_compiled += outcome == Outcome::kNotCompiled;
  counts.by_case += outcome == Outcome::kByCase;
  counts.by_generated += outcome == Outcome::kByGenerated;
}

Counts try_lab(const Lab& lab, const test::DailyShare& share) {
  INFO("lab " << lab.folder << ", " << share.text());
  const std::vector<Equivalent> equivalents = all_equivalents();
  Counts counts;
  std::vector<Mutant> chosen;
  const std::vector<Mutant> all = mutants_of(Bench::for_lab(lab).solution());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (share.includes(i, all.size())) chosen.push_back(all[i]);
  }
  counts.mutants = chosen.size();
  for (std::size_t first = 0; first < chosen.size(); first += kMostAtOnce) {
    const auto begin = chosen.begin() + std::ptrdiff_t(first);
    const auto end = chosen.begin() + std::ptrdiff_t(std::min(chosen.size(), first + kMostAtOnce));
    const std::vector<Outcome> outcomes = try_mutants(lab, {begin, end});
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const Mutant& mutant = chosen[first + i];
      count(counts, lab, mutant, find_entry(equivalents, lab.number, mutant), outcomes[i]);
    }
  }
  return counts;
}

}  // namespace

TEST_CASE("no mutant of a solution has all points, some of two labs every day") {
  const test::DailyShare labs_of_day(kLabDays);
  const std::vector<Lab> labs = all_labs();
  for (std::size_t i = 0; i < labs.size(); ++i) {
    if (!labs_of_day.includes(i, labs.size())) continue;
    const Counts counts = try_lab(labs[i], test::DailyShare(8, test::seed_of_shares() / kLabDays));
    CHECK(counts.survivors == std::vector<std::string>());
    CHECK(counts.wrong_entries == std::vector<std::string>());
    CHECK(counts.by_case + counts.by_generated > counts.not_compiled);
  }
}

// Checks one of them every day.
TEST_CASE("a change that goes beyond an array is found by lab check --sanitize") {
  std::vector<Equivalent> undefined = all_equivalents();
  std::erase_if(undefined, [](const Equivalent& each) { return !each.is_undefined; });
  REQUIRE_FALSE(undefined.empty());
  const Equivalent& today = undefined[test::seed_of_shares() % undefined.size()];
  const Lab& lab = all_labs().at(std::size_t(today.lab) - 1);
  const std::vector<Mutant> mutants = mutants_of(Bench::for_lab(lab).solution());
  const auto mutant = std::find_if(mutants.begin(), mutants.end(), [&](const Mutant& each) {
    return each.before == today.before && each.after == today.after;
  });
  REQUIRE(mutant != mutants.end());
  const fs::path folder =
      fs::temp_directory_path() / fmt::format("glassbox-undefined-{}", getpid());
  fs::create_directories(folder);
  REQUIRE(write_if_changed(folder / "student.cpp", mutant->source));
  const auto checked = test::run_program(
      GLASSBOX_PROGRAM,
      {"lab", "check", folder.string(), "--lab", std::to_string(today.lab), "--sanitize"}, "/");
  fs::remove_all(folder);
  INFO(checked.out << checked.err);
  CHECK(checked.exit_code == 1);
  CHECK(checked.out.find("student.cpp:") != std::string::npos);  // where the finding is
}

TEST_CASE("every equivalent mutant that is listed is a mutant, with a reason") {
  std::map<int, std::vector<Mutant>> mutants;
  for (const Lab& lab : all_labs())
    mutants[lab.number] = mutants_of(solution_text(find_sources().value(), lab.folder).value());
  for (const Equivalent& each : all_equivalents()) {
    INFO("lab " << each.lab << ": " << each.before << "\n" << each.after);
    const std::vector<Mutant>& all = mutants[each.lab];
    CHECK(std::any_of(all.begin(), all.end(), [&](const Mutant& mutant) {
      return mutant.before == each.before && mutant.after == each.after;
    }));
    CHECK(each.why.size() > 10);
  }
}

TEST_CASE("no mutant of any solution has all points", "[.mutation]") {
  const char* only = std::getenv("LAB");
  for (const Lab& lab : all_labs()) {
    if (only != nullptr && std::to_string(lab.number) != only) continue;
    const Counts counts = try_lab(lab, test::DailyShare::everything());
    fmt::print("| {} | {} | {} | {} | {} | {} | {} |\n", lab.number, counts.mutants,
               counts.not_compiled, counts.by_case, counts.by_generated, counts.equivalent,
               counts.survivors.size());
    for (const std::string& each : counts.survivors) fmt::print(stderr, "{}\n", each);
    std::fflush(stdout);
    CHECK(counts.survivors.empty());
    CHECK(counts.wrong_entries == std::vector<std::string>());
  }
}
