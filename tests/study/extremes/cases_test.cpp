// Every extreme case: our code is within its bound, naive code exceeds it, every mutant is caught,
// and no floating-point exception is raised that the case does not declare.
#include <tests/support/catch.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <set>
#include <string>

#include "study/extremes/run_case.h"

namespace glassbox::study {
namespace {

// clang++ may compute a value that is not needed and select afterwards, so its flags say nothing
// about the source.
#ifdef __clang__
constexpr int kExceptions = 0;
#else
constexpr int kExceptions = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
#endif

// The exceptions raised in this thread since the object was made. It uses flags instead of traps,
// because the tile engine's threads would inherit a trap and keep it for the rest of the program.
class RaisedExceptions {
public:
  RaisedExceptions() { std::feclearexcept(FE_ALL_EXCEPT); }

  std::string besides(int allowed) const {
    const int found = std::fetestexcept(kExceptions & ~allowed);
    return std::string((found & FE_INVALID) != 0 ? "invalid " : "") +
           ((found & FE_DIVBYZERO) != 0 ? "divide by zero " : "") +
           ((found & FE_OVERFLOW) != 0 ? "overflow " : "");
  }
};

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

TEST_CASE(
    "in every extreme case ours stays within its bound and raises no floating-point exception",
    "[extremes]") {
  for (const ExtremeCase& each : extreme_cases()) {
    const RaisedExceptions exceptions;
    const Outcome first = each.ours.measure_error();
    const std::string raised = exceptions.besides(each.exceptions_of_ours);
    const Outcome second = each.ours.measure_error();
    INFO(each.id << " " << each.name << ": " << first.error << " " << each.unit << ", bound "
                 << first.bound << "; " << first.summary);
    CHECK(first.passes());
    CHECK(raised == "");
    // Errors are the same to the last digit; only times differ between runs.
    CHECK(same_bits(first.error, second.error));
    CHECK(first.summary == second.summary);
  }
}

TEST_CASE("in every extreme case naive code fails and every mutant is caught and named",
          "[extremes]") {
  int mutants = 0;
  for (const ExtremeCase& each : extreme_cases()) {
    const Outcome naive = each.naive.measure_error();
    INFO(each.id << " " << each.name << ", naive: " << each.naive.name << ": " << naive.error
                 << " within " << naive.bound);
    CHECK_FALSE(naive.passes());
    std::set<std::string> names;
    for (const Subject& mutant : each.mutants) {
      const Outcome outcome = mutant.measure_error();
      INFO("mutant: " << mutant.name << ": " << outcome.error << " within " << outcome.bound);
      CHECK_FALSE(outcome.passes());
      CHECK_FALSE(mutant.name.empty());
      CHECK(names.insert(mutant.name).second);
      ++mutants;
    }
    CHECK_FALSE(each.mutants.empty());
  }
  CHECK(mutants >= 151);
}

TEST_CASE("cases that show in a picture are drawn right by both engines and for every target",
          "[extremes]") {
  REQUIRE(tested_engines().size() == 2 + available_targets().size());
  CHECK(tested_engines().front().name == "staged");
  int drawn = 0;
  for (const ExtremeCase& each : extreme_cases()) {
    // Cases of stages outside the renderer have numbers from C-80 on.
    const bool is_renderers = std::stoi(each.id.substr(2)) < 80;
    if (is_renderers) {
      INFO(each.id << ": it is drawn, or says why no picture shows it");
      CHECK(bool(each.drawn) == each.not_drawn.empty());
    }
    if (!each.drawn) continue;
    ++drawn;
    for (const TestedEngine& engine : tested_engines()) {
      const Outcome outcome = each.drawn(engine);
      INFO(each.id << " " << each.name << ", drawn by " << engine.name << ": " << outcome.error
                   << "; " << outcome.summary);
      CHECK(outcome.passes());
    }
  }
  CHECK(drawn >= 68);
}

TEST_CASE("the list of extreme cases has C-01 to C-79 once each, done or left out with a reason",
          "[extremes]") {
  std::set<std::string> known;
  int last = 0;
  for (const ExtremeCase& each : extreme_cases()) {
    INFO(each.id);
    const int number = std::stoi(each.id.substr(2));
    CHECK(last < number);
    last = number;
    CHECK(known.insert(each.id).second);
    for (const std::string* text : {&each.name, &each.construction, &each.stage, &each.right_answer,
                                    &each.unit, &each.ours.name, &each.naive.name}) {
      CHECK_FALSE(text->empty());
    }
    CHECK(find_case(each.id) == &each);
  }
  for (const OmittedCase& each : omitted_cases()) {
    INFO(each.id);
    CHECK_FALSE(each.reason.empty());
    known.insert(each.id);
  }
  for (int number = 1; number <= 79; ++number) {
    const std::string id = (number < 10 ? "C-0" : "C-") + std::to_string(number);
    INFO(id);
    CHECK(known.count(id) == 1);
  }
  CHECK(find_case("c-43") != nullptr);
  CHECK(find_case("C-00") == nullptr);
}

TEST_CASE("a division by zero, an overflow and an invalid operation are noticed", "[extremes]") {
  if (kExceptions == 0) SKIP_TEST("the flags of clang++'s code say nothing about the source");
  const RaisedExceptions exceptions;
  const volatile double zero = 0, large = 1e308;
  const volatile double quotient = 1 / zero, product = large * 10, nothing = zero / zero;
  CHECK(quotient == product);
  CHECK(std::isnan(double(nothing)));
  CHECK(exceptions.besides(0) == "invalid divide by zero overflow ");
  CHECK(exceptions.besides(FE_DIVBYZERO) == "invalid overflow ");
}

TEST_CASE("a case with a mutant that survives does not hold", "[extremes]") {
  ExtremeCase planted;
  const auto answer = [](double error) { return [error] { return Outcome{error, 1, {}, {}}; }; };
  planted.ours = {"ours", answer(1)};
  planted.naive = {"naive", answer(2)};
  planted.mutants = {{"caught", answer(std::nan(""))}};
  CHECK(run_case(planted).holds());
  planted.mutants.push_back({"survives", answer(0.5)});
  CHECK_FALSE(run_case(planted).holds());
  CHECK(run_case(planted).mutants_caught() == 1);
  planted.mutants.pop_back();
  planted.drawn = [](const TestedEngine& engine) {
    return Outcome{engine.name == "staged" ? 0.0 : 2.0, 1, {}, {}};
  };
  CHECK_FALSE(run_case(planted).holds());
  CHECK(run_case(planted).drawn_right() == 1);
  planted.drawn = [](const TestedEngine&) { return Outcome{1, 1, {}, {}}; };
  CHECK(run_case(planted).holds());
  planted.mutants.clear();
  planted.naive = {"as good as ours", answer(1)};
  CHECK_FALSE(run_case(planted).holds());
  planted.naive = {"naive", answer(2)};
  planted.ours = {"no number", answer(std::nan(""))};
  CHECK_FALSE(run_case(planted).holds());
}

TEST_CASE("pictures of extreme cases are PNG files", "[extremes]") {
  for (const ExtremeCase& each : extreme_cases()) {
    for (const ExtremePicture& picture : each.pictures) {
      INFO(each.id << " " << picture.name);
      CHECK(picture.png().substr(1, 3) == "PNG");
    }
  }
}

}  // namespace
}  // namespace glassbox::study
