// The command `glassbox study`.
#include <tests/app/text.h>
#include <tests/support/catch.h>
#include <tests/support/skip.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace glassbox {
namespace {

using nlohmann::json;
using test::contains;
using test::Outcome;
using test::unwrapped;
using test::WorkingDirectory;

// One of the experiments that take little time.
constexpr const char* kQuick = "D-13 --quick --threads 1";

// The results without the times and without the state of the machine.
json errors_of(json results) {
  for (json& experiment : results["experiments"]) {
    experiment.erase("load"), experiment.erase("mhz");
    for (json& each : experiment["configurations"]) each.erase("times");
  }
  return results;
}

TEST_CASE("study list names every experiment and what it asks") {
  const WorkingDirectory place;
  const Outcome run = place.run("study list --json list.json");
  REQUIRE(run.exit_code == 0);
  const json list = json::parse(place.read("list.json"));
  CHECK(list.size() >= 18);
  for (const json& each : list) {
    INFO(each.dump());
    CHECK(run.out.find(each.at("id").get<std::string>() + " ") != std::string::npos);
    for (const char* name :
         {"id", "name", "question", "axis", "error", "reference", "theory", "item"})
      CHECK_FALSE(each.at(name).get<std::string>().empty());
  }
}

TEST_CASE("study run gives errors, theory, times and origin as JSON, CSV and text") {
  const WorkingDirectory place;
  const Outcome run = place.run(std::string("study run --json out.json --csv out.csv ") + kQuick);
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  CHECK(run.out.find("D-13") != std::string::npos);
  const json results = json::parse(place.read("out.json"));
  for (const char* name : {"version", "machine", "target", "compiler", "flags"})
    CHECK_FALSE(results.at(name).get<std::string>().empty());
  CHECK(results.at("effort") == "quick");
  CHECK(results.at("threads") == 1);
  REQUIRE(results.at("experiments").size() == 1);
  std::size_t lines = 1;
  for (const json& each : results.at("experiments").at(0).at("configurations")) {
    CHECK(each.at("error").get<double>() >= 0);
    lines += std::max<std::size_t>(1, each.at("times").size());
    for (const json& time : each.at("times")) {
      CHECK(time.at("repetitions").get<int>() >= 11);
      CHECK(time.at("ns_quartiles").at(0) <= time.at("ns"));
      CHECK(time.at("ns_quartiles").at(1) >= time.at("ns"));
      CHECK((time.at("standing") == "front" || time.at("standing") == "dominated"));
    }
  }
  const std::string csv = place.read("out.csv");
  CHECK(std::size_t(std::ranges::count(csv, '\n')) == lines);
  CHECK(csv.starts_with(
      "experiment,series,scene,measure,parameter,error,error_unit,predicted_error,ratio,"));
}

TEST_CASE(
    "two runs give the same errors to the last digit, and JSON alone goes to standard output") {
  const WorkingDirectory place;
  const Outcome one = place.run(std::string("study run --json - ") + kQuick);
  const Outcome two = place.run(std::string("study run --json - ") + kQuick);
  REQUIRE(one.exit_code == 0);
  REQUIRE(two.exit_code == 0);
  CHECK(errors_of(json::parse(one.out)) == errors_of(json::parse(two.out)));
}

TEST_CASE("study run goes on with its own file, and refuses one of another effort or of nobody") {
  const WorkingDirectory place;
  REQUIRE(place.run(std::string("study run --resume kept.json ") + kQuick).exit_code == 0);
  const std::string kept = place.read("kept.json");
  REQUIRE(place.run(std::string("study run --resume kept.json ") + kQuick).exit_code == 0);
  CHECK(place.read("kept.json") == kept);  // nothing was measured again
  const Outcome full = place.run("study run D-13 --threads 1 --resume kept.json");
  CHECK(full.exit_code == 2);
  CHECK(full.err.find("effort") != std::string::npos);
  CHECK(place.read("kept.json") == kept);
  place.write("nobody.json", "{}");
  CHECK(place.run(std::string("study run --resume nobody.json ") + kQuick).exit_code == 2);
}

TEST_CASE("study report makes a page of kept results that asks nothing of the network") {
  const WorkingDirectory place;
  REQUIRE(place.run(std::string("study run --resume kept.json ") + kQuick).exit_code == 0);
  const Outcome run = place.run("study report --from kept.json -o page.html");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const std::string page = place.read("page.html");
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(page.find("Chart.js") != std::string::npos);
  CHECK(page.find("study run D-13 --quick --threads 1") != std::string::npos);
  for (const char* outside : {"src=\"http", "href=\"http", "@import", "{SCRIPT}", "{DATA}"}) {
    INFO(outside);
    CHECK(page.find(outside) == std::string::npos);
  }
}

TEST_CASE("charts as SVG files are gnuplot's, and without it the error says so") {
  const WorkingDirectory place;
  REQUIRE(place.run(std::string("study run --resume kept.json ") + kQuick).exit_code == 0);
  std::filesystem::create_directory(place.file("charts"));
  const Outcome run = place.run("study report --from kept.json --svg charts");
  if (run.exit_code == 2) {
    CHECK(run.err.find("gnuplot-nox") != std::string::npos);
    return;
  }
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  for (const char* name : {"charts/D-13-time.svg", "charts/D-13-axis.svg"}) {
    INFO(name);
    const std::string svg = place.read(name);
    CHECK(svg.find("<svg") != std::string::npos);
    CHECK(svg.find("</svg>") != std::string::npos);
  }
}

TEST_CASE("parts of a run, measured by GNU parallel, are joined to what one run gives") {
  const WorkingDirectory place;
  const auto shell = [&](const std::string& command) {
    return test::run_program("/bin/sh", {"-c", command}, place.path());
  };
  if (shell("parallel --version").exit_code != 0) SKIP_TEST("parallel is not installed");
  const std::string some = " D-5 D-7 D-8 D-13 --quick --threads 1";
  // The command that docs/study.md gives.
  const Outcome parallel =
      shell("mkdir parts && seq 3 | parallel --will-cite '" GLASSBOX_PROGRAM " study run" + some +
            " --part {}/3 --json parts/{}.json'");
  INFO(parallel.err);
  REQUIRE(parallel.exit_code == 0);
  const Outcome run = place.run("study collect parts -o joined.json");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  REQUIRE(place.run("study run" + some + " --json whole.json").exit_code == 0);
  const json joined = json::parse(place.read("joined.json"));
  CHECK(errors_of(joined) == errors_of(json::parse(place.read("whole.json"))));
  CHECK(place.run("study report --from joined.json -o page.html").exit_code == 0);

  // A part that is missing, is there twice, is damaged, or comes from another machine.
  const auto refused = [&](const std::string& words, const std::string& what) {
    const Outcome outcome = place.run("study collect " + words + " -o never.json");
    INFO(outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.err.find(what) != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(place.path() + "/never.json"));
  };
  namespace fs = std::filesystem;
  const fs::path parts = fs::path(place.path()) / "parts";
  json second = json::parse(place.read("parts/2.json"));
  fs::remove(parts / "2.json");
  refused("parts", "part 2/3 is missing");
  const auto put = [&](const char* name, const json& results) {
    std::ofstream(parts / name) << results.dump();
  };
  second["machine"] = "another";
  put("2.json", second);
  refused("parts", "2.json");
  refused("parts", "the machine is");
  CHECK(place.run("study collect parts -o both.json --any-machine").exit_code == 0);
  CHECK(json::parse(place.read("both.json")).at("machine").get<std::string>().find("another") !=
        std::string::npos);
  // A part of a different list of experiments.
  json other = second;
  other["experiments"][0]["id"] = json::parse(place.read("parts/1.json"))["experiments"][0]["id"];
  put("2.json", other);
  refused("parts --any-machine", "which another part contains too");
  second["version"] = "another build";
  put("2.json", second);
  refused("parts --any-machine", "the version is");
  put("2.json", json::parse(place.read("parts/1.json")));
  refused("parts", "is the same part");
  second["part"] = {7, 3};
  put("2.json", second);
  refused("parts", "is damaged");
  refused("absent", "cannot be read");
  CHECK(place.run("study run D-13 --quick --part 4/3").exit_code == 2);
  CHECK(place.run("study run D-13 --quick --part 1/3x").exit_code == 2);
}

TEST_CASE("two runs agree where neither states the opposite of the other") {
  const WorkingDirectory place;
  REQUIRE(place.run(std::string("study run --json one.json ") + kQuick).exit_code == 0);
  CHECK(place.run("study agree one.json one.json").exit_code == 0);
  // In the second file the configuration that was fastest is slower than all others.
  json turned = json::parse(place.read("one.json"));
  auto& all = turned["experiments"][0]["configurations"];
  std::size_t fastest = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i]["times"][0]["ns"] < all[fastest]["times"][0]["ns"]) fastest = i;
  }
  for (json& time : all[fastest]["times"]) {
    time["ns"] = 1e12;
    time["ns_quartiles"] = time["ns_octiles"] = {1e12, 1e12};
  }
  place.write("other.json", turned.dump());
  // A file that this version did not write is refused with our own message.
  for (const auto& [damage, says] : std::vector<std::pair<std::function<void(json&)>, std::string>>{
           {[](json& time) { time.erase("ns_octiles"); },
            "has no 'ns_octiles', so it was written by an older version"},
           {[](json& time) { time["threads"] = "two"; }, "is damaged: a value has the wrong type"},
           {[](json& time) { time["ns"] = "much"; }, "is damaged: 'much' is not a number"},
           {[](json& time) { time["ns_octiles"] = json::array(); }, "is damaged"}}) {
    json damaged = turned;
    damage(damaged["experiments"][0]["configurations"][0]["times"][0]);
    place.write("damaged.json", damaged.dump());
    const Outcome refused = place.run("study agree one.json damaged.json");
    CHECK(refused.exit_code == 2);
    CHECK(refused.err.find("damaged.json: " + says) != std::string::npos);
    CHECK(refused.err.find("json.exception") == std::string::npos);
  }
  const Outcome run = place.run("study agree one.json other.json");
  CHECK(run.exit_code == 1);
  CHECK(run.out.find(all[fastest]["series"].get<std::string>() + " at ") != std::string::npos);
  CHECK(run.out.find("faster") != std::string::npos);
  // Fewer configurations, then other experiments.
  turned["experiments"][0]["configurations"].erase(0);
  place.write("less.json", turned.dump());
  CHECK(place.run("study agree one.json less.json").exit_code == 2);
  turned["experiments"][0]["id"] = "D-1";
  place.write("another.json", turned.dump());
  CHECK(place.run("study agree one.json another.json").exit_code == 2);
  CHECK(place.run("study agree one.json absent.json").exit_code == 2);
  CHECK(place.run("study agree . one.json").exit_code == 2);
}

