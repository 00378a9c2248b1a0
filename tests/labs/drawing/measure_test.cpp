// A student's functions as points in an experiment's chart: every lab's solution; functions that
// are less exact, crash or never end; and the claim that a student hands in about a measurement.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/framework/lab.h"
#include "labs/framework/strip_solution.h"
#include "labs/measuring/claim.h"
#include "labs/measuring/measuring.h"
#include "study/experiment/runner.h"
#include "tests/support/catch.h"
#include "tests/support/daily_share.h"
#include "tests/support/run_program.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;
using study::ConfigurationResult;

const Lab& lab_numbered(int number) {
  const auto& all = all_labs();
  return *std::find_if(all.begin(), all.end(), [&](const Lab& l) { return l.number == number; });
}

// A lab's solution with a part replaced, as a program that is called and timed.
class Bench {
public:
  enum Change { kReplaced, kEmptied };
  // With kEmptied, `replace` is inserted at the beginning of the function whose name is found.
  Bench(int lab, const std::string& find, const std::string& replace, Change change = kReplaced)
      : directory_(make_temporary_directory()),
        sandbox_(grading::Sandbox::choose(directory_).value()),
        folder_(lab_numbered(lab).folder) {
    std::string text = solution_text(find_sources().value(), folder_).value();
    std::size_t at = text.find(find);
    REQUIRE(at != std::string::npos);
    if (change == kEmptied) {
      at = text.find(") {\n", at);
      REQUIRE(at != std::string::npos);
      text.insert(at + 4, replace);
    } else {
      text.replace(at, find.size(), replace);
    }
    std::ofstream(directory_ / "student.cpp") << text;
    program_ = built(false);
  }
  ~Bench() {
    std::error_code error;
    fs::remove_all(directory_, error);
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  StudentAnswers student(double seconds = 60) const { return {sandbox_, program_, seconds}; }
  StudentAnswers starter() const { return {sandbox_, built(true), 60}; }

private:
  fs::path built(bool starter) const {
    const fs::path kept = fs::path(KEPT) / (folder_ + "-measured");
    fs::create_directories(kept);
    const auto made = build_stages(
        find_sources().value(),
        {folder_, directory_ / "student.cpp", kept, directory_, true, starter}, sandbox_);
    REQUIRE(made);
    INFO(made->messages);
    REQUIRE_FALSE(made->program.empty());
    return made->program;
  }
  static fs::path make_temporary_directory() {
    std::string name = (fs::temp_directory_path() / "glassbox-measure-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    fs::permissions(name, fs::perms(0711));
    return name;
  }

  fs::path directory_;
  grading::Sandbox sandbox_;
  std::string folder_;
  fs::path program_;
};

void say_nothing(const std::string&) {}

// For each series, the experiment's way that it is compared with.
struct Peer {
  int lab;
  std::map<std::string, std::string> ways;
};
const std::vector<Peer>& peers() {
  static const std::vector<Peer> all{
      {1, {{"yours", "Newell, relative to the first corner"}}},
      {2,
       {{"yours, every step", "float, renormalised every step"},
        {"yours, every 10 steps", "float, renormalised every 10 steps"},
        {"yours, every 100 steps", "float, renormalised every 100 steps"},
        {"yours, every 1000 steps", "float, renormalised every 1000 steps"}}},
      {3,
       {{"yours, U V N", "three steps: minus the eye, rotation, projection"},
        {"yours, two rotations", "three steps: minus the eye, rotation, projection"}}},
      {4, {{"yours", "three steps: minus the eye, rotation, projection"}}},
      {5, {{"yours", "clip space, against the box"}}},
      {6, {{"yours", "int64"}}},
      {7,
       {{"yours, u16", "u16"},
        {"yours, u24", "u24"},
        {"yours, float", "float"},
        {"yours, float, reversed", "float, reversed"}}},
      {8,
       {{"yours, every 8 pixels", "a division every 8 pixels"},
        {"yours, every 16 pixels", "a division every 16 pixels"},
        {"yours, every 32 pixels", "a division every 32 pixels"}}},
      {9, {{"yours", "union, eight planes"}}},
  };
  return all;
}

const study::Experiment& experiment_of(const LabMeasure& measure) {
  return *study::find_experiment(study::experiments(), measure.experiment);
}

// Returns the theoretical error of an experiment's way with the scene, measure and parameter of
// `mine`, or nothing if there is none.
std::optional<double> theory_at(const std::vector<study::Configuration>& all,
                                const std::string& way, const ConfigurationResult& mine) {
  for (const study::Configuration& each : all) {
    if (each.series == way && each.scene == mine.scene && each.measure == mine.measure &&
        each.parameter == mine.parameter)
      return each.predicted_error;
  }
  return std::nullopt;
}

study::ConfigurationResult timed(const std::string& series, double error, double ns) {
  ConfigurationResult result;
  result.series = series;
  result.parameter = 8;
  result.scene = "wall";
  result.error = error;
  result.timings = {{1, 11, {ns * 0.9, ns, ns * 1.1}, 0}};
  return result;
}

Claim small_claim(double yours, double ns) {
  study::ExperimentResult result;
  result.id = "D-4";
  result.configurations = {timed("slow", 0, 100), timed("quick", 1, 10), timed("yours", yours, ns)};
  return claim_of("08-attributes", "ann", "c0de", {}, result, {"yours"});
}

}  // namespace

namespace {

// Checks that a lab's solution is as exact as its theory at the experiment's places, and that its
// starter counts as not written yet.
void measure_solution(const Peer& peer) {
  CAPTURE(peer.lab);
  const auto measure = measure_of(peer.lab);
  REQUIRE(measure);
  const Bench bench(peer.lab, "#include", "#include");
  StudentAnswers student = bench.student();
  const auto points = measure_points(*measure, student, 0, say_nothing);
  INFO(student.failure().value_or(""));
  REQUIRE(points);
  const auto ways = experiment_of(*measure).configurations(study::Effort::kQuick);
  for (const ConfigurationResult& mine : *points) {
    CAPTURE(mine.series, mine.scene, mine.measure, mine.parameter, mine.error);
    REQUIRE(peer.ways.contains(mine.series));
    const auto theory = theory_at(ways, peer.ways.at(mine.series), mine);
    REQUIRE(theory);
    // A theory has to hold up to a factor of two (study/experiment/theory.h).
    CHECK(mine.error <= 2 * *theory);
  }
  // Every series of the starter is recognized as unwritten, and none of the solution's is.
  StudentAnswers starter = bench.starter(), the_same = bench.starter();
  const auto of_solution = untouched_series(*measure, student, starter, say_nothing);
  REQUIRE(of_solution);
  CHECK(of_solution->empty());
  const auto of_starter = untouched_series(*measure, the_same, starter, say_nothing);
  INFO(the_same.failure().value_or(""));
  REQUIRE(of_starter);
  CHECK(of_starter->size() == peer.ways.size());
}

void measure_solutions(const test::DailyShare& share) {
  INFO(share.text());
  for (std::size_t i = 0; i < peers().size(); ++i) {
    if (share.includes(i, peers().size())) measure_solution(peers()[i]);
  }
}

}  // namespace

TEST_CASE("solutions are measured, some every day, as exact as their theories; starters are not") {
  measure_solutions(test::DailyShare(3));
}

TEST_CASE(
    "every lab's solution is measured where its experiment measures, as exact as its theory, and "
    "its starter is not written yet",
    "[.faults]") {
  measure_solutions(test::DailyShare::everything());
}

TEST_CASE("a lab without a part of an experiment has no measurement") {
  CHECK_FALSE(measure_of(99));
}

TEST_CASE(
    "a student's less exact variant has its error in the chart, by the theory of its arithmetic") {
  const Bench bench(6, "std::int64_t edge(", R"(std::int64_t exact_edge(
    const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p);
std::int64_t edge(const SnappedVertex& a, const SnappedVertex& b, const SnappedVertex& p) {
  return std::int64_t(float(b.x - a.x) * float(p.y - a.y) - float(b.y - a.y) * float(p.x - a.x));
}
std::int64_t exact_edge()");
  const LabMeasure measure = measure_of(6).value();
  StudentAnswers student = bench.student();
  const auto points = measure_points(measure, student, 0, say_nothing);
  REQUIRE(points);
  const auto ways = experiment_of(measure).configurations(study::Effort::kQuick);
  for (const ConfigurationResult& mine : *points) {
    if (mine.parameter < 32768) continue;  // few of two million decisions are wrong there
    CAPTURE(mine.scene, mine.error);
    const double theory = theory_at(ways, "float, difference form", mine).value();
    CHECK(mine.error >= theory / 2);
    CHECK(mine.error <= theory * 2);
  }
}

TEST_CASE(
    "what is measured is timed in rounds, and a crash, an exception or a loop ends it with a "
    "message") {
  const LabMeasure measure = measure_of(8).value();
  const MeasuredPoint point = measure.points().front();
  const LabMeasure one{measure.experiment, measure.functions, [&] { return std::vector{point}; }};
  {
    const Bench bench(8, "#include", "#include");
    StudentAnswers student = bench.student();
    const auto points = measure_points(one, student, 11, say_nothing);
    REQUIRE(points);
    const study::Timing& time = points->front().timings.at(0);
    CHECK(time.repetitions == 11);
    CHECK(time.ns.lower > 0);
    CHECK(time.ns.lower <= time.ns.median);
    CHECK(time.ns.median <= time.ns.upper);
  }
  const std::string start = "  std::vector<double> u;\n";
  for (const auto& [replace, said] :
       {std::pair{"  *static_cast<volatile int*>(nullptr) = 1;\n", "SIGSEGV"},
        {"  throw 5;\n", "threw something"},
        {"  for (volatile int i = 0;;) i = 1;\n", "still running after 0.5 seconds"}}) {
    const Bench bench(8, start, start + replace);
    StudentAnswers student = bench.student(0.5);
    CHECK_FALSE(measure_points(one, student, 11, say_nothing));
    REQUIRE(student.failure());
    CAPTURE(*student.failure());
    CHECK(student.failure()->find(said) != std::string::npos);
    CHECK(student.failure()->find("span_coordinates") != std::string::npos);
  }
}

TEST_CASE("a claim is borne out by the same errors and orders, whatever the times are") {
  const Claim here = small_claim(0.5, 50);
  REQUIRE(here.points.size() == 1);
  CHECK(here.points[0].faster_than == std::vector<std::string>{"slow"});
  CHECK(here.points[0].slower_than == std::vector<std::string>{"quick"});
  const Claim read = read_claim("measured.json", claim_json(here).dump()).value();
  CHECK(contradictions(read, here).empty());
  // Another machine with other times and the same order; and one on which the order cannot be
  // decided.
  CHECK(contradictions(read, small_claim(0.5, 70)).empty());
  CHECK(contradictions(read, small_claim(0.5, 100)).empty());

  const auto differs = [&](const Claim& claimed, const Claim& measured) {
    const auto found = contradictions(claimed, measured);
    REQUIRE(found.size() == 1);
    return found[0];
  };
  CHECK(differs(read, small_claim(0.25, 50)) ==
        "yours at 8, wall: the measured error is 0.25, not 0.5");
  CHECK(differs(small_claim(0.5, 2), here) ==
        "yours at 8, wall: measured as slower than \"quick\", not faster");
  CHECK(differs(small_claim(0.5, 300), here) ==
        "yours at 8, wall: measured as faster than \"slow\", not slower");
  Claim other = here;
  other.code = "another";
  CHECK(differs(other, here) == "it was made with another student.cpp than this measurement");
  other = here;
  other.points.push_back(other.points.front());
  CHECK(differs(other, here) == "yours at 8, wall: appears twice");
  other.points.back().parameter = 9;
  CHECK(differs(other, here) == "yours at 9, wall: is not a point of this lab's measurement");
  other = here;
  other.points.clear();
  CHECK(differs(other, here) == "yours at 8, wall: is missing");
  other.lab = "06-rasterisation";
  CHECK(differs(other, here) == "it is for lab 06-rasterisation, not for lab 08-attributes");
  // Infinity and NaN are read back as they were.
  const Claim infinite = small_claim(HUGE_VAL, 50), none = small_claim(std::nan(""), 50);
  CHECK(contradictions(read_claim("", claim_json(infinite).dump()).value(), infinite).empty());
  CHECK(contradictions(read_claim("", claim_json(none).dump()).value(), none).empty());
  CHECK(contradictions(none, infinite).size() == 1);
}

TEST_CASE("a file that is no claim is refused with a line") {
  for (const char* text : {"", "[]", "{\"lab\": 5}", "{\"lab\": \"a\", \"code\": \"b\"}",
                           R"({"lab": "a", "code": "b", "experiment": "D-4", "points": [{}]})",
                           R"({"lab": "a", "code": "b", "experiment": "D-4", "points": 3})"}) {
    CAPTURE(text);
    const auto read = read_claim("measured.json", text);
    REQUIRE_FALSE(read);
    const std::string message = read.error().message();
    CHECK(message.find("measured.json") != std::string::npos);
    CHECK(message.find("exception") == std::string::npos);
    CHECK(message.find('\n') == std::string::npos);
  }
  const auto missing = read_claim("measured.json", R"({"lab": "a"})");
  CHECK(missing.error().message().find("it has no 'code'") != std::string::npos);
}

TEST_CASE(
    "lab measure writes a chart and a claim, and tells a claim that holds from one that does not") {
  const fs::path folder =
      fs::temp_directory_path() / fmt::format("glassbox-lab-measure-{}", getpid());
  fs::remove_all(folder);
  fs::create_directories(folder / "ann");
  const Sources sources = find_sources().value();
  std::ofstream(folder / "ann/student.cpp") << solution_text(sources, "05-clipping").value();
  const auto run = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"lab", "measure", "ann", "--lab", "5"});
    return test::run_program(GLASSBOX_PROGRAM, words, folder.string());
  };
  const auto made = run({"--json", "measured.json", "--html", "chart.html"});
  CAPTURE(made.out, made.err);
  CHECK(made.exit_code == 0);
  CHECK(made.out.find("Lab 5 in D-32") != std::string::npos);
  CHECK(made.out.find("yours") != std::string::npos);
  const std::string page = read_text_file(folder / "chart.html").value();
  CHECK(page.find("\"yours\"") != std::string::npos);
  CHECK(page.find("clip space, against the box") != std::string::npos);
  const std::string claim = read_text_file(folder / "measured.json").value();
  CHECK(claim.size() < 4096);
  // It says whose times they are.
  const auto owner = nlohmann::json::parse(claim);
  CHECK(owner["submission"] == "ann");
  CHECK(owner["code"].get<std::string>().size() >= 16);
  CHECK_FALSE(owner["machine"].get<std::string>().empty());
  CHECK_FALSE(fs::exists(folder / "ann/build"));

  std::string text = claim;
  const std::string error = "\"error\": 0.0";
  REQUIRE(text.find(error) != std::string::npos);
  text.replace(text.find(error), error.size(), "\"error\": 0.5");
  std::ofstream(folder / "better.json") << text;
  const auto wrong = run({"--against", "better.json"});
  CAPTURE(wrong.out, wrong.err);
  CHECK(wrong.exit_code == 1);
  CHECK(wrong.out.find("the measured error is 0, not 0.5") != std::string::npos);
  CHECK(wrong.out.find("better.json: the times of ann (student.cpp with the digest") !=
        std::string::npos);
  // With JSON on standard output, nothing else is printed there.
  const auto both = run({"--against", "better.json", "--json", "-"});
  CHECK(both.exit_code == 1);
  CHECK(nlohmann::json::accept(both.out));
  CHECK(both.err.find("the measured error is 0, not 0.5") != std::string::npos);

  std::ofstream(folder / "ann/student.cpp")
      << strip_solution(solution_text(sources, "05-clipping").value(), "student.cpp").value();
  const auto none = run({"--json", "none.json", "--html", "none.html"});
  CAPTURE(none.out, none.err);
  CHECK(none.exit_code == 1);
  CHECK(none.out.find("Not written yet: outcode") != std::string::npos);
  CHECK_FALSE(fs::exists(folder / "none.json"));
  CHECK_FALSE(fs::exists(folder / "none.html"));

  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"--against", "nowhere.json"},
        {"--against", "."},
        {"--html", "chart.txt"}}) {
    const auto refused = run(words);
    CHECK(refused.exit_code == 2);
    CHECK(std::count(refused.err.begin(), refused.err.end(), '\n') == 1);
    CHECK(refused.err.find("hand in") == std::string::npos);
  }
  fs::remove_all(folder);
}

