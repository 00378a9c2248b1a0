#include "tests/labs/framework/mutate.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <string_view>

namespace glassbox::labs {

namespace {

struct Token {
  enum class Kind { kWord, kNumber, kSymbol, kText };
  Kind kind = Kind::kSymbol;
  std::size_t begin = 0, end = 0;  // in the solution
};

bool is_word_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// The end of the token that begins at `at`, which is no space.
Token token_at(const std::string& text, std::size_t at) {
  static const std::array<std::string_view, 21> symbols{"<<=", ">>=", "<=", ">=", "==", "!=", "&&",
                                                        "||",  "+=",  "-=", "*=", "/=", "%=", "|=",
                                                        "&=",  "++",  "--", "->", "::", "<<", ">>"};
  const char c = text[at];
  std::size_t end = at + 1;
  if (c == '"' || c == '\'') {
    while (end < text.size() && text[end] != c) end += text[end] == '\\' ? 2u : 1u;
    return {Token::Kind::kText, at, end + 1};
  }
  if (std::isdigit(static_cast<unsigned char>(c)) != 0) {
    const bool is_hexadecimal = text.compare(at, 2, "0x") == 0;
    const auto is_exponent = [&](char e) { return is_hexadecimal ? e == 'p' : e == 'e'; };
    while (end < text.size() &&
           (is_word_letter(text[end]) || text[end] == '.' || text[end] == '\'' ||
            (is_exponent(text[end - 1]) && (text[end] == '-' || text[end] == '+'))))
      ++end;
    return {Token::Kind::kNumber, at, end};
  }
  if (is_word_letter(c)) {
    while (end < text.size() && is_word_letter(text[end])) ++end;
    return {Token::Kind::kWord, at, end};
  }
  for (const std::string_view symbol : symbols) {
    if (text.compare(at, symbol.size(), symbol) == 0)
      return {Token::Kind::kSymbol, at, at + symbol.size()};
  }
  return {Token::Kind::kSymbol, at, end};
}

// The tokens of the solution's own code, without comments. Markers are comments, too.
std::vector<Token> tokens_of(const std::string& text) {
  std::vector<Token> tokens;
  bool is_solution = false;
  for (std::size_t at = 0; at < text.size();) {
    if (std::isspace(static_cast<unsigned char>(text[at])) != 0) {
      ++at;
    } else if (text.compare(at, 2, "//") == 0) {
      if (text.compare(at, 17, "// BEGIN SOLUTION") == 0) is_solution = true;
      if (text.compare(at, 15, "// END SOLUTION") == 0) is_solution = false;
      at = std::min(text.find('\n', at), text.size());
    } else {
      const Token token = token_at(text, at);
      if (is_solution) tokens.push_back(token);
      at = token.end;
    }
  }
  return tokens;
}

class Mutator {
public:
  explicit Mutator(const std::string& solution)
      : solution_(solution), tokens_(tokens_of(solution)) {}

  std::vector<Mutant> all() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      change_operator(i);
      change_number(i);
      change_word(i);
      change_condition(i);
      change_statement(i);
    }
    std::stable_sort(mutants_.begin(), mutants_.end(),
                     [](const Mutant& a, const Mutant& b) { return a.line < b.line; });
    return mutants_;
  }

private:
  std::string text(std::size_t i) const {
    return i < tokens_.size()
               ? solution_.substr(tokens_[i].begin, tokens_[i].end - tokens_[i].begin)
               : "";
  }
  bool is_word(std::size_t i) const {
    return i < tokens_.size() && tokens_[i].kind == Token::Kind::kWord;
  }
  // Whether a value ends here, so that an operator behind it has two operands.
  bool ends_value(std::size_t i) const {
    const std::string last = text(i);
    return last == ")" || last == "]" ||
           (tokens_[i].kind != Token::Kind::kSymbol && last != "return");
  }
  // Operators with two operands have spaces around them; those of types have not.
  bool is_binary(std::size_t i) const {
    return i > 0 && ends_value(i - 1) && solution_[tokens_[i].begin - 1] == ' ' &&
           std::isspace(static_cast<unsigned char>(solution_[tokens_[i].end])) != 0;
  }

