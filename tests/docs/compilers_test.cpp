// Finds code that g++ 12 compiles and clang++ 14 of Debian 12 does not, even where no clang++ is
// installed: algorithms that return a subrange, and views (clang++ checks the concepts of a view
// before the view is a complete class); lambdas that capture the names of a structured binding. It
// also finds code that both compile, but with different numbers as the result.
#include <string>
#include <vector>

#include "tests/docs/captured_bindings.h"
#include "tests/docs/machine_numbers.h"
#include "tests/docs/tree.h"
#include "tests/docs/unordered_draws.h"
#include "tests/support/catch.h"

namespace glassbox::test {

namespace {

std::string in_words(std::size_t line) {
  return std::to_string(line);
}
std::string in_words(const CapturedBinding& each) {
  return in_words(each.line) + ": " + each.name;
}
std::string in_words(const MachineNumber& each) {
  return in_words(each.line) + ": " + each.name;
}

std::string text_of(const std::string& file) {
  std::string text;
  for (const std::string& line : lines_of(file)) text += line + "\n";
  return text;
}

// Returns "file:what" for everything that `find` finds in the sources.
template <typename Find>
std::vector<std::string> found_in_sources(Find find) {
  std::vector<std::string> found;
  for (const std::string& file : text_files()) {
    if (!file.ends_with(".cpp") && !file.ends_with(".h")) continue;
    for (const auto& each : find(text_of(file))) found.push_back(file + ":" + in_words(each));
  }
  return found;
}

std::vector<std::string> not_compiled() {
  std::vector<std::string> words{std::string("std::") + "views::"};
  for (const char* name :
       {"unique", "remove", "remove_if", "rotate", "search", "search_n", "partition",
        "stable_partition", "find_end", "equal_range", "subrange"}) {
    for (const char* next : {"(", "<"}) words.push_back(std::string("ranges::") + name + next);
  }
  return words;
}

// Whether the numbers of a source can reach a picture, or a file that other commands read.
// Experiments, extreme cases and labs compare with numbers of their own that are wider than a
// double; charts and tables of times are for people.
bool makes_pictures(const std::string& file) {
  for (const char* other : {"tests/", "study/", "labs/", "exact/"}) {
    if (file.starts_with(other)) return false;
  }
  return true;
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
  CHECK(sources > 1000);  // fewer would mean that they were not all read
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
  CHECK(found_in_sources(captured_bindings) == std::vector<std::string>());
}

TEST_CASE("random numbers that a call or an expression draws in no order are told from others") {
  const auto lines = [](const std::string& body) {
    return unordered_draws("void f(Random& random) {\n" + body + "\n}\n");
  };
  const std::vector<std::size_t> second{2}, none;
  CHECK(lines("f(random.unit(), random.unit());") == second);
  CHECK(lines("const Vector2d v(2, random.unit() * a, b + random.bits());") == second);
  CHECK(lines("f(g(random), random.unit());") == second);
  CHECK(lines("f(place(random, 1), place(random, 2));") == second);
  CHECK(lines("x = random.unit() - random.unit();") == second);
  CHECK(lines("x = g(random) * h(2, random);") == second);
  CHECK(lines("const auto some = [&] { return random.unit(); }; f(some(), some());") == second);
  CHECK(lines("while (f({random.unit(), 1}, random.unit())) ;") == second);
  CHECK(lines("Vector2d{random.unit(), random.unit()}; double x = random.unit(), y = "
              "random.unit();") == none);
  CHECK(lines("x = random.unit() < 0.5 ? random.unit() : 1 + random.unit();") == none);
  CHECK(lines("if (random.unit() < 1 && random.unit() < 2) f(random.unit());") == none);
  CHECK(lines("for (int i = random.bits(); i < 3; ++i) { f(random); } f(random);") == none);
  CHECK(lines("f(place(random, 1), random); f(random, random.unit());") == none);
  CHECK(lines("a[random.integer(0, 7)] = random.bits() >> random.integer(0, 63);") == none);
  CHECK(lines("f(random.between(0, random.unit()), 1); f(random.integer(0, 1));") == none);
  CHECK(lines("f([&] { return random.unit(); }, [&] { return random.unit(); });") == none);
  CHECK(
      lines("const auto one = [] { Random random(1); return random.unit(); }; f(one(), one());") ==
      none);
  CHECK(lines("// f(random.unit(), random.unit())") == none);
}

TEST_CASE("no two random numbers are drawn in an order that each compiler chooses for itself") {
  CHECK(found_in_sources(unordered_draws) == std::vector<std::string>());
}

TEST_CASE("numbers of which each machine has its own are told from those that IEEE 754 defines") {
  const auto names = [](const std::string& source) {
    std::string all;
    for (const MachineNumber& each : machine_numbers(source))
      all += each.name + std::to_string(each.line) + " ";
    return all;
  };
  CHECK(names("x = std::pow(2, y) +\n std::hypot(a, b);") == "pow1 hypot2 ");
  CHECK(names("long double x = 1;") == "long double1 ");
  CHECK(names("r = Eigen::AngleAxisd(a, v).matrix();") == "AngleAxisd1 ");
  CHECK(names("x = std::sqrt(2) + std::floor(y) + std::ldexp(z, 3) + std::abs(-1);").empty());
  CHECK(names("x = exact::sin(y) + multiprecision::log(z) + sum.exp(); std::exp_of(x);").empty());
  CHECK(names("// std::pow(x, y)\nconst char* text = \"std::log(x)\";").empty());
}

TEST_CASE("no picture, and no file that a command reads, has a number that is a machine's own") {
  std::vector<std::string> found = found_in_sources(machine_numbers);
  CHECK(found.size() > 100);  // fewer would mean that nothing is found: experiments have these
  std::erase_if(found, [](const std::string& each) { return !makes_pictures(each); });
  CHECK(found == std::vector<std::string>());
}

}  // namespace glassbox::test
