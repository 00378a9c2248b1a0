// The text about points, and its last part: where they are, what is wrong, and what would make them
// visible.
#include <algorithm>
#include <span>

#include <fmt/format.h>

#include "app/step/point_summary.h"
#include "app/step/point_texts.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/counted.h>
#include <glassbox/matrices/decimal.h>

namespace glassbox::app {

namespace {

constexpr std::size_t kMaxPrintedWalks = 16;

std::string heading_text(const PointStep& step) {
  if (!step.setup.projection.given) return {};
  const auto [x, y, width, height] = step.window;
  const std::string place = x == 0 && y == 0 ? "" : fmt::format(" at ({}, {})", x, y);
  const std::string assumed = step.setup.picture ? "" : " (assumed: give yours with --size)";
  return wrapped("", fmt::format("{} ({}), window {}x{}{}{}", step.setup.dialect.title,
                                 step.dialect_reason, width, height, place, assumed)) +
         "\n";
}

std::string point_text(const glm::vec4& p) {
  return p.w == 1 ? fmt::format("({}, {}, {})", p.x, p.y, p.z)
                  : fmt::format("({}, {}, {}, {})", p.x, p.y, p.z, p.w);
}

std::string where_text(const PointStep::Walk& walk, const PointStep& step) {
  std::string text = wrapped("  ", where_sentence(walk, step));
  const std::string imprecise = imprecision_text(walk, step);
  if (imprecise.empty()) return text;
  return text + wrapped("  WRONG ", imprecise) + wrapped("        -> ", imprecision_remedy(walk));
}

std::string behind_text(const ConventionsReport& report) {
  if (report.points < 2 || report.behind_eye == 0) return {};
  const bool all = report.behind_eye == report.points;
  return wrapped("  ", fmt::format("{} negative ({} of {} points): behind the eye",
                                   all ? "every w is" : "w is", report.behind_eye, report.points));
}

std::string findings_text(const std::vector<Finding>& findings) {
  std::string text;
  constexpr std::pair<Severity, const char*> kWords[] = {
      {Severity::kAlarm, "  WRONG "}, {Severity::kHint, "  hint  "}, {Severity::kNote, "  note  "}};
  for (const auto& [severity, word] : kWords) {
    for (const Finding& finding : findings) {
      if (finding.severity != severity) continue;
      text += wrapped(word, finding_place(finding) + finding.cause);
      if (!finding.remedy.empty()) text += wrapped("        -> ", finding.remedy);
    }
  }
  return text;
}

std::string alternatives_text(const ConventionsReport& report) {
  std::string text;
  int number = 0;
  for (const Alternative& a : report.alternatives) {
    std::string line = a.what + ": ";
    if (report.points > 1)
      line += fmt::format("{} of {} points are where they should be", a.points, report.points);
    if (report.points > 1 && a.window) line += ", the first ";
    if (a.window) line += fmt::format("at ({:.2f}, {:.2f})", a.window->x, a.window->y);
    text += wrapped(fmt::format("  {}. ", ++number), line);
    for (const std::string& reason : a.reasons) text += wrapped("       because ", reason);
    text += wrapped("       -> ", a.remedy);
  }
  if (report.spoiling > 0) {
    text +=
        wrapped("  ", fmt::format("{} would also work, but {} a matrix that is correct as given",
                                  counted(report.spoiling, "other change"),
                                  singular_or_plural(report.spoiling, "damages", "damage")));
  }
  return text;
}

std::string no_change_text(const PointStep& step) {
  const bool alarmed =
      std::any_of(step.findings.begin(), step.findings.end(),
                  [](const Finding& finding) { return finding.severity == Severity::kAlarm; });
  return wrapped("  ", alarmed ? "None of the tried changes of convention brings it into the "
                                 "picture: correct what is marked WRONG first"
                               : "None of the tried changes of convention brings it into the "
                                 "picture: check its position, and where the camera looks");
}

std::string changes_text(const PointStep& step) {
  const ConventionsReport& report = step.conventions;
  const bool expects = step.walks.front().expected.has_value();
  const bool pairs = report.alternatives.front().second.has_value();
  const std::string line = fmt::format(
      "If the {} should be {}, {} would work{}:", singular_or_plural(report.points, "point"),
      expects ? "where it is expected" : "in the picture",
      pairs ? "two changes together" : "one of these changes",
      report.alternatives.size() == 1 ? ""
                                      : " (the likeliest first; only you know what was meant)");
  return "\n" + wrapped("  ", line) + alternatives_text(report);
}

// Where the first points are. A table may have many: then the others are counted.
std::string where_all_are_text(const PointStep& step) {
  constexpr std::size_t kMaxLines = 8;
  std::string text;
  for (const PointStep::Walk& walk :
       std::span(step.walks).first(std::min(step.walks.size(), kMaxLines))) {
    text += where_text(walk, step);
  }
  if (step.walks.size() <= kMaxLines) return text;
  const auto seen = std::ranges::count_if(step.walks, [](const PointStep::Walk& walk) {
    return walk.chain.verdict == VertexVerdict::kVisible;
  });
  text += wrapped("  ", fmt::format("and {} more; {} of these {} are inside the view volume",
                                    step.walks.size() - kMaxLines, seen, step.walks.size()));
  if (step.points > step.walks.size()) {
    text += wrapped("  ", fmt::format("the points above are chosen evenly from the {} of the table",
                                      counted(step.points, "point")));
  }
  return text;
}

std::string verdict_text(const PointStep& step) {
  std::string text = "VERDICT\n";
  text += where_all_are_text(step);
  const ConventionsReport& report = step.conventions;
  text += behind_text(report) + findings_text(step.findings);
  if (step.clip) text += clip_comparison_text(*step.clip);
  if (report.visible == report.points) return text;
  return text + (report.alternatives.empty() ? no_change_text(step) : changes_text(step));
}

}  // namespace

std::string finding_place(const Finding& finding) {
  return *finding.matrix == '\0' ? "" : std::string(finding.matrix) + ": ";
}

std::string where_sentence(const PointStep::Walk& walk, const PointStep& step) {
  const VertexChain& chain = walk.chain;
  std::string line = point_text(chain.object) + " is ";
  if (step.setup.projection.given) {
    line += vertex_verdict_text(walk, step);
    if (walk.expected) {
      line += fmt::format(", expected at ({:.2f}, {:.2f})", walk.expected->x, walk.expected->y);
    }
  } else {
    line += fmt::format("at {} in eye space; without --proj nothing is projected",
                        short_vector_text(glm::dvec3(chain.to_eye.after)));
  }
  if (chain.object.w == 0) line += "; w = 0 makes it a direction, which no translation moves";
  return line;
}

std::string point_step_text(const PointStep& step) {
  const std::string summary = summary_text(summarize(step));
  if (step.brief) return summary;
  std::string text = summary + "\n" + heading_text(step) + matrices_text(step.setup);
  // The first points of a large table stand for the others.
  const std::size_t printed = step.walks.size() > kMaxPrintedWalks ? 3 : step.walks.size();
  for (const PointStep::Walk& walk : std::span(step.walks).first(printed)) {
    text += "\nPOINT " + point_text(walk.chain.object) + "\n" + walk_text(walk, step);
  }
  if (printed < step.walks.size()) {
    text += fmt::format("\n... and {} more points; --json has them\n", step.walks.size() - printed);
  }
  return text + "\n" + verdict_text(step);
}

}  // namespace glassbox::app
