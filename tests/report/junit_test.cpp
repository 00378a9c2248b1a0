// JUnit's XML: well-formed for all names, with correct counts.
#include "tests/support/catch.h"

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include "tests/images/temporary_directory.h"
#include "tests/report/comparisons.h"
#include "tests/report/xml.h"
#include "tests/support/skip.h"

#include <glassbox/compare/report/junit.h>

namespace glassbox::test {
namespace {

Element parsed(const std::string& xml) {
  INFO(xml);
  Element root;
  REQUIRE_NOTHROW(root = XmlReader(xml).document());
  return root;
}

Element suite_of(const std::string& name, const std::vector<Comparison>& comparisons) {
  const Element root = parsed(junit_report(name, comparisons));
  CHECK(root.name == "testsuites");
  REQUIRE(root.children.size() == 1);
  CHECK(root.children[0].name == "testsuite");
  return root.children[0];
}

TEST_CASE("a suite has a case for each picture and counts what fails") {
  const std::vector<Comparison> all{comparison("a", Verdict::kSame),
                                    comparison("b", Verdict::kWithinTolerance),
                                    different("c"),
                                    without_test("d"),
                                    without_reference("e"),
                                    broken("f"),
                                    broken("g")};
  const Element suite = suite_of("golden", all);
  CHECK(suite.attributes == std::map<std::string, std::string>{{"name", "golden"},
                                                               {"tests", "7"},
                                                               {"failures", "3"},
                                                               {"errors", "2"},
                                                               {"time", "0.000"}});
  REQUIRE(suite.children.size() == 7);
  const std::vector<std::string> kinds{"", "", "failure", "failure", "failure", "error", "error"};
  for (std::size_t i = 0; i < 7; ++i) {
    const Element& one = suite.children[i];
    INFO(i);
    CHECK(one.name == "testcase");
    CHECK(one.attributes.at("classname") == "golden");
    CHECK(one.attributes.at("name") == all[i].name);
    REQUIRE(one.children.size() == (kinds[i].empty() ? 0 : 1));
    if (kinds[i].empty()) continue;
    CHECK(one.children[0].name == kinds[i]);
    CHECK(one.children[0].attributes.at("message").find(all[i].name + ": ") == 0);
  }
}

TEST_CASE("a failure says what a person would read") {
  Comparison one = different("c");
  one.hints = {"a hint"};
  const Element failure = suite_of("golden", {one}).children[0].children[0];
  CHECK(failure.attributes.at("message") == "c: different: 3 of 32 pixels differ");
  CHECK(failure.text == "  likely: a hint\n");
}

TEST_CASE("a case has its time, and the suite their sum") {
  Comparison one = comparison("a", Verdict::kSame), two = different("b");
  one.seconds = 0.25;
  two.seconds = 1.5;
  const Element suite = suite_of("golden", {one, two});
  CHECK(suite.attributes.at("time") == "1.750");
  CHECK(suite.children[0].attributes.at("time") == "0.250");
  CHECK(suite.children[1].attributes.at("time") == "1.500");
}

TEST_CASE("no pictures are a suite of none") {
  const Element suite = suite_of("golden", {});
  CHECK(suite.attributes.at("tests") == "0");
  CHECK(suite.children.empty());
}

// A name, and how it is written: characters that XML cannot contain become U+FFFD.
const std::vector<std::pair<std::string, std::string>> kNames{
    {"a&b<c>d\"e'f", "a&b<c>d\"e'f"},
    {"]]>", "]]>"},
    {"<![CDATA[x]]>", "<![CDATA[x]]>"},
    {"--> <!-- -->", "--> <!-- -->"},
    {"&amp;&#0;", "&amp;&#0;"},
    {"a\tb\nc\rd", "a\tb\nc\rd"},
    {"a\x01\x1b\x08z", "a\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbdz"},
    {std::string("a\0z", 3), "a\xef\xbf\xbdz"},
    {"\x7f", "\x7f"},
    {"\xc3\xa4\xf0\x9f\x98\x80", "\xc3\xa4\xf0\x9f\x98\x80"},
    {"a\xffz", "a\xef\xbf\xbdz"},
    {"a\xef\xbf\xbez", "a\xef\xbf\xbdz"},  // U+FFFE
    {"a\xef\xbf\xbfz", "a\xef\xbf\xbdz"},  // U+FFFF
};

TEST_CASE("hostile names are shown as they are, or replaced where XML cannot hold them") {
  for (const auto& [name, shown] : kNames) {
    INFO(shown);
    const Element suite = suite_of(name, {comparison(name, Verdict::kSame)});
    CHECK(suite.attributes.at("name") == shown);
    CHECK(suite.children[0].attributes.at("name") == shown);
    CHECK(suite.children[0].attributes.at("classname") == shown);
  }
}

// A comparison in which all that may come from a file is `text`.
Comparison all_made_of(const std::string& text) {
  Comparison one = different(text);
  one.reasons = {text, text};
  one.hints = one.notes = {text};
  one.tolerance = one.tolerance_reason = one.inspect_command = text;
  return one;
}

TEST_CASE("random bytes in every place give well-formed XML") {
  Random random(61);
  for (int round = 0; round < 500; ++round) {
    std::string text;
    for (auto i = random.integer(0, 40); i > 0; --i) {
      text += random.integer(0, 2) == 0 ? "<>&\"']-\xef\xbf\xbe"[random.integer(0, 9)]
                                        : char(random.bits());
    }
    Comparison error = broken(text);
    error.error = Error{text, text, text, text};
    INFO("seed 61, round " << round);
    const Element suite = suite_of(text, {all_made_of(text), error});
    REQUIRE(suite.children.size() == 2);
  }
}

TEST_CASE("xmllint agrees that hostile reports are well-formed") {
  if (std::system("xmllint --version > /dev/null 2>&1") != 0)
    SKIP_TEST("xmllint (Debian: libxml2-utils) is not installed");
  const TemporaryDirectory here;
  std::vector<Comparison> all;
  for (const auto& [name, shown] : kNames) all.push_back(all_made_of(name));
  std::ofstream(here.file("report.xml"), std::ios::binary) << junit_report("suite & more", all);
  CHECK(std::system(("xmllint --noout " + here.file("report.xml")).c_str()) == 0);
}

}  // namespace
}  // namespace glassbox::test
