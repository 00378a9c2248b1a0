// Tests which pictures a pattern or a list chooses for approval.
#include "tests/support/catch.h"

#include <cstddef>
#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include <glassbox/compare/pictures/approval.h>

namespace glassbox::test {
namespace {

std::vector<Comparison> named(const std::vector<std::string>& names) {
  std::vector<Comparison> comparisons(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) comparisons[i].name = names[i];
  return comparisons;
}

std::vector<std::string> chosen_of(const std::vector<Comparison>& comparisons,
                                   const ApprovalRequest& request) {
  std::vector<std::string> names;
  for (const std::size_t i : choose_for_approval(comparisons, request).chosen) {
    names.push_back(comparisons[i].name);
  }
  return names;
}

TEST_CASE("a pattern chooses by the whole name, or by the part behind the last /") {
  const auto all = named({"a.png", "menu/a.png", "menu/b.png", "menu/sub/c.png", "menu2/a.png"});
  using Names = std::vector<std::string>;
  CHECK(chosen_of(all, {{"a.png"}, {}}) == Names{"a.png", "menu/a.png", "menu2/a.png"});
  CHECK(chosen_of(all, {{"menu/*"}, {}}) == Names{"menu/a.png", "menu/b.png", "menu/sub/c.png"});
  CHECK(chosen_of(all, {{"menu/?.png"}, {}}) == Names{"menu/a.png", "menu/b.png"});
  CHECK(chosen_of(all, {{"[bc].png"}, {}}) == Names{"menu/b.png", "menu/sub/c.png"});
  CHECK(chosen_of(all, {{"*"}, {}}).size() == all.size());
  CHECK(chosen_of(all, {{"c.png", "b.png"}, {"a.png"}}) ==
        Names{"a.png", "menu/b.png", "menu/sub/c.png"});
}

TEST_CASE("what chooses nothing is named, and the rest is chosen") {
  const auto all = named({"a.png", "b.png"});
  const ApprovalChoice choice = choose_for_approval(all, {{"x*", "b*"}, {"a.png", "A.png"}});
  CHECK(choice.chosen == std::vector<std::size_t>{0, 1});
  CHECK(choice.unknown == std::vector<std::string>{"no picture's name matches 'x*'",
                                                   "no picture has the name 'A.png'"});
}

TEST_CASE("a list has a name a line, as editors on all systems write it") {
  const auto names = parse_approval_list(
      "\xef\xbb\xbf# glassbox diff --approve-list\r\na b.png\r\n\r\n./#1.png\n c");
  REQUIRE(names);
  CHECK(*names == std::vector<std::string>{"a b.png", "#1.png", " c"});
  for (const char* nothing : {"", "\n\n", "# only a comment\n"})
    CHECK(!parse_approval_list(nothing));
}

TEST_CASE("a list of random names chooses just these") {
  Random random(64);
  for (int round = 0; round < 300; ++round) {
    INFO("seed 64, round " << round);
    std::vector<std::string> names, wanted;
    std::string list = "# names\n";
    for (int i = 0; i < 12; ++i) {
      std::string name = (i % 3 == 0 ? "#" : i % 3 == 1 ? "./" : "") + std::to_string(i);
      for (auto length = random.integer(0, 6); length > 0; --length) {
        name += "ab*?[]\\/ #"[random.integer(0, 9)];
      }
      names.push_back(name);
      if (random.integer(0, 1) == 0) continue;
      wanted.push_back(name);
      // Only these names need something before them.
      list += (name.starts_with('#') || name.starts_with("./") ? "./" : "") + name + "\n";
    }
    const auto parsed = parse_approval_list(list);
    REQUIRE(parsed.has_value() == !wanted.empty());
    if (parsed) CHECK(chosen_of(named(names), {{}, *parsed}) == wanted);
  }
}

}  // namespace
}  // namespace glassbox::test