  void change_operator(std::size_t i) {
    static const std::map<std::string, std::vector<std::string>> binary{
        {"<", {"<=", ">"}},  {">", {">=", "<"}},  {"<=", {"<", ">="}},
        {">=", {">", "<="}}, {"==", {"!="}},      {"!=", {"=="}},
        {"+", {"-"}},        {"-", {"+"}},        {"*", {"/"}},
        {"/", {"*"}},        {"%", {"/"}},        {"<<", {">>"}},
        {">>", {"<<"}},      {"&", {"|"}},        {"|", {"&"}},
        {"&&", {"||"}},      {"||", {"&&"}},      {"+=", {"-=", "="}},
        {"-=", {"+=", "="}}, {"*=", {"/=", "="}}, {"/=", {"*=", "="}},
        {"|=", {"&=", "="}}, {"&=", {"|=", "="}}, {"?", {"|| true ?", "&& false ?"}}};
    const std::string symbol = text(i);
    if (const auto found = binary.find(symbol); found != binary.end() && is_binary(i)) {
      for (const std::string& other : found->second) replace(i, i, other);
    }
    const bool is_prefix = i == 0 || !ends_value(i - 1);
    if ((symbol == "-" || symbol == "!") && is_prefix) replace(i, i, "");
    if (symbol == "++") replace(i, i, "--");
    if (symbol == "--") replace(i, i, "++");
  }

  void change_number(std::size_t i) {
    if (tokens_[i].kind != Token::Kind::kNumber) return;
    const std::string number = text(i);
    static const std::regex whole("[0-9]+");
    if (!std::regex_match(number, whole)) {
      replace(i, i, "(2 * " + number + ")");
      replace(i, i, "0");
      return;
    }
    replace(i, i, std::to_string(std::stoull(number) + 1));
    if (number != "0") replace(i, i, std::to_string(std::stoull(number) - 1));
  }

  void change_word(std::size_t i) {
    static const std::map<std::string, std::vector<std::string>> words{
        {"true", {"false"}},
        {"false", {"true"}},
        {"double", {"float"}},
        {"float", {"double"}},
        {"int64_t", {"int32_t"}},
        {"uint64_t", {"uint32_t"}},
        {"min", {"max"}},
        {"max", {"min"}},
        {"minmax", {"make_pair"}},
        {"floor", {"ceil"}},
        {"ceil", {"floor"}},
        {"round", {"floor"}},
        {"sin", {"cos"}},
        {"cos", {"sin"}},
        {"tan", {"sin"}},
        {"abs", {""}},
        {"sqrt", {""}},
        {"hypot", {"max"}},
        {"stable_sort", {"sort"}},
        {"lower_bound", {"upper_bound"}},
        {"upper_bound", {"lower_bound"}},
        {"all_of", {"any_of"}},
        {"any_of", {"all_of"}},
        {"break", {"continue", ""}},
        {"continue", {"break", ""}},
    };
    if (!is_word(i)) return;
    const std::string word = text(i);
    if (const auto found = words.find(word); found != words.end()) {
      const bool is_std = i >= 2 && text(i - 1) == "::";
      for (const std::string& other : found->second)
        // without the name a call is its argument in parentheses
        replace(other.empty() && is_std ? i - 2 : i, i, other);
    }
    if (i > 0 && text(i - 1) == ".") {
      for (const char* other : {"x", "y", "z", "w"}) {
        if (word.size() == 1 && std::string("xyzw").find(word) != std::string::npos &&
            word != other)
          replace(i, i, other);
      }
    }
  }

  // if (CONDITION) and while (CONDITION)
  void change_condition(std::size_t i) {
    if (!is_word(i) || (text(i) != "if" && text(i) != "while") || text(i + 1) != "(") return;
    const std::size_t close = closing(i + 1);
    if (text(i) == "if") replace(i + 2, close - 1, "true");
    replace(i + 2, close - 1, "false");
  }

  // The token that closes the parenthesis, bracket or brace at token `open`.
  std::size_t closing(std::size_t open) const {
    int depth = 0;
    for (std::size_t i = open; i < tokens_.size(); ++i) {
      const std::string t = text(i);
      depth += t == "(" || t == "[" || t == "{" ? 1 : t == ")" || t == "]" || t == "}" ? -1 : 0;
      if (depth == 0) return i;
    }
    return tokens_.size();
  }

