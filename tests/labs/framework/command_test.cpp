// Tests the labs' commands as a student uses them.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "labs/framework/strip_solution.h"
#include "labs/framework/zip.h"
#include "tests/support/catch.h"
#include "tests/support/run_program.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;

// A directory of its own, removed at the end.
struct CommandDirectory {
  fs::path path = fs::temp_directory_path() / fmt::format("glassbox-lab-command-{}", getpid());
  CommandDirectory() {
    fs::remove_all(path);
    fs::create_directories(path);
  }
  ~CommandDirectory() { fs::remove_all(path); }
  test::Outcome run(const std::vector<std::string>& words) const {
    return test::run_program(GLASSBOX_PROGRAM, words, path.string());
  }
};

// Returns the path at which the shell finds the program.
fs::path path_of(const std::string& program) {
  const auto found = test::run_program("/bin/sh", {"-c", "command -v " + program}, "/");
  INFO(program << " is not installed");
  REQUIRE(found.exit_code == 0);
  return found.out.substr(0, found.out.find('\n'));
}

std::string number_of(const Lab& lab) {
  return std::to_string(lab.number);
}

std::vector<std::byte> bytes_of(const fs::path& path) {
  const std::string text = read_text_file(path).value();
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

}  // namespace

TEST_CASE("a case's text names an extreme case of two or of three digits") {
  CHECK(extreme_case_command("two planes (C-08), one eye") ==
        "\nglassbox study extremes --case C-08");
  CHECK(extreme_case_command("in front of both (C-105)") ==
        "\nglassbox study extremes --case C-105");
  CHECK(extreme_case_command("a point") == "");
}

TEST_CASE("lab list names every lab and its tasks") {
  const CommandDirectory directory;
  const auto outcome = directory.run({"lab", "list", "--json", "-"});
  CHECK(outcome.exit_code == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  REQUIRE(json.size() == all_labs().size());
  CHECK(json[0]["tasks"].size() == all_labs()[0].tasks.size());
}

TEST_CASE(
    "lab start makes a folder whose check gives no points, and the solution put into it gives "
    "all") {
  const CommandDirectory directory;
  const Lab& lab = all_labs().front();
  REQUIRE(directory.run({"lab", "start", number_of(lab), "mine"}).exit_code == 0);
  for (const char* file :
       {"handout.md", "student.h", "student.cpp", "cases.h", "runner.cpp", "CMakeLists.txt",
        "CMakePresets.json", ".vscode/launch.json", "lab.json"})
    CHECK(fs::exists(directory.path / "mine" / file));

  auto outcome = directory.run({"lab", "check", "mine", "--json", "-", "--html", "report.html"});
  CHECK(outcome.exit_code == 1);
  auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["score"] == 0);
  CHECK(json["max_score"] > 0);
  for (const auto& test : json["tests"]) {
    CHECK(test["hidden"] == false);
    CHECK(test["first_divergence"]["stage"] == test["stage"]);
    CHECK(test["first_divergence"].contains("slips"));
  }
  const auto page = read_text_file(directory.path / "report.html");
  REQUIRE(page);
  CHECK(page->find("</html>") != std::string::npos);

  const auto solution = solution_text(find_sources().value(), lab.folder);
  std::ofstream(directory.path / "mine/student.cpp") << *solution;
  outcome = directory.run({"lab", "check", "mine"});
  INFO(outcome.out);
  CHECK(outcome.exit_code == 0);

  std::ofstream(directory.path / "mine/student.cpp") << *solution + "\nint missing_semicolon = 1\n";
  outcome = directory.run({"lab", "check", "mine", "--json", "-"});
  CHECK(outcome.exit_code == 1);
  json = nlohmann::json::parse(outcome.out);
  CHECK(json["score"] == 0);
  CHECK(json["compile_error"].get<std::string>().find("student.cpp") != std::string::npos);
  CHECK(json["tests"][0]["status"] == "not built");
}

TEST_CASE("a started folder's handout explains the codes that it cites") {
  const CommandDirectory directory;
  REQUIRE(directory.run({"lab", "start", "5", "mine"}).exit_code == 0);
  const std::string handout = read_text_file(directory.path / "mine/handout.md").value();
  CHECK(handout.find("\n| E16 | ") != std::string::npos);
  CHECK(handout.find("\n| B.1 | ") != std::string::npos);
  CHECK(handout.find("\n| B.11 | ") == std::string::npos);
  CHECK(handout.find("\n| E1 | ") == std::string::npos);
}

