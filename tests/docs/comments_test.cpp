// The comments of all C++ sources: how they are written, and a sample of them for readers to judge.
#include <algorithm>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/docs/tree.h"
#include "tests/support/catch.h"
#include "tests/support/daily_share.h"

namespace glassbox::test {
namespace {

struct Comment {
  std::string place;  // "raster/coverage.h:20"
  std::string text;   // its lines, and the line of code below it or beside it
};

std::string_view without_indentation(std::string_view line) {
  const std::size_t at = line.find_first_not_of(' ');
  return at == line.npos ? std::string_view() : line.substr(at);
}

bool is_comment(std::string_view line) {
  return without_indentation(line).starts_with("//");
}

// A line that closes a namespace says nothing of its own, and neither does a section's head.
bool says_something(std::string_view line) {
  return line.find("}  // namespace") == line.npos && line.find("// ----") == line.npos;
}

std::vector<Comment> comments_of(const std::string& file) {
  std::vector<Comment> found;
  const std::vector<std::string> lines = lines_of(file);
  for (std::size_t at = 0; at < lines.size(); ++at) {
    if (lines[at].find("// ") == std::string::npos || !says_something(lines[at])) continue;
    Comment comment{file + ":" + std::to_string(at + 1), lines[at] + "\n"};
    if (is_comment(lines[at])) {
      while (at + 1 < lines.size() && is_comment(lines[at + 1])) comment.text += lines[++at] + "\n";
      if (at + 1 < lines.size()) comment.text += lines[at + 1] + "\n";
    }
    found.push_back(comment);
  }
  return found;
}

// The words of a comment's lines one after the other, without the code beside or below them.
std::string words_of(const Comment& comment) {
  std::string words;
  std::istringstream lines(comment.text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t at = line.find("// ");
    if (at != line.npos) words += (words.empty() ? "" : " ") + line.substr(at + 3);
  }
  return words;
}

// "Of an edge the triangle.": such a sentence can only be understood with the one before it.
bool has_sentence_with_of(const std::string& words) {
  if (words.starts_with("Of ")) return true;
  return std::ranges::any_of(
      std::vector<std::string>{". ", ": ", "? ", "! "},
      [&](const std::string& end) { return words.find(end + "Of ") != std::string::npos; });
}

std::vector<std::string> sources() {
  std::vector<std::string> files = text_files();
  std::erase_if(files, [](const std::string& file) {
    return !file.ends_with(".h") && !file.ends_with(".cpp");
  });
  return files;
}

}  // namespace

TEST_CASE("a line that has a comment is at most 100 columns wide") {
  std::vector<std::string> wide;
  std::size_t lines_with_comments = 0;
  for (const std::string& file : sources()) {
    // Made by tests/images/make_srgb_table.cpp.
    if (file == "images/srgb_table.h") continue;
    std::size_t number = 0;
    for (const std::string& line : lines_of(file)) {
      ++number;
      if (line.find("// ") == std::string::npos) continue;
      ++lines_with_comments;
      const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
      const auto columns = line.size() - std::size_t(std::ranges::count_if(line, continues));
      if (columns > 100) wide.push_back(file + ":" + std::to_string(number));
    }
  }
  CHECK(lines_with_comments > 10000);
  CHECK(wide == std::vector<std::string>());
}

TEST_CASE("no sentence of a comment begins with Of") {
  const std::string mark = "//";  // in pieces, so that this file has no such comment
  CHECK(has_sentence_with_of(words_of({"", mark + " Of an edge the triangle.\nint edge;\n"})));
  CHECK(has_sentence_with_of(
      words_of({"", mark + " The edge.\n" + mark + " Of a line the end.\nint edge;\n"})));
  CHECK(has_sentence_with_of(words_of({"", "int edge;  " + mark + " Of a triangle.\n"})));
  CHECK_FALSE(has_sentence_with_of(words_of({"", "int edge;  " + mark + " of a triangle\n"})));
  std::vector<std::string> found;
  for (const std::string& file : sources()) {
    for (const Comment& comment : comments_of(file)) {
      if (has_sentence_with_of(words_of(comment))) found.push_back(comment.place);
    }
  }
  CHECK(found == std::vector<std::string>());
}

// SEED=7 build/release/tests/docs/test_docs '[.sample]' prints 200 comments outside of the tests.
TEST_CASE("a sample of comments, each with the line below it", "[.sample]") {
  std::vector<Comment> all;
  for (const std::string& file : sources()) {
    if (file.starts_with("tests/")) continue;
    for (Comment& comment : comments_of(file)) all.push_back(std::move(comment));
  }
  std::mt19937_64 random(seed_of_shares());
  constexpr std::size_t kSample = 200;
  REQUIRE(all.size() > kSample);
  for (std::size_t i = 0; i < kSample; ++i) {
    std::swap(all[i], all[i + std::size_t(random() % (all.size() - i))]);
    std::cout << all[i].place << "\n" << all[i].text << "\n";
  }
}

}  // namespace glassbox::test
