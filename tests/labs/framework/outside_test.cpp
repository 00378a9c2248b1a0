// A lab outside the source tree: it is made from the files that docs/labs.md shows, and graded.
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/framework/sources.h"
#include "labs/framework/strip_solution.h"
#include "tests/support/catch.h"
#include "tests/support/run_program.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;

// A directory of its own, removed at the end, with the page's lab in 40-fog.
struct OutsideLabDirectory {
  fs::path path = fs::temp_directory_path() / fmt::format("glassbox-outside-{}", getpid());
  fs::path lab = path / "40-fog";
  OutsideLabDirectory() {
    fs::remove_all(path);
    fs::create_directories(lab);
    const std::string page = read_text_file(LABS_PAGE).value();
    for (const char* name :
         {"handout.md", "student.h", "student.cpp", "cases.h", "runner.cpp", "checks.cpp"})
      write(lab / name, shown(page, name));
  }
  ~OutsideLabDirectory() { fs::remove_all(path); }
  // Returns the block that the page shows below the line "`NAME`:".
  static std::string shown(const std::string& page, const std::string& name) {
    const std::size_t named = page.find("\n`" + name + "`:\n");
    INFO(name);
    REQUIRE(named != std::string::npos);
    const std::size_t first = page.find('\n', page.find("```", named)) + 1;
    return page.substr(first, page.find("\n```", first) + 1 - first);
  }
  static void write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }
  std::string solution() const { return read_text_file(lab / "student.cpp").value(); }
  test::Outcome run(const std::vector<std::string>& words) const {
    return test::run_program(GLASSBOX_PROGRAM, words, path.string());
  }
  double total(const std::string& name) const {
    const std::string text = read_text_file(path / "results" / name / "results.json").value();
    return nlohmann::json::parse(text).at("extra_data").at("score").get<double>();
  }
};

}  // namespace

TEST_CASE("a lab of the page's small files, outside of the source tree, is graded (--lab-dir)") {
  const OutsideLabDirectory directory;
  const std::string solution = directory.solution();
  OutsideLabDirectory::write(directory.path / "class/right/student.cpp", solution);
  OutsideLabDirectory::write(directory.path / "class/fresh/student.cpp",
                             strip_solution(solution, "").value());
  std::string unclamped = solution;
  unclamped.replace(unclamped.find(", 0.0, 1.0"), 10, ", -9.0, 9.0");
  OutsideLabDirectory::write(directory.path / "class/unclamped/student.cpp", unclamped);

  const auto graded =
      directory.run({"lab", "grade", "class", "--lab-dir", "40-fog", "-o", "results"});
  INFO(graded.err);
  REQUIRE(graded.exit_code == 0);
  CHECK(directory.total("right") == 100);
  CHECK(directory.total("fresh") == 0);
  // Two of the visible check's four distances are outside start and end, and all three of the
  // hidden check's are inside.
  CHECK(directory.total("unclamped") == 75);

  // Graded one by one, with a kit and a judge that are kept.
  for (int i = 0; i < 2; ++i) {
    const auto one = directory.run({"lab", "grade", "class/right", "--one", "--lab-dir", "40-fog",
                                    "--kit", "kit", "-o", "one.json"});
    INFO(one.err);
    CHECK(one.exit_code == 0);
    CHECK(read_text_file(directory.path / "one.json").value() ==
          read_text_file(directory.path / "results/right/results.json").value());
    CHECK(std::distance(fs::directory_iterator(directory.path / "kit.judge"), {}) == 1);
  }
  // Graded again only if the judge has changed.
  const std::vector<std::string> again{"lab",    "grade", "class",   "--lab-dir",
                                       "40-fog", "-o",    "results", "--resume"};
  CHECK(directory.run(again).err.find("3 of 3 submissions already have a result") !=
        std::string::npos);
  std::string judge = read_text_file(directory.lab / "checks.cpp").value();
  judge.replace(judge.find(", 0.0, 1.0"), 10, ", -9.0, 9.0");
  OutsideLabDirectory::write(directory.lab / "checks.cpp", judge);
  REQUIRE(directory.run(again).exit_code == 0);
  CHECK(directory.total("right") == 75);
  CHECK(directory.total("unclamped") == 100);
}

TEST_CASE("a lab outside of the source tree is started and checked (--lab-dir)") {
  const OutsideLabDirectory directory;
  const auto started = directory.run({"lab", "start", "mine", "--lab-dir", "40-fog"});
  INFO(started.err);
  REQUIRE(started.exit_code == 0);
  CHECK(started.out.find("lab check mine --lab-dir 40-fog") != std::string::npos);
  const std::string handed_out = read_text_file(directory.path / "mine/cases.h").value();
  CHECK(handed_out.find("hidden") == std::string::npos);
  const auto fresh = directory.run({"lab", "check", "mine", "--lab-dir", "40-fog", "--json", "-"});
  INFO(fresh.err);
  CHECK(fresh.exit_code == 1);
  CHECK(nlohmann::json::parse(fresh.out).at("score") == 0);
  const auto whole = directory.run({"lab", "check", "40-fog", "--lab-dir", "40-fog", "--hidden"});
  CHECK(whole.exit_code == 0);
  CHECK(whole.out.find("100 of 100") != std::string::npos);
  CHECK(directory.run({"lab", "start", "3", "other", "--lab-dir", "40-fog"}).exit_code == 2);
  CHECK(directory.run({"lab", "start", "3"}).exit_code == 2);
}

TEST_CASE("what is wrong with a lab's folder is said, with exit code 2 (--lab-dir)") {
  const OutsideLabDirectory directory;
  OutsideLabDirectory::write(directory.path / "class/right/student.cpp", directory.solution());
  const auto refused = [&](const std::string& folder, const std::string& words) {
    const auto outcome =
        directory.run({"lab", "grade", "class", "--lab-dir", folder, "-o", "results"});
    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find(words) != std::string::npos);
  };
  refused("nowhere", "is not a folder");
  fs::create_directories(directory.path / "fog");
  refused("fog", "does not have the name of a lab");
  const std::string checks = read_text_file(directory.lab / "checks.cpp").value();
  const auto with = [&](const std::string& find, const std::string& replace) {
    std::string changed = checks;
    changed.replace(changed.find(find), find.size(), replace);
    OutsideLabDirectory::write(directory.lab / "checks.cpp", changed);
  };
  with("Lab lab_40()", "Lab lab_41()");
  refused("40-fog", "lab_40");
  with("expect(const FogCase& input) {", "expect(const FogCase& input) { oh");
  refused("40-fog", "checks.cpp:");
  with("\"40-fog\"", "\"40-mist\"");
  refused("40-fog", "that its folder is called \"40-mist\"");
  with(".number = 40", ".number = 41");
  refused("40-fog", "number is 41");
  with("{{\"40.1\"", "{{\"40.2\"");
  refused("40-fog", "belongs to task 40.1");
  for (const char* name : {"runner.cpp", "checks.cpp", "student.h", "handout.md"}) {
    const std::string text = read_text_file(directory.lab / name).value();
    fs::remove(directory.lab / name);
    refused("40-fog", std::string("40-fog/") + name);
    OutsideLabDirectory::write(directory.lab / name, text);
  }
}
