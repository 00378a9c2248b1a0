// Mutation testing of the labs: each solution is changed by operators (mutate.h), and a check must
// find every change, unless equivalent_mutants.json says why the changed program does the same.
// Every run tries a share of the mutants of two labs; "[.mutation]" tries all of them and prints
// the table of docs/grading.md (./glassbox test faults).
#include <algorithm>
#include <cstdio>
#include <cstdlib>
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

using namespace glassbox;
using namespace glassbox::labs;

namespace {

constexpr std::size_t kLabDays = 7;      // each lab has its mutants tried on one of so many days
constexpr std::size_t kMostAtOnce = 80;  // in one program; compiling it takes some 10 seconds

// A change that cannot be found, because the program does the same, and the reason.
struct Equivalent {
  int lab = 0;
  std::string before, after, why;
};

std::vector<Equivalent> all_equivalents() {
  const auto text =
      read_text_file(GLASSBOX_SOURCE_DIR "/tests/labs/framework/equivalent_mutants.json");
  REQUIRE(text);
  std::vector<Equivalent> all;
  for (const auto& group : nlohmann::json::parse(*text)) {
    for (const auto& each : group.at("mutants"))
      all.push_back({group.at("lab"), each.at(0), each.at(1), group.at("why")});
  }
  return all;
}

bool is_listed(const std::vector<Equivalent>& all, int lab, const Mutant& mutant) {
  return std::any_of(all.begin(), all.end(), [&](const Equivalent& each) {
    return each.lab == lab && each.before == mutant.before && each.after == mutant.after;
  });
}

// Runs one variant of a program with many, with limits: a mutant may run for ever, or allocate for
// ever. The time is the processor's, so that a busy machine does not find mutants.
class VariantRunner : public Runner {
public:
  explicit VariantRunner(std::size_t number) : number_(number) {}
  RunOutcome run(const RunRequest& request) override {
    RunRequest limited = request;
    limited.program = "/usr/bin/env";
    limited.arguments = {fmt::format("{}={}", kPlanted, number_),
                         "prlimit",
                         "--cpu=5",
                         "--as=2000000000",
                         "--core=0",
                         request.program.string()};
    limited.arguments.insert(limited.arguments.end(), request.arguments.begin(),
                             request.arguments.end());
    if (has_failed_) return {};  // a crash would otherwise cost a run for each case
    const RunOutcome outcome = LocalRunner().run(limited);
    has_failed_ = outcome.ending != RunOutcome::Ending::kExit;
    return outcome;
  }

private:
  std::size_t number_;
  bool has_failed_ = false;
};

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
    VariantRunner runner(0);
    REQUIRE(bench.first_wrong(runner, *program, "") == nullptr);
  }
  run_in_parallel(left.size(), [&](std::size_t k) {
    VariantRunner runner(k + 1);
    const auto check = bench.first_wrong(runner, *program, mutants[left[k]].task);
    outcomes[left[k]] = !check             ? Outcome::kSurvived
                        : check->generated ? Outcome::kByGenerated
                                           : Outcome::kByCase;
  });
  return outcomes;
}

struct Counts {
  std::size_t mutants = 0, not_compiled = 0, by_case = 0, by_generated = 0, equivalent = 0;
  std::vector<std::string> survivors;
};

Counts try_lab(const Lab& lab, const test::DailyShare& share) {
  INFO("lab " << lab.folder << ", " << share.text());
  const std::vector<Equivalent> equivalents = all_equivalents();
  Counts counts;
  std::vector<Mutant> chosen;
  const std::vector<Mutant> all = mutants_of(Bench::for_lab(lab).solution());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!share.includes(i, all.size())) continue;
    ++counts.mutants;
    if (is_listed(equivalents, lab.number, all[i])) {
      ++counts.equivalent;
    } else {
      chosen.push_back(all[i]);
    }
  }
  for (std::size_t first = 0; first < chosen.size(); first += kMostAtOnce) {
    const auto begin = chosen.begin() + std::ptrdiff_t(first);
    const auto end = chosen.begin() + std::ptrdiff_t(std::min(chosen.size(), first + kMostAtOnce));
    const std::vector<Outcome> outcomes = try_mutants(lab, {begin, end});
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      const Mutant& mutant = chosen[first + i];
      switch (outcomes[i]) {
        case Outcome::kNotCompiled:
          ++counts.not_compiled;
          break;
        case Outcome::kByCase:
          ++counts.by_case;
          break;
        case Outcome::kByGenerated:
          ++counts.by_generated;
          break;
        case Outcome::kSurvived:
          counts.survivors.push_back(fmt::format("lab {}, line {}, task {}:\n  {}\n  {}",
                                                 lab.number, mutant.line, mutant.task,
                                                 mutant.before, mutant.after));
      }
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
    CHECK(counts.by_case + counts.by_generated > counts.not_compiled);
  }
}

TEST_CASE("every equivalent mutant that is listed is one, with a reason") {
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
  }
}
