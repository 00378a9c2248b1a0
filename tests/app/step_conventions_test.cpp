// Tests glassbox step --point: wrong conventions are named, correct ones raise no alarm.
#include <algorithm>
#include <cmath>

#include "tests/app/step_run.h"

namespace glassbox::test {
namespace {

TEST_CASE("correct chains raise no alarm and no hint") {
  const WorkingDirectory here;
  const double fovy = book::radians(60);
  const Rows left = book::look_at_left({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const struct {
    const char* options;
    Rows view, projection;
  } chains[] = {
      {"--dialect opengl", kView, kProjection},
      {"--dialect opengl --world right", kView, book::ortho_gl(-9, 9, -6, 6, 0.1, 100)},
      {"--dialect opengl", kView, book::frustum_gl(-0.1, 0.2, -0.1, 0.1, 0.1, 50)},
      {"--dialect d3d", left, book::perspective_d3d_left(fovy, 1.5, 0.1, 100)},
      {"--dialect d3d --world left", left, book::ortho_d3d(-9, 9, -6, 6, 0.1, 100, true)},
      {"--dialect d3d", kView, book::perspective_d3d_right(fovy, 1.5, 0.1, 100)},
      {"--dialect vulkan --world right", kView, book::perspective_vulkan(fovy, 1.5, 0.1, 100)},
      {"--dialect vulkan", kView, book::ortho_vulkan(-9, 9, -6, 6, 0.1, 100)},
      {"--dialect reversed", kView, book::perspective_reversed_infinite(fovy, 1.5, 0.1)},
      {"", kView, kProjection},
      {"", left, book::perspective_d3d_left(fovy, 1.5, 0.1, 100)},
      {"", kView, book::perspective_vulkan(fovy, 1.5, 0.1, 100)},
      {"", kView, book::perspective_reversed_infinite(fovy, 1.5, 0.1)},
  };
  for (const auto& chain : chains) {
    const Json json = step_json(here, {kModel, chain.view, chain.projection,
                                       std::string(kPoints) + "--size 600x400 " + chain.options});
    CAPTURE(chain.options, json["dialect"], json["findings"].dump());
    CHECK(findings(json, "alarm") == Ids());
    CHECK(findings(json, "hint") == Ids());
    CHECK(json["visible"] == 3);
    CHECK(json["alternatives"].empty());
  }
}

TEST_CASE("each planted slip is named: by a finding, or by the first change that would mend it") {
  const WorkingDirectory here;
  const double fovy = book::radians(60);
  Rows turned = kView;
  turned[0][3] = turned[1][3] = turned[2][3] = 0;
  // The place of (0, 1, 0) in a window that counts y from the other edge.
  const Rows both = book::product(kProjection, kView);
  const double w = both[3][1] + both[3][3];
  const std::string flipped = std::to_string(300 + 300 * (both[0][1] + both[0][3]) / w) + "," +
                              std::to_string(200 - 200 * (both[1][1] + both[1][3]) / w);
  const auto with = [](Rows m, std::size_t row, std::size_t column, double entry) {
    m[row][column] = entry;
    return m;
  };
  const Rows d3d_right = book::perspective_d3d_right(fovy, 1.5, 0.1, 100);
  struct Slip {
    const char* name;
    Call call;
    const char* finding;  // the alarm, or nullptr
    const char* change;   // the first proposed change, or nullptr
    const char* words;    // words in the text
  };
  const Slip slips[] = {
      {"view transposed",
       {kModel, book::transposed(kView), kProjection, kPoints},
       "transposed",
       "transpose-view",
       "the view is then rigid, and as given it is not"},
      {"projection transposed",
       {kModel, kView, book::transposed(kProjection), kPoints},
       "transposed",
       "transpose-projection",
       "are in the last column"},
      {"view not inverted",
       {kModel, book::rigid_inverse(kView), kProjection, kPoints},
       nullptr,
       "invert-view",
       "the eye is then at (3, 2, 5)"},
      {"factors of the view exchanged",
       {kModel, book::product(book::translation(-3, -2, -5), turned), kProjection, kPoints},
       nullptr,
       "view-factors",
       "rotation * translation(-eye)"},
      {"view times projection",
       {kModel, book::identity(), book::product(kView, kProjection), kPoints},
       "factors-exchanged",
       nullptr,
       "view * projection"},
      {"view and projection exchanged",
       {kModel, kProjection, kView, kPoints},
       "exchanged",
       "exchange-view-projection",
       "exchange --view and --proj"},
      {"degrees for radians",
       {kModel, kView, book::perspective_gl(60, 1.5, 0.1, 100), kPoints},
       "degrees-as-radians",
       nullptr,
       "60 degrees were taken for radians"},
      {"radians for degrees",
       {kModel, kView, book::perspective_gl(book::radians(book::radians(60)), 1.5, 0.1, 100),
        kPoints},
       "radians-as-degrees",
       "radians",
       "radians were taken for degrees"},
      {"reversed depth",
       {kModel, kView, book::perspective_reversed_infinite(fovy, 1.5, 0.1),
        std::string(kPoints) + "--dialect d3d"},
       "depth-direction",
       nullptr,
       "--dialect reversed"},
      {"near and far exchanged",
       {kModel, kView, book::perspective_gl(fovy, 1.5, 100, 0.1), kPoints},
       "depth-direction",
       nullptr,
       "near and far are exchanged"},
      {"near negative",
       {kModel, kView, book::perspective_gl(fovy, 1.5, -0.1, 100), kPoints},
       "planes",
       nullptr,
       "they would be near -0.1 and far 100"},
      {"the sign of beta",
       {kModel, kView, with(d3d_right, 2, 3, 100 * 0.1 / (100 - 0.1)), kPoints},
       "planes",
       nullptr,
       "with [2][3] negated it has near 0.1 and far 100"},
      {"the sign of w",
       {kModel, kView, with(kProjection, 3, 2, 1), kPoints},
       "planes",
       nullptr,
       "with the last row negated it has near 0.1 and far 100"},
      {"the last row forgotten",
       {kModel, kView, with(with(kProjection, 3, 2, 0), 3, 3, 1), kPoints},
       "last-row",
       nullptr,
       "with 0 0 -1 0 it is a perspective projection with near 0.1 and far 100"},
      {"a corner of the identity",
       {kModel, kView, with(kProjection, 3, 3, 1), kPoints},
       "w-leftover",
       nullptr,
       "start from a matrix of zeros, not from the identity"},
      {"a projection and a view given as the view",
       {kModel, book::product(kProjection, kView), book::identity(), kPoints},
       "is-a-projection",
       nullptr,
       "it is the product of a projection and a view"},
      {"y of the window",
       {book::identity(), kView, book::perspective_gl(fovy, 1.5, 0.1, 100),
        "--size 600x400 --point 0,1,0 --expect " + flipped},
       nullptr,
       "flip-y",
       "counted from the other edge"},
  };
  for (const Slip& slip : slips) {
    CAPTURE(slip.name);
    const Answer answer = run_step(here, slip.call);
    const Json& json = answer.json;
    CAPTURE(json["findings"].dump(), json["alternatives"].dump(), json["visible"], answer.text);
    if (slip.finding != nullptr) {
      CHECK(alarms_at(json, slip.finding));
      CHECK(contains(answer.text, "WRONG"));
    } else {
      CHECK(findings(json, "alarm") == Ids());
    }
    if (slip.change != nullptr) {
      REQUIRE_FALSE(json["alternatives"].empty());
      CHECK(json["alternatives"][0]["ids"] == Json::array({slip.change}));
      CHECK(contains(answer.text, "should be"));
    }
    CHECK(contains(answer.text, slip.words));
  }
}

TEST_CASE("a projection times a view one step back is no leftover of the identity") {
  const WorkingDirectory here;
  const Rows both = book::product(kProjection, book::translation(0, 0, -1));
  const Json json = step_json(here, {kModel, book::identity(), both, "--point 0,0,-5"});
  CHECK(double(json["matrices"]["projection"]["rows"][3][3]) == 1);
  CHECK(findings(json, "alarm") == Ids());
}

TEST_CASE("a turned aspect ratio, and one of integers, are explained where the size is known") {
  const WorkingDirectory here;
  const auto hint = [&](double aspect, const std::string& size) {
    return run_step(here,
                    {kModel, kView, book::perspective_gl(1, aspect, 0.1, 100), kPoints + size});
  };
  const Answer turned = hint(9.0 / 16, "--size 1280x720");
  CHECK(findings(turned.json, "hint") == Ids{"aspect"});
  CHECK(contains(turned.text, "it is height/width"));
  CHECK(contains(hint(1, "--size 1280x720").text, "1280/720 in integers is 1"));
  CHECK(findings(hint(1, "").json, "hint") == Ids());
}

TEST_CASE(
    "a left-handed world before a right-handed eye, as Unity has it, is right where it is meant") {
  const WorkingDirectory here;
  Rows view = book::look_at_left({3, 2, -5}, {0, 0, 0}, {0, 1, 0});
  for (double& entry : view[2]) entry = -entry;
  const Call call{kModel, view, kProjection, kPoints};
  CHECK(findings(step_json(here, call), "hint") == Ids{"mirror"});
  Call left = call, right = call;
  left.options += "--world left";
  right.options += "--world right";
  CHECK(step_json(here, left)["findings"].empty());
  CHECK(alarms_at(step_json(here, right), "world-mirrored"));
}

TEST_CASE("without a projection the way ends in the eye's space, and nothing vanishes") {
  const WorkingDirectory here;
  here.write("view.txt", plain_rows(kView));
  const Outcome text = here.run("step --view view.txt --point 0,0,0");
  CHECK(contains(text.out, "(0, 0, 0) is at (0, 0, -6.16441) in eye space"));
  CHECK_FALSE(contains(text.out, "decided"));
  const Json json = Json::parse(here.run("step --view view.txt --point 0,0,0 --json -").out);
  CHECK(json["points"][0]["steps"].size() == 2);
  CHECK_FALSE(json["points"][0].contains("fate"));
  CHECK_FALSE(json.contains("alternatives"));
}

TEST_CASE("where no convention helps, it says what the camera sees instead") {
  const WorkingDirectory here;
  const Outcome outcome = step(here, {book::identity(), kView, kProjection, "--point 0,9,0"});
  CHECK(contains(outcome.out, "None of the tried changes of convention"));
  CHECK(contains(outcome.out, "the picture spans y from"));
  CHECK_FALSE(contains(outcome.out, "WRONG"));
}

TEST_CASE("NaN, infinity, w = 0 and directions are told, and nothing is computed from them") {
  const WorkingDirectory here;
  Rows broken = kView;
  broken[0][1] = std::nan("");
  Json json = step_json(here, {kModel, broken, kProjection, "--point 0,0,0"});
  CHECK(findings(json, "alarm") == Ids{"not-finite"});
  CHECK(json["points"][0]["fate"] == "not-finite");
  CHECK_FALSE(json["points"][0].contains("ndc"));
  const Outcome direction = step(here, {kModel, kView, kProjection, "--point 0,0,1,0"});
  CHECK(contains(direction.out, "it a direction"));
  // A point in the plane of the eye.
  json = step_json(here, {book::identity(), book::identity(), kProjection, "--point 1,1,0"});
  CHECK(json["points"][0]["fate"] == "in-eye-plane");
  // A NaN as JavaScript writes it.
  here.write("null.txt", "[1,0,0,0, 0,null,0,0, 0,0,1,0, 0,0,0,1]");
  json = Json::parse(here.run("step --view null.txt --point 0,0,0 --json -").out);
  CHECK(findings(json, "alarm") == Ids{"not-finite"});
  // An overflow in an intermediate product.
  json = step_json(here, {book::scaling(1e30, 1e30, 1e30), book::scaling(1e30, 1e30, 1e30),
                          kProjection, "--point 1,1,1"});
  CHECK(json["points"][0]["fate"] == "not-finite");
}

}  // namespace
}  // namespace glassbox::test