  // The semicolon of the statement that begins at token `i`; the end if it has a block.
  std::size_t semicolon(std::size_t i) const {
    for (; i < tokens_.size(); ++i) {
      const std::string t = text(i);
      if (t == ";") return i;
      if (t == "(" || t == "[" || t == "{") i = closing(i);
      if (t == "}") break;
    }
    return tokens_.size();
  }

  bool begins_statement(std::size_t i) const {
    if (i == 0) return true;
    const std::string last = text(i - 1);
    if (last == ";" || last == "{" || last == "}" || last == "else") return true;
    if (last != ")") return false;
    int depth = 0;  // of an if or a loop
    for (std::size_t k = i - 1; k > 0; --k) {
      depth += text(k) == ")" ? 1 : text(k) == "(" ? -1 : 0;
      if (depth == 0) return text(k - 1) == "if" || text(k - 1) == "for" || text(k - 1) == "while";
    }
    return false;
  }

  // Whether the statement is a declaration: a type's name is followed by another name.
  bool is_declaration(std::size_t i) const {
    while (is_word(i) && text(i + 1) == "::") i += 2;
    const std::string next = text(i + 1);
    return is_word(i + 1) || next == "<" || next == "&" || next == "*" || next == "{";
  }

  void change_statement(std::size_t i) {
    if (!begins_statement(i)) return;
    const std::size_t end = semicolon(i);
    if (end >= tokens_.size()) return;
    const std::string first = text(i);
    if (first == "return") {
      const std::string value =
          end > i + 1
              ? solution_.substr(tokens_[i + 1].begin, tokens_[end].begin - tokens_[i + 1].begin)
              : "";
      if (value != "" && value != "{}" && value != "std::nullopt") replace(i + 1, end - 1, "{}");
      return;
    }
    static const std::set<std::string> kept{"if",      "for",      "while", "case",
                                            "default", "using",    "else",  "struct",
                                            "break",   "continue", "static"};
    if (kept.count(first) == 1) return;
    const bool is_step = first == "++" || first == "--";
    if (is_step || first == "throw" || (is_word(i) && !is_declaration(i))) replace(i, end - 1, "");
  }

  // Adds the mutant in which tokens `first` to `last` are replaced.
  void replace(std::size_t first, std::size_t last, const std::string& by) {
    const std::size_t begin = tokens_[first].begin, end = tokens_[last].end;
    Mutant mutant;
    mutant.source = solution_.substr(0, begin) + by + solution_.substr(end);
    const std::size_t start = begin == 0 ? 0 : solution_.rfind('\n', begin - 1) + 1;
    const std::size_t stop = std::min(solution_.find('\n', end), solution_.size());
    mutant.line =
        1 + int(std::count(solution_.begin(), solution_.begin() + std::ptrdiff_t(begin), '\n'));
    mutant.task = task_at(begin);
    mutant.before = on_one_line(solution_.substr(start, stop - start));
    mutant.after = on_one_line(solution_.substr(start, begin - start) + by +
                               solution_.substr(end, stop - end));
    const auto is_same = [&](const Mutant& each) { return each.source == mutant.source; };
    if (std::none_of(mutants_.begin(), mutants_.end(), is_same)) mutants_.push_back(mutant);
  }

  static std::string on_one_line(const std::string& lines) {
    static const std::regex spaces("\\s+"), ends("^ | $");
    return std::regex_replace(std::regex_replace(lines, spaces, " "), ends, "");
  }

  // The first number in the last heading before a place: "// ---- task 6.4: coverage ----".
  std::string task_at(std::size_t place) const {
    const std::size_t heading = solution_.rfind("\n// ---- task", place);
    if (heading == std::string::npos) return "";
    const std::size_t number = solution_.find_first_of("0123456789", heading);
    return solution_.substr(number, solution_.find_first_not_of("0123456789.", number) - number);
  }

  const std::string& solution_;
  std::vector<Token> tokens_;
  std::vector<Mutant> mutants_;
};

}  // namespace

std::vector<Mutant> mutants_of(const std::string& solution) {
  return Mutator(solution).all();
}

}  // namespace glassbox::labs
