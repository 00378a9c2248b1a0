#include "labs/grading/assembly.h"

#include <algorithm>
#include <cctype>

namespace glassbox::labs::grading {

namespace {

// The allowed directives, except those for call frames, which all begin with ".cfi_".
constexpr std::string_view kDirectives[] = {
    ".2byte",        ".4byte",      ".8byte",       ".align",     ".arch",        ".ascii",
    ".asciz",        ".att_syntax", ".balign",      ".bss",       ".byte",        ".comm",
    ".cpu",          ".data",       ".double",      ".file",      ".float",       ".global",
    ".globl",        ".hidden",     ".hword",       ".ident",     ".inst",        ".internal",
    ".intel_syntax", ".lcomm",      ".loc",         ".local",     ".long",        ".octa",
    ".p2align",      ".popsection", ".previous",    ".protected", ".pushsection", ".quad",
    ".section",      ".set",        ".short",       ".single",    ".size",        ".skip",
    ".sleb128",      ".space",      ".string",      ".text",      ".tlsdesccall", ".type",
    ".uleb128",      ".value",      ".variant_pcs", ".weak",      ".weakref",     ".word",
    ".xword",        ".zero"};

bool is_space(char c) {
  return c == ' ' || c == '\t';
}

// Whether a name may contain the character; bytes beyond ASCII count as letters.
bool is_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '$' ||
         static_cast<unsigned char>(c) >= 0x80;
}

bool is_directive(std::string_view word) {
  return word.starts_with(".cfi_") ||
         std::find(std::begin(kDirectives), std::end(kDirectives), word) != std::end(kDirectives);
}

class AssemblyReader {
public:
  explicit AssemblyReader(std::string_view text) : text_(text) {}

  std::optional<std::string> first_foreign_statement() {
    while (at_ < text_.size()) {
      start_ = at_;
      if (!statement()) return shown();
    }
    return std::nullopt;
  }

private:
  char here() const { return at_ < text_.size() ? text_[at_] : '\n'; }
  char next() const { return at_ + 1 < text_.size() ? text_[at_ + 1] : '\n'; }
  void skip_spaces() {
    while (is_space(here()) && at_ < text_.size()) ++at_;
  }
  std::string_view name() {
    const std::size_t from = at_;
    while (at_ < text_.size() && is_of_name(here())) ++at_;
    return text_.substr(from, at_ - from);
  }

  // Reads one statement with its separator; false if the statement is not allowed.
  bool statement() {
    skip_spaces();
    // a comment over the whole line; # begins one on AArch64 too, where it has another meaning
    // inside a line
    if (here() == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (here() != '\n' && here() != ';') {
      const std::string_view word = name();
      if (word.empty()) return false;
      skip_spaces();
      if (here() == ':') {
        ++at_;
        return true;  // a label; another statement may follow on the line
      }
      const bool assignment = here() == '=';
      if (word.starts_with('.') && !assignment && !is_directive(word)) return false;
      if (!rest()) return false;
    }
    if (at_ < text_.size()) ++at_;
    return true;
  }

  // Reads the rest of a statement up to its separator (the line's end or ';'), but not the
  // separator itself; false if it is not allowed.
  bool rest() {
    for (; here() != '\n' && here() != ';'; ++at_) {
      if (here() == '"') {
        if (!string()) return false;
      } else if (here() == '\'' || (here() == '/' && next() == '*') || is_control(here())) {
        return false;
      }
    }
    return true;
  }

  // Reads a string up to its closing quote; false if that is not in the same line.
  bool string() {
    for (++at_; here() != '"'; ++at_) {
      if (here() == '\\' && next() != '\n') {
        ++at_;
      } else if (here() == '\n') {
        return false;
      }
    }
    return true;
  }

  static bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t'; }

  std::string shown() const {
    std::string_view line = text_.substr(start_, text_.find('\n', start_) - start_);
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    return std::string(line.substr(0, 80));
  }

  std::string_view text_;
  std::size_t at_ = 0, start_ = 0;
};

}  // namespace

std::optional<std::string> foreign_statement(std::string_view assembly) {
  return AssemblyReader(assembly).first_foreign_statement();
}

}  // namespace glassbox::labs::grading
