// glassbox explain: the numbers of a run, without its picture.
#include <nlohmann/json.hpp>

#include "tests/app/run.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

TEST_CASE("explain counts what goes into every stage and what comes out, and writes no picture") {
  const Workplace here;
  const Outcome outcome = here.run("explain room --size 96x64");
  REQUIRE(outcome.exit_code == 0);
  for (const char* stage : {"clip", "back-face cull", "coverage", "depth test", "fragments"}) {
    CAPTURE(stage);
    CHECK(outcome.out.find(stage) != std::string::npos);
  }
  CHECK(here.names().empty());

  const Json json = Json::parse(here.run("explain room --size 96x64 --json -").out);
  const auto count = [&](const char* name) { return json.at(name).get<std::uint64_t>(); };
  CHECK(count("after_clipping") == count("zero_area") + count("culled") + count("set_up"));
  CHECK(count("covered") == count("depth_failed") + count("discarded") + count("written"));
  CHECK(count("written") > 0);
  CHECK(json.at("ms").at("fragments").get<double>() >= 0);
  CHECK(json.at("scene") == "room");
  CHECK(count("width") == 96);
  CHECK(count("height") == 64);
}

TEST_CASE("explain refuses what render refuses") {
  const Workplace here;
  CHECK(here.run("explain nothing-of-this-name").exit_code == 2);
  CHECK(here.run("explain room --fov 400").exit_code == 2);
}

}  // namespace
}  // namespace glassbox::test
