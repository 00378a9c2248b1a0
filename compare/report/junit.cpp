#include <glassbox/compare/report/junit.h>

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include <glassbox/compare/report/text.h>
#include <glassbox/html/escaped_html.h>

namespace glassbox {
namespace {

// XML attributes can contain tab, line feed and carriage return only as character references.
std::string in_xml(const std::string& text) {
  std::string out;
  for (const char c : escaped_html(text)) {
    const bool space = c == '\t' || c == '\n' || c == '\r';
    out += space ? fmt::format("&#{};", int(c)) : std::string(1, c);
  }
  return out;
}

std::string test_case(const std::string& suite, const Comparison& comparison) {
  const std::string start =
      fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", in_xml(suite),
                  in_xml(comparison.name), comparison.seconds);
  if (passes(comparison.verdict)) return start + "/>\n";
  const char* kind = comparison.verdict == Verdict::kUncompared ? "error" : "failure";
  return fmt::format("{}>\n      <{} message=\"{}\">{}</{}>\n    </testcase>\n", start, kind,
                     in_xml(comparison_line(comparison)), in_xml(comparison_details(comparison)),
                     kind);
}

}  // namespace

std::string junit_report(const std::string& suite, std::span<const Comparison> comparisons) {
  const auto errors =
      std::count_if(comparisons.begin(), comparisons.end(),
                    [](const Comparison& one) { return one.verdict == Verdict::kUncompared; });
  const auto passed = std::count_if(comparisons.begin(), comparisons.end(),
                                    [](const Comparison& one) { return passes(one.verdict); });
  const auto tests = std::ptrdiff_t(comparisons.size());
  const double seconds =
      std::accumulate(comparisons.begin(), comparisons.end(), 0.0,
                      [](double sum, const Comparison& one) { return sum + one.seconds; });
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  text += fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\">\n",
      in_xml(suite), tests, tests - passed - errors, errors, seconds);
  for (const Comparison& comparison : comparisons) text += test_case(suite, comparison);
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace glassbox
