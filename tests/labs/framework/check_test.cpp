// Tests `glassbox lab check` on code that crashes, runs away or looks around: it is named as what
// it is, and confined by the sandbox.
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "labs/framework/sources.h"
#include "tests/support/catch.h"
#include "tests/support/run_program.h"
#include "tests/support/skip.h"

using namespace glassbox;

namespace {

namespace fs = std::filesystem;

// A folder of lab 5. A line is inserted at the beginning of is_back_face(), and code before the
// function.
class Folder {
public:
  Folder() {
    fs::remove_all(path_);
    const auto outcome =
        test::run_program(GLASSBOX_PROGRAM, {"lab", "start", "5", path_.string()}, "/");
    REQUIRE(outcome.exit_code == 0);
  }
  ~Folder() { fs::remove_all(path_); }

  const fs::path& path() const { return path_; }

  // Returns the report on the check of is_back_face().
  nlohmann::json check(const std::string& line, const std::string& before,
                       const std::vector<std::string>& options = {}) const {
    const std::string solution =
        labs::solution_text(labs::find_sources().value(), "05-clipping").value();
    const std::string start =
        "bool is_back_face(const std::vector<Point<World>>& face, const Point<World>& eye) {\n";
    const std::size_t at = solution.find(start);
    REQUIRE(at != std::string::npos);
    std::string text = solution;
    text.insert(at + start.size(), line + "\n");
    text.insert(at, before + "\n");
    std::ofstream(path_ / "student.cpp") << text;
    std::vector<std::string> words{"lab",          "check", path_.string(), "--json", "-",
                                   "--time-limit", "60"};
    words.insert(words.end(), options.begin(), options.end());
    const auto outcome = test::run_program(GLASSBOX_PROGRAM, words, "/");
    INFO(outcome.err);
    const auto json = nlohmann::json::parse(outcome.out);
    for (const auto& test : json.at("tests")) {
      if (test.at("name") == "faces of solids that look away") return test;
    }
    return {};
  }

private:
  fs::path path_ = fs::temp_directory_path() / fmt::format("glassbox-check-{}", getpid());
};

std::string outcome_of(const nlohmann::json& test) {
  return test.at("first_divergence").at("outcome");
}

}  // namespace

TEST_CASE("lab check names a crash, a stack overflow, endless memory and a file that is opened") {
  const Folder folder;
  CHECK(outcome_of(folder.check("*(volatile int*)nullptr = 1;", "")) == "crash (SIGSEGV)");
  CHECK(
      outcome_of(folder.check("deep(1);",
                              "int deep(int n) { volatile char b[4096]; b[0] = 1; return deep(n + "
                              "1) + b[3]; }")) == "crash (stack overflow)");
  CHECK(outcome_of(folder.check("std::vector<Point<World>> all; for (;;) all.push_back(eye);",
                                "#include <vector>")) == "out of memory");
  const fs::path secret = folder.path() / "secret";
  std::ofstream(secret) << "the secret";
  const auto opened =
      folder.check("char text[99] = {}; if (FILE* f = std::fopen(\"" + secret.string() +
                       "\", \"r\")) { std::fgets(text, 99, f); std::puts(text); }",
                   "#include <cstdio>");
  CHECK(outcome_of(opened).starts_with("forbidden call (open"));
  CHECK(opened.dump().find("the secret") == std::string::npos);
}

TEST_CASE("lab check shows what a check printed, be it right or wrong") {
  const Folder folder;
  const auto test = folder.check("std::puts(\"hello\");", "#include <cstdio>");
  CHECK(test.at("first_divergence").is_null());
  CHECK(test.at("printed").get<std::string>().starts_with("hello\n"));
  const auto text =
      test::run_program(GLASSBOX_PROGRAM, {"lab", "check", folder.path().string()}, "/");
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("your code printed:\n      hello\n") != std::string::npos);
}

