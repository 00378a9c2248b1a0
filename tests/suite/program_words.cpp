#include "tests/suite/program_words.h"

#include <algorithm>
#include <cctype>
#include <regex>
#include <vector>

namespace glassbox::test {

namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t';
}

bool is_name(std::string_view word) {
  return !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("_+.-").find(char(c)) != std::string_view::npos;
  });
}

// Returns the program's name: env for "/usr/bin/env". It is empty for other paths: a file of our
// own is not a program from a package.
std::string program_of(std::string word) {
  for (const char* place : {"/bin/", "/usr/bin/"}) {
    if (word.starts_with(place)) word = word.substr(std::string_view(place).size());
  }
  return is_name(word) ? word : "";
}

const Words& of_the_shell() {
  static const Words words{".",    ":",    "[",       "break",  "case",  "cd",     "continue",
                           "done", "echo", "esac",    "eval",   "exit",  "export", "false",
                           "fi",   "for",  "getopts", "in",     "kill",  "local",  "printf",
                           "pwd",  "read", "return",  "set",    "shift", "source", "test",
                           "trap", "true", "type",    "ulimit", "umask", "unset",  "wait"};
  return words;
}

// Words of the shell after which a command still follows.
const Words& before_a_command() {
  static const Words words{"!",    "{",  "}",    "command", "do",    "elif", "else",
                           "exec", "if", "then", "time",    "until", "while"};
  return words;
}

// Programs that start another one: their first word that is not an option is a command.
const Words& that_start_another() {
  static const Words words{"env", "nice", "sudo", "xargs"};
  return words;
}

class ShellReader {
public:
  explicit ShellReader(std::string_view text) : text_(text) {}

  Words read() {
    while (at_ < text_.size()) commands('\0');
    for (const std::string& name : functions_) found_.erase(name);
    return found_;
  }

private:
  char here() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  bool next_is(std::string_view what) const { return text_.substr(at_).starts_with(what); }
  void skip_to(std::string_view end) {
    const auto found = text_.find(end, at_);
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  }

