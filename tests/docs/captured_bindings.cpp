#include "tests/docs/captured_bindings.h"

#include <set>

#include "tests/docs/tokens.h"

namespace glassbox::test {

namespace {

// Returns the position after the last token at which a name declared before `at` is known: the rest
// of its block, or the statement that a for loop repeats.
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

bool is_member(const Tokens& tokens, std::size_t at) {
  const std::string& before = tokens[at - 1].text;
  return before == "." || before == "->" || before == "::";
}

// Whether a variable is declared at `at`, as in `Type name`, `Type& name` or `List<Type> name`, but
// not in `return name` and `a * name`.
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
  std::set<std::string> known;  // names that the lambda itself declares
  bool is_value = false;  // whether in the value of a capture, which is computed outside the lambda
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
