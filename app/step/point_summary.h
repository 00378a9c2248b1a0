// The answer about points in at most ten lines: whether they are seen, what is most probably wrong,
// what mends it, and how sure that is.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/step/point_step.h"
#include "cli/options/cli_fwd.h"

namespace glassbox::app {

enum class Certainty {
  kCertain,  // no correct set of matrices looks like this
  kLikely,   // the matrices show evidence for it, and for nothing else
  kGuess,    // it would explain what is seen, and so would other causes
  kNone,     // nothing looks wrong
};

struct PointSummary {
  int points = 0;
  int seen = 0;       // points in the picture; with --expect, at the expected position
  std::string where;  // the first point that is not seen, or else the first one: "(0, 0, 0) is ..."
  // What is most probably wrong: the `id` of a finding or of a change (docs/step.md lists them), or
  // "imprecise"; empty if nothing looks wrong.
  std::string id;
  std::string cause, mend;
  Certainty certainty = Certainty::kNone;
  std::string evidence;  // the reason for this certainty
  // Whether at least one point is seen, all expected positions are met, and nothing looks wrong.
  bool passes = true;
};

PointSummary summarize(const PointStep& step);

// Lines of at most kTextWidth columns; at most ten.
std::string summary_text(const PointSummary& summary);
nlohmann::ordered_json summary_json(const PointSummary& summary);

// Adds --brief and --check.
void add_summary_options(CLI::App& command, PointStepOptions& options);

// The exit code for points: with --check it is 1 if the summary does not pass.
int exit_code_of(const PointStep& step);

}  // namespace glassbox::app
