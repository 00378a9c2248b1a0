// The command `glassbox study scene`.
#include <tests/app/working_directory.h>
#include <tests/support/catch.h>

#include <algorithm>
#include <set>
#include <string>

#include <nlohmann/json.hpp>

#include "study/curve/picture_error.h"

#include <glassbox/images/read.h>

namespace glassbox {
namespace {

using nlohmann::json;
using test::Outcome;
using test::WorkingDirectory;

json curve_of(const WorkingDirectory& place, const std::string& words) {
  const Outcome run = place.run("study scene " + words + " --json -");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  return json::parse(run.out);
}

TEST_CASE("every way has the command that draws it, and these make as many pictures as it says") {
  const WorkingDirectory place;
  for (const char* words : {"checker --size 48x36", "sphere:8 --size 48x36 --quick",
                            "room --size 48x36 --depth d24 --fov 80 --quick",
                            "cube --size 32x24 --projection t_pers --cull-stage object --quick"}) {
    INFO(words);
    const json curve = curve_of(place, words);
    CHECK(curve.at("faults").empty());
    std::map<int, std::string> pictures;
    for (const json& point : curve.at("points")) {
      const std::string command = point.at("command");
      INFO(command);
      const std::string own = command.substr(command.find("render "));
      REQUIRE(place.run(own + " -o picture.ppm").exit_code == 0);
      const std::string bytes = place.read("picture.ppm");
      const auto [same, fresh] = pictures.emplace(point.at("picture").get<int>(), bytes);
      CHECK(same->second == bytes);
    }
    std::set<std::string> different;
    for (const auto& [number, bytes] : pictures) different.insert(bytes);
    CHECK(different.size() == curve.at("pictures"));
  }
}

TEST_CASE("the front is what nothing beats, and times have their quartiles and octiles") {
  const WorkingDirectory place;
  const json curve = curve_of(place, "checker --size 64x48 --quick --threads 2");
  bool front = false;
  for (const json& point : curve.at("points")) {
    INFO(point.dump());
    const double times[] = {point.at("ns_octiles").at(0), point.at("ns_quartiles").at(0),
                            point.at("ns"), point.at("ns_quartiles").at(1),
                            point.at("ns_octiles").at(1)};
    CHECK(std::ranges::is_sorted(times));
    CHECK(point.at("standing").is_null() == (point.at("threads") == 2));
    if (point.at("standing") != "front") continue;
    front = true;
    for (const json& other : curve.at("points")) {
      const bool beats = other.at("rms") <= point.at("rms") && !other.at("standing").is_null() &&
                         other.at("ns_octiles").at(1) < point.at("ns_octiles").at(0);
      CHECK_FALSE(beats);
    }
  }
  CHECK(front);
}

TEST_CASE("CSV, JSON and text say the same, and the page has the pictures") {
  const WorkingDirectory place;
  const Outcome run = place.run(
      "study scene checker --size 48x36 --quick --csv out.csv --json out.json --html page.html");
  INFO(run.err);
  REQUIRE(run.exit_code == 0);
  const json curve = json::parse(place.read("out.json"));
  const std::string csv = place.read("out.csv"), page = place.read("page.html");
  CHECK(std::size_t(std::ranges::count(csv, '\n')) == 1 + curve.at("points").size());
  for (const json& point : curve.at("points")) {
    const std::string name = point.at("name");
    INFO(name);
    CHECK(csv.find("," + name + ",") != std::string::npos);
    CHECK(run.out.find("  " + name + " ") != std::string::npos);
  }
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(page.find("id=\"reference\"") != std::string::npos);
  const int last = curve.at("pictures").get<int>() - 1;
  CHECK(page.find("id=\"difference" + std::to_string(last) + "\"") != std::string::npos);
  CHECK(page.find("id=\"flip" + std::to_string(last) + "\"") != std::string::npos);
  CHECK(run.out.find("page.html: open it in a browser") != std::string::npos);
}

TEST_CASE("bad usage of study scene ends in 2, says why, and writes nothing") {
  const WorkingDirectory place;
  for (const char* words :
       {"study scene", "study scene absent.glb", "study scene room --show depth",
        "study scene room --quick --json - --csv -", "study scene room --html page.txt",
        "study scene room --quick --json nowhere/out.json", "study scene room --threads 0",
        "study scene room --filter blurred", "study scene teapot:0",
        "study scene room --eye 0,1,9 --look-at 0,1,20 --size 32x24 --html page.html",
        "study scene room --json same --csv same", "study scene room --stereo anaglyph"}) {
    INFO(words);
    const Outcome run = place.run(words);
    CHECK(run.exit_code == 2);
    CHECK(run.out.empty());
    CHECK_FALSE(run.err.empty());
  }
  CHECK(place.names().empty());
}

}  // namespace
}  // namespace glassbox