TEST_CASE("lab check --sanitize names the line of the student's file") {
  const Folder folder;
  const auto line_is = [&](const std::string& line, const std::string& kind) {
    // The report must name the line that was inserted.
    const auto test = folder.check(line, "#include <vector>", {"--sanitize"});
    const std::string named = outcome_of(test);
    INFO(test.dump(2));
    std::ifstream file(folder.path() / "student.cpp");
    int number = 0;
    for (std::string each; std::getline(file, each);) {
      ++number;
      if (each == line) break;
    }
    CHECK(named.find(kind) != std::string::npos);
    CHECK(named.find(fmt::format("student.cpp:{}, in lab_05::is_back_face", number)) !=
          std::string::npos);
  };
  line_is(
      "std::vector<double> v(3); volatile std::size_t i = 3; v.data()[i] = 1; static volatile "
      "double x; x = v.data()[i];",
      "heap-buffer-overflow");
  line_is("std::vector<double> v(3); v.reserve(9); volatile std::size_t i = 3; v[i] = 1;",
          "the standard library's assertion");
  line_is("volatile int big = 2147483647; big = big + 1;", "signed integer overflow");
  // clang++ takes a null pointer that it knows for granted; this one it must load.
  line_is("int* volatile none = nullptr; *none = 1;", "null pointer");
}

TEST_CASE("the debugger sees the variables of the failing case") {
  if (test::run_program("/bin/sh", {"-c", "command -v gdb"}, "/").exit_code != 0)
    SKIP_TEST("gdb is not installed");
  const Folder folder;
  const auto test =
      folder.check("int seven = 7; int more = seven * 6; *(volatile int*)nullptr = more;", "");
  const std::string command = test.at("first_divergence").at("debugger");
  REQUIRE(command.starts_with("gdb --args "));
  const auto outcome = test::run_program(
      "/bin/sh",
      {"-c", "gdb -nx -batch -ex run -ex 'print more' -ex 'info source' " + command.substr(4)},
      "/");
  INFO(outcome.out << outcome.err);
  CHECK(outcome.out.find("$1 = 42") != std::string::npos);
  CHECK(outcome.out.find("Located in " + (folder.path() / "student.cpp").string()) !=
        std::string::npos);
}

TEST_CASE("lab check leaves nothing hidden in a student's folder, with --hidden either") {
  const Folder folder;
  folder.check("", "", {"--hidden"});
  folder.check("return false;", "", {"--hidden"});
  folder.check("return false;", "");
  std::size_t looked_at = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
    if (!entry.is_regular_file()) continue;
    ++looked_at;
    INFO(entry.path());
    const std::string text = labs::read_text_file(entry.path()).value();
    CHECK(text.find("an eye in the face's plane") == std::string::npos);
  }
  CHECK(looked_at > 10);
  CHECK(fs::exists(folder.path() / "build/check/runner"));
}

TEST_CASE("lab check writes nothing through a link in a student's folder") {
  const Folder folder;
  const fs::path others = folder.path().string() + "-others";
  fs::remove_all(others);
  for (const char* link : {"build", "build/check", "build/check/runner"}) {
    INFO(link);
    const fs::path target = others / "check";
    fs::create_directories(target / "kit");
    std::ofstream(target / "kit/lab") << "precious";
    std::ofstream(target / "file") << "precious";
    fs::remove_all(folder.path() / "build");
    fs::create_directories((folder.path() / link).parent_path());
    const bool is_file = fs::path(link).filename() == "runner";
    const fs::path to = is_file ? target / "file" : link == std::string("build") ? others : target;
    fs::create_symlink(to, folder.path() / link);
    CHECK(folder.check("return false;", "").at("score") < 1);
    CHECK(labs::read_text_file(target / "kit/lab").value() == "precious");
    CHECK(labs::read_text_file(target / "file").value() == "precious");
    CHECK(std::distance(fs::recursive_directory_iterator(others),
                        fs::recursive_directory_iterator()) == 4);
  }
  fs::remove_all(others);
}
