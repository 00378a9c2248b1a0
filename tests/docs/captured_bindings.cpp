#include "tests/docs/captured_bindings.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>

namespace glassbox::test {

namespace {

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

struct Token {
  std::string text;
  std::size_t line = 0;
  bool after_space = false;
  bool is_word() const { return is_of_word(text.front()); }
};

// Words, and other characters one by one, but for -> and ::. Comments and literals are left out.
std::vector<Token> tokens_of(std::string_view source) {
  static const std::regex kLeftOut(R"re(//[^\n]*|"(\\.|[^"\\\n])*"|'(\\.|[^'\\\n])')re");
  const std::string text = std::regex_replace(std::string(source), kLeftOut, " ");
  std::vector<Token> tokens;
  std::size_t line = 1;
  bool space = true;
  for (std::size_t i = 0; i < text.size();) {
    if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      line += text[i] == '\n';
      space = true;
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    if (is_of_word(text[i])) {
      while (end < text.size() && is_of_word(text[end])) ++end;
    } else if (text.compare(i, 2, "->") == 0 || text.compare(i, 2, "::") == 0) {
      ++end;
    }
    tokens.push_back({text.substr(i, end - i), line, space});
    space = false;
    i = end;
  }
  return tokens;
}

using Tokens = std::vector<Token>;

// One past the bracket that closes the one at `at`.
std::size_t closed(const Tokens& tokens, std::size_t at) {
  std::size_t depth = 0;
  for (; at < tokens.size(); ++at) {
    const char c = tokens[at].text.front();
    if (tokens[at].text.size() > 1) continue;
    if (c == '(' || c == '[' || c == '{') ++depth;
    if ((c == ')' || c == ']' || c == '}') && --depth == 0) return at + 1;
  }
  return at;
}

// One past what a name that is declared before `at` is known in: the rest of its block, or what a for loop repeats.
std::size_t end_of_scope(const Tokens& tokens, std::size_t at, bool of_loop) {
  for (std::size_t depth = 0; at < tokens.size(); ++at) {
    const std::string& text = tokens[at].text;
    if (text == "(" || text == "{") ++depth;
    if (text != ")" && text != "}") continue;
    if (depth-- > 0) continue;
    if (!of_loop) return at;
    const std::size_t body = at + 1;
    if (body < tokens.size() && tokens[body].text == "{") return closed(tokens, body);
    while (at < tokens.size() && tokens[at].text != ";") ++at;
    return at;
  }
  return at;
}

// One past the body of the lambda whose captures end before `at`; `at` if it is none.
std::size_t end_of_lambda(const Tokens& tokens, std::size_t at) {
  std::size_t body = at;
  if (body < tokens.size() && tokens[body].text == "(") body = closed(tokens, body);
  while (body < tokens.size() &&
         (tokens[body].is_word() || tokens[body].text == "->" || tokens[body].text == "::"))
    ++body;
  return body < tokens.size() && tokens[body].text == "{" ? closed(tokens, body) : at;
}

bool is_member(const Tokens& tokens, std::size_t at) {
  const std::string& before = tokens[at - 1].text;
  return before == "." || before == "->" || before == "::";
}

// As in `Type name`, `Type& name` or `List<Type> name`; not in `return name` and `a * name`.
bool is_declared(const Tokens& tokens, std::size_t at) {
  static const std::set<std::string> kNoTypes{"return", "else", "case", "throw", "new", "delete"};
  const Token& before = tokens[at - 1];
  if (!tokens[at].after_space) return false;
  if (before.is_word()) return kNoTypes.count(before.text) == 0;
  return (before.text == "&" || before.text == "*" || before.text == ">") && !before.after_space;
}

void find_in_lambda(const Tokens& tokens, std::size_t begin, std::size_t captures_end,
                    std::size_t end, const std::set<std::string>& names,
                    std::vector<CapturedBinding>& found) {
  std::set<std::string> known;  // by the lambda itself
  bool is_value = false;        // of a capture that has one of its own, outside of the lambda
  for (std::size_t i = begin + 1; i < end; ++i) {
    const std::string& text = tokens[i].text;
    if (i < captures_end) {
      if (text == "," || text == "]") is_value = false;
      if (text == "=" && tokens[i - 1].is_word()) {
        known.insert(tokens[i - 1].text);
        is_value = true;
      }
      if (is_value || tokens[i + 1].text == "=") continue;
    }
    if (names.count(text) == 0 || is_member(tokens, i)) continue;
    if (is_declared(tokens, i)) known.insert(text);
    if (known.insert(text).second) found.push_back({tokens[i].line, text});
  }
}

}  // namespace

std::vector<CapturedBinding> captured_bindings(std::string_view source) {
  const Tokens tokens = tokens_of(source);
  std::vector<CapturedBinding> found;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].text != "auto") continue;
    std::size_t at = i + 1;
    while (at < tokens.size() && tokens[at].text == "&") ++at;
    if (at == tokens.size() || tokens[at].text != "[") continue;
    const std::size_t after = closed(tokens, at);
    std::set<std::string> names;
    for (std::size_t k = at; k < after; ++k) {
      if (tokens[k].is_word()) names.insert(tokens[k].text);
    }
    if (after == tokens.size()) break;
    const std::size_t end = end_of_scope(tokens, after, tokens[after].text == ":");
    for (std::size_t k = after; k < end; ++k) {
      if (tokens[k].text != "[" || tokens[k - 1].is_word()) continue;
      if (tokens[k - 1].text == "]" || tokens[k - 1].text == ")") continue;
      if (tokens[k + 1].text == "]") continue;  // captures nothing
      const std::size_t captures = closed(tokens, k), last = end_of_lambda(tokens, captures);
      if (last > captures) find_in_lambda(tokens, k, captures, last, names, found);
    }
  }
  return found;
}

}  // namespace glassbox::test
