// A grading that was killed: no result is lost, and the next grading continues it.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/labs/grading/grading.h"
#include "tests/support/catch.h"

namespace glassbox::test {

namespace {

constexpr int kClass = 6;

std::string name_of(int i) {
  return "student-" + std::to_string(10 + i);
}

void write_class(const fs::path& folder, const std::string& note) {
  for (int i = 0; i < kClass; ++i)
    write(folder / name_of(i) / "student.cpp",
          submission(i % 2 == 0 ? "return 2 * x;" : "return x;", "return 1 / x;") + note);
}

nlohmann::json result_of(const fs::path& results, int i) {
  return read_json(results / name_of(i) / "results.json");
}

const std::vector<std::string> kGrade{"grade", "class",   "--lab",  "99",
                                      "-o",    "results", "--jobs", "1"};

std::vector<std::string> with(std::vector<std::string> words, const std::string& word) {
  words.push_back(word);
  return words;
}

// Grades the class again and kills the grader when some of the results are new.
Outcome killed_regrade(const fs::path& directory, std::vector<std::string> words,
                       const std::string& old) {
  return grader(words, directory, [&](pid_t process) {
    for (int i = 0; i < 6000; ++i) {
      const auto first = read_json(directory / "results" / name_of(2) / "results.json");
      if (first.is_object() && first.at("extra_data").value("digest", "") != old) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ::kill(process, SIGKILL);
  });
}

std::size_t scratch_folders(const fs::path& temporary) {
  return std::size_t(std::count_if(fs::directory_iterator(temporary), fs::directory_iterator(),
                                   [](const fs::directory_entry& entry) {
                                     return entry.path().filename().string().starts_with(
                                         "glassbox-scratch-");
                                   }));
}

}  // namespace

TEST_CASE(
    "kill -9 of a regrade loses no grade, collect counts what is unfinished, --resume goes on") {
  const TestDirectory directory;
  const fs::path results = directory.path / "results";
  const fs::path temporary = directory.path / "tmp";
  fs::create_directories(temporary);
  fs::permissions(temporary, fs::perms(0711));
  const std::string before = std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : "";
  ::setenv("TMPDIR", temporary.c_str(), 1);
  write_class(directory.path / "class", "");
  REQUIRE(grader(kGrade, directory.path).exit_code == 0);
  std::vector<double> totals;
  for (int i = 0; i < kClass; ++i) totals.push_back(total(result_of(results, i)));
  const std::string old = result_of(results, 2).at("extra_data").at("digest");

  write_class(directory.path / "class", "// handed in again\n");
  CHECK(killed_regrade(directory.path, kGrade, old).exit_code == 128 + SIGKILL);
  for (int i = 0; i < kClass; ++i) CHECK(total(result_of(results, i)) == totals[std::size_t(i)]);
  CHECK(scratch_folders(temporary) == 1);

  const Outcome collected = grader({"collect", "results"}, directory.path);
  CHECK(collected.exit_code == 1);
  CHECK(collected.err.find("of 6 submissions did not finish") != std::string::npos);
  CHECK(read(results / "class.csv").find("the points shown are those of an earlier result") !=
        std::string::npos);

  const Outcome resumed = grader(with(kGrade, "--resume"), directory.path);
  CHECK(resumed.exit_code == 0);
  CHECK(resumed.err.find("of 6 submissions already have a result") != std::string::npos);
  CHECK(scratch_folders(temporary) == 0);
  for (int i = 0; i < kClass; ++i)
    CHECK(result_of(results, i).at("extra_data").at("digest") != old);
  CHECK(grader({"collect", "results"}, directory.path).exit_code == 0);
  before.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", before.c_str(), 1);
}

TEST_CASE("--resume grades again what has another submission or other limits") {
  const TestDirectory directory;
  write(directory.path / "class/ann/student.cpp", solution());
  const std::vector<std::string> words{"grade", "class/ann", "--one",  "--lab",
                                       "99",    "-o",        "r.json", "--resume"};
  const auto graded_anew = [&](const std::vector<std::string>& called) {
    const Outcome outcome = grader(called, directory.path);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return outcome.out.find("already") == std::string::npos;
  };
  CHECK(graded_anew(words));
  CHECK_FALSE(graded_anew(words));
  CHECK(graded_anew(with(with(words, "--time-limit"), "7")));
  write(directory.path / "class/ann/student.cpp", solution() + "// more\n");
  CHECK(graded_anew(words));
  CHECK_FALSE(graded_anew(words));
  write(directory.path / "r.json", "{}");
  CHECK(graded_anew(words));
}

}  // namespace glassbox::test
