#include "tests/labs/framework/handed_out.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "labs/framework/strip_solution.h"
#include "tests/support/catch.h"

namespace glassbox::labs {

namespace {

// The members of a struct, by its code between the braces: "s.x, s.y". They are indented by two
// columns, and each declaration ends with a semicolon.
std::string members_of_struct(const std::string& body) {
  static const std::regex declared(
      R"(\n  (?! |using|enum|friend|static|template)([^;(){}]|\{[^;()]*\})*;)");
  static const std::regex name(R"((\w+)\s*(?:\[[^\]]*\])*\s*(?:=[^,;]*)?[,;])");
  std::string list;
  for (std::sregex_iterator at(body.begin(), body.end(), declared), end; at != end; ++at) {
    // Commas between <> or braces separate no members.
    std::string flat;
    int depth = 0;
    for (const char c : at->str()) {
      if (c == '<' || c == '{') ++depth;
      if (depth == 0) flat += c;
      if (c == '>' || c == '}') --depth;
    }
    for (std::sregex_iterator one(flat.begin(), flat.end(), name); one != end; ++one)
      list += (list.empty() ? "s." : ", s.") + (*one)[1].str();
  }
  return list;
}

// Whether a parameter's type is a template's, so that a call with any type seems to compile until
// the body is compiled.
bool takes_any_type(const std::string& templated, const std::string& parameters) {
  static const std::regex type("class (\\w+)");
  for (std::sregex_iterator at(templated.begin(), templated.end(), type), end; at != end; ++at) {
    const std::string name = (*at)[1];
    const std::regex alone("(^|, *)(const )?" + name + "\\b"), within("<[^()]*\\b" + name + "\\b");
    if (std::regex_search(parameters, alone) && !std::regex_search(parameters, within)) return true;
  }
  return false;
}

// The fewest and the most arguments that a list of parameters takes.
std::pair<int, int> argument_counts(const std::string& parameters) {
  int all = parameters.find_first_not_of(" \n") == std::string::npos ? 0 : 1, defaults = 0;
  int depth = 0;
  for (const char c : parameters) {
    if (c == '<' || c == '(') ++depth;
    if (c == '>' || c == ')') --depth;
    if (c == ',' && depth == 0) ++all;
    if (c == '=' && depth == 0) ++defaults;
  }
  return {all - defaults, all};
}

}  // namespace

std::string filled_in(std::string text, const std::string& what, const std::string& by) {
  INFO("looking for: " << what);
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

void add_definitions(HandedOut& all, const std::string& header, const std::string& space) {
  const std::string bare = std::regex_replace("\n" + header, std::regex("//[^\n]*"), "");
  const std::string code = std::regex_replace(bare, std::regex(R"(= \{\})"), "= 0");
  static const std::regex function(
      R"(\n(template <[^\n]*>\n(?:  requires[^\n]*\n)?)?)"
      R"((?!namespace|struct|class|using|enum|return|template)[A-Za-z][\w:<>, ]*[ >&*])"
      R"((\w+)\(([^;{}]*)\)[^;{}()]*\{)");
  for (std::sregex_iterator at(code.begin(), code.end(), function), end; at != end; ++at) {
    const std::string name = space + "::" + (*at)[2].str();
    if (takes_any_type((*at)[1], (*at)[3])) all.left_out.insert(name);
    const auto [fewest, most] = argument_counts((*at)[3]);
    const auto& known = all.functions.try_emplace(name, fewest, most).first;
    known->second = {std::min(known->second.first, fewest), std::max(known->second.second, most)};
  }
  static const std::regex record(R"(([^\n]*)\nstruct (\w+) \{\n)");
  for (std::sregex_iterator at(code.begin(), code.end(), record), end; at != end; ++at) {
    if ((*at)[1].str().starts_with("template")) continue;
    const std::size_t first = std::size_t(at->position() + at->length()) - 1;
    const std::string list =
        members_of_struct(code.substr(first, code.find("\n};", first) - first));
    if (list.empty()) continue;
    for (const char* qualifier : {"", "const "})
      all.members += fmt::format("inline auto members({}{}::{}& s) {{ return std::tie({}); }}\n",
                                 qualifier, space, (*at)[2].str(), list);
  }
}

namespace {

// Puts the headers of the lab's folder together.
class Collector {
public:
  Collector(const Sources& sources, const Lab& lab) : lab_(fmt::format("lab_{:02}", lab.number)) {
    const auto files = support_files(sources, lab.folder, false);
    REQUIRE(files);
    std::vector<SourceFile> own;
    for (const SourceFile& each : *files) {
      texts_[each.path] = each.text;
      if (each.path == "student.h") own.push_back(each);
    }
    const auto of_all = library_headers(sources, *files), of_own = library_headers(sources, own);
    REQUIRE(of_all);
    REQUIRE(of_own);
    for (const SourceFile& each : *of_all) texts_[each.path] = each.text;
    for (const SourceFile& each : *of_own) {
      add_definitions(all_, each.text, "glassbox");
      done_.insert(each.path);
    }
    add_definitions(all_, texts_.at("student.h"), lab_);
    done_.insert("student.h");
    take("labs/framework/runner.h");
    take("cases.h");
    for (const SourceFile& each : *files) {
      if (each.path.starts_with("generators")) take(each.path);
    }
  }
  const HandedOut& all() const { return all_; }

private:
  void take(const std::string& path) {
    if (!done_.insert(path).second) return;
    std::istringstream lines(texts_.at(path));
    std::string kept;
    static const std::regex include(R"re(#include ["<](.*)[">])re");
    for (std::string line; std::getline(lines, line);) {
      std::smatch found;
      if (line == "#pragma once") continue;
      if (std::regex_match(line, found, include) && texts_.count(found[1]) == 1) {
        take(found[1]);
      } else {
        kept += line + "\n";
      }
    }
    const bool of_library = path.starts_with("glassbox/");
    const bool of_framework = path.starts_with("labs/framework/");
    if (!of_library && !of_framework) {
      kept = filled_in(kept, "namespace " + lab_ + " {",
                       "namespace " + lab_ + " { namespace handed_out {");
      kept = filled_in(kept, "}  // namespace " + lab_, "}}");
    }
    add_definitions(all_, kept,
                    of_library     ? "glassbox"
                    : of_framework ? "glassbox::labs"
                                   : lab_ + "::handed_out");
    all_.text += kept;
  }

  std::string lab_;
  std::map<std::string, std::string> texts_;
  std::set<std::string> done_;
  HandedOut all_;
};

}  // namespace

HandedOut handed_out(const Sources& sources, const Lab& lab) {
  return Collector(sources, lab).all();
}

}  // namespace glassbox::labs
