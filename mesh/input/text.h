// Lines, words and numbers of OBJ and MTL text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/printable.h>
#include <glassbox/base/trimmed.h>

namespace glassbox::obj {

// The text without a comment at its end. A '#' inside a word ("Material#25") does not begin a
// comment.
std::string_view without_comment(std::string_view text);

// The lines of a text, with any line endings (LF, CR LF or CR). A backslash at the end of a line
// joins the next line to it, except in a comment, where it is usually the end of a Windows path.
// The text may be in UTF-8, with or without a byte order mark, or in UTF-16, which is converted.
class Lines {
public:
  explicit Lines(std::string_view text);
  Lines(const Lines&) = delete;
  Lines& operator=(const Lines&) = delete;

  // Moves to the next line that is neither blank nor a comment; false at the end of the text.
  bool next();

  std::string_view text() const { return line_; }       // trimmed; valid until next()
  std::uint64_t number() const { return first_line_; }  // of its first line, counted from 1

private:
  std::string_view take_physical_line();

  std::string converted_;  // the whole text, if it was in UTF-16
  std::string_view rest_;
  std::string_view line_;
  std::string joined_;
  std::uint64_t first_line_ = 0;
  std::uint64_t lines_taken_ = 0;
};

// The words of one line, from left to right, up to a word that starts with '#'.
class Words {
public:
  explicit Words(std::string_view line) : rest_(trimmed(line)) {}

  // The next word; empty at the end.
  std::string_view next();
  // The text after the words taken so far, trimmed, comments included.
  std::string_view rest() const { return rest_; }

private:
  std::string_view rest_;
};

// The float nearest to a decimal number. Numbers that round to infinity, and "inf" and "nan"
// themselves, are not finite; everything else is text.
struct Number {
  enum class Kind { kFinite, kNotFinite, kText };
  Kind kind = Kind::kText;
  float value = 0;  // where finite
};
Number parse_number(std::string_view word);

std::optional<std::int64_t> parse_integer(std::string_view word);

// Warnings about what was ignored or repaired. A hostile file could cause millions: only the first
// few are kept, and the others are counted.
class Warnings {
public:
  void add(std::string text);
  std::vector<std::string> take();

private:
  static constexpr std::size_t kMaxKept = 64;
  std::vector<std::string> kept_;
  std::uint64_t dropped_ = 0;
};

// Counts the occurrences of one problem, for one warning that names the first.
class OccurrenceCount {
public:
  void add(std::uint64_t number) {
    if (count_++ == 0) first_ = number;
  }
  // Adds "<count> <one or many> (first<where> <number>)" if there were any: `one` is the text for
  // one occurrence, `many` for several.
  void report(std::string_view one, std::string_view many, Warnings& warnings,
              const char* where = " in line") const;

private:
  std::uint64_t count_ = 0;
  std::uint64_t first_ = 0;
};

}  // namespace glassbox::obj
