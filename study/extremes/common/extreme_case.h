// An extreme case is an input that breaks pipelines: how it is built, what the right answer is, and
// how several subjects handle it: the pipeline's own code, the naive code that a beginner would
// write, and mutants of the right code.
//
// Each case has a function measure_error: it runs a subject and measures how far it is from the
// right answer; all subjects of a case have the same function. The naive variants and the mutants
// are real code (study/naive), which the pipeline never uses.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/extremes/common/outcome.h"
#include "study/extremes/common/tested_engine.h"

namespace glassbox::study {

// How the right answer is known: from exact rationals, exact integers, extended precision, a
// formula or a property.
enum class Oracle { kRational, kInteger, kExtended, kAnalytic, kProperty };

struct Subject {
  // For example "float differences"; for a mutant it says what was changed: "the tie rule is
  // missing".
  std::string name;
  std::function<Outcome()> measure_error;
};

// A picture that shows the error better than its number does.
struct ExtremePicture {
  std::string name;  // stem of the file name: "naive"
  std::function<std::string()> png;
};

struct ExtremeCase {
  std::string id;            // for example "C-38"
  std::string name;          // for example "Shared clipped edge"
  std::string construction;  // how the case is built, with its numbers
  std::string stage;         // the pipeline stage that it tests: "clip", "snap"
  std::string right_answer;  // the right answer or the bound, with the bound's source
  std::string unit;          // unit of error and bound: "px", "radian", "pixels", "ulp"
  Oracle oracle = Oracle::kProperty;
  Subject ours, naive;
  std::vector<Subject> mutants = {};
  // For a case that shows in a picture: the same input is drawn by a complete run of any engine,
  // and checked by code that the engines do not share. Floating-point exceptions of the run do not
  // matter.
  std::function<Outcome(const TestedEngine& engine)> drawn = {};
  std::string not_drawn = {};  // why no picture shows the case, if `drawn` is empty
  std::vector<ExtremePicture> pictures = {};
  // The floating-point exceptions that the case may raise (FE_INVALID | FE_DIVBYZERO |
  // FE_OVERFLOW): naive code divides by zero, right code does not. This applies to `ours` only;
  // naive code and mutants may raise any.
  int exceptions_of_ours = 0;
};

// All cases, in the order of their numbers.
const std::vector<ExtremeCase>& extreme_cases();

// A case of the list that is missing here, and the reason: "C-12", "needs the camera file of a data
// set".
struct OmittedCase {
  std::string id, name, reason;
};
const std::vector<OmittedCase>& omitted_cases();

}  // namespace glassbox::study
