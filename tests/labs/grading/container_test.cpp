// Tests the Containerfile of a grader as far as it can be without a container.
#include <sstream>

#include "tests/labs/grading/grading.h"
#include "tests/support/catch.h"

namespace glassbox::test {

namespace {

struct Instruction {
  std::string word, rest;
};

// The instructions of the file, with continued lines joined.
std::vector<Instruction> instructions() {
  std::istringstream lines(read(fs::path(GLASSBOX_SOURCE_DIR) / "examples/grader/Containerfile"));
  std::vector<Instruction> found;
  std::string whole;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    whole += line;
    if (whole.ends_with('\\')) {
      whole.pop_back();
      continue;
    }
    const std::size_t blank = whole.find(' ');
    REQUIRE(blank != std::string::npos);
    found.push_back({whole.substr(0, blank), whole.substr(blank + 1)});
    whole.clear();
  }
  CHECK(whole.empty());
  return found;
}

}  // namespace

TEST_CASE("the grader's Containerfile installs the package and grades /submissions to /results") {
  const auto all = instructions();
  REQUIRE(all.size() == 4);
  CHECK(all[0].word == "FROM");
  CHECK(all[0].rest == "debian:bookworm-slim");  // Debian 12, of which the package below is

  // The name is one that cmake/package.cmake gives, and not that of the package for students.
  CHECK(all[1].word == "COPY");
  CHECK(all[1].rest == "glassbox_*-deb12_*.deb /tmp/glassbox.deb");
  const std::string made = read(fs::path(GLASSBOX_SOURCE_DIR) / "cmake/package.cmake");
  for (const char* part :
       {"set(CPACK_PACKAGE_NAME glassbox)", "CPACK_DEBIAN_FILE_NAME DEB-DEFAULT",
        "set(CPACK_DEBIAN_PACKAGE_RELEASE ${release})", "string(REPLACE \"debian\" \"deb\""})
    CHECK(made.find(part) != std::string::npos);

  CHECK(all[2].word == "RUN");
  CHECK(run_program("/bin/sh", {"-n", "-c", all[2].rest}, "/").exit_code == 0);
  CHECK(all[2].rest.find(" /tmp/glassbox.deb ") != std::string::npos);

  // The command grades a class when it is given a lab and the two folders.
  CHECK(all[3].word == "ENTRYPOINT");
  const auto words = nlohmann::json::parse(all[3].rest).get<std::vector<std::string>>();
  REQUIRE(words.size() > 2);
  CHECK(words[0] == "glassbox");
  CHECK(words[1] == "lab");
  const TestDirectory directory;
  write(directory.path / "submissions/ann/student.cpp", solution());
  std::vector<std::string> given;
  for (std::size_t i = 2; i < words.size(); ++i)
    given.push_back(words[i].starts_with('/') ? directory.path.string() + words[i] : words[i]);
  given.insert(given.end(), {"--lab", "99"});
  const Outcome outcome = grader(given, directory.path);
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(fs::exists(directory.path / "results/class.csv"));
}

}  // namespace glassbox::test