namespace {

void measure_nothing(const test::DailyShare& share) {
  INFO(share.text());
  const std::vector<std::tuple<int, const char*, const char*>> all{
      {1, "Vector<Object> newell_vector(", "return {};"},
      {2, "World> repaired(", "return {};"},
      {3, "World>> uvn_view(", "return {};"},
      {4, "Projection perspective(", "return {};"},
      {5, "Polygon clip_to_frustum(", "return {};"},
      {6, "std::vector<Pixel> covered_pixels(", "return {};"},
      {7, "std::vector<int> visible(", "return {};"},
      {8, "std::vector<double> span_coordinates(", "return {};"},
      {9, "Verdict cull(", "return Verdict::kDraw;"}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!share.includes(i, all.size())) continue;
    const auto& [lab, find, replace] = all[i];
    CAPTURE(lab);
    const Bench bench(lab, find, replace, Bench::kEmptied);
    const LabMeasure measure = measure_of(lab).value();
    StudentAnswers student = bench.student();
    const auto points = measure_points(measure, student, 0, say_nothing);
    REQUIRE(points);
    for (const ConfigurationResult& mine : *points) {
      if (mine.series == "yours, two rotations") continue;  // another function computes it
      CAPTURE(mine.series, mine.scene, mine.parameter, mine.error);
      CHECK_FALSE(mine.error <= 1e-3);
    }
  }
}

}  // namespace

TEST_CASE("functions that do nothing, some every day, have no small error") {
  measure_nothing(test::DailyShare(3));
}

TEST_CASE("a function that does nothing has no small error, and is not in front for being fast",
          "[.faults]") {
  measure_nothing(test::DailyShare::everything());
}
