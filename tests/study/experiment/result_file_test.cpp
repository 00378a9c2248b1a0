// Results in a file: exact to the last digit, and a basis for continuing.
#include <tests/images/temporary_directory.h>
#include <tests/support/catch.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "study/experiment/result_file.h"
#include "study/experiment/results_json.h"
#include "study/experiment/study.h"
#include "tests/study/experiment/sample_experiment.h"

namespace glassbox::study {
namespace {

using test::Calls;
using test::result_of;
using test::sample_experiment;
using test::TemporaryDirectory;

const Origin kHere{"a machine", "a compiler", "-O9", "1.2.3", Effort::kQuick, 2};

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

StudyResults made_by_hand() {
  ExperimentResult experiment;
  experiment.id = "D-0";
  experiment.name = "By \"hand\"";
  experiment.question = "What, then?";
  experiment.axis = "steps";
  experiment.axis_unit = "m";
  experiment.logarithmic_axis = false;
  experiment.axis_is_chosen = true;
  experiment.error = "error";
  experiment.error_unit = "px";
  experiment.reference = "nothing";
  experiment.theory = "none";
  experiment.item = "pixel";
  for (const double error : {0.0, 0.1, 1.0 / 3, 5e-324, std::numeric_limits<double>::infinity()})
    experiment.configurations.push_back(result_of(error, error, 1.0 / 7, 0.01));
  experiment.configurations[1].predicted_error = 0.30000000000000004;
  experiment.configurations[1].explanation = Finding{"because", 0.3, 1.0 / 3};
  experiment.configurations[2].scene = "room";
  experiment.machine = {1.5, 2300.25};
  experiment.measures = {{"signal", "signal over noise", "dB", "distance", "m", false, true}};
  experiment.configurations[2].measure = "signal";
  experiment.configurations[3].timings.push_back({2, 21, {1, 2, 3}, 4});
  experiment.configurations[4].timings.clear();
  return {kHere, {experiment}};
}

TEST_CASE("results come back from their file as they went in, to the last digit") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("results.json");
  const StudyResults before = made_by_hand();
  REQUIRE(write_results(path, before));
  const auto after = read_results(path);
  REQUIRE(after);
  CHECK(after->origin == before.origin);
  REQUIRE(after->experiments.size() == 1);
  CHECK(results_json(*after) == results_json(before));
  for (std::size_t i = 0; i < 5; ++i) {
    const ConfigurationResult &a = before.experiments[0].configurations[i],
                              &b = after->experiments[0].configurations[i];
    CHECK(a.error == b.error);
    CHECK(a.predicted_error == b.predicted_error);
    CHECK(a.explanation == b.explanation);
    CHECK(a.scene == b.scene);
    CHECK(a.measure == b.measure);
    CHECK(a.timings.size() == b.timings.size());
  }
  CHECK(after->experiments[0].machine.load == 1.5);
  CHECK(after->experiments[0].machine.mhz == 2300.25);
  CHECK(after->experiments[0].measures == before.experiments[0].measures);
  CHECK(after->experiments[0].axis_is_chosen);
  CHECK_FALSE(after->experiments[0].logarithmic_axis);
}

TEST_CASE("an error that is no number has a name in JSON") {
  CHECK(number_json(std::numeric_limits<double>::infinity()) == "infinity");
  CHECK(number_json(-std::numeric_limits<double>::infinity()) == "-infinity");
  CHECK(number_json(std::nan("")) == "nan");
  StudyResults results = made_by_hand();
  results.experiments[0].configurations[0].error = std::nan("");
  const auto back = results_of(results_json(results));
  REQUIRE(back);
  CHECK(std::isnan(back->experiments[0].configurations[0].error));
}

TEST_CASE("a run goes on where it stopped: what the file has is not measured again") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("results.json");
  Calls one, two, three;
  const Experiment first = sample_experiment("D-1", one), second = sample_experiment("D-2", two),
                   third = sample_experiment("D-3", three);
  REQUIRE(run_study({&first}, kHere, {}, path));
  CHECK(one.errors == 2);
  const auto both = run_study({&first, &second}, kHere, {}, path);
  REQUIRE(both);
  CHECK(one.errors == 2);
  CHECK(two.errors == 2);
  REQUIRE(both->experiments.size() == 2);
  CHECK(both->experiments[0].id == "D-1");
  const auto last = run_study({&third}, kHere, {}, path);  // keeps the results of other experiments
  REQUIRE(last);
  CHECK(last->experiments.size() == 1);
  const auto kept = read_results(path);
  REQUIRE(kept);
  CHECK(kept->experiments.size() == 3);
}

TEST_CASE("the file is written after every experiment, not at the end") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("results.json");
  Calls calls;
  const Experiment first = sample_experiment("D-1", calls);
  Experiment second = sample_experiment("D-2", calls);
  std::size_t kept_by_then = 0;
  second.configurations = [&](Effort) {
    const auto kept = read_results(path);
    kept_by_then = kept ? kept->experiments.size() : 0;
    return std::vector<Configuration>();
  };
  REQUIRE(run_study({&first, &second}, kHere, {}, path));
  CHECK(kept_by_then == 1);
}

TEST_CASE(
    "a file of another version, machine, effort, compiler or number of threads is refused and left "
    "alone") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("results.json");
  REQUIRE(write_results(path, made_by_hand()));
  const std::string before = text_of(path);
  Calls calls;
  const Experiment experiment = sample_experiment("D-0", calls);
  std::vector<std::pair<Origin, std::string>> others(8, {kHere, ""});
  others[0].first.machine = "b machine", others[0].second = "machine";
  others[1].first.version = "1.2.4", others[1].second = "version";
  others[2].first.effort = Effort::kFull, others[2].second = "effort";
  others[3].first.compiler = "b compiler", others[3].second = "compiler";
  others[4].first.flags = "-O0", others[4].second = "flags";
  others[5].first.threads = 1, others[5].second = "threads";
  others[6].first.target = "avx512", others[6].second = "instruction set";
  others[7].first.caches = "32 KiB", others[7].second = "caches";
  for (const auto& [origin, named] : others) {
    INFO(named);
    const auto refused = run_study({&experiment}, origin, {}, path);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().file == path);
    CHECK(refused.error().cause.find(named) != std::string::npos);
    CHECK_FALSE(refused.error().remedy.empty());
  }
  CHECK(calls.configurations == 0);
  CHECK(text_of(path) == before);
}

TEST_CASE("a file that is no result file, or half of one, is refused") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("results.json");
  REQUIRE(write_results(path, made_by_hand()));
  const std::string whole = text_of(path);
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string("{}"), std::string("{\"format\": 3}"),
        whole.substr(0, whole.size() / 2)}) {
    INFO(text.substr(0, 60));
    std::ofstream(path, std::ios::binary) << text;
    CHECK_FALSE(read_results(path));
    CHECK_FALSE(resume_results(path, kHere));
  }
  auto damaged = nlohmann::ordered_json::parse(whole);
  damaged["experiments"][0]["configurations"][0]["error"] = "seven";
  CHECK_FALSE(results_of(damaged));
  damaged["experiments"][0]["configurations"][0].erase("error");
  CHECK_FALSE(results_of(damaged));
  CHECK_FALSE(read_results(directory.file("absent.json")));
  CHECK(resume_results(directory.file("absent.json"), kHere)->experiments.empty());
}

}  // namespace
}  // namespace glassbox::study
