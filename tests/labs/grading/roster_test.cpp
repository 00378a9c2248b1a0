// Tests --roster: the tables of a class have one row for each enrolled student, whatever came.
#include "labs/grading/roster.h"

#include <algorithm>

#include <glassbox/base/random.h>
#include <glassbox/base/utf8.h>

#include "tests/labs/grading/grading.h"
#include "tests/support/catch.h"

namespace glassbox::test {

using namespace labs::grading;

namespace {

// What a roster says: the further columns, then each student with the cells.
std::string told(const std::string& text) {
  const auto roster = parse_roster(text, "r.csv");
  if (!roster) return roster.error().message();
  std::string said;
  for (const std::string& column : roster->columns) said += "[" + column + "]";
  for (const EnrolledStudent& student : roster->students) {
    said += " " + student.submission;
    for (const std::string& cell : student.cells) said += "|" + cell;
  }
  return said;
}

bool is_told(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count_lines(const std::string& text) {
  return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("a roster is a CSV file with or without names of columns, as programs write it") {
  CHECK(told("ann\nbob\n") == " ann bob");
  CHECK(told("ann,3\nbob,4") == "[column 2] ann|3 bob|4");
  CHECK(told("name,Submission,group\nAnn Bell,ann,3\nBob,bob\n") ==
        "[name][group] ann|Ann Bell|3 bob|Bob|");
  // a mark of UTF-8, Windows' ends of lines, empty lines, blanks, semicolons and tabs
  CHECK(told("\xef\xbb\xbfsubmission;a\r\n\r\n ann ; 1,5\r\n;\r\nbob;2\r\n") ==
        "[a] ann|1,5 bob|2");
  CHECK(told("submission\ta\nann\tx y\n") == "[a] ann|x y");
  CHECK(told("\"Bell, Ann\",\"says \"\"hi\"\"\"\n") == "[column 2] Bell, Ann|says \"hi\"");
  CHECK(told("ann,\"two\nlines\"\nbob,x\n") == "[column 2] ann|two\nlines bob|x");
}

TEST_CASE("a roster that is not clear is refused with its line and what to do") {
  CHECK(told("") == told("\n ,\n"));
  CHECK(is_told(told(""), "r.csv: names nobody; write a line for each student"));
  CHECK(is_told(told("submission,a\n"), "r.csv: names nobody"));
  CHECK(is_told(told("ann\nbob\n\nann\n"), "r.csv: line 4: names 'ann', as line 1 does; remove"));
  CHECK(is_told(told("ann,1\nbob,1,2\n"), "r.csv: line 2: has 3 cells, and the first line has 2"));
  CHECK(is_told(told("a,submission\n1,ann\n2,\n"), "line 3: has no name of a submission"));
  CHECK(is_told(told("name,email\nann,a@x.org\n"), "line 1: seems to name columns"));
  CHECK(is_told(told("submission,Submission\n"), "two columns \"submission\""));
  CHECK(is_told(told("ann\n\"bob\ncid\n"), "line 2: begins a cell in quotes that does not end"));
}

TEST_CASE("bytes that are no text are refused, and no others for that reason") {
  Random random(45);
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text(std::size_t(random.integer(1, 40)), ' ');
    // Few values, so that there are separators, quotes, ends of lines and whole characters, too.
    const std::string letters = "ab,;\"\t\n\xc3\xa9\xff\x01";
    for (char& c : text)
      c = letters[std::size_t(random.integer(0, std::int64_t(letters.size()) - 1))];
    const bool is_text = is_utf8(text) && text.find('\x01') == std::string::npos;
    INFO(text);
    CHECK(is_told(told(text), "is not a text in UTF-8") == !is_text);
  }
}

TEST_CASE("with --roster class.csv and index.html have one row for each student, whatever came") {
  const TestDirectory directory;
  write(directory.path / "class/ann/student.cpp", solution());
  write(directory.path / "class/bob/student.cpp", "int x = ;");
  write(directory.path / "class/eve/student.cpp", solution());
  write(directory.path / "roster.csv",
        "name,submission,group\n\"Zoe, M.\",zoe,=1+1\nBob,bob,2\nAnn <b>,ann,1\n");
  const std::vector<std::string> words{"grade", "class",   "--lab",    "99",
                                       "-o",    "results", "--roster", "roster.csv"};
  const Outcome outcome = grader(words, directory.path);
  INFO(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(is_told(outcome.err, "no submission of 1 student on the roster:\n  zoe\n"));
  CHECK(is_told(outcome.err,
                "1 submission of nobody on the roster, without a row in the tables:\n"
                "  eve\n"));
  const std::string csv = read(directory.path / "results/class.csv");
  CHECK(csv ==
        "submission,score,max_score,outcome,task 99.1,task 99.2,name,group\r\n"
        "zoe,0,10,no submission,0,0,\"Zoe, M.\",'=1+1\r\n"
        "bob,0,10,compile error,0,0,Bob,2\r\n"
        "ann,10,10,graded,4,6,Ann <b>,1\r\n");
  const std::string page = read(directory.path / "results/index.html");
  CHECK(is_told(page,
                "2 submissions of 3 students, 1 of whom handed in nothing; on average 5 of 10"));
  CHECK(is_told(page, "name: Ann &lt;b&gt;; group: 1"));
  CHECK(is_told(page, "No submission."));
  CHECK_FALSE(is_told(page, "<b>eve</b>"));
  // The result of a submission of nobody is there, for a roster that is corrected later.
  CHECK(total(read_json(directory.path / "results/eve/results.json")) == 10);

  // lab collect makes the same tables of the results alone.
  fs::remove(directory.path / "results/class.csv");
  fs::remove(directory.path / "results/index.html");
  CHECK(grader({"collect", "results", "--roster", "roster.csv"}, directory.path).exit_code == 1);
  CHECK(read(directory.path / "results/class.csv") == csv);
  CHECK(read(directory.path / "results/index.html") == page);

  // When everybody is on the roster and has handed in, nothing is left to look at.
  write(directory.path / "roster.csv", "bob\nann\neve\n");
  const Outcome complete = grader({"collect", "results", "--roster", "roster.csv"}, directory.path);
  CHECK(complete.exit_code == 0);
  CHECK(complete.err.empty());
  write(directory.path / "class/notes.txt", "x");
  const Outcome skipped = grader(words, directory.path);
  CHECK(skipped.exit_code == 1);
  CHECK(is_told(skipped.err, "notes.txt: is neither a folder"));
  CHECK(is_told(skipped.err, "1 entry of class was skipped"));
}

TEST_CASE("a class that handed in nothing has a row for each student, and no class has none") {
  const TestDirectory directory;
  fs::create_directories(directory.path / "class");
  write(directory.path / "roster.csv", "ann\nbob\n");
  const Outcome outcome = grader(
      {"grade", "class", "--lab", "99", "-o", "results", "--roster", "roster.csv"}, directory.path);
  INFO(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(is_told(read(directory.path / "results/class.csv"), "\r\nbob,0,10,no submission,0,0\r\n"));
  const Outcome none = grader({"grade", "class", "--lab", "99", "-o", "results"}, directory.path);
  CHECK(none.exit_code == 2);
  CHECK(is_told(none.err, "holds no submission"));
  CHECK(grader({"collect", "class"}, directory.path).exit_code == 2);
}

TEST_CASE("a roster that cannot be read is refused before anything is graded") {
  const TestDirectory directory;
  write(directory.path / "class/ann/student.cpp", solution());
  write(directory.path / "bad.csv", "ann\nann\n");
  for (const char* file : {"bad.csv", "nowhere.csv", "class"}) {
    const Outcome outcome = grader(
        {"grade", "class", "--lab", "99", "-o", "results", "--roster", file}, directory.path);
    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(count_lines(outcome.err) == 1);
    CHECK(is_told(outcome.err, file));
    CHECK_FALSE(fs::exists(directory.path / "results"));
  }
}

}  // namespace glassbox::test
