// Runs the recipe for pytest: as plain functions, and by pytest where it is installed.
#include <string>
#include <vector>

#include "tests/recipes/project.h"
#include "tests/support/catch.h"
#include "tests/support/skip.h"

namespace glassbox::test {
namespace {

// Goes through the life of a golden image; `run` runs the recipe's test.
void check_recipe(const Project& project, const auto& run) {
  const auto fails_with = [&](const std::vector<std::string>& texts) {
    const Outcome outcome = run();
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 1);
    for (const std::string& text : texts) CHECK(contains(outcome.out + outcome.err, text));
  };
  // A test that passes also deletes the page of an earlier failure.
  const auto passes = [&] {
    const Outcome outcome = run();
    INFO(outcome.out << outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK_FALSE(project.has("golden-failures/cube.png.html"));
  };
  project.copy("examples/image_tests");
  const std::string page = project.path("golden-failures/cube.png.html");
  fails_with({"there is no such reference", "page: " + page, "GLASSBOX_APPROVE=1"});
  CHECK(project.has("golden-failures/cube.png.html"));
  {
    const EnvironmentVariable wanted("GLASSBOX_APPROVE", "1");
    {
      const EnvironmentVariable server("CI", "true");
      fails_with({"CI is set"});
    }
    CHECK_FALSE(project.has("golden/cube.png"));
    passes();
    CHECK(project.has("golden/cube.png"));
  }
  passes();
  project.draw("teapot", "golden/cube.png");
  fails_with({"pixels differ", "page: " + page});
  project.write("golden/cube.png.fuzzy", "max-differing: 100%\nreason: a test\n");
  fails_with({"pixels differ"});  // the recipe's own tolerance replaces that of the file
}

// Runs the recipe with an option that does not exist.
Outcome with_a_slip(const Project& project) {
  return project.run("python3",
                     {"-B", "-c",
                      "from golden import assert_matches_golden\n"
                      "assert_matches_golden('golden/cube.png', 'cube.png', '--sise')\n"});
}

}  // namespace

TEST_CASE("pytest's recipe is a plain function, which fails, is approved, and passes") {
  const Project project;
  check_recipe(project, [&] {
    return project.run("python3", {"-B", "-c",
                                   "import pathlib, test_cube\n"
                                   "test_cube.test_cube(pathlib.Path('.'))\n"});
  });
  // There is no page of what glassbox diff refuses, and that of the failure before is not named.
  CHECK(project.has("golden-failures/cube.png.html"));
  const Outcome outcome = with_a_slip(project);
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(contains(outcome.err, "--sise"));
  CHECK_FALSE(contains(outcome.err, "page:"));
}

TEST_CASE("pytest's recipe does the same when pytest runs it") {
  const Project project;
  if (project.run("python3", {"-m", "pytest", "--version"}).exit_code != 0)
    SKIP_TEST("pytest is not installed");
  check_recipe(project, [&] {
    return project.run("python3", {"-B", "-m", "pytest", "-p", "no:cacheprovider", "."});
  });
}

}  // namespace glassbox::test
