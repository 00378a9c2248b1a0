#include "tests/labs/framework/planted.h"

#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/support/catch.h"

namespace glassbox::labs {

namespace {

std::string replaced(const std::string& text, const std::string& what, const std::string& by) {
  return std::regex_replace(text, std::regex(what), by);
}

// A function that student.h declares.
struct Function {
  std::string declaration;  // "bool owns_edge(const SnappedVertex& a, const SnappedVertex& b)"
  std::string name;         // "owns_edge"
  std::string arguments;    // "a, b"
};

// Declarations begin in the first column and have no braces.
std::vector<Function> functions_of(const std::string& header) {
  const std::string code = replaced(header, "//[^\n]*", "");
  const std::regex declared(R"(\n([A-Za-z][\w:<>, ]*?[ >&](\w+)\(([^{};]*)\));)");
  std::vector<Function> functions;
  for (std::sregex_iterator at(code.begin(), code.end(), declared), end; at != end; ++at) {
    // The last word before a comma that is not within <>, and before the end.
    std::string arguments, word;
    int depth = 0;
    for (const char c : (*at)[3].str() + ",") {
      depth += c == '<' ? 1 : c == '>' ? -1 : 0;
      if (c == ',' && depth == 0) arguments += (arguments.empty() ? "" : ", ") + word;
      if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
        word += c;
      } else {
        word.clear();
      }
    }
    functions.push_back({(*at)[1], (*at)[2], arguments});
  }
  return functions;
}

// What stands in the lab's namespace, as members of a class: there no function is static, and no namespace.
std::string members_of(const std::string& source) {
  const std::size_t open = source.find("namespace lab_");
  const std::size_t first = source.find('\n', open), last = source.rfind("}  // namespace lab_");
  REQUIRE(open != std::string::npos);
  REQUIRE(last != std::string::npos);
  const std::string body = source.substr(first, last - first);
  return replaced(replaced(body, "\nnamespace \\{|\n\\}  // namespace\n", "\n"), "\nstatic ", "\n");
}

}  // namespace

std::vector<Fault> faults_of(const Sources& sources, const Lab& lab) {
  const auto text = read_text_file(sources.labs / lab.folder / "faults.json");
  REQUIRE(text);
  std::vector<Fault> faults;
  for (const auto& json : nlohmann::json::parse(*text)) {
    Fault fault{json.at("name"), json.at("find"), json.at("replace"), json.at("task")};
    fault.slip = json.value("slip", "");
    fault.headline = json.value("headline", false);
    fault.stage = json.value("stage", "");
    faults.push_back(fault);
  }
  return faults;
}

std::string with_fault(const std::string& solution, const Fault& fault) {
  INFO("fault: " << fault.name << "\nfind: " << fault.find);
  const std::size_t at = solution.find(fault.find);
  REQUIRE(at != std::string::npos);
  REQUIRE(solution.find(fault.find, at + 1) == std::string::npos);
  std::string changed = solution;
  return changed.replace(at, fault.find.size(), fault.replace);
}

std::string all_in_one(const std::string& header, const std::string& solution,
                       const std::vector<Fault>& faults) {
  std::string includes, classes, chosen, calls, virtuals;
  const std::regex include("(^|\n)(#include [^\n]*)");
  for (std::sregex_iterator at(solution.begin(), solution.end(), include), end; at != end; ++at)
    includes += (*at)[2].str() + "\n";
  for (const Function& each : functions_of(header)) {
    virtuals += fmt::format("  virtual {} = 0;\n", each.declaration);
    calls += fmt::format("{} {{\n  return chosen().{}({});\n}}\n", each.declaration, each.name,
                         each.arguments);
  }
  REQUIRE_FALSE(virtuals.empty());
  for (std::size_t i = 0; i <= faults.size(); ++i) {
    const std::string source = i == 0 ? solution : with_fault(solution, faults[i - 1]);
    classes += fmt::format("// {}\nstruct Planted{} : Student {{{}}};\n",
                           i == 0 ? "the solution" : faults[i - 1].name, i, members_of(source));
    chosen += fmt::format("    case {0}: return std::make_unique<Planted{0}>();\n", i);
  }
  const std::size_t open = solution.find("namespace lab_");
  return fmt::format(
      R"({}#include <cstdlib>
#include <memory>

{}
struct Student {{
  virtual ~Student() = default;
{}}};
{}
std::unique_ptr<Student> made(int number) {{
  switch (number) {{
{}  }}
  std::abort();
}}
Student& chosen() {{
  const char* number = std::getenv("{}");
  static const auto one = made(number == nullptr ? 0 : std::atoi(number));
  return *one;
}}
{}}}
)",
      includes, solution.substr(open, solution.find('\n', open) - open), virtuals, classes, chosen,
      kPlanted, calls);
}

}  // namespace glassbox::labs