TEST_CASE("a started folder builds with no program but the named ones: Ninja or make") {
  const CommandDirectory directory;
  const std::string preset = GENERATE("ninja", "make");
  REQUIRE(directory.run({"lab", "start", all_labs().front().folder, "mine"}).exit_code == 0);
  // Only the programs of the packages g++ (with binutils), cmake and ninja-build or make, and a
  // shell.
  fs::create_directories(directory.path / "bin");
  for (const std::string& program : {std::string("sh"), std::string("c++"), std::string("as"),
                                     std::string("ld"), std::string("cmake"), preset})
    fs::create_symlink(path_of(program), directory.path / "bin" / program);
  // The command of docs/labs.md.
  const auto outcome = test::run_program(
      "/usr/bin/env",
      {"-u", "CMAKE_GENERATOR", "-u", "CMAKE_CXX_COMPILER_LAUNCHER", "-u", "CXX",
       "PATH=" + (directory.path / "bin").string(), "/bin/sh", "-c",
       "cmake --preset " + preset + " && cmake --build build && build/runner --list"},
      (directory.path / "mine").string());
  INFO(preset << ": " << outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find("\"check\": ") != std::string::npos);
}

TEST_CASE("the editor's task builds a started folder with what there is") {
  const CommandDirectory directory;
  REQUIRE(directory.run({"lab", "start", all_labs().front().folder, "mine"}).exit_code == 0);
  const auto tasks =
      nlohmann::json::parse(read_text_file(directory.path / "mine/.vscode/tasks.json").value());
  const std::string line = tasks["tasks"][0]["command"];
  for (const std::string program : {"ninja", "make"}) {
    // A cmake that prints its arguments.
    const fs::path bin = directory.path / program;
    fs::create_directories(bin);
    fs::create_symlink("/bin/echo", bin / "cmake");
    fs::create_symlink("/bin/echo", bin / program);
    const auto outcome =
        test::run_program("/usr/bin/env", {"PATH=" + bin.string(), "/bin/sh", "-c", line}, "/");
    CHECK(outcome.out == "--preset " + program + "\n--build build\n");
  }
}

TEST_CASE("the editor's tasks check a started folder, and draw with it where the lab draws") {
  const CommandDirectory directory;
  REQUIRE(directory.run({"lab", "start", "6", "mine"}).exit_code == 0);
  const auto tasks =
      nlohmann::json::parse(read_text_file(directory.path / "mine/.vscode/tasks.json").value());
  std::map<std::string, std::string> commands;
  for (const auto& task : tasks["tasks"]) commands[task["label"]] = task["command"];
  CHECK(commands.size() == 3);
  CHECK(commands.at("check") == "glassbox lab check .");
  std::string line = commands.at("render");
  const std::string mark = "${input:scene}";
  REQUIRE(line.find(mark) != std::string::npos);
  REQUIRE(tasks["inputs"][0]["id"] == "scene");
  const std::string scene = tasks["inputs"][0]["default"];
  line.replace(line.find(mark), mark.size(), scene);
  // The command as the editor starts it, with this program.
  fs::create_directories(directory.path / "bin");
  fs::create_symlink(GLASSBOX_PROGRAM, directory.path / "bin/glassbox");
  const auto drawn = test::run_program(
      "/usr/bin/env",
      {"PATH=" + (directory.path / "bin").string() + ":/usr/bin:/bin", "/bin/sh", "-c", line},
      (directory.path / "mine").string());
  INFO(drawn.out << drawn.err);
  // Nothing is written yet, and the picture says so.
  CHECK(drawn.exit_code == 1);
  CHECK(fs::exists(directory.path / "mine/picture.png"));
}

TEST_CASE("lab start writes over nobody's work") {
  const CommandDirectory directory;
  fs::create_directories(directory.path / "mine");
  const std::string number = number_of(all_labs().front());
  CHECK(directory.run({"lab", "start", number, "mine"}).exit_code ==
        0);  // an empty folder is accepted
  const auto again = directory.run({"lab", "start", number, "mine"});
  CHECK(again.exit_code == 2);
  CHECK(again.err.find("is not empty") != std::string::npos);
  CHECK(directory.run({"lab", "start", number, "mine/student.cpp"}).exit_code == 2);
}

