// Tests glassbox explain: what a picture needs, what is left out of it, and the counts and times of
// a run, without writing the picture.
#include <algorithm>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/app/text.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

void check_counts(const Json& json) {
  const auto count = [&](const char* name) { return json.at(name).get<std::uint64_t>(); };
  CHECK(count("after_clipping") == count("zero_area") + count("culled") + count("set_up"));
  CHECK(count("covered") == count("depth_failed") + count("discarded") + count("written"));
  CHECK(count("written") > 0);
  CHECK(json.at("ms").at("fragments").get<double>() >= 0);
  CHECK(json.at("scene") == "room");
  CHECK(count("width") == 96);
  CHECK(count("height") == 64);
}

// Returns the decision about a stage from a list of decisions.
Json decision(const Json& decisions, const std::string& stage) {
  for (const Json& d : decisions) {
    if (d.at("stage") == stage) return d;
  }
  return {};
}

TEST_CASE("explain says how many samples are drawn, and of what they are not") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("explain room --size 96x64 --samples 4 --json -");
  REQUIRE(outcome.exit_code == 0);
  const Json plan = Json::parse(outcome.out).at("plan");
  const Json samples = decision(plan.at("picture"), "samples");
  CHECK(samples.at("needed") == true);
  CHECK(samples.at("numbers") == "4 per pixel");
  for (const Json& draw : plan.at("draws")) {
    const std::string way = draw.at("way");
    CHECK((contains(way, "in SIMD lanes") || way == "not drawn"));
  }
  const Outcome depths = here.run("explain room --size 96x64 --samples 4 --show depth --json -");
  const Json of_depths = Json::parse(depths.out).at("plan");
  CHECK(decision(of_depths.at("picture"), "samples").at("needed") == false);
  CHECK(of_depths.at("draws").at(0).at("way") == "in SIMD lanes");
  const Json one = Json::parse(here.run("explain room --size 96x64 --json -").out).at("plan");
  CHECK(decision(one.at("picture"), "samples").is_null());
}

TEST_CASE("explain says of every stage whether it is needed, and why, and writes no picture") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("explain teapot --size 96x64");
  REQUIRE(outcome.exit_code == 0);
  for (const char* part : {"left out", "needed", "clip test of vertices", "divide by w", "light"}) {
    CAPTURE(part);
    CHECK(contains(outcome.out, part));
  }
  CHECK(here.names().empty());

  const Json json = Json::parse(here.run("explain cube --size 96x64 --json -").out);
  const Json& plan = json.at("plan");
  REQUIRE(plan.at("draws").size() == 1);
  const Json& draw = plan.at("draws")[0];
  CHECK(draw.at("instances") == Json::array({0}));
  CHECK(decision(draw.at("decisions"), "clip test of vertices").at("needed") == false);
  CHECK(decision(draw.at("decisions"), "depth test").is_null());  // no decision is made about it
  CHECK(decision(plan.at("picture"), "depth plane").at("needed") == false);
  CHECK_FALSE(json.contains("written"));  // nothing was drawn
}

TEST_CASE("explain without the plan leaves nothing out that a proof would") {
  const WorkingDirectory here;
  const Json json = Json::parse(here.run("explain cube --size 96x64 --no-plan --json -").out);
  const Json& draw = json.at("plan").at("draws")[0];
  CHECK(decision(draw.at("decisions"), "clip test of vertices").at("needed") == true);
  CHECK(decision(json.at("plan").at("picture"), "depth plane").at("needed") == true);
}

TEST_CASE("explain --analyze draws with the tile engine, and counts items, times and bytes") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("explain room --size 96x64 --analyze --threads 2");
  REQUIRE(outcome.exit_code == 0);
  for (const char* part : {"2 threads", "coverage", "bytes", "thread by thread", "fragments"}) {
    CAPTURE(part);
    CHECK(contains(outcome.out, part));
  }
  const Json json = Json::parse(here.run("explain room --size 96x64 --analyze --json -").out);
  check_counts(json);
  const Json& tile = json.at("tile");
  CHECK(tile.at("tiles") == 2);
  CHECK(tile.at("rounds") == 1);
  CHECK_FALSE(tile.at("thread_ms").empty());
  // At least the positions, of 12 bytes each, were read.
  CHECK(tile.at("bytes").at("vertices").at("read").get<std::uint64_t>() >=
        12 * json.at("vertices").get<std::uint64_t>());
}

