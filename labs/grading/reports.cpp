#include "labs/grading/reports.h"

#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glassbox/html/escaped_html.h>

namespace glassbox::labs::grading {

namespace {

using OrderedJson = nlohmann::ordered_json;

bool is_visible(const OrderedJson& test) {
  return test.at("visibility") == "visible";
}

std::string outcome_in(const OrderedJson& test) {
  return test.at("extra_data").at("outcome");
}

}  // namespace

std::string junit_xml(const OrderedJson& results) {
  const OrderedJson& extra = results.at("extra_data");
  std::string cases;
  int tests = 0, failures = 0;
  for (const OrderedJson& test : results.at("tests")) {
    if (!is_visible(test)) continue;
    ++tests;
    cases +=
        fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                    escaped_html("task " + test.at("extra_data").at("task").get<std::string>()),
                    escaped_html(test.at("name")));
    if (test.at("status") == "passed") {
      cases += "/>\n";
      continue;
    }
    ++failures;
    cases += fmt::format(">\n      <failure message=\"{}\">{}</failure>\n    </testcase>\n",
                         escaped_html(outcome_in(test)), escaped_html(test.at("output")));
  }
  const bool graded = extra.at("outcome") == "graded";
  // If nothing was graded, the report has one error: the reason why no check was run.
  if (!graded)
    cases += fmt::format(
        "    <testcase classname=\"submission\" name=\"student.cpp\">\n      <error "
        "message=\"{}\">{}</error>\n"
        "    </testcase>\n",
        escaped_html(extra.at("outcome")), escaped_html(results.at("output")));
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n{}  "
      "</testsuite>\n</testsuites>\n",
      escaped_html(extra.value("folder", "lab")), tests + (graded ? 0 : 1), failures,
      graded ? 0 : 1, cases);
}

std::string vpl_text(const OrderedJson& results, double most) {
  std::string text;
  double score = 0, max_score = 0;
  // In the format of VPL (Moodle's Virtual Programming Lab), a line that begins with "-" is a
  // title, and a line that begins with ">" is shown literally.
  const auto add = [&](const std::string& title, const std::string& body) {
    text += "<|--\n-" + title + "\n";
    std::istringstream lines(body);
    for (std::string line; std::getline(lines, line);) text += ">" + line + "\n";
    text += "--|>\n\n";
  };
  const OrderedJson& extra = results.at("extra_data");
  if (extra.at("outcome") != "graded") add(extra.at("outcome"), results.at("output"));
  for (const OrderedJson& test : results.at("tests")) {
    if (!is_visible(test)) continue;
    score += test.at("score").get<double>();
    max_score += test.at("max_score").get<double>();
    if (extra.at("outcome") == "graded")
      add(fmt::format("{} {}: {}", test.at("number").get<std::string>(),
                      test.at("name").get<std::string>(), outcome_in(test)),
          test.at("output"));
  }
  return text + fmt::format("Grade :=>>{:.2f}\n", max_score > 0 ? most * score / max_score : 0.0);
}

}  // namespace glassbox::labs::grading
