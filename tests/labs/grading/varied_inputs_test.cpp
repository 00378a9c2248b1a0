// Tests --vary: each submission's hidden checks have inputs of their own, which follow from its
// name.
#include "tests/labs/grading/grading.h"
#include "tests/support/catch.h"

using namespace glassbox::test;

namespace {

// Writes a class whose 1/(1/x) in the hidden check is right for the lab's own inputs and wrong for
// most others, so that the report shows one of those.
void make_class(const TestDirectory& directory) {
  const std::string wrong =
      submission("return 2 * x;",
                 "const double own[] = {1, -3, 0.5, -5, -0.2, 0.015625, 64, 8, 0.125};"
                 "for (double y : own) if (x == y) return 1 / x;"
                 "return 0;");
  for (const char* name : {"ann", "bob"})
    write(directory.path / "class" / name / "student.cpp", wrong);
  write(directory.path / "class/eve.cpp", solution());
}

nlohmann::json tests_of(const TestDirectory& directory, const std::string& results) {
  return read_json(directory.path / results / "results.json").at("tests");
}

}  // namespace

TEST_CASE(
    "two names have different hidden inputs, one name the same whenever and however (--vary)") {
  const TestDirectory directory;
  make_class(directory);
  const auto grade = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "grade");
    const auto outcome = grader(words, directory.path);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
  };
  grade({"class", "-o", "plain", "--lab", "99"});
  grade({"class", "-o", "one", "--lab", "99", "--vary", "--jobs", "1"});
  grade({"class", "-o", "two", "--lab", "99", "--vary", "--jobs", "3"});
  CHECK(tests_of(directory, "plain/ann") == tests_of(directory, "plain/bob"));
  CHECK(tests_of(directory, "one/ann") != tests_of(directory, "one/bob"));
  CHECK(tests_of(directory, "one/ann") != tests_of(directory, "plain/ann"));
  for (const char* file :
       {"ann/results.json", "bob/results.json", "eve/results.json", "class.csv", "index.html"})
    CHECK(read(directory.path / "one" / file) == read(directory.path / "two" / file));
  CHECK(total(read_json(directory.path / "one/eve/results.json")) == 10);

  // What students can see is the same for all of them: the results that lab check shows.
  const auto visible = [&](const std::string& results) {
    auto shown = nlohmann::json::array();
    for (const auto& test : tests_of(directory, results)) {
      if (test.at("visibility") == "visible") shown.push_back(test);
    }
    return shown;
  };
  CHECK(visible("one/ann").size() == 2);
  CHECK(visible("one/ann") == visible("plain/bob"));

  // Graded one by one, a submission has the same result.
  grade({"class/bob/", "--one", "-o", "bob.json", "--lab", "99", "--vary"});
  CHECK(read_json(directory.path / "bob.json") ==
        read_json(directory.path / "one/bob/results.json"));
  grade({"class/bob", "--one", "-o", "ann.json", "--lab", "99", "--vary", "--name", "ann"});
  CHECK(read_json(directory.path / "ann.json").at("tests") == tests_of(directory, "one/ann"));
  grade({"class/eve.cpp", "--one", "-o", "eve.json", "--lab", "99", "--vary"});
  CHECK(read_json(directory.path / "eve.json") ==
        read_json(directory.path / "one/eve/results.json"));

  // With --resume, a result for other inputs is not reused.
  grade({"class", "-o", "plain", "--lab", "99", "--vary", "--resume"});
  CHECK(read(directory.path / "plain/ann/results.json") ==
        read(directory.path / "one/ann/results.json"));
}
