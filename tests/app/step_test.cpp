// Tests glassbox step --point: a point's chain of transformations, compared with a second
// computation, as text and as JSON.
#include <array>
#include <cmath>
#include <sstream>

#include "tests/app/sessions.h"
#include "tests/app/step_run.h"
#include "tests/app/text.h"

namespace glassbox::test {
namespace {

TEST_CASE("the chain is that of a second computation, within its bounds, in every window") {
  const WorkingDirectory here;
  struct Api {
    const char* name;
    Rows view, projection;
    bool y_up_in_window_and_ndc_agree;
  };
  const double fovy = book::radians(60);
  const Api apis[] = {
      {"opengl", kView, kProjection, true},
      {"d3d", book::look_at_left({3, 2, 5}, {0, 0, 0}, {0, 1, 0}),
       book::perspective_d3d_left(fovy, 1.5, 0.1, 100), false},
      {"vulkan", kView, book::perspective_vulkan(fovy, 1.5, 0.1, 100), true},
      {"reversed", kView, book::perspective_reversed_infinite(fovy, 1.5, 0.1), false},
      {"glassbox", kView, book::perspective_d3d_right(fovy, 1.5, 0.1, 100), false},
      {"opengl", kView, book::ortho_gl(-9, 9, -6, 6, 0.1, 100), true},
  };
  for (const Api& api : apis) {
    const Json json = step_json(here, {kModel, api.view, api.projection,
                                       std::string("--dialect ") + api.name +
                                           " --viewport 10,20,600,400 --point 0.5,0.25,-0.5"});
    const Rows all = book::product(api.projection, book::product(api.view, kModel));
    std::array<double, 4> clip{};
    for (std::size_t i = 0; i < 4; ++i) {
      clip[i] = all[i][0] * 0.5 + all[i][1] * 0.25 - all[i][2] * 0.5 + all[i][3];
    }
    const Json& point = json["points"][0];
    CAPTURE(api.name, point.dump());
    CHECK(point["fate"] == "visible");
    // The matrices are rounded to float when they are read, by u for each entry; the numbers here
    // are below 10.
    constexpr double kRead = 64 * 0x1p-24;
    for (std::size_t i = 0; i < 4; ++i) {
      const double bound = double(point["steps"][2]["bound"][i]) + kRead;
      CHECK(std::abs(double(point["steps"][2]["position"][i]) - clip[i]) <= bound);
    }
    const double x = 10 + (clip[0] / clip[3] + 1) * 300;
    const double up = clip[1] / clip[3];
    const double y = 20 + (api.y_up_in_window_and_ndc_agree ? 1 + up : 1 - up) * 200;
    CHECK(std::abs(double(point["window"]["position"][0]) - x) <= 300 * kRead);
    CHECK(std::abs(double(point["window"]["position"][1]) - y) <= 300 * kRead);
    const double z = clip[2] / clip[3];
    CHECK(std::abs(double(point["window"]["depth"]) -
                   (std::string(api.name) == "opengl" ? (z + 1) / 2 : z)) <= kRead);
    CHECK(point["window"]["y_up"] == (std::string(api.name) == "opengl"));
  }
}

TEST_CASE("a viewport of negative height turns y over, and is no picture upside down") {
  const WorkingDirectory here;
  const Rows d3d = book::perspective_d3d_right(book::radians(60), 1.5, 0.1, 100);
  const Rows vulkan = book::perspective_vulkan(book::radians(60), 1.5, 0.1, 100);
  const Json negated = step_json(
      here, {kModel, kView, vulkan, "--dialect vulkan --point 0.5,1,0 --viewport 0,0,600,400"});
  const Json turned = step_json(
      here, {kModel, kView, d3d, "--dialect vulkan --point 0.5,1,0 --viewport 0,400,600,-400"});
  CHECK(findings(turned, "hint") == Ids());
  CHECK(negated["points"][0]["window"]["position"] == turned["points"][0]["window"]["position"]);
  // A height below one pixel gives no aspect ratio that could be compared.
  const Outcome thin = step(here, {kModel, kView, d3d, "--point 0.5,1,0 --viewport 0,0,600,0.5"});
  CHECK(thin.exit_code == 0);
}

TEST_CASE("bits, bounds, conditions and the deciding plane are printed, within 100 columns") {
  const WorkingDirectory here;
  const Outcome outcome =
      step(here, {kModel, kView, kProjection, "--point 0.5,0.25,-0.5 --point 90,1,2 --bits"});
  REQUIRE(outcome.exit_code == 0);
  for (const char* part :
       {"MODEL", "VIEW", "PROJECTION", "POINT (0.5, 0.25, -0.5)", "object -> world", "world -> eye",
        "eye -> clip", "clip -> NDC", "NDC -> window", "3f800000", "+- ", "exact", "condition",
        "snapped to", "stable", "decided: inside all six planes",
        "decided: outside the right plane by", "the picture spans x from", "VERDICT"}) {
    CAPTURE(part, outcome.out);
    CHECK(contains(outcome.out, part));
  }
  // The longest numbers have to fit as well.
  Rows long_numbers = kProjection;
  for (auto& row : long_numbers) {
    for (double& entry : row) entry = -1.2345678e-5 * (entry + 0.12345678);
  }
  const Outcome wide = step(here, {long_numbers, long_numbers, long_numbers,
                                   "--point -0.123456789,-1.2345678e-10,-1.2345678e10 --bits"});
  REQUIRE(wide.exit_code == 0);
  for (const std::string& text : {outcome.out, wide.out, here.run("step --help").out}) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (contains(line, "--")) continue;  // lines that CLI11 lays out
      CAPTURE(line);
      CHECK(line.size() <= 100);
    }
  }
}

