#include "tests/docs/tokens.h"

#include <cctype>
#include <regex>

namespace glassbox::test {

namespace {

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

}  // namespace

bool Token::is_word() const {
  return is_of_word(text.front());
}

Tokens tokens_of(std::string_view source) {
  static const std::regex kLeftOut(R"re(//[^\n]*|"(\\.|[^"\\\n])*"|'(\\.|[^'\\\n])')re");
  const std::string text = std::regex_replace(std::string(source), kLeftOut, " ");
  Tokens tokens;
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

std::size_t end_of_lambda(const Tokens& tokens, std::size_t at) {
  std::size_t body = at;
  if (body < tokens.size() && tokens[body].text == "(") body = closed(tokens, body);
  while (body < tokens.size() &&
         (tokens[body].is_word() || tokens[body].text == "->" || tokens[body].text == "::"))
    ++body;
  return body < tokens.size() && tokens[body].text == "{" ? closed(tokens, body) : at;
}

}  // namespace glassbox::test