  // Reads commands up to and including `end`, or to the end of the text.
  void commands(char end) {
    expected_ = true;
    while (at_ < text_.size()) {
      const char c = here();
      if (end != '\0' && c == end) {
        ++at_;
        return;
      }
      if (c == '\n') {
        ++at_;
        skip_documents();
        expected_ = true;
      } else if (is_space(c)) {
        ++at_;
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (c == ';' || c == '|' || c == '&' || c == '(' || c == ')') {
        ++at_;
        expected_ = true;
      } else if (c == '<' || c == '>') {
        redirection();
      } else {
        word();
      }
    }
  }

  void redirection() {
    if (next_is("<<")) {
      at_ += 2;
      while (here() == '-' || is_space(here()) || here() == '\'' || here() == '"') ++at_;
      const auto from = at_;
      while (std::isalnum(static_cast<unsigned char>(here())) != 0 || here() == '_') ++at_;
      documents_.emplace_back(text_.substr(from, at_ - from));
      if (here() == '\'' || here() == '"') ++at_;
      return;
    }
    while (here() == '<' || here() == '>' || here() == '&' || here() == '|' || is_space(here()))
      ++at_;
    const bool expected = expected_;
    expected_ = false;
    if (here() != '\n') word();
    expected_ = expected;
  }

  void skip_documents() {
    for (const std::string& end : documents_) skip_to("\n" + end + "\n");
    if (!documents_.empty()) --at_;  // the newline stays to be read
    documents_.clear();
  }

  void word() {
    std::string word;
    bool plain = true;
    while (at_ < text_.size()) {
      const char c = here();
      if (c == '\n' || is_space(c) || std::string_view(";|&()<>").find(c) != std::string_view::npos)
        break;
      if (c == '\\') {
        if (next_is("\\\n")) {
          at_ += 2;
          if (word.empty()) return;
          break;
        }
        at_ += 2;
        plain = false;
      } else if (c == '\'') {
        ++at_;
        skip_to("'");
        plain = false;
      } else if (c == '"') {
        quoted();
        plain = false;
      } else if (c == '$' || c == '`') {
        expansion();
        plain = false;
      } else {
        word += c;
        ++at_;
      }
    }
    take(word, plain);
  }

  void quoted() {
    ++at_;
    while (at_ < text_.size() && here() != '"') {
      if (here() == '\\') {
        at_ += 2;
      } else if (here() == '$') {
        expansion();
      } else {
        ++at_;
      }
    }
    ++at_;
  }

  void expansion() {
    const bool expected = expected_;
    if (next_is("$((")) {
      skip_to("))");
    } else if (next_is("$(")) {
      at_ += 2;
      commands(')');
    } else if (next_is("${")) {
      int depth = 0;
      do {
        depth += here() == '{' ? 1 : here() == '}' ? -1 : 0;
        ++at_;
      } while (at_ < text_.size() && (depth > 0 || text_[at_ - 1] == '$'));
    } else if (here() == '`') {
      ++at_;
      commands('`');
    } else {
      ++at_;
    }
    expected_ = expected;
  }

  void take(const std::string& word, bool plain) {
    if (next_is("()")) {
      functions_.insert(word);
      return;
    }
    if (word == "-exec") {
      expected_ = true;
      return;
    }
    if (!expected_) return;
    static const std::regex assignment("[A-Za-z_][A-Za-z_0-9]*=.*");
    if (std::regex_match(word, assignment)) return;
    if (plain && before_a_command().contains(word)) return;
    if (word.starts_with("-")) return;  // an option of a program that starts another one
    const std::string program = program_of(word);
    expected_ = plain && that_start_another().contains(program);
    if (plain && !program.empty() && !of_the_shell().contains(program)) found_.insert(program);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool expected_ = true;                // whether a command comes next
  std::vector<std::string> documents_;  // ends of here-documents whose text begins on the next line
  Words found_, functions_;
};

// ---- C++ ----

struct Literal {
  std::string text;
  std::size_t begin, end;  // the quotes included
};

// Returns all string literals except raw ones. Escapes are undone as far as words need it.
std::vector<Literal> literals_of(std::string_view source) {
  std::vector<Literal> all;
  for (std::size_t i = 0; i < source.size(); ++i) {
    if (source.substr(i).starts_with("//")) {
      i = std::min(source.find('\n', i), source.size());
    } else if (source.substr(i).starts_with("R\"")) {
      const auto open = source.find('(', i);
      if (open == std::string_view::npos) break;
      const std::string end = ")" + std::string(source.substr(i + 2, open - i - 2)) + "\"";
      const auto close = source.find(end, open);
      if (close == std::string_view::npos) break;
      i = close + end.size() - 1;
    } else if (source[i] == '\'' && i > 0 &&
               std::isdigit(static_cast<unsigned char>(source[i - 1])) == 0) {
      i += source.substr(i + 1).starts_with("\\") ? 3u : 2u;
    } else if (source[i] == '"') {
      Literal literal{"", i, 0};
      for (++i; i < source.size() && source[i] != '"'; ++i) {
        if (source[i] == '\\') {
          ++i;
          literal.text += source[i] == 'n' ? '\n' : source[i];
        } else {
          literal.text += source[i];
        }
      }
      literal.end = i + 1;
      all.push_back(literal);
    }
  }
  return all;
}

// Returns the place after the `last` that follows or is the bracket that closes the one at `open`.
std::size_t end_of(std::string_view source, const std::vector<Literal>& literals, std::size_t open,
                   std::string_view brackets, char last) {
  int depth = 0;
  auto literal = std::ranges::lower_bound(literals, open, {}, &Literal::begin);
  for (std::size_t i = open; i < source.size(); ++i) {
    if (literal != literals.end() && literal->begin == i) {
      i = literal->end - 1;
      ++literal;
      continue;
    }
    if (source[i] == brackets[0]) ++depth;
    if (source[i] == brackets[1]) --depth;
    if (depth <= 0 && source[i] == last) return i + 1;
  }
  return source.size();
}

// Returns the literals between `from` and `to` as one text. Neighbours are joined as the compiler
// joins them; between others a word is inserted.
std::string text_within(std::string_view source, const std::vector<Literal>& literals,
                        std::size_t from, std::size_t to) {
  std::string text;
  std::size_t last = std::string_view::npos;
  for (const Literal& each : literals) {
    if (each.begin < from || each.end > to) continue;
    if (last != std::string_view::npos) {
      const std::string_view between = source.substr(last, each.begin - last);
      const bool joined =
          std::ranges::all_of(between, [](char c) { return is_space(c) || c == '\n'; });
      if (!joined) text += between.find(',') == std::string_view::npos ? "\"X\"" : " \"X\"\n";
    }
    text += each.text;
    last = each.end;
  }
  return text;
}

// Returns the literals that the variables named between `from` and `to` are initialized with.
std::string text_of_variables(const std::string& source, const std::vector<Literal>& literals,
                              std::size_t from, std::size_t to) {
  std::string text;
  static const std::regex name("[A-Za-z_][A-Za-z_0-9]*");
  const auto begin = source.begin() + std::ptrdiff_t(from),
             end = source.begin() + std::ptrdiff_t(to);
  for (std::sregex_iterator at(begin, end, name), none; at != none; ++at) {
    const std::regex made("[a-z>&*] " + at->str() + " ?[=({]");
    for (std::sregex_iterator it(source.begin(), source.end(), made); it != none; ++it) {
      const auto start = std::size_t(it->position());
      text += "\n" +
              text_within(source, literals, start, end_of(source, literals, start + 1, "{}", ';'));
    }
  }
  return text;
}

void add(Words& all, const Words& more) {
  all.insert(more.begin(), more.end());
}

void add_matches(Words& all, const std::string& source, const std::string& pattern) {
  const std::regex regex(pattern);
  for (std::sregex_iterator at(source.begin(), source.end(), regex), none; at != none; ++at) {
    const std::string program = program_of((*at)[1].str());
    if (!program.empty()) all.insert(program);
  }
}

const std::regex& system_calls() {
  static const std::regex regex(
      "(^|[^A-Za-z_.>])(::|std::)?(exec[lv]p?e?|posix_spawnp?|popen|system)\\(");
  return regex;
}

}  // namespace

Words shell_words(std::string_view script) {
  return ShellReader(script).read();
}

Words cpp_words(std::string_view text) {
  const std::string source(text);
  Words all;
  const auto literals = literals_of(source);
  static const std::regex call(
      "\\b(run_program|run_process|find_system_program|execv?p?e?|posix_spawnp?|popen|system)\\(");
  for (std::sregex_iterator at(source.begin(), source.end(), call), none; at != none; ++at) {
    const auto open = std::size_t(at->position() + at->length() - 1);
    // Arguments of the program under test are not commands.
    if ((*at)[1] == "run_program" && !std::string_view(source).substr(open + 1).starts_with("\""))
      continue;
    const std::size_t end = end_of(source, literals, open, "()", ')');
    add(all, shell_words(text_within(source, literals, open, end) +
                         text_of_variables(source, literals, open + 1, end)));
  }
  static const std::regex script("R\"sh\\(");
  for (std::sregex_iterator at(source.begin(), source.end(), script), none; at != none; ++at) {
    const auto begin = std::size_t(at->position() + at->length());
    add(all, shell_words(text.substr(begin, source.find(")sh\"", begin) - begin)));
  }
  return all;
}

Words cmake_words(std::string_view text) {
  const std::string source(text);
  Words all;
  add_matches(all, source, "COMMAND\\s+([A-Za-z][A-Za-z0-9_+.-]*)");
  add_matches(all, source, "find_program\\(\\s*\\w+\\s+NAMES\\s+([A-Za-z][A-Za-z0-9_+.-]*)");
  return all;
}

Words javascript_words(std::string_view text) {
  Words all;
  add_matches(all, std::string(text),
              "(?:spawn|exec|execFile)(?:Sync)?\\(\\s*[\"'`]([A-Za-z0-9_+./-]+)");
  add_matches(all, std::string(text), "[\"'`](/usr/bin/[A-Za-z0-9_+.-]+)[\"'`]");
  return all;
}

bool launches(std::string_view source) {
  return std::regex_search(source.begin(), source.end(), system_calls());
}

}  // namespace glassbox::test
