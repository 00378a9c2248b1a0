#include "labs/grading/results.h"

#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/framework/divergence_text.h"
#include "labs/framework/slips.h"

#include <glassbox/base/counted.h>

namespace glassbox::labs::grading {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxText = 4000;  // how many bytes of a student's printed output are shown

std::string truncated(const std::string& text, std::size_t most) {
  return text.size() <= most ? text : text.substr(0, most) + "\n[cut off here]";
}

// Rounds sums of thirds and sevenths to 1e-6 of a point, so that no rounding error is visible.
double points(double value) {
  return std::round(value * 1e6) / 1e6;
}

// A number as JSON; infinities and NaN, which JSON does not have, become text.
Json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

std::string divergence_text(const Divergence& divergence) {
  std::string text = fmt::format("  {}", divergence.field);
  if (!divergence.element.empty()) text += ", " + divergence.element;
  text +=
      fmt::format(" ({}): expected {}, actual {}\n  distance {}", kind_name(divergence.kind),
                  expected_text(divergence), actual_text(divergence), distance_text(divergence));
  text += '\n';
  if (!divergence.explanation.empty()) text += "  " + divergence.explanation + '\n';
  return text;
}

Json failure_json(const FirstFailure& failure) {
  Json json{{"case", failure.index}, {"verdict", verdict_name(failure.verdict)}};
  if (!failure.where.empty()) json["where"] = failure.where;
  if (!failure.text.empty()) json["text"] = truncated(failure.text, kMaxText);
  if (const auto& divergence = failure.divergence) {
    json["field"] = divergence->field;
    json["element"] = divergence->element;
    json["kind"] = kind_name(divergence->kind);
    json["expected"] = number(divergence->expected);
    json["actual"] = number(divergence->actual);
    json["distance"] = number(divergence->distance);
    json["bound"] = number(divergence->bound);
    json["unit"] = divergence->unit;
    json["ulps"] = number(divergence->ulps);
  }
  return json;
}

Json test_json(const CheckResult& check, const std::string& name, const std::string& number) {
  Json extra{{"task", check.task},          {"stage", check.stage}, {"outcome", name},
             {"cases", check.cases.size()}, {"right", check.right}, {"hidden", check.hidden}};
  if (!check.slips.empty()) extra["slips"] = check.slips;
  if (check.first) extra["first_failure"] = failure_json(*check.first);
  return {{"score", points(check.score)},
          {"max_score", points(check.max_score)},
          {"status", check.verdict == Verdict::kRight ? "passed" : "failed"},
          {"name", check.name},
          {"name_format", "text"},
          {"number", number},
          {"output", explanation(check, name)},
          {"output_format", "text"},
          {"tags", {check.task, check.stage, name}},
          {"visibility", check.hidden ? "after_published" : "visible"},
          {"extra_data", extra}};
}

// Describes the first case that is not right, and what may be the reason.
std::string failure_text(const CheckResult& check, const std::string& name) {
  std::string text = fmt::format(
      "{}: {} of {} {} right{}.\n", name, check.right, counted(check.cases.size(), "case"),
      singular_or_plural(check.right, "is", "are"), all_or_nothing_note(check));
  if (const auto& first = check.first) {
    text += fmt::format("The first case that is not right: case {}", first->index);
    if (!first->where.empty()) text += fmt::format(" ({})", first->where);
    text += fmt::format(": {}\n", verdict_name(first->verdict));
    if (!first->text.empty()) text += "  " + truncated(first->text, kMaxText) + '\n';
    if (first->divergence) text += divergence_text(*first->divergence);
    if (!first->restated.empty()) text += "The case:\n" + first->restated + '\n';
  }
  for (const std::string& slip : check.slips) text += "Likely: " + slip_text(slip) + '\n';
  return text;
}

}  // namespace

std::string explanation(const CheckResult& check, const std::string& name) {
  if (check.verdict == Verdict::kNotBuilt) return fmt::format("Not run: {}.\n", name);
  std::string text;
  if (check.verdict == Verdict::kUntouched) {
    text = "Not written yet: every answer is the same as the starter's.\n";
  } else if (check.verdict == Verdict::kRight) {
    text = check.cases.size() == 1 ? "The only case is right.\n"
                                   : fmt::format("All {} cases are right.\n", check.cases.size());
  } else {
    text = failure_text(check, name);
  }
  if (!check.printed.empty())
    text += "Your code printed:\n" + truncated(check.printed, kMaxText) + '\n';
  return text;
}

