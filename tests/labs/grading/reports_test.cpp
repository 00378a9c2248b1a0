// Tests the reports that other services read, and the part of a compiler's output that a student
// reads.
#include "labs/grading/reports.h"

#include "labs/grading/compiler_messages.h"
#include "labs/grading/vpl.h"
#include "tests/labs/grading/grading.h"
#include "tests/labs/grading/tiny_lab.h"
#include "tests/support/catch.h"

namespace glassbox::test {

using namespace labs::grading;

namespace {

bool is_in(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("JUnit's XML and Moodle's text have the visible checks and nothing of the hidden one") {
  const TestDirectory directory;
  write(directory.path / "one/student.cpp",
        submission("return x < 0 ? 0 : 2 * x;", "return 1 / x;"));
  const Outcome outcome = grader({"grade", "one", "--one", "--lab", "99", "-o", "r.json", "--junit",
                                  "junit.xml", "--vpl", "vpl.txt"},
                                 directory.path);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const std::string xml = read(directory.path / "junit.xml"),
                    text = read(directory.path / "vpl.txt");
  CHECK(run_program("/usr/bin/xmllint", {"--noout", (directory.path / "junit.xml").string()}, "/")
            .exit_code == 0);
  CHECK(is_in(xml, "tests=\"2\" failures=\"1\" errors=\"0\""));
  CHECK(is_in(xml, "<testcase classname=\"task 99.2\" name=\"a reciprocal\"/>"));
  CHECK(is_in(xml, "<failure message=\"wrong answer\">"));
  // 3 of 4 cases of the first task's 4 points, and 3 of the second task's 6 points, half of which
  // belong to a hidden check.
  CHECK(is_in(text, "Grade :=>>85.71\n"));
  CHECK(is_in(text, "-99.1.1 twice a number: wrong answer\n>wrong answer: 3 of 4"));
  for (const std::string& each : {xml, text}) CHECK_FALSE(is_in(each, "undone"));

  write(directory.path / "one/student.cpp", "int x = ;");
  grader({"grade", "one", "--one", "--lab", "99", "-o", "r.json", "--junit", "junit.xml", "--vpl",
          "vpl.txt"},
         directory.path);
  CHECK(is_in(read(directory.path / "junit.xml"), "errors=\"1\""));
  CHECK(run_program("/usr/bin/xmllint", {"--noout", (directory.path / "junit.xml").string()}, "/")
            .exit_code == 0);
  CHECK(is_in(read(directory.path / "vpl.txt"), "Grade :=>>0.00\n"));
  CHECK(is_in(read(directory.path / "vpl.txt"), "student.cpp:1:9: error:"));
}

TEST_CASE("with --visible no file of a result has a hidden check, and its points are not counted") {
  const TestDirectory directory;
  const std::vector<std::string> words{"grade",   "one",   "--one",       "--lab",
                                       "99",      "-o",    "r.json",      "--visible",
                                       "--junit", "j.xml", "--classroom", "c.json"};
  // The hidden check would find the second one wrong.
  for (const auto& [text, points] :
       {std::pair{solution(), 7},
        {submission("return 2 * x;", "return x == -5 ? 0 : 1 / x;"), 7},
        {std::string("int x = ;"), 0}}) {
    write(directory.path / "one/student.cpp", text);
    const Outcome outcome = grader(words, directory.path);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const auto results = read_json(directory.path / "r.json");
    CHECK(total(results) == points);
    CHECK(results.at("extra_data").at("max_score") == 7);
    CHECK(results.at("tests").size() == 2);
    for (const auto& file : fs::directory_iterator(directory.path)) {
      if (file.is_regular_file()) CHECK_FALSE(is_in(read(file.path()), "undone"));
    }
  }
  // A result of all checks is not reused for one of the visible checks.
  REQUIRE(
      grader({"grade", "one", "--one", "--lab", "99", "-o", "r.json"}, directory.path).exit_code ==
      0);
  CHECK(read_json(directory.path / "r.json").at("tests").size() == 3);
  auto again = words;
  again.push_back("--resume");
  REQUIRE(grader(again, directory.path).exit_code == 0);
  CHECK(read_json(directory.path / "r.json").at("tests").size() == 2);
}

TEST_CASE("no two results of a submission go to one file") {
  const TestDirectory directory;
  write(directory.path / "one/student.cpp", solution());
  for (const char* option : {"--junit", "--classroom", "--vpl"}) {
    for (const char* file : {"r.json", "./r.json", "r.json.unfinished"}) {
      INFO(option << " " << file);
      const Outcome outcome = grader(
          {"grade", "one", "--one", "--lab", "99", "-o", "r.json", option, file}, directory.path);
      CHECK(outcome.exit_code == 2);
      CHECK(is_in(outcome.err, "two outputs would go to this file"));
      CHECK_FALSE(fs::exists(directory.path / "r.json"));
    }
  }
}

TEST_CASE("Moodle's scripts leave a program that grades and writes a grade out of the activity's") {
  const TestDirectory directory;
  write(directory.path / "student.cpp", solution());
  write(directory.path / "vpl_environment.sh", "export VPL_GRADEMAX=20\n");
  write(directory.path / "bin/glassbox",
        std::string("#!/bin/sh\nexec ") + TINY_GRADER + " \"$@\"\n");
  fs::permissions(directory.path / "bin/glassbox", fs::perms(0755));
  const auto said = [&](const std::string& script) {
    write(directory.path / "script.sh", script);
    return run_program("/bin/bash",
                       {"-c", "PATH=" + (directory.path / "bin").string() +
                                  ":$PATH; bash ./script.sh && ./vpl_execution"},
                       directory.path.string())
        .out;
  };
  const std::string evaluated = said(vpl_evaluate_script(99));
  INFO(evaluated);
  CHECK(is_in(evaluated, "Grade :=>>20.00\n"));
  const std::string run = said(vpl_run_script(99));
  INFO(run);
  CHECK(is_in(run, "99.1.1 twice a number: passed\nAll 4 cases are right."));
  CHECK_FALSE(is_in(run, "Grade"));
  // What the scripts leave where the student's program may look names no hidden check.
  for (const auto& file : fs::directory_iterator(directory.path)) {
    if (file.is_regular_file() && file.path().filename() != "student.cpp")
      CHECK_FALSE(is_in(read(file.path()), "undone"));
  }
}

TEST_CASE("an error in a header or of the linker begins with the student's line") {
  const std::string source = "#include <vector>\n\n  std::vector<void> all;\n";
  const std::string header =
      "In file included from student.cpp:1:\n/usr/include/v.h: In instantiation of 'x':\n"
      "student.cpp:3:21:   required from here\n/usr/include/v.h:10:2: error: no such thing\n";
  CHECK(student_line_first(header, source) ==
        "student.cpp:3: this line leads to the error below:\n    std::vector<void> all;\n" +
            header);
  const std::string own = "student.cpp:3:2: error: x\n/usr/include/v.h:1:1: error: y\n";
  CHECK(student_line_first(own, source) == own);
  CHECK(student_line_first("a warning\n", source) == "a warning\n");
  CHECK(
      student_line_first("ld: visible.o: undefined reference to `twice(double)'\n", "")
          .starts_with("student.cpp does not define twice(double), which is called somewhere.\n"));
}

TEST_CASE("all checks of a submission have one budget of time together") {
  const TestDirectory directory;
  write(directory.path / "one/student.cpp",
        submission("for (volatile int i = 0;; ++i) {}", "for (volatile int i = 0;; ++i) {}"));
  REQUIRE(grader({"grade", "one", "--one", "--lab", "99", "-o", "r.json", "--time-limit", "30",
                  "--total-time", "2"},
                 directory.path)
              .exit_code == 0);
  const auto results = read_json(directory.path / "r.json");
  for (const auto& test : results.at("tests")) {
    CHECK(test.at("extra_data").at("outcome") ==
          "timeout (the time limit of the whole submission is reached)");
    CHECK(test.at("score") == 0);
  }
}

TEST_CASE("a task that answers as the starter does is not written yet") {
  const TestDirectory directory;
  write(directory.path / "one/student.cpp", submission("return 2 * x;", "return 0 * x;"));
  REQUIRE(
      grader({"grade", "one", "--one", "--lab", "99", "-o", "r.json"}, directory.path).exit_code ==
      0);
  const auto results = read_json(directory.path / "r.json");
  CHECK(results.at("tests")[0].at("extra_data").at("outcome") == "passed");
  CHECK(results.at("tests")[1].at("extra_data").at("outcome") == "not written yet");
}

}  // namespace glassbox::test
