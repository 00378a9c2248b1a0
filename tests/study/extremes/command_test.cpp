// The command `glassbox study extremes`.
#include <tests/app/working_directory.h>
#include <tests/support/catch.h>

#include <nlohmann/json.hpp>

namespace glassbox {
namespace {

using nlohmann::json;
using test::Outcome;
using test::WorkingDirectory;

TEST_CASE("study extremes shows chosen cases in a table and as JSON") {
  const WorkingDirectory place;
  const Outcome run = place.run("study extremes C-43 c-52 --json report.json");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("C-43") != std::string::npos);
  CHECK(run.out.find("2 of 2 cases hold") != std::string::npos);
  const Outcome piped = place.run("study extremes C-43 C-52 --json -");
  const json report = json::parse(piped.out);
  CHECK(report.at("holds") == true);
  REQUIRE(report.at("cases").size() == 2);
  const json& first = report.at("cases").at(0);
  CHECK(first.at("ours").at("error") == 0);
  CHECK(first.at("naive").at("passes") == false);
  for (const json& mutant : first.at("mutants")) CHECK(mutant.at("passes") == false);
}

TEST_CASE("study extremes --case shows one in full and writes its pictures") {
  const WorkingDirectory place;
  const Outcome run = place.run("study extremes --case C-51 -o pictures");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  for (const char* text : {"built", "right", "mutant", "pictures/C-51-naive.png"}) {
    INFO(text);
    CHECK(run.out.find(text) != std::string::npos);
  }
}

TEST_CASE("study extremes --sweep prints the curve of one parameter") {
  const WorkingDirectory place;
  const Outcome run = place.run("study extremes --sweep near-far --html curves.html");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("fails at") != std::string::npos);
  CHECK(run.out.find("C-43") == std::string::npos);
  const Outcome both = place.run("study extremes --sweep near-far --case C-43");
  CHECK(both.out.find("C-43") == 0);
  CHECK(both.out.find(run.out.substr(0, run.out.find("\n\ncurves.html"))) != std::string::npos);
}

TEST_CASE("study extremes refuses cases and sweeps that there are not, with the reason") {
  const WorkingDirectory place;
  for (const char* wrong :
       {"study extremes C-999", "study extremes --sweep far", "study extremes --case x",
        "study extremes C-43 --case C-44", "study extremes --html page.txt"}) {
    INFO(wrong);
    const Outcome run = place.run(wrong);
    CHECK(run.exit_code == 2);
    CHECK_FALSE(run.err.empty());
  }
  const Outcome left_out = place.run("study extremes c-116");
  CHECK(left_out.exit_code == 2);
  CHECK(left_out.err.find("left out") != std::string::npos);
}

}  // namespace
}  // namespace glassbox
