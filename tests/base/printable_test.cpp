// Text from a file on a line of a terminal.
#include <glassbox/base/printable.h>
#include <glassbox/base/random.h>
#include <tests/support/catch.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace glassbox {
namespace {

// Random bytes; half of them are pieces of UTF-8, so that valid and broken characters are common.
std::string random_text(Random& random) {
  static const std::string kPieces[] = {
      "a",        "\xc3\xa4",     "\xe2\x82\xac", "\xf0\x9f\x90\x91",
      "\xc2\x9b", "\xe2\x80\xae", "\xed\xa0\x80", "\xc0\x80"};
  std::string text;
  for (std::int64_t n = random.integer(0, 120); n > 0; --n) {
    if (random.integer(0, 1) == 0) {
      text += char(random.integer(0, 255));
    } else {
      text += kPieces[random.integer(0, 7)];
    }
  }
  return text;
}

TEST_CASE("any bytes become valid UTF-8 that a terminal only shows") {
  Random random(20261127);
  for (int i = 0; i < 20000; ++i) {
    const std::string text = random_text(random);
    const std::string line = printable(text);
    CHECK(line.size() <= 80 + 3);
    CHECK(printable(line, line.size()) == line);  // nothing is left to replace
    for (std::string_view rest = line; !rest.empty();) {
      const std::optional<char32_t> character = take_character(rest);
      REQUIRE(character);
      CHECK(is_shown_as_itself(*character));
    }
  }
}

TEST_CASE("exactly controls, separators and marks of direction are not shown as themselves") {
  // The ranges of Unicode technical report 36, 2.7, and of the C0 and C1 controls.
  const std::pair<char32_t, char32_t> hidden[] = {{0, 0x1f},        {0x7f, 0x9f},
                                                  {0x61c, 0x61c},   {0x200e, 0x200f},
                                                  {0x2028, 0x202e}, {0x2066, 0x2069}};
  std::vector<char32_t> wrong;
  for (char32_t c = 0; c <= 0x10ffff; ++c) {
    const bool is_hidden = std::ranges::any_of(
        hidden, [c](const auto& range) { return c >= range.first && c <= range.second; });
    if (is_shown_as_itself(c) == is_hidden) wrong.push_back(c);
  }
  CHECK(wrong == std::vector<char32_t>());
}

TEST_CASE("printable text is kept, and a long one is cut between two characters") {
  CHECK(printable("Gr\xc3\xb6\xc3\x9f"
                  "e \xf0\x9f\x90\x91") ==
        "Gr\xc3\xb6\xc3\x9f"
        "e \xf0\x9f\x90\x91");
  CHECK(printable("12345", 5) == "12345");
  CHECK(printable("123456", 5) == "12345...");
  CHECK(printable("1234\xc3\xa4", 5) == "1234...");
  CHECK(printable("1234\xc3\xa4", 6) == "1234\xc3\xa4");
}

TEST_CASE("what a terminal would obey, and what is no character, become question marks") {
  CHECK(printable("a\x1b[2Jb") == "a?[2Jb");
  CHECK(printable("a\xc2\x9b"
                  "2Jb") == "a?2Jb");
  CHECK(printable("gpj.\xe2\x80\xae"
                  "exe") == "gpj.?exe");
  CHECK(printable("\xff\xfe\x80") == "???");
  CHECK(printable("\xe2\x82") == "??");
}

}  // namespace
}  // namespace glassbox
