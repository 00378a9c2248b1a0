#include <glassbox/images/recipe.h>

#include "tests/support/catch.h"

#include <algorithm>

#include <glassbox/images/png_text.h>

#include <glassbox/base/random.h>
#include "tests/support/run_program.h"

namespace {

using namespace glassbox;
using namespace std::string_literals;

const Recipe kDuck{"my duck.glb", {"--camera", "Main \"view\"", "--size", "64x48"}, "0.1.0"};

// Returns a word made of pieces that a shell, JSON or a line of text could misread.
std::string nasty_word(Random& random) {
  static const std::vector<std::string> kPieces{"a",
                                                "Z",
                                                "7",
                                                " ",
                                                "'",
                                                "\"",
                                                "\\",
                                                "$(x)",
                                                "`",
                                                "\n",
                                                "\t",
                                                "\r",
                                                "\x01",
                                                "\x7f",
                                                "*",
                                                "?",
                                                "~",
                                                "!",
                                                "#",
                                                "&",
                                                ";",
                                                "|",
                                                "<",
                                                ">",
                                                "(",
                                                ")",
                                                "[",
                                                "]",
                                                "{",
                                                "}",
                                                "=",
                                                "-",
                                                "--",
                                                ",",
                                                "%",
                                                "^",
                                                "\\n",
                                                "'\\''",
                                                "\xc3\xa9",
                                                "\xe2\x82\xac",
                                                "\xf0\x9f\xab\x96",
                                                "\xef\xbb\xbf"};
  std::string word;
  for (std::int64_t n = random.integer(0, 8); n > 0; --n) {
    word += kPieces[std::size_t(random.integer(0, std::int64_t(kPieces.size()) - 1))];
  }
  return word;
}

std::vector<TextEntry> text(const std::string& software, const std::string& scene,
                            const std::string& options) {
  return {{"Software", software}, {"glassbox scene", scene}, {"glassbox options", options}};
}

}  // namespace

TEST_CASE("a recipe is three entries that people can read, too") {
  CHECK(to_text(kDuck) ==
        text("glassbox 0.1.0", "my duck.glb", R"(["--camera","Main \"view\"","--size","64x48"])"));
}

TEST_CASE("a recipe comes back from a PNG, whatever is in its words") {
  const std::uint64_t seed = 29;
  CAPTURE(seed);
  Random random(seed);
  for (int round = 0; round < 500; ++round) {
    Recipe recipe{"s" + nasty_word(random), {}, "1.20.3-rc+4"};
    for (std::int64_t n = random.integer(0, 5); n > 0; --n) {
      recipe.options.push_back(nasty_word(random));
    }
    CAPTURE(round, recipe.scene, recipe.options);
    const auto entries = to_text(recipe);
    REQUIRE(recipe_of(entries) == recipe);
    const auto png = encode_png(Image<Rgba8>(1, 1), entries);
    REQUIRE(png);
    REQUIRE(recipe_of(read_png_text(*png).value()) == recipe);
  }
}

TEST_CASE("a recipe that would not come back whole is not written") {
  const auto written = [](Recipe changed) { return !to_text(changed).empty(); };
  Recipe longest = kDuck;
  longest.scene = std::string(4096, 's');
  longest.options = std::vector<std::string>(200, "word");
  longest.options[0] = std::string(4096, '"');
  CHECK(written(longest));
  CHECK(recipe_of(to_text(longest)) == longest);

  Recipe changed = longest;
  changed.options.push_back("one too many");
  CHECK_FALSE(written(changed));
  changed = longest;
  changed.options[0] += 'x';
  CHECK_FALSE(written(changed));
  changed = longest;
  changed.scene += 'x';
  CHECK_FALSE(written(changed));
  changed = longest;  // each word is short enough, but not all of them together
  std::fill(changed.options.begin(), changed.options.end(), std::string(400, 'x'));
  CHECK_FALSE(written(changed));

  for (const std::string& word : {"a\0b"s, "\xff"s, "\xc3"s, "\xed\xa0\x80"s}) {
    CAPTURE(word);
    changed = kDuck;
    changed.scene = word;
    CHECK_FALSE(written(changed));
    changed = kDuck;
    changed.options.push_back(word);
    CHECK_FALSE(written(changed));
  }
  for (const std::string& version : {""s, "1.0 beta"s, "1\n"s, std::string(41, '1'), "\xc3\xa9"s}) {
    CAPTURE(version);
    changed = kDuck;
    changed.version = version;
    CHECK_FALSE(written(changed));
  }
  changed = kDuck;
  changed.scene.clear();
  CHECK_FALSE(written(changed));
}

