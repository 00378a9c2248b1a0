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

std::vector<labs::ZipEntry> archive(bool vary = false) {
  const auto files =
      autograder_files(tiny_labs()[0], GLASSBOX_SOURCE_DIR, {"--time-limit 2"}, vary);
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

TEST_CASE("submitters have one name in any order: their ids, or their emails") {
  const TestDirectory directory;
  const auto name_in = [&](const std::string& text) {
    write(directory.path / "m.json", text);
    const auto name = read_submitters(directory.path / "m.json");
    return name ? *name : "refused: " + name.error().message();
  };
  CHECK(name_in(R"({"users": [{"email": "ann@x.org", "id": 12, "name": "Ann"}]})") == "12");
  CHECK(name_in(R"({"users": [{"id": 7}, {"id": 12}]})") == "12+7");
  CHECK(name_in(R"({"users": [{"id": 12}, {"id": 7}]})") == "12+7");
  CHECK(name_in(R"({"users": [{"email": "bob@x.org"}, {"email": "ann@x.org"}]})") ==
        "ann@x.org+bob@x.org");
  for (const char* bad : {"", "[]", "{}", R"({"users": []})", R"({"users": 3})",
                          R"({"users": [{"name": "Ann"}]})", R"({"users": ["ann"]})"}) {
    const std::string said = name_in(bad);
    INFO(bad << ": " << said);
    CHECK(said.starts_with("refused: "));
    CHECK(said.find("m.json") != std::string::npos);
    CHECK(said.find("--name") != std::string::npos);
  }
}

TEST_CASE("with --vary run_autograder gives each student's submission its own hidden inputs") {
  const TestDirectory directory;
  unpack(directory.path, archive(true));
  fs::create_symlink(TINY_GRADER, directory.path / "source/bin/glassbox");
  // It is right for the lab's own inputs only, so the hidden check shows one of the others.
  write(directory.path / "submission/student.cpp",
        submission("return 2 * x;",
                   "const double own[] = {1, -3, 0.5, -5, -0.2, 0.015625, 64, 8, 0.125};"
                   "for (double y : own) if (x == y) return 1 / x;"
                   "return 0;"));
  const auto hidden = [&](const std::string& metadata) {
    fs::remove(directory.path / "submission_metadata.json");
    if (!metadata.empty()) write(directory.path / "submission_metadata.json", metadata);
    const Outcome outcome = run_autograder(directory.path);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 0);
    CHECK((outcome.err.find("get the same hidden inputs") != std::string::npos) ==
          metadata.empty());
    return read_json(directory.path / "results/results.json").at("tests")[2].dump();
  };
  const std::string ann = hidden(R"({"id": 1, "users": [{"id": 12, "email": "ann@x.org"}]})");
  CHECK(hidden(R"({"id": 2, "users": [{"id": 12, "email": "ann@x.org"}]})") == ann);
  CHECK(hidden(R"({"id": 3, "users": [{"id": 13, "email": "bob@x.org"}]})") != ann);
  CHECK(hidden("") != ann);
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
