#include <glassbox/compare/report/junit.h>

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glassbox/compare/report/text.h>

namespace glassbox {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD

// Names may be anything but UTF-8; the JSON library replaces what is not.
std::string valid_utf8(const std::string& text) {
  using nlohmann::json;
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace))
      .get<std::string>();
}

// XML 1.0 has neither U+FFFE nor U+FFFF.
void replace_noncharacters(std::string& text) {
  for (const std::string_view code : {"\xef\xbf\xbe", "\xef\xbf\xbf"}) {
    for (auto at = text.find(code); at != std::string::npos; at = text.find(code)) {
      text.replace(at, code.size(), kReplacement);
    }
  }
}

// Nor control characters but tab, line feed and carriage return, which attributes hold as references only.
std::string escaped(const std::string& any_text) {
  std::string text = valid_utf8(any_text);
  replace_noncharacters(text);
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\t':
        out += "&#9;";
        break;
      case '\n':
        out += "&#10;";
        break;
      case '\r':
        out += "&#13;";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          out += kReplacement;
        } else {
          out += c;
        }
    }
  }
  return out;
}

std::string test_case(const std::string& suite, const Comparison& comparison) {
  const std::string start = fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                                        escaped(suite), escaped(comparison.name));
  if (passes(comparison.verdict)) return start + "/>\n";
  const char* kind = comparison.verdict == Verdict::kUncompared ? "error" : "failure";
  return fmt::format("{}>\n      <{} message=\"{}\">{}</{}>\n    </testcase>\n", start, kind,
                     escaped(one_line(comparison)), escaped(details(comparison)), kind);
}

}  // namespace

std::string junit_report(const std::string& suite, std::span<const Comparison> comparisons) {
  const auto errors =
      std::count_if(comparisons.begin(), comparisons.end(),
                    [](const Comparison& one) { return one.verdict == Verdict::kUncompared; });
  const auto passed = std::count_if(comparisons.begin(), comparisons.end(),
                                    [](const Comparison& one) { return passes(one.verdict); });
  const auto tests = std::ptrdiff_t(comparisons.size());
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  text += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
                      escaped(suite), tests, tests - passed - errors, errors);
  for (const Comparison& comparison : comparisons) text += test_case(suite, comparison);
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace glassbox
