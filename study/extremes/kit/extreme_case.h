// A case that breaks pipelines (SPEC C): how it is built, what the right answer is, and what several subjects make of
// it: the pipeline's own code, the naive code that one would write first, and mutants of the right code.
//
// A case is one judge, a function that puts a subject to the case and measures how far from the right answer it
// comes; all subjects of a case go through the same judge. The naive variants and the mutants are real code
// (study/naive), which nothing of the pipeline uses.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/extremes/kit/drawer.h"
#include "study/extremes/kit/outcome.h"

namespace glassbox::study {

// How the right answer is known (SPEC C): exact rationals, exact integers, extended precision, a formula, a property.
enum class Oracle { kRational, kInteger, kExtended, kAnalytic, kProperty };

struct Subject {
  // "float differences"; for a mutant what was changed: "the tie rule is missing".
  std::string name;
  std::function<Outcome()> judged;
};

// A picture that tells more than the number.
struct ExtremePicture {
  std::string name;  // a file name's stem: "naive"
  std::function<std::string()> png;
};

struct ExtremeCase {
  std::string id;            // "C-38"
  std::string name;          // "Shared clipped edge"
  std::string construction;  // how it is built, with its numbers
  std::string stage;         // the stage of the pipeline that it strains: "clip", "snap"
  std::string right;         // the right answer or bound, with where the bound comes from
  std::string unit;          // of error and bound: "px", "radian", "pixels", "ulp"
  Oracle oracle = Oracle::kProperty;
  Subject ours, naive;
  std::vector<Subject> mutants = {};
  // A case that shows in a picture: the same put to a whole run by any of the drawers, judged by something that no drawer has a
  // part in. Exceptions of the run's own are not asked about.
  std::function<Outcome(const Drawer& drawer)> drawn = {};
  std::string not_drawn = {};  // where that is empty: why no picture shows it
  std::vector<ExtremePicture> pictures = {};
  // Floating-point exceptions that the case itself asks for (FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW): naive code
  // divides by zero, right code does not. Of `ours` alone; naive code and mutants may raise any.
  int exceptions_of_ours = 0;
};

// All of them, in the order of their numbers.
const std::vector<ExtremeCase>& extreme_cases();

// A case of the list that is not among them, and why: "C-12", "needs the camera file of a data set".
struct LeftOut {
  std::string id, name, reason;
};
const std::vector<LeftOut>& left_out_cases();

}  // namespace glassbox::study