TEST_CASE("explain --analyze counts the clusters that are out of sight") {
  const WorkingDirectory here;
  const std::string ball = "explain sphere:128 --size 480x360 --analyze ";
  const Outcome outcome = here.run(ball);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "1,016 tested: 0 outside the view and "));
  CHECK_FALSE(contains(outcome.out, "whole draws"));
  const Json json = Json::parse(here.run(ball + "--json -").out);
  const auto n = [&](const char* name) { return json.at(name).get<std::uint64_t>(); };
  CHECK(n("clusters") == 1016);
  CHECK(n("clusters_turned_away") > 300);
  CHECK(n("left_out_in_clusters") == 64 * n("clusters_turned_away"));
  CHECK(n("left_out") == n("left_out_in_clusters"));
}

TEST_CASE("explain --engine staged counts what goes into every stage and what comes out") {
  const WorkingDirectory here;
  const Outcome outcome = here.run("explain room --size 96x64 --engine staged");
  REQUIRE(outcome.exit_code == 0);
  for (const char* stage : {"clip", "back-face cull", "coverage", "depth test", "fragments"}) {
    CAPTURE(stage);
    CHECK(contains(outcome.out, stage));
  }
  CHECK(here.names().empty());
  check_counts(Json::parse(here.run("explain room --size 96x64 --engine staged --json -").out));
}

TEST_CASE(
    "explain says of a scene of many draws what the largest need, and how many more there are") {
  const WorkingDirectory here;
  // A pole at two hundred places, some of them beyond the picture's edge.
  std::string nodes, list;
  for (int i = 0; i < 200; ++i) {
    nodes += (i == 0 ? "" : ",") + std::string("{\"mesh\":0,\"translation\":[") +
             std::to_string(i - 100) + ",0,-5]}";
    list += (i == 0 ? "" : ",") + std::to_string(i);
  }
  here.write("pole.bin", float_bytes({0, 0, 0, 1, 0, 0, 0, 1, 0}));
  here.write("poles.gltf",
             R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + list +
                 R"(]}],"nodes":[)" + nodes +
                 R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
                 R"("buffers":[{"uri":"pole.bin","byteLength":36}],)"
                 R"("bufferViews":[{"buffer":0,"byteLength":36}],)"
                 R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
                 R"("min":[0,0,0],"max":[1,1,0]}]})");
  const std::string words = "explain poles.gltf --size 96x64 --eye 0,0,2 --look-at 0,0,-5";
  const Outcome outcome = here.run(words);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(contains(outcome.out, "not drawn"));
  CHECK(contains(outcome.out, "left edge"));
  const Json json = Json::parse(here.run(words + " --json -").out);
  std::size_t draws = 0;
  for (const Json& group : json.at("plan").at("draws")) draws += group.at("instances").size();
  CHECK(draws == 200);
}

TEST_CASE("explain refuses what render refuses") {
  const WorkingDirectory here;
  CHECK(here.run("explain nothing-of-this-name").exit_code == 2);
  CHECK(here.run("explain room --fov 400").exit_code == 2);
  CHECK(here.run("explain room --engine staged --no-plan").exit_code == 2);
}

// ---- two eyes ----

std::vector<std::string> stages_in(const Json& json) {
  std::vector<std::string> stages;
  if (json.contains("stage")) stages.push_back(json.at("stage"));
  if (!json.is_structured()) return stages;
  for (const Json& part : json) {
    for (const std::string& stage : stages_in(part)) stages.push_back(stage);
  }
  return stages;
}