TEST_CASE("study recommend says what fits on this scene, and with which options it is drawn") {
  const WorkingDirectory place;
  const Outcome run = place.run(
      "study recommend teapot --size 64x48 --error-budget position<0.01,depth<1e-3,colour<1/16 "
      "--json -");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const json found = json::parse(run.out);
  CHECK(found.at("meets_all") == true);
  REQUIRE(found.at("budgets").size() == 3);
  for (const json& budget : found.at("budgets")) {
    const std::string chosen = budget.at("recommended");
    bool listed = false;
    for (const json& each : budget.at("candidates")) {
      CHECK(each.at("fits") == (each.at("error").get<double>() < budget.at("limit").get<double>()));
      // Configurations that may be recommended are timed.
      const bool timed = budget.at("quantity") != "position" && each.at("fits");
      CHECK(timed == !each.at("ns").is_null());
      if (each.at("name") == chosen) listed = each.at("fits");
    }
    CHECK(listed);
  }
  const json& together = found.at("together");
  CHECK(together.at("ns").get<double>() > 0);
  CHECK(together.at("colour_error").get<double>() < 1.0 / 16);
  const std::string command = found.at("command");
  CHECK(command.find("render teapot --size 64x48 --depth d") != std::string::npos);
  const std::string words = command.substr(command.find("render"));
  CHECK(place.run(words).exit_code == 0);
}