TEST_CASE("hostile text is no recipe") {
  REQUIRE(recipe_of(text("glassbox 1", "s", "[]")) == Recipe{"s", {}, "1"});
  for (const char* software : {"", "glassbox", "glassbox ", "glassbox  1", "Glassbox 1", "gimp 2",
                               "glassbox 1 or so", "glassbox 1\n2"}) {
    CAPTURE(software);
    CHECK_FALSE(recipe_of(text(software, "s", "[]")));
  }
  for (const std::string& options :
       {""s, "["s, "{}"s, "null"s, "\"word\""s, "[1]"s, "[null]"s, "[[]]"s, "[\"a\"]x"s,
        "[\"a\",]"s, "[\"\\u0000\"]"s, "[\"\\ud800\"]"s, "[\"\xff\"]"s, "['a']"s, "[1e99999]"s,
        std::string(60000, '['), std::string(70000, ' ') + "[]",
        "[\"" + std::string(4097, 'a') + "\"]"}) {
    CAPTURE(options.substr(0, 40), options.size());
    CHECK_FALSE(recipe_of(text("glassbox 1", "s", options)));
  }
  CHECK_FALSE(recipe_of(text("glassbox 1", "", "[]")));
  CHECK_FALSE(recipe_of(text("glassbox 1", std::string(4097, 's'), "[]")));
  CHECK_FALSE(recipe_of({}));

  const auto whole = to_text(kDuck);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    auto missing = whole, twice = whole;
    missing.erase(missing.begin() + std::ptrdiff_t(i));
    twice.push_back(whole[i]);  // two values for one key are ambiguous
    CAPTURE(whole[i].first);
    CHECK_FALSE(recipe_of(missing));
    CHECK_FALSE(recipe_of(twice));
  }
}

TEST_CASE("words are quoted only where a shell needs it") {
  CHECK(shell_quoted("teapot") == "teapot");
  CHECK(shell_quoted("--size=64x48") == "--size=64x48");
  CHECK(shell_quoted("../out/a_b-c.d:e,f+g@h") == "../out/a_b-c.d:e,f+g@h");
  CHECK(shell_quoted("") == "''");
  CHECK(shell_quoted("=ls") == "'=ls'");
  CHECK(shell_quoted("two words") == "'two words'");
  CHECK(shell_quoted("it's") == "'it'\\''s'");
  CHECK(shell_quoted("~") == "'~'");
  CHECK(shell_quoted("$HOME") == "'$HOME'");
  CHECK(shell_quoted("\xc3\xa9t\xc3\xa9") == "'\xc3\xa9t\xc3\xa9'");
}

TEST_CASE("words that would not look like what they are, are not quoted at all") {
  for (const std::string& word :
       {"a\nb"s, "\t"s, "\x1b[31m"s, "a\0b"s, "\x7f"s, "\xc2\x9b"s /* CSI in one character */,
        "\xe2\x80\xae.png"s /* right to left */, "\xe2\x81\xa6"s, "\xe2\x80\xa8"s /* line */,
        "\xd8\x9c"s, "\xff"s, "a\xc3"s, "\xc0\xaf"s, "\xe0\x80\xaf"s, "\xf0\x80\x80\xaf"s,
        "\xf4\x90\x80\x80"s}) {
    CAPTURE(word);
    CHECK_FALSE(shell_quoted(word));
  }
}

TEST_CASE("a shell reads back every word that is quoted") {
  const std::uint64_t seed = 31;
  CAPTURE(seed);
  Random random(seed);
  std::string script = "printf '%s\\n'", expected;
  for (int round = 0; round < 2000; ++round) {
    const std::string word = nasty_word(random);
    const auto quoted = shell_quoted(word);
    const bool plain = std::none_of(word.begin(), word.end(),
                                    [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; });
    CAPTURE(round, word);
    REQUIRE(quoted.has_value() == plain);
    if (!quoted) continue;
    script += " " + *quoted;
    expected += word + "\n";
  }
  const auto outcome = test::run_program("/bin/sh", {"-c", script}, "/");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == expected);
}