TEST_CASE("the same words give the same bytes, to a file and to standard output") {
  const WorkingDirectory here;
  const Call call{kModel, kView, kProjection, std::string(kPoints) + "--json -"};
  const Outcome first = step(here, call), second = step(here, call);
  CHECK(first.out == second.out);
  const Outcome file =
      step(here, {kModel, kView, kProjection, std::string(kPoints) + "--json out.json"});
  CHECK(here.read("out.json") == first.out);
  CHECK(contains(file.out, "VERDICT"));
}

TEST_CASE("digits that the text lacks are told in pixels") {
  const WorkingDirectory here;
  here.write("few.txt", numbers(kView, false, "%.5f"));
  here.write("many.txt", numbers(kView, false, "%.9g"));
  here.write("proj.txt", plain_rows(kProjection));
  const auto open = [&](const char* file) {
    const Outcome outcome =
        here.run(std::string("step --point 0.5,0.25,-0.5 --proj proj.txt --json - --view ") + file);
    return double(Json::parse(outcome.out)["points"][0]["window"]["open_by_digits"]);
  };
  // The entries are uncertain by 5e-6. The point is at a distance of 6, and 6.2/1.73 units are 720
  // pixels there: the position is uncertain by some hundred times 5e-6.
  CHECK(open("few.txt") > 1e-4);
  CHECK(open("few.txt") < 1e-2);
  CHECK(open("many.txt") < open("few.txt") / 5);
}

TEST_CASE("the sessions in docs/step.md are what the program prints") {
  CHECK(replay(WorkingDirectory(), "docs/step.md") >= 5);
}

TEST_CASE("a window that nobody gave is said to be assumed") {
  const WorkingDirectory here;
  here.write("proj.txt", "2 0 0 0  0 2 0 0  0 0 -1.002 -0.2002  0 0 -1 0\n");
  const std::string words = "step --point 0,0,-2 --proj proj.txt";
  // It has the shape of the projection.
  CHECK(
      contains(unwrapped(here.run(words).out), "window 720x720 (assumed: give yours with --size)"));
  for (const char* window : {" --size 1280x720", " --viewport 0,0,1280,720"}) {
    const Outcome outcome = here.run(words + window);
    CHECK(contains(outcome.out, "window 1280x720"));
    CHECK(!contains(outcome.out, "assumed"));
  }
}

}  // namespace
}  // namespace glassbox::test
