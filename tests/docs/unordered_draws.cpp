#include "tests/docs/unordered_draws.h"

#include <set>
#include <string>

#include "tests/docs/tokens.h"

namespace glassbox::test {

namespace {

class Reader {
public:
  explicit Reader(const Tokens& tokens) : tokens_(tokens) {}

  std::vector<std::size_t> lines() {
    read(0, tokens_.size(), false);
    return {lines_.begin(), lines_.end()};
  }

private:
  const std::string& text(std::size_t at) const {
    static const std::string kNone;
    return at < tokens_.size() ? tokens_[at].text : kNone;
  }

  bool is_lambda(std::size_t at) const {
    if (text(at) != "[") return false;
    const std::string& before = text(at - 1);
    return before != "]" && before != ")" && (before == "return" || !tokens_[at - 1].is_word());
  }

  // Whether the brace begins a block of statements or declarations, and not the parts of a value.
  bool is_block(std::size_t at) const {
    static const std::set<std::string> kBefore{")", "else", "do", "try", ";", "{", "}"};
    if (at == 0 || kBefore.count(text(at - 1)) != 0) return true;
    const std::size_t last = closed(tokens_, at) - 1;
    for (std::size_t i = at + 1; i < last; ++i) {
      if (text(i) == ";") return true;
      if (text(i) == "(" || text(i) == "[" || text(i) == "{") i = closed(tokens_, i) - 1;
    }
    std::size_t i = at - 1;
    while (i > 0 && (tokens_[i].is_word() || text(i) == "::") && text(i) != "namespace") --i;
    return text(i) == "namespace";
  }

  bool is_condition(std::size_t at) const {
    static const std::set<std::string> kBefore{"if", "while", "for", "switch", "constexpr"};
    return at > 0 && kBefore.count(text(at - 1)) != 0;
  }

  bool draws_here(std::size_t at) const {
    if (lambdas_.count(text(at)) != 0) return text(at + 1) == "(" && text(at - 1) != ".";
    return is_random(at) && text(at + 1) == ".";
  }

  bool is_random(std::size_t at) const { return text(at) == "random" || text(at) == "random_"; }

  // Whether the generator is passed as an argument: then the function draws, after its other
  // arguments have been computed.
  bool is_given(std::size_t at) const {
    const std::string &before = text(at - 1), &after = text(at + 1);
    return is_random(at) && (before == "(" || before == ",") && (after == "," || after == ")");
  }

  // Whether the token separates computations that are done one after the other.
  bool is_order(std::size_t at) const {
    static const std::set<std::string> kAlone{";", "?", ":"}, kTwice{"&", "|", "<", ">"};
    const std::string before = at > 0 ? text(at - 1) : "";
    if (text(at) == "=") return !(before == "=" || before == "!" || text(at + 1) == "=");
    const bool twice = text(at) == text(at + 1) || text(at) == before;
    return kAlone.count(text(at)) != 0 || (twice && kTwice.count(text(at)) != 0);
  }

  // Reads the tokens between brackets and returns whether they draw a number. If they are
  // `arguments` in parentheses, at most one of them may.
  bool read(std::size_t begin, std::size_t end, bool arguments) {
    bool any = false, in_argument = false, in_part = false;
    int of_arguments = 0;
    std::size_t line = begin < tokens_.size() ? tokens_[begin].line : 0;
    const auto found = [&](std::size_t at) {
      if (in_part) lines_.insert(tokens_[at].line);
      any = in_argument = in_part = true;
    };
    for (std::size_t i = begin; i < end; ++i) {
      if (text(i) == ",") {
        of_arguments += in_argument;
        in_argument = in_part = false;
      } else if (is_order(i)) {
        if (text(i) == ";") arguments = false;
        in_part = false;
      } else if (is_lambda(i)) {
        i = read_lambda(i) - 1;
      } else if (text(i) == "{" && is_block(i)) {
        in_part = false;
        any |= read(i + 1, closed(tokens_, i) - 1, false);
        i = closed(tokens_, i) - 1;
      } else if (text(i) == "(" || text(i) == "[" || text(i) == "{") {
        const std::size_t last = closed(tokens_, i) - 1;
        const bool inside = read(i + 1, last, text(i) == "(");
        // The arguments of a function that draws are computed before it draws.
        if (inside && !is_call_that_draws(i)) found(i);
        if (is_condition(i)) in_part = false;
        i = last;
      } else if (draws_here(i)) {
        found(i);
      } else if (is_given(i)) {
        any = true;
      }
    }
    if (arguments && of_arguments + in_argument > 1) lines_.insert(line);
    return any;
  }

  bool is_call_that_draws(std::size_t at) const {
    if (at < 1) return false;
    return draws_here(at - 1) || (at > 2 && text(at - 2) == "." && draws_here(at - 3));
  }

  // Returns the position after the lambda. If it draws, its name is remembered from here on.
  std::size_t read_lambda(std::size_t at) {
    const std::size_t after = closed(tokens_, at), end = end_of_lambda(tokens_, after);
    if (end == after) return after;
    const bool draws = read(after, end, false) && !declares(after, end);
    if (draws && at > 1 && text(at - 1) == "=") lambdas_.insert(text(at - 2));
    return end;
  }

  // Whether a random generator is declared within.
  bool declares(std::size_t begin, std::size_t end) const {
    for (std::size_t i = begin; i < end; ++i) {
      if (is_random(i) && tokens_[i - 1].is_word() && text(i + 1) == "(") return true;
    }
    return false;
  }

  const Tokens& tokens_;
  std::set<std::string> lambdas_;  // names of lambdas that draw
  std::set<std::size_t> lines_;
};

}  // namespace

std::vector<std::size_t> unordered_draws(std::string_view source) {
  return Reader(tokens_of(source)).lines();
}

}  // namespace glassbox::test