TEST_CASE("study recommend reads a scene from standard input") {
  const WorkingDirectory place;
  place.write("corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto shell = [&](const std::string& words) {
    return test::run_program("/bin/sh", {"-c", GLASSBOX_PROGRAM " study recommend " + words},
                             place.path());
  };
  const std::string more = " --size 16x16 --error-budget 'position<0.1px' --json -";
  const Outcome piped = shell("-" + more + " < corner.obj"), named = shell("corner.obj" + more);
  INFO(piped.err);
  REQUIRE(piped.exit_code == 0);
  const json one = json::parse(piped.out), other = json::parse(named.out);
  CHECK(one["budgets"][0]["recommended"] == other["budgets"][0]["recommended"]);
}

TEST_CASE("a budget that nothing meets ends in 1 and names the most accurate candidate") {
  const WorkingDirectory place;
  // A configuration that is precise enough has more subpixel bits than `render` offers.
  const Outcome finer =
      place.run("study recommend teapot --size 64x48 --error-budget position<0.001px");
  CHECK(finer.exit_code == 1);
  CHECK(contains(unwrapped(finer.out), "but glassbox render has no option for it"));
  const Outcome run = place.run("study recommend teapot --size 64x48 --error-budget depth<1e-12");
  CHECK(run.exit_code == 1);
  CHECK(run.out.find("No candidate is accurate enough") != std::string::npos);
}