TEST_CASE("wrong names are refused with what there is") {
  const CommandDirectory directory;
  const auto none = directory.run({"lab", "start", "77", "mine"});
  CHECK(none.exit_code == 2);
  CHECK(none.err.find(all_labs().front().folder) != std::string::npos);
  CHECK(none.err.starts_with("glassbox: LAB: there is no lab \"77\""));
  fs::create_directories(directory.path / "work");
  const auto other = directory.run({"lab", "check", "work", "--lab", "77"});
  CHECK(other.exit_code == 2);
  CHECK(other.err.starts_with("glassbox: --lab: there is no lab \"77\""));
  std::ofstream(directory.path / "work/lab.json") << "{\"lab\": \"77-fog\"}";
  CHECK(directory.run({"lab", "check", "work"})
            .err.starts_with("glassbox: work/lab.json: there is no"));
  CHECK(directory.run({"lab", "check", "nowhere"}).exit_code == 2);
  CHECK(directory.run({"lab", "check", "."}).exit_code == 2);
  std::ofstream(directory.path / "lab.json") << "[1, 2";
  CHECK(directory.run({"lab", "check", "."}).exit_code == 2);
  CHECK(directory.run({"lab", "export", "1", "-o", "starter.tar"}).exit_code == 2);
  CHECK(directory.run({"lab"}).exit_code == 2);
}

TEST_CASE("an exported archive has no line of a solution and no hidden check") {
  const CommandDirectory directory;
  const auto sources = find_sources().value();
  for (const Lab& lab : all_labs()) {
    INFO("lab " << lab.folder);
    const std::string zip = lab.folder + ".zip";
    const auto outcome = directory.run({"lab", "export", number_of(lab), "-o", zip});
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const auto entries = read_zip(bytes_of(directory.path / zip));
    REQUIRE(entries);
    std::string all;
    for (const ZipEntry& entry : *entries) {
      CHECK(entry.path.rfind(lab.folder + "/", 0) == 0);
      if (entry.path == lab.folder + "/student.cpp")
        CHECK(find_leaks(solution_text(sources, lab.folder).value(), entry.text).empty());
      if (entry.path == lab.folder + "/cases.h")
        CHECK(find_leaks(read_text_file(sources.labs / lab.folder / "cases.h").value(), entry.text)
                  .empty());
      CHECK(entry.text.find("// BEGIN ") == std::string::npos);
      CHECK(entry.path.find("checks.cpp") == std::string::npos);
      CHECK(entry.path.find("faults") == std::string::npos);
      all += entry.text;
    }
    for (const Check& check : lab.checks) {
      if (check.hidden) CHECK(all.find("\"" + check.name + "\"") == std::string::npos);
    }
  }
}

TEST_CASE("lab watch checks again when the file is saved") {
  const CommandDirectory directory;
  REQUIRE(directory.run({"lab", "start", number_of(all_labs().front()), "mine"}).exit_code == 0);
  const auto count = [&](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t at = text.find("Ctrl-C ends"); at != std::string::npos;
         at = text.find("Ctrl-C ends", at + 1))
      ++found;
    return found;
  };
  // The shell redirects the output to a file, which can be read while the command runs.
  const std::string command =
      fmt::format("exec '{}' lab watch mine > watched.txt", GLASSBOX_PROGRAM);
  const auto waited_for = [&](std::size_t reports) {
    for (int i = 0; i < 6000; ++i) {
      const auto text = read_text_file(directory.path / "watched.txt");
      if (text && count(*text) >= reports) return true;
      usleep(100000);
    }
    return false;
  };
  bool first = false, second = false;
  test::run_program("/bin/sh", {"-c", command}, directory.path.string(), [&](pid_t child) {
    first = waited_for(1);
    std::ofstream(directory.path / "mine/student.cpp", std::ios::app) << "// saved\n";
    second = waited_for(2);
    kill(child, SIGINT);
  });
  CHECK(first);
  CHECK(second);
}
