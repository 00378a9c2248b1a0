// Checks that docs/references.md explains every code that is cited, and no others.
#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/docs/tree.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

const char* const kPage = "docs/references.md";

// Tests use these codes because no such cases exist; the last one is another project's number that
// looks like an erratum.
const std::vector<std::string> kNoCodes{"C-0", "C-00", "C-999", "E402"};

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
bool is_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::size_t digits_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end - at;
}

// Returns the code that begins at this place, such as S3-11, S4.18, E12, C-38, D-4, B.1 and F.4
// with any number of digits, or an empty text.
std::string code_at(std::string_view text, std::size_t at) {
  const std::string_view no_boundary = "._-/#&%";
  const auto is_any_of = [](char c, std::string_view list) { return list.find(c) != list.npos; };
  if (at > 0 && (is_word(text[at - 1]) || is_any_of(text[at - 1], no_boundary))) return {};
  std::size_t end = at + 1;
  const auto number = [&] {
    const std::size_t count = digits_at(text, end);
    end += count;
    return count > 0;
  };
  const auto separated = [&](std::string_view separators) {
    if (end >= text.size() || !is_any_of(text[end], separators)) return false;
    ++end;
    return number();
  };
  bool is_code = false;
  switch (text[at]) {
    case 'S':
      is_code = number() && separated("-._");
      break;
    case 'E':
      is_code = number() && end - at <= 4;
      break;
    case 'C':
    case 'D':
      is_code = separated("-._");
      break;
    case 'B':
    case 'F':
      is_code = separated("-.");
      break;
    default:
      break;
  }
  if (!is_code || (end < text.size() && is_word(text[end]))) return {};
  return std::string(text.substr(at, end - at));
}

std::vector<std::string> codes_in(std::string_view text) {
  std::vector<std::string> codes;
  for (std::size_t at = text.find_first_of("SECDBF"); at < text.size();
       at = text.find_first_of("SECDBF", at + 1)) {
    if (std::string code = code_at(text, at); !code.empty()) codes.push_back(std::move(code));
  }
  return codes;
}

// Splits a code into its group and its number: "C-" and 80 for "C-80".
std::pair<std::string, int> parts_of(const std::string& code) {
  const std::size_t number = code.find_last_not_of("0123456789") + 1;
  return {code.substr(0, number), std::stoi(code.substr(number))};
}

// A row of the table: one code, or "C-80 to C-86".
struct Entry {
  std::string first, last;
  bool kept = false;
  bool explains(const std::string& code) const {
    if (code == first || code == last) return true;
    const auto [group, number] = parts_of(code);
    const auto [group_first, from] = parts_of(first);
    return first != last && group == group_first && number > from && number < parts_of(last).second;
  }
};

std::optional<Entry> entry_in(const std::string& line) {
  if (!line.starts_with("| ")) return std::nullopt;
  const std::string cell = line.substr(2, line.find(" |", 2) - 2);
  const std::vector<std::string> codes = codes_in(cell);
  if (codes.empty()) return std::nullopt;
  const bool range = codes.size() == 2 && cell == codes[0] + " to " + codes[1];
  if (!range && cell != codes.front()) return std::nullopt;
  return Entry{codes.front(), codes.back(), line.find("*(kept)*") != std::string::npos};
}

std::vector<Entry> entries() {
  std::vector<Entry> all;
  for (const std::string& line : lines_of(kPage)) {
    if (const auto entry = entry_in(line)) all.push_back(*entry);
  }
  return all;
}

// Returns the first place where each code is cited.
std::map<std::string, std::string> citations() {
  std::map<std::string, std::string> cited;
  for (const std::string& file : text_files()) {
    if (file == kPage || file == "tests/docs/references_test.cpp") continue;
    int number = 0;
    for (const std::string& line : lines_of(file)) {
      ++number;
      for (const std::string& code : codes_in(line)) {
        // This page says what is on each slide.
        if (file == "docs/slides.md" && code.starts_with('S') && code[2] == '.') continue;
        cited.emplace(code, file + ":" + std::to_string(number) + ": " + line);
      }
    }
  }
  return cited;
}

bool is_explained(const std::vector<Entry>& all, const std::string& code) {
  return std::ranges::any_of(all, [&](const Entry& entry) { return entry.explains(code); });
}

}  // namespace

TEST_CASE("every code that is cited is explained in docs/references.md, in the form it has there") {
  const std::vector<Entry> all = entries();
  REQUIRE(all.size() > 200);
  const auto cited = citations();
  CHECK(cited.size() > 200);
  for (const auto& [code, where] : cited) {
    if (std::ranges::count(kNoCodes, code) > 0) continue;
    CAPTURE(code, where);
    CHECK(is_explained(all, code));
  }
}

TEST_CASE(
    "every code that docs/references.md explains is cited, or marked as kept, and once there") {
  const auto cited = citations();
  std::map<std::string, int> times;
  for (const Entry& entry : entries()) {
    CAPTURE(entry.first);
    CHECK(++times[entry.first] == 1);
    const bool is_cited = std::ranges::any_of(
        cited, [&](const auto& citation) { return entry.explains(citation.first); });
    CHECK((is_cited || entry.kept));
  }
}

TEST_CASE("every part of SPEC that is cited is explained") {
  const std::string word = "SPEC ";
  std::vector<std::string> explained;
  for (const std::string& line : lines_of(kPage)) {
    if (line.starts_with("| " + word)) explained.push_back(line.substr(2, line.find(" |", 2) - 2));
  }
  CHECK(explained.size() == 5);
  for (const std::string& file : text_files()) {
    if (file == "tests/docs/references_test.cpp") continue;
    for (const std::string& line : lines_of(file)) {
      const std::size_t at = line.find(word);
      if (at == std::string::npos || !codes_in(line.substr(at + word.size())).empty()) continue;
      CAPTURE(file, line);
      const std::string part = line.substr(at);
      CHECK((part.starts_with(word + "before") ||
             std::ranges::any_of(explained, [&](const auto& e) { return part.starts_with(e); })));
    }
  }
}

TEST_CASE("codes are found where they are cited, and nothing else is taken for one") {
  using Codes = std::vector<std::string>;
  CHECK(codes_in("(S3-11, S4.18; E12) C-38: SPEC B.1, D-4 and F.4.") ==
        Codes{"S3-11", "S4.18", "E12", "C-38", "B.1", "D-4", "F.4"});
  CHECK(codes_in("S4.18-20, E3 .. E6, C-80 to C-86") == Codes{"S4.18", "E3", "E6", "C-80", "C-86"});
  CHECK(codes_in("S1 to S7, S4bf, 1E10, 0xE9, c38_edge, C++20, A-1, #D-901, ID-4, D-d").empty());
}

TEST_CASE("a code that has not the form of its table is found") {
  const std::vector<Entry> all = entries();
  for (const char* code : {"S3-11", "S4.19", "E20", "C-07", "C-83", "D-13", "B.11", "F.4"}) {
    CAPTURE(code);
    CHECK(is_explained(all, code));
  }
  for (const char* line : {"S3-9", "S3_11", "S5-01", "S3-011", "E07", "E21", "C-7", "C_38", "C-117",
                           "D-04", "D-40", "B.12", "B-1", "F.9"}) {
    CAPTURE(line);
    REQUIRE(codes_in(line).size() == 1);
    CHECK_FALSE(is_explained(all, codes_in(line).front()));
  }
}

}  // namespace glassbox::test
