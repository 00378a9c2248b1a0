#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/labs/grading/grading.h"
#include "tests/support/catch.h"
#include "tests/support/skip.h"

namespace glassbox::test {

namespace {

std::vector<std::string> for_one(const std::string& name) {
  return {"grade", "class/" + name, "--one", "--lab", "99", "-o", name + ".json"};
}

// Writes submissions of different content and points: some are right, some half right, some crash,
// and some do not compile.
void write_class(const fs::path& folder, int count) {
  const std::vector<std::string> twice{"return 2 * x;", "return 0;", "return x;"};
  const std::vector<std::string> reciprocal{"return 1 / x;",
                                            "return 0;",
                                            "return -1 / x;",
                                            "return x == 8 ? 0 : 1 / x;",
                                            "if (x == 0.5) __builtin_trap(); return 1 / x;",
                                            "return y;",
                                            "return x > 0 ? 1 / x : throw 1;"};
  for (int i = 0; i < count; ++i) {
    const std::string text = submission(twice[std::size_t(i) % twice.size()],
                                        reciprocal[std::size_t(i) % reciprocal.size()]);
    write(folder / ("student-" + std::to_string(1000 + i)) / "student.cpp",
          text + "// " + std::to_string(i) + "\n");
  }
}

// Returns all results.json of a folder, one after the other.
std::string all_results(const fs::path& results) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(results)) {
    if (entry.is_directory()) files.push_back(entry.path() / "results.json");
  }
  std::sort(files.begin(), files.end());
  std::string text;
  for (const fs::path& file : files) text += file.parent_path().filename().string() + read(file);
  return text;
}

bool have_parallel() {
  return std::system("parallel --version >/dev/null 2>&1 </dev/null") == 0;
}

}  // namespace

TEST_CASE("a class has the same results in two runs and with any number of jobs, to the byte") {
  const TestDirectory directory;
  write_class(directory.path / "class", 21);
  const auto grade = [&](const std::string& folder, const std::string& jobs, KitChoice kit) {
    const Outcome outcome = grader({"grade", "class", "--lab", "99", "-o", folder, "--jobs", jobs},
                                   directory.path, {}, kit);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
  };
  // Another kit and other numbers of jobs are tried together: a change by any of them would show.
  grade("a", "1", KitChoice::kOwn);
  grade("b", "5", KitChoice::kShared);
  const std::string first = all_results(directory.path / "a");
  CHECK(first.size() > 21 * 1000);
  CHECK(all_results(directory.path / "b") == first);
  CHECK(read(directory.path / "b/class.csv") == read(directory.path / "a/class.csv"));
}

TEST_CASE("partial credit is per case") {
  const TestDirectory directory;
  // There are 4 cases of 1 point, and 8 cases of 0.75 points, of which only x = 8 is wrong, in each
  // of the two checks of the reciprocal.
  write(directory.path / "class/ann/student.cpp",
        submission("return x > 0 ? 2 * x : 0;", "return x == 8 ? 0 : 1 / x;"));
  REQUIRE(grader(for_one("ann"), directory.path).exit_code == 0);
  const auto results = read_json(directory.path / "ann.json");
  CHECK(total(results) == 3 + 3 * 0.75 + 3 * 0.75);
  CHECK(results.at("tests")[0].at("score") == 3);
  CHECK(results.at("tests")[1].at("extra_data").at("right") == 3);
}

TEST_CASE("GNU parallel grades submissions as the class is") {
  if (!have_parallel()) SKIP_TEST("parallel is not installed");
  const TestDirectory directory;
  write_class(directory.path / "class", 21);  // every combination once
  REQUIRE(grader({"grade", "class", "--lab", "99", "-o", "as-class"}, directory.path).exit_code ==
          0);
  // The command of docs/grading.md.
  const std::string command =
      std::string(
          "mkdir results && ls class | parallel --will-cite --joblog jobs.log "
          "'mkdir -p results/{} && ") +
      TINY_GRADER
      " lab grade class/{} --one --lab 99 --kit kit -o results/{}/results.json' 2>err.log >out.log";
  const Outcome outcome = run_program("/bin/sh", {"-c", command}, directory.path.string());
  INFO(read(directory.path / "err.log"));
  REQUIRE(outcome.exit_code == 0);
  CHECK(all_results(directory.path / "results") == all_results(directory.path / "as-class"));
  REQUIRE(grader({"collect", "results"}, directory.path).exit_code == 0);
  CHECK(read(directory.path / "results/class.csv") == read(directory.path / "as-class/class.csv"));
}

TEST_CASE("results.json is valid, and gives no points, when a grading is killed") {
  const TestDirectory directory;
  write(directory.path / "class/slow/student.cpp", submission("for (;;) {}", "return 1 / x;"));
  const auto kill_soon = [&](pid_t process) {
    // Waits until the first results exist, and then stops in the middle of the work.
    for (int i = 0; i < 1000 && !fs::exists(directory.path / "slow.json"); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ::kill(process, SIGKILL);
  };
  CHECK(grader(for_one("slow"), directory.path, kill_soon).exit_code == 128 + SIGKILL);
  const auto results = read_json(directory.path / "slow.json");
  REQUIRE(results.is_object());
  CHECK(total(results) == 0);
  CHECK(results.at("extra_data").at("outcome") == "grading did not finish");
}

TEST_CASE(
    "what is handed in is a file: links, pipes and devices are refused, and a missing file is "
    "named") {
  const TestDirectory directory;
  const fs::path folder = directory.path / "class";
  fs::create_directories(folder / "link");
  fs::create_symlink(TINY_SOLUTION, folder / "link/student.cpp");
  fs::create_directories(folder / "pipe");
  REQUIRE(::mkfifo((folder / "pipe/student.cpp").c_str(), 0600) == 0);
  fs::create_directories(folder / "nothing");
  fs::create_directory_symlink(fs::path(TINY_SOLUTION).parent_path(), folder / "folder-link");
  write(folder / "large/student.cpp", solution() + std::string(std::size_t(2) << 20, ' '));
  write(folder / "unpacked/lab/student.cpp", solution());
  REQUIRE(grader({"grade", "class", "--lab", "99", "-o", "results"}, directory.path).exit_code ==
          0);
  const auto outcome = [&](const std::string& name) {
    return read_json(directory.path / "results" / name / "results.json")
        .at("extra_data")
        .at("outcome");
  };
  CHECK(outcome("link") == "file refused");
  CHECK(outcome("pipe") == "file refused");
  CHECK(outcome("large") == "file refused");
  CHECK(outcome("nothing") == "missing file");
  CHECK(outcome("unpacked") == "graded");
  CHECK(outcome("folder-link") == "file refused");
}

TEST_CASE("the lab is known by student.h in a submission, and asked for where there is none") {
  const TestDirectory directory;
  write(directory.path / "class/ann/student.cpp", solution());
  const Outcome unknown = grader({"grade", "class", "-o", "results"}, directory.path);
  CHECK(unknown.exit_code == 2);
  CHECK(unknown.err.find("--lab") != std::string::npos);
  fs::copy_file(fs::path(TINY_SOLUTION).parent_path() / "student.h",
                directory.path / "class/ann/student.h");
  CHECK(grader({"grade", "class", "-o", "results"}, directory.path).exit_code == 0);
  CHECK(total(read_json(directory.path / "results/ann/results.json")) == 10);
}

}  // namespace glassbox::test