Json gradescope_json(const GradedSubmission& graded, const std::string& confinement,
                     const std::string& digest) {
  const LabResult& lab = graded.result;
  // The text shows no points: students read it before grades are published, and the total would
  // reveal something about hidden checks.
  std::string output = fmt::format("Lab {}, {}.\n", lab.number, lab.title);
  if (graded.outcome != "graded") output += graded.outcome + ".\n";
  if (!graded.messages.empty()) output += "\n" + truncated(graded.messages, 3 * kMaxText);
  Json tasks = Json::array();
  for (const TaskResult& task : lab.tasks) {
    tasks.push_back({{"id", task.id},
                     {"title", task.title},
                     {"score", points(task.score)},
                     {"max_score", points(task.max_score)}});
  }
  Json tests = Json::array();
  std::map<std::string, int> counts;
  for (std::size_t i = 0; i < lab.checks.size(); ++i) {
    const CheckResult& check = lab.checks[i];
    const std::string number = fmt::format("{}.{}", check.task, ++counts[check.task]);
    tests.push_back(test_json(check, graded.check_outcomes[i], number));
  }
  // There is no "score" here: Gradescope adds up the scores of the tests, and shows the sum when it
  // shows all tests.
  return {{"output", output},
          {"output_format", "text"},
          {"test_output_format", "text"},
          {"stdout_visibility", "hidden"},
          {"extra_data",
           {{"lab", lab.number},
            {"folder", lab.folder},
            {"outcome", graded.outcome},
            {"score", points(lab.score)},
            {"max_score", points(lab.max_score)},
            {"tasks", tasks},
            {"sandbox", confinement},
            {"digest", digest}}},
          {"tests", tests}};
}

Json unfinished_json() {
  return {{"score", 0.0},  // there are no tests to add up
          {"output", std::string(kUnfinished) + ".\n"},
          {"output_format", "text"},
          {"stdout_visibility", "hidden"},
          {"extra_data", {{"outcome", kUnfinished}, {"score", 0.0}}},
          {"tests", Json::array()}};
}

Json classroom_json(const Json& results) {
  const auto entry = [](const std::string& name, bool passed, const Json& message,
                        const std::string& code) -> Json {
    return {{"name", name},
            {"status", passed ? "pass" : "fail"},
            {"score", 0.0},
            {"max_score", 0.0},
            {"message", passed ? Json() : message},
            {"test_code", code},
            {"filename", "student.cpp"},
            {"line_no", 0},
            {"duration", 0}};
  };
  Json tests = Json::array();
  std::size_t hidden = 0;
  bool all = true, all_hidden = true;
  double hidden_score = 0, hidden_most = 0;
  for (const Json& test : results.at("tests")) {
    const bool passed = test.at("status") == "passed";
    all = all && passed;
    if (test.at("extra_data").at("hidden")) {
      ++hidden;
      all_hidden = all_hidden && passed;
      hidden_score += test.at("score").get<double>();
      hidden_most += test.at("max_score").get<double>();
      continue;
    }
    tests.push_back(entry(test.at("name"), passed, test.at("output"),
                          fmt::format("glassbox lab check, task {}",
                                      test.at("extra_data").at("task").get<std::string>())));
    tests.back()["score"] = test.at("score");
    tests.back()["max_score"] = test.at("max_score");
  }
  // The reporter adds up the points, so the hidden checks are there, as one without their names.
  if (hidden > 0) {
    tests.push_back(entry("hidden checks", all_hidden, "hidden", "glassbox lab grade"));
    tests.back()["score"] = points(hidden_score);
    tests.back()["max_score"] = points(hidden_most);
  }
  const Json& extra = results.at("extra_data");
  const bool graded = extra.at("outcome") == "graded";
  return {{"version", 1},
          {"status", !graded ? "error"
                     : all   ? "pass"
                             : "fail"},
          {"max_score", extra.value("max_score", 0.0)},
          {"tests", tests}};
}

double total_of(const Json& results) {
  return results.at("extra_data").at("score").get<double>();
}

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace glassbox::labs::grading
