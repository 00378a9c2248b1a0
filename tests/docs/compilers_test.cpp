// What g++ 12 compiles and clang++ 14, Debian 12's, does not, so that it is found where no clang++ runs: algorithms that return a
// subrange, and views (it checks the concepts of a view before the view is a complete class); lambdas that capture the names of a
// structured binding.
#include <string>
#include <vector>

#include "tests/docs/captured_bindings.h"
#include "tests/docs/tree.h"
#include "tests/support/catch.h"

namespace glassbox::test {

namespace {

std::vector<std::string> not_compiled() {
  std::vector<std::string> words{std::string("std::") + "views::"};
  for (const char* name :
       {"unique", "remove", "remove_if", "rotate", "search", "search_n", "partition",
        "stable_partition", "find_end", "equal_range", "subrange"}) {
    for (const char* next : {"(", "<"}) words.push_back(std::string("ranges::") + name + next);
  }
  return words;
}

}  // namespace

TEST_CASE("no source uses the ranges of g++'s library that clang++ does not compile") {
  const std::vector<std::string> words = not_compiled();
  std::vector<std::string> found;
  std::size_t sources = 0;
  for (const std::string& file : text_files()) {
    if (!file.ends_with(".cpp") && !file.ends_with(".h")) continue;
    ++sources;
    const std::vector<std::string> lines = lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const std::string& word : words) {
        if (lines[i].find(word) == std::string::npos) continue;
        found.push_back(file + ":" + std::to_string(i + 1) + ": " + word);
      }
    }
  }
  CHECK(found == std::vector<std::string>());
  CHECK(sources > 1000);  // or they were not looked at
}

TEST_CASE("lambdas that capture a structured binding's names are told from those that do not") {
  const auto names = [](const std::string& body) {
    std::string all;
    for (const CapturedBinding& each : captured_bindings("void f() {\n" + body + "\n}\n"))
      all += each.name + std::to_string(each.line);
    return all;
  };
  CHECK(names("const auto& [a, b] = pair;\nuse([&] { return a; });") == "a3");
  CHECK(names("const auto [a, b] = pair;\nuse([=](int i) { return i * b; });") == "b3");
  CHECK(names("for (const auto& [a, b] : pairs)\nuse([&a] { return 1; });") == "a3");
  CHECK(names("for (const auto& [a, b] : pairs) {\nx = {.f = [=] { return a + b; }};\n}") ==
        "a3b3");
  CHECK(names("auto [a, b] = pair; use([&a = a] { return a; });").empty());
  CHECK(names("auto [a, b] = pair; use([&, a = a] { return c + a; });").empty());
  CHECK(names("auto [a, b] = pair; use([&](const T& a) { return a; });").empty());
  CHECK(names("auto [a, b] = pair; use([&] { int a = 1; return p.a + q->b + x::a; });").empty());
  CHECK(names("for (auto [a, b] : pairs) use(a); use([&] { return a; });").empty());
  CHECK(names("{ auto [a, b] = pair; } use([&] { return a; });").empty());
  CHECK(names("auto [a, b] = pair; use(table[a]); // [&] { return a; }").empty());
}

TEST_CASE("no lambda captures a structured binding, which clang++ does not compile") {
  std::vector<std::string> found;
  for (const std::string& file : text_files()) {
    if (!file.ends_with(".cpp") && !file.ends_with(".h")) continue;
    std::string source;
    for (const std::string& line : lines_of(file)) source += line + "\n";
    for (const CapturedBinding& each : captured_bindings(source))
      found.push_back(file + ":" + std::to_string(each.line) + ": " + each.name);
  }
  CHECK(found == std::vector<std::string>());
}

}  // namespace glassbox::test
