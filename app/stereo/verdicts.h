// The findings as verdicts of one line each.
#pragma once

#include <string>
#include <vector>

#include "app/stereo/findings.h"

namespace glassbox::app {

enum class Level { kGood, kWarning, kBad, kFact };

// A name for JSON, which does not change between versions.
constexpr const char* name_of(Level level) {
  constexpr const char* kNames[] = {"good", "warning", "bad", "fact"};
  return kNames[std::size_t(level)];
}

struct Verdict {
  std::string about;  // "parallax"
  Level level = Level::kFact;
  std::string text;
};

// The verdicts in the order of importance.
std::vector<Verdict> verdicts_of(const Scene& scene, const StereoFindings& found);

// The names of the objects that the picture's edge cuts: "trunk, ground and 3 others".
std::string names_of_cut(const Scene& scene, const WindowViolation& violation);

// Suggests changes to a pair of eyes, in words and as options.
struct Advice {
  std::string text;
  std::vector<std::string> options;  // options that replace the current ones; may be empty
};

// The suggestions; none if all is well. Separations and windows are computed by parallax_budget.h
// for the visible depths. They have three digits and are rounded such that the budget is kept.
std::vector<Advice> advise(const Scene& scene, const StereoFindings& found);

}  // namespace glassbox::app
