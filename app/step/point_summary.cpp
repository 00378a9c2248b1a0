#include "app/step/point_summary.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/step/point_texts.h"
#include "cli/report/exit_codes.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/counted.h>
#include <glassbox/matrices/decimal.h>

namespace glassbox::app {

namespace {

using Walk = PointStep::Walk;

// ---- what is seen ----

bool is_seen(const Walk& walk) {
  const VertexChain& chain = walk.chain;
  if (chain.verdict != VertexVerdict::kVisible) return false;
  if (!walk.expected) return true;
  const Point<Screen>& at = chain.screen->screen.position;
  return std::abs(double(at.x) - walk.expected->x) <= kExpectedWithinPx &&
         std::abs(double(at.y) - walk.expected->y) <= kExpectedWithinPx;
}

void count_seen(const PointStep& step, PointSummary& summary) {
  summary.points = int(step.walks.size());
  const Walk* shown = nullptr;
  for (const Walk& walk : step.walks) {
    const bool seen = step.setup.projection.given && is_seen(walk);
    summary.seen += seen;
    summary.passes = summary.passes && (seen || !walk.expected);
    if (!seen && shown == nullptr) shown = &walk;
  }
  summary.where = where_sentence(shown == nullptr ? step.walks.front() : *shown, step);
  if (step.setup.projection.given && summary.seen == 0) summary.passes = false;
}

// ---- what is wrong ----

const Finding* first_of(const PointStep& step, Severity severity) {
  const auto found = std::find_if(step.findings.begin(), step.findings.end(),
                                  [&](const Finding& f) { return f.severity == severity; });
  return found == step.findings.end() ? nullptr : &*found;
}

void take_finding(const Finding& finding, PointSummary& summary) {
  summary.id = finding.id;
  summary.cause = finding_place(finding) + finding.cause;
  summary.mend = finding.remedy;
  const bool wrong = finding.severity == Severity::kAlarm;
  summary.certainty = wrong ? Certainty::kCertain : Certainty::kGuess;
  summary.evidence = wrong ? "no correct set of matrices looks like this"
                           : "this is legal, but it is often a mistake";
}

std::string mend_of(const Alternative& change, const PointSummary& summary) {
  return fmt::format("{}: {} of {} then where {} should be", change.what, change.points,
                     counted(summary.points, "point is", "points are"),
                     singular_or_plural(summary.points, "it", "they"));
}

// How sure the first of several changes is. The others that bring as many points into the picture
// speak against it, unless there is more evidence in the matrices for the first one.
void judge_change(const std::vector<Alternative>& changes, PointSummary& summary) {
  constexpr double kClearlyMore = 3;
  const Alternative& first = changes.front();
  std::vector<std::string> rivals;
  for (std::size_t i = 1; i < changes.size(); ++i) {
    if (changes[i].points < first.points || changes[i].score + kClearlyMore <= first.score)
      continue;
    rivals.push_back(changes[i].what);
  }
  if (rivals.empty()) {
    summary.certainty = Certainty::kLikely;
    summary.evidence =
        first.reasons.empty() ? "no other change does as much" : first.reasons.front();
  } else {
    summary.certainty = Certainty::kGuess;
    summary.evidence = fmt::format("{} would do as much, with as good evidence: {}",
                                   counted(rivals.size(), "other change"),
                                   rivals.front() + (rivals.size() > 1 ? ", ..." : ""));
  }
}

void take_change(const PointStep& step, PointSummary& summary) {
  const std::vector<Alternative>& changes = step.conventions.alternatives;
  summary.id = changes.front().id;
  summary.cause = changes.front().remedy;
  summary.mend = mend_of(changes.front(), summary);
  judge_change(changes, summary);
}

// The point whose position or depth is known least, if that is too little to say where it is.
void take_imprecision(const PointStep& step, PointSummary& summary) {
  for (const Walk& walk : step.walks) {
    const std::string text = imprecision_text(walk, step);
    if (text.empty()) continue;
    summary.id = "imprecise";
    summary.cause = text;
    summary.mend = imprecision_remedy(walk);
    summary.certainty = Certainty::kCertain;
    summary.evidence = "this is the bound of the rounding errors";
    return;
  }
}

// What the program computed is not what its matrices give.
void take_clip_difference(const ClipComparison& clip, PointSummary& summary) {
  const bool explained = !clip.explanations.empty();
  summary.id = explained ? clip.explanations.front().id : "clip-differs";
  summary.cause = fmt::format("the program's clip positions differ at {} of {}", clip.different,
                              counted(clip.compared, "vertex", "vertices"));
  summary.mend = explained ? clip.explanations.front().text
                           : "compare what the program multiplies with these matrices";
  summary.certainty = explained ? Certainty::kLikely : Certainty::kCertain;
  summary.evidence = explained ? "this gives the program's positions at every vertex"
                               : "they differ by more than rounding";
}

// An alarm is certain, and comes first. The change that mends most is its mend where the matrices
// show evidence for it.
void find_cause(const PointStep& step, PointSummary& summary) {
  const std::vector<Alternative>& changes = step.conventions.alternatives;
  if (const Finding* alarm = first_of(step, Severity::kAlarm)) {
    take_finding(*alarm, summary);
    if (!changes.empty() && !changes.front().reasons.empty()) {
      summary.mend = mend_of(changes.front(), summary) + "; " + changes.front().remedy;
    }
    return;
  }
  if (step.clip && step.clip->different > 0) return take_clip_difference(*step.clip, summary);
  if (!changes.empty()) return take_change(step, summary);
  take_imprecision(step, summary);
  if (!summary.id.empty()) return;
  if (const Finding* hint = first_of(step, Severity::kHint)) take_finding(*hint, summary);
}

// ---- as text ----

const char* certainty_word(Certainty certainty) {
  constexpr const char* kWords[] = {"certain", "likely", "a guess", "nothing looks wrong"};
  return kWords[std::size_t(certainty)];
}

// At most `lines` lines. What does not fit ends in "...".
std::string field_text(const char* label, const std::string& text, int lines) {
  if (text.empty()) return {};
  std::string field = wrapped(fmt::format("{:<7}", label), text);
  std::size_t end = 0;
  for (int i = 0; i < lines; ++i) {
    end = field.find('\n', end) + 1;
    if (end == field.size()) return field;
  }
  field.resize(end - 1);
  field.resize(std::min(field.size(), field.rfind('\n') + 1 + kTextWidth - 4));
  return field + " ...\n";
}

std::string seen_text(const PointSummary& s) {
  return fmt::format("{} of {}: {}", s.seen, counted(s.points, "point"), s.where);
}

std::string nothing_wrong_text(const PointSummary& s) {
  if (s.passes) return "nothing looks wrong";
  return "no wrong convention was found that explains this: check the point's position, and what "
         "the camera sees";
}

}  // namespace

PointSummary summarize(const PointStep& step) {
  PointSummary summary;
  count_seen(step, summary);
  find_cause(step, summary);
  summary.passes = summary.passes && summary.id.empty();
  return summary;
}

std::string summary_text(const PointSummary& s) {
  const std::string seen = field_text("seen", seen_text(s), 3);
  if (s.id.empty()) return seen + field_text("cause", nothing_wrong_text(s), 2);
  return seen + field_text("cause", s.cause, 3) + field_text("mend", s.mend, 2) +
         field_text("sure", fmt::format("{}: {}", certainty_word(s.certainty), s.evidence), 2);
}

nlohmann::ordered_json summary_json(const PointSummary& s) {
  constexpr const char* kNames[] = {"certain", "likely", "guess", "none"};
  nlohmann::ordered_json json{{"points", s.points}, {"seen", s.seen}, {"where", s.where}};
  json["id"] = s.id.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(s.id);
  json["cause"] = s.cause;
  json["mend"] = s.mend;
  json["certainty"] = kNames[std::size_t(s.certainty)];
  json["evidence"] = s.evidence;
  json["passes"] = s.passes;
  return json;
}

void add_summary_options(CLI::App& command, PointStepOptions& options) {
  const std::string group = "Your own matrices";
  command
      .add_flag("--brief", options.brief,
                "print only the summary: whether the points are seen, what is wrong, what mends it")
      ->group(group);
  command
      .add_flag("--check", options.check,
                "exit with 1 if no point is seen, an --expect is missed, or something looks wrong")
      ->group(group);
}

int exit_code_of(const PointStep& step) {
  return !step.check || summarize(step).passes ? kSuccess : kFailure;
}

}  // namespace glassbox::app
