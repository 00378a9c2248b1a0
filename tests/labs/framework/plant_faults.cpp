#include "tests/labs/framework/plant_faults.h"

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

}  // namespace

// Declarations begin in the first column and have no braces.
std::vector<Function> functions_of(const std::string& header) {
  const std::string code = replaced(header, "//[^\n]*", "");
  const std::regex declared(R"(\n([A-Za-z][\w:<>, ]*?[ >&](\w+)\(([^{};]*)\));)");
  std::vector<Function> functions;
  for (std::sregex_iterator at(code.begin(), code.end(), declared), end; at != end; ++at) {
    // A parameter's name is the last word before a comma that is not within <>, or before the end.
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

namespace {

// Returns the contents of the lab's namespace as members of a class: `static` and unnamed
// namespaces are removed, because a class cannot have them with this meaning.
std::string members_of(const std::string& source) {
  const std::size_t open = source.find("namespace lab_");
  const std::size_t first = source.find('\n', open), last = source.rfind("}  // namespace lab_");
  REQUIRE(open != std::string::npos);
  REQUIRE(last != std::string::npos);
  const std::string body = source.substr(first, last - first);
  return replaced(replaced(body, "\nnamespace \\{|\n\\}  // namespace\n", "\n"), "\nstatic ", "\n");
}

std::size_t after_comment(const std::string& text, std::size_t at) {
  return std::min(text.find('\n', at), text.size());
}

// Returns the position after a string or a character; `at` is its opening quote.
std::size_t after_quoted(const std::string& text, std::size_t at) {
  const char quote = text[at++];
  while (at < text.size() && text[at] != quote) at += text[at] == '\\' ? 2u : 1u;
  return at + 1;
}

// Splits a text into its members, each with the comment before it.
std::vector<std::string> single_members(const std::string& text) {
  std::vector<std::string> all;
  std::size_t start = 0;
  int depth = 0;
  const auto letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (text.compare(at, 2, "//") == 0) {
      at = after_comment(text, at);
      continue;
    }
    // The quote in a number such as 10'000 begins no character.
    if (c == '"' || (c == '\'' && (at == 0 || !letter(text[at - 1])))) {
      at = after_quoted(text, at);
      continue;
    }
    if (c == '(' || c == '{' || c == '[') ++depth;
    if (c == ')' || c == '}' || c == ']') --depth;
    ++at;
    const std::size_t next = text.find_first_not_of(" \n", at);
    const bool goes_on = next != std::string::npos && text.find_first_of(";,(", next) == next;
    if (depth > 0 || !(c == ';' || (c == '}' && !goes_on))) continue;
    all.push_back(text.substr(start, at - start));
    start = at;
  }
  if (start < text.size()) all.push_back(text.substr(start));
  return all;
}

struct Member {
  std::string comment, code;
  // The text before the body if it is a function that a class may override, or empty.
  std::string head;
};

Member member_of(const std::string& text) {
  static const std::regex comments("^(\\s|//[^\n]*\n)*");
  static const std::regex no_function(
      "^(struct|class|enum|union|using|template|constexpr|auto)\\b");
  std::smatch found;
  std::regex_search(text, found, comments);
  Member member{found.str(), found.suffix(), {}};
  const std::string head = member.code.substr(0, member.code.find('{'));
  const bool function = member.code.ends_with('}') && head.find('(') != std::string::npos &&
                        head.find('=') == std::string::npos &&
                        !std::regex_search(member.code, no_function);
  if (function) member.head = head;
  return member;
}

std::vector<Member> all_members(const std::string& source) {
  std::vector<Member> all;
  for (const std::string& text : single_members(members_of(source))) all.push_back(member_of(text));
  return all;
}

// Returns a whole class. If a function is overridden, every other function that calls it calls the
// override.
std::string class_of(const std::string& name, const std::vector<Member>& members) {
  std::string text = fmt::format("struct {} : Student {{", name);
  for (const Member& each : members)
    text += each.comment + (each.head.empty() ? "" : "virtual ") + each.code;
  return text + "\n};\n";
}

// Returns a class with only the functions that differ from the solution, or with all members if
// something else differs.
std::string class_of_variant(const std::string& name, const std::vector<Member>& solution,
                             const std::vector<Member>& faulty) {
  std::string overridden, names;
  bool functions = solution.size() == faulty.size();
  for (std::size_t i = 0; i < faulty.size() && functions; ++i) {
    if (faulty[i].code == solution[i].code) continue;
    functions = !faulty[i].head.empty() && faulty[i].head == solution[i].head;
    std::smatch called;
    const std::regex before("(\\w+)\\(");
    if (!functions || !std::regex_search(faulty[i].head, called, before))
      return class_of(name, faulty);
    // Keeps other functions of that name visible.
    names += fmt::format("  using Solution::{};\n", called[1].str());
    overridden += faulty[i].code + "\n";
  }
  if (!functions) return class_of(name, faulty);
  return fmt::format("struct {} : Solution {{\n{}{}}};\n", name, names, overridden);
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
    fault.unseen = json.value("unseen", "");
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

// The chosen object lives until the program ends. Smart pointers and destructors for a hundred
// classes would take a third of the compilation time.
std::string solution_with_variants(const std::string& header, const std::string& solution,
                                   const std::vector<Variant>& variants) {
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
  const std::vector<Member> right = all_members(solution);
  for (std::size_t i = 0; i <= variants.size(); ++i) {
    const std::string name = i == 0 ? "Solution" : fmt::format("Planted{}", i);
    if (i == 0) {
      classes += class_of(name, right);
    } else {
      const Variant& variant = variants[i - 1];
      classes += fmt::format("// {}\n{}", variant.name,
                             class_of_variant(name, right, all_members(variant.source)));
    }
    chosen += fmt::format("    case {}: return new {};\n", i, name);
  }
  const std::size_t open = solution.find("namespace lab_");
  return fmt::format(
      R"({}#include <cstdlib>

{}
struct Student {{
{}}};
{}
Student* made(int number) {{
  switch (number) {{
{}  }}
  std::abort();
}}
Student& chosen() {{
  const char* number = std::getenv("{}");
  static Student* const one = made(number == nullptr ? 0 : std::atoi(number));
  return *one;
}}
{}}}
)",
      includes, solution.substr(open, solution.find('\n', open) - open), virtuals, classes, chosen,
      kPlanted, calls);
}

std::string solution_with_all_faults(const std::string& header, const std::string& solution,
                                     const std::vector<Fault>& faults) {
  std::vector<Variant> variants;
  for (const Fault& fault : faults) variants.push_back({fault.name, with_fault(solution, fault)});
  return solution_with_variants(header, solution, variants);
}

}  // namespace glassbox::labs