TEST_CASE("explain leaves a blank between a stage's name and its reason") {
  constexpr std::size_t kColumn = 24;  // the column in plan_report.cpp
  const WorkingDirectory here;
  std::vector<std::string> all;
  for (const char* words : {"room --stereo anaglyph", "forest --samples 4", "cube --show depth",
                            "teapot --wireframe", "checker --no-plan"}) {
    const Outcome explained = here.run(std::string("explain ") + words + " --size 96x64 --json -");
    REQUIRE(explained.exit_code == 0);
    for (const std::string& stage : stages_in(Json::parse(explained.out))) {
      CAPTURE(words, stage);
      CHECK(stage.size() < kColumn);
      all.push_back(stage);
    }
  }
  CHECK(std::ranges::count(all, "light of channels") == 2);
  CHECK(all.size() > 100);
}

TEST_CASE(
    "explain --stereo says of both eyes what their pictures need, and what their stages did") {
  const WorkingDirectory here;
  const std::string pair = "explain room --size 96x64 --stereo anaglyph ";
  const Outcome plain = here.run(pair);
  REQUIRE(plain.exit_code == 0);
  CHECK(contains(plain.out, "stereo: eyes"));
  CHECK(contains(plain.out, "the left eye"));  // the left eye's mask keeps one channel
  CHECK(contains(plain.out, "the right eye"));
  CHECK_FALSE(contains(plain.out, "busy ms"));
  CHECK(here.names().empty());

  const Json json = Json::parse(here.run(pair + "--analyze --json -").out);
  const auto channels = [&](const char* eye) {
    return decision(json.at(eye).at("plan").at("picture"), "encoding of channels");
  };
  CHECK(channels("left").at("numbers") == "written: red ");
  CHECK(channels("right").at("numbers") == "written: green blue");
  const auto shaded = [&](const char* eye) {
    return decision(json.at(eye).at("plan").at("picture"), "light of channels")
        .at("because")
        .get<std::string>();
  };
  CHECK(shaded("left").starts_with("blue is not computed for opaque pixels"));
  CHECK(shaded("right").starts_with("red is not computed for opaque pixels"));
  CHECK(json.at("left").at("vertices").get<int>() > 0);
  CHECK(json.at("right").at("vertices") == 0);  // the left eye's vertices are moved in x
  CHECK(json.at("left").at("written").get<int>() > 0);
  CHECK(json.at("right").at("written").get<int>() > 0);
  CHECK(json.at("tile").at("rounds") == 1);
  CHECK(json.at("stereo").contains("parallax"));
}

TEST_CASE(
    "explain --stereo: what is the same for both eyes is said once; one picture for both; the "
    "staged engine; cropped eyes") {
  const WorkingDirectory here;
  const std::string pair = "explain cube --size 96x64 --stereo ";
  const Outcome same = here.run(pair + "pair");
  REQUIRE(same.exit_code == 0);
  CHECK(contains(same.out, "both eyes"));
  CHECK_FALSE(contains(same.out, "the right eye"));

  const Json one = Json::parse(here.run(pair + "anaglyph --eye-separation 0 --json -").out);
  CHECK(one.contains("both"));
  CHECK_FALSE(one.contains("left"));

  for (const char* staged : {"anaglyph --engine staged", "anaglyph --stereo-cull centre"}) {
    const Json counted = Json::parse(here.run(pair + staged + std::string(" --json -")).out);
    CHECK_FALSE(counted.at("left").contains("plan"));
    CHECK(counted.at("right").at("written").get<int>() > 0);
  }
  CHECK(contains(here.run(pair + "anaglyph --stereo-cull centre").out, "which has no plan"));
  const Json cropped =
      Json::parse(here.run(pair + "anaglyph --eyes-by crop --analyze --json -").out);
  CHECK(cropped.at("right").at("vertices").get<int>() > 0);  // each eye is drawn by itself
}

TEST_CASE("explain refuses options of two eyes without --stereo, as render does") {
  const WorkingDirectory here;
  for (const char* words : {"--glasses red-cyan", "--stereo anaglyph --seen-by left"}) {
    const Outcome refused = here.run(std::string("explain cube --size 96x64 ") + words);
    CHECK(refused.exit_code == 2);
    CHECK(contains(refused.err, "--stereo"));
  }
}

}  // namespace
}  // namespace glassbox::test