TEST_CASE("more samples are drawn only until one number of them fits") {
  const WorkingDirectory place;
  const auto candidates = [&](const std::string& limit) {
    const Outcome run = place.run("study recommend teapot --size 64x48 --error-budget colour<" +
                                  limit + " --json -");
    INFO(run.err);
    REQUIRE(run.exit_code <= 1);
    return json::parse(run.out).at("budgets").at(0).at("candidates");
  };
  const json none = candidates("1e-9"), first = candidates("1"), some = candidates("1/100");
  CHECK(none.size() == 10);
  for (const json& each : none) CHECK(each.at("ns").is_null());
  REQUIRE(first.size() == 2);
  CHECK(first[0].at("name") == "gouraud, 1 sample");
  CHECK(first[1].at("name") == "phong, 1 sample");
  CHECK(some.size() > 2);
  CHECK(some.size() < 10);
}

TEST_CASE("bad usage of study ends in 2, says why, and writes nothing") {
  const WorkingDirectory place;
  place.write("empty.json", "");
  for (const char* words : {"study",
                            "study run D-999",
                            "study run d",
                            "study run --threads 0",
                            "study run D-13 --resume",
                            "study run D-13 --quick --json - --csv -",
                            "study run D-13 --quick --json nowhere/out.json",
                            "study run D-13 --quick --json same --csv same",
                            "study report",
                            "study report -o page.txt",
                            "study report --from absent.json -o page.html",
                            "study report --from empty.json -o page.html",
                            "study report --from empty.json --quick -o page.html",
                            "study agree /dev/zero empty.json",
                            "study report --from /dev/zero -o page.html",
                            "study run D-13 --quick --resume /dev/full",
                            "study report --quick --svg nowhere",
                            "study recommend teapot",
                            "study recommend teapot --error-budget speed<1",
                            "study recommend absent.glb --error-budget depth<1",
                            "study dance"}) {
    INFO(words);
    const Outcome run = place.run(words);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_FALSE(run.err.empty());
  }
  CHECK(place.names() == std::vector<std::string>{"empty.json"});
}

}  // namespace
}  // namespace glassbox
