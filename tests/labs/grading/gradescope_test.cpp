#include "labs/grading/autograder.h"

#include <set>
#include <sstream>

#include "tests/labs/grading/grading.h"
#include "tests/labs/grading/tiny_lab.h"
#include "tests/support/catch.h"

namespace glassbox::test {

namespace {

using namespace labs::grading;

// Makes Gradescope's folders with the unpacked archive. The tests' grader takes the place of the
// one that setup.sh builds.
void unpack(const fs::path& root, const std::vector<labs::ZipEntry>& entries) {
  for (const labs::ZipEntry& entry : entries) {
    write(root / "source" / entry.path, entry.text);
    if (entry.executable)
      fs::permissions(root / "source" / entry.path, fs::perms::owner_exec, fs::perm_options::add);
  }
  fs::copy_file(root / "source/run_autograder", root / "run_autograder");
  fs::create_directories(root / "source/bin");
  fs::create_directories(root / "submission");
  fs::create_directories(root / "results");
}

Outcome run_autograder(const fs::path& root) {
  return run_program("/usr/bin/env",
                     {"GLASSBOX_AUTOGRADER=" + root.string(), (root / "run_autograder").string()},
                     root.string());
}

std::vector<labs::ZipEntry> archive() {
  const auto files = autograder_files(tiny_labs()[0], GLASSBOX_SOURCE_DIR, {"--time-limit 2"});
  REQUIRE(files);
  const auto bytes = labs::make_zip(*files);
  REQUIRE(bytes);
  const auto entries = labs::read_zip(*bytes);
  REQUIRE(entries);
  return *entries;
}

}  // namespace

TEST_CASE(
    "autograder.zip has Gradescope's two scripts at its root and the sources that setup.sh "
    "builds") {
  bool setup = false, run = false, launcher = false;
  for (const labs::ZipEntry& entry : archive()) {
    setup = setup || (entry.path == "setup.sh" && entry.executable);
    run = run || (entry.path == "run_autograder" && entry.executable);
    launcher = launcher || entry.path == "glassbox/cmake/setup.sh";
    CHECK(entry.path.find("/.git") == std::string::npos);
  }
  CHECK(setup);
  CHECK(run);
  CHECK(launcher);
}

TEST_CASE("autograder.zip has every folder that the build of its sources enters") {
  std::set<std::string> folders;
  for (const labs::ZipEntry& entry : archive()) {
    const std::string path = entry.path;
    if (path.starts_with("glassbox/")) folders.insert(path.substr(9, path.find('/', 9) - 9));
  }
  std::istringstream lines(read(fs::path(GLASSBOX_SOURCE_DIR) / "CMakeLists.txt"));
  std::size_t entered = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string call = "add_subdirectory(";
    if (!line.starts_with(call)) continue;  // tests/ is entered on a condition
    ++entered;
    INFO(line);
    CHECK(folders.count(line.substr(call.size(), line.find(')') - call.size())) == 1);
  }
  CHECK(entered >= 10);
  CHECK(folders.count("include") == 1);
}

TEST_CASE("run_autograder grades /autograder/submission into /autograder/results/results.json") {
  const TestDirectory directory;
  unpack(directory.path, archive());
  fs::create_symlink(TINY_GRADER, directory.path / "source/bin/glassbox");
  write(directory.path / "submission/student.cpp", submission("return 2 * x;", "return 0;"));
  const Outcome outcome = run_autograder(directory.path);
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  const auto results = read_json(directory.path / "results/results.json");
  REQUIRE(results.is_object());
  CHECK(total(results) == 4);
  CHECK(results.at("tests").size() == 3);
}

TEST_CASE("run_autograder leaves a valid results.json where the program cannot even start") {
  const TestDirectory directory;
  unpack(directory.path, archive());
  write(directory.path / "submission/student.cpp", solution());
  run_autograder(directory.path);
  const auto results = read_json(directory.path / "results/results.json");
  REQUIRE(results.is_object());
  CHECK(total(results) == 0);
}

}  // namespace glassbox::test
