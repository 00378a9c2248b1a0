#include "tests/labs/grading/hostile.h"

#include <map>

#include "tests/labs/grading/grading.h"
#include "tests/support/catch.h"
#include "tests/support/daily_share.h"
#include "tests/support/skip.h"

namespace glassbox::test {

namespace {

// Returns the tests of results.json by name.
std::map<std::string, nlohmann::json> checks_of(const nlohmann::json& results) {
  std::map<std::string, nlohmann::json> checks;
  for (const auto& test : results.at("tests")) checks[test.at("name")] = test;
  return checks;
}

// Returns the folder of a submission: hanging ones have a short time limit, all others one that is
// enough on a busy machine.
std::string class_of(const Hostile& each) {
  return each.outcome.starts_with("timeout") ? "hanging" : "class";
}

std::vector<Hostile> attacks_in_share(const std::vector<Hostile>& all, const DailyShare& share) {
  std::vector<Hostile> some;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (share.includes(i, all.size())) some.push_back(all[i]);
  }
  return some;
}

void grade_hostile_class(const std::string& sandbox, const DailyShare& share) {
  INFO(share.text());
  const std::vector<Hostile> runs = attacks_in_share(hostile_runs(), share);
  const std::vector<Hostile> sources = attacks_in_share(hostile_sources(TINY_SOLUTION), share);
  const TestDirectory directory;
  fs::create_directories(directory.path / "hanging");
  for (const Hostile& each : runs)
    write(directory.path / class_of(each) / each.name / "student.cpp", source_of(each));
  write(directory.path / "hanging" / "slow" / "student.cpp",
        submission("return 2 * x;", "for (;;) {}"));
  for (const Hostile& each : sources)
    write(directory.path / "class" / each.name / "student.cpp", each.body);
  write(directory.path / "class" / "the-solution" / "student.cpp", solution());
  const std::string reference = read(TINY_SOLUTION), program = read(TINY_GRADER);
  fs::remove("/tmp/glassbox-was-here");

  for (const auto& [folder, seconds] : {std::pair{"class", "30"}, {"hanging", "1.5"}}) {
    std::vector<std::string> words{"grade",
                                   folder,
                                   "--lab",
                                   "99",
                                   "-o",
                                   std::string(folder) + "-results",
                                   "--jobs",
                                   "2",
                                   "--time-limit",
                                   seconds,
                                   "--memory-limit",
                                   "128"};
    if (!sandbox.empty()) words.insert(words.end(), {"--sandbox", sandbox});
    const Outcome outcome = grader(words, directory.path);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.err.find("sandbox: ") != std::string::npos);
  }

  for (const Hostile& each : runs) {
    INFO(each.name << " in " << (sandbox.empty() ? "what there is" : sandbox));
    const auto results =
        read_json(directory.path / (class_of(each) + "-results") / each.name / "results.json");
    REQUIRE(results.is_object());
    INFO(results.at("output").get<std::string>());
    REQUIRE(results.at("extra_data").at("outcome") == "graded");
    const auto checks = checks_of(results);
    const std::string told = checks.at("a reciprocal").at("output");
    INFO(told);
    if (each.name == "flood")
      CHECK(told.find("the program printed more than 1 MiB") != std::string::npos);
    if (each.name == "flood-answers")
      CHECK(told.find("more than 64 MiB of answers") != std::string::npos);
    const std::string named = checks.at("a reciprocal").at("extra_data").at("outcome");
    INFO("expected " << each.outcome << ", named " << named);
    CHECK(named.starts_with(each.outcome));
    // The attack costs points in its own check, and in no other.
    CHECK(checks.at("twice a number").at("score") == 4);
    if (each.costs_some) {
      CHECK(checks.at("a reciprocal").at("score") < checks.at("a reciprocal").at("max_score"));
    } else {
      CHECK(checks.at("a reciprocal").at("score") == 0);
      CHECK(total(results) == 4);
    }
  }
  for (const Hostile& each : sources) {
    INFO(each.name << " in " << (sandbox.empty() ? "what there is" : sandbox));
    const auto results = read_json(directory.path / "class-results" / each.name / "results.json");
    REQUIRE(results.is_object());
    INFO(results.at("output").get<std::string>());
    CHECK(total(results) == 0);
    const std::string named = results.at("extra_data").at("outcome");
    CHECK(named == each.outcome);
    CHECK(results.at("tests").size() == 3);
  }
  CHECK(total(read_json(directory.path / "class-results/the-solution/results.json")) == 10);
  CHECK(read(TINY_SOLUTION) == reference);
  CHECK(read(TINY_GRADER) == program);
  CHECK_FALSE(fs::exists("/tmp/glassbox-was-here"));
}

// Whether this machine has the sandbox, according to the grader.
bool has(const std::string& sandbox) {
  const TestDirectory directory;
  write(directory.path / "one/student.cpp", solution());
  return grader(
             {"grade", "one", "--one", "--lab", "99", "-o", "results.json", "--sandbox", sandbox},
             directory.path)
             .exit_code == 0;
}

void grade_where_there_is(const std::string& sandbox, const DailyShare& share) {
  if (!has(sandbox)) SKIP_TEST("no confinement by " << sandbox << " on this machine");
  grade_hostile_class(sandbox, share);
}

// Every day each kind is graded in one of the three sandboxes, and in three days in all of them.
DailyShare share_of(std::uint64_t sandbox) {
  return DailyShare(3, seed_of_shares() + sandbox);
}

}  // namespace

TEST_CASE("there are at least 15 kinds of hostile submission") {
  CHECK(hostile_runs().size() + hostile_sources(TINY_SOLUTION).size() >= 15);
}

TEST_CASE("bubblewrap that is asked for and not permitted is named as the reason") {
  const TestDirectory directory;
  write(directory.path / "one/student.cpp", solution());
  // A user namespace that does not allow further namespaces, as in many containers.
  const std::string shut =
      "for f in /proc/sys/user/max_*_namespaces; do echo 0 > $f || exit 9; done; ";
  const auto in_container = [&](const std::string& command) {
    return run_program("/bin/sh", {"-c", "unshare -Ur sh -c '" + shut + command + "'"},
                       directory.path.string());
  };
  if (in_container("true").exit_code != 0) SKIP_TEST("no user namespaces on this machine");
  const Outcome outcome = in_container(
      TINY_GRADER " lab grade one --one --lab 99 -o results.json --sandbox bubblewrap");
  INFO(outcome.err);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.err.find("the sandbox: bubblewrap: ") != std::string::npos);
  CHECK(outcome.err.find("refused by libseccomp") == std::string::npos);
}

TEST_CASE("hostile submissions are contained and named in bubblewrap") {
  grade_where_there_is("bubblewrap", share_of(0));
}

TEST_CASE("hostile submissions are contained and named in Landlock") {
  grade_where_there_is("landlock", share_of(1));
}

TEST_CASE("hostile submissions are contained and named in limits") {
  grade_where_there_is("limits", share_of(2));
}

TEST_CASE("every kind of hostile submission is contained and named in every sandbox", "[.faults]") {
  const std::string sandbox = GENERATE("bubblewrap", "landlock", "limits");
  grade_where_there_is(sandbox, DailyShare::everything());
}

}  // namespace glassbox::test
