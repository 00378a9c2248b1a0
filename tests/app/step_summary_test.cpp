// Tests the summary of glassbox step --point: it comes first, is short, and --check follows it.
#include <algorithm>
#include <cmath>
#include <string>

#include "tests/app/step_run.h"

namespace glassbox::test {
namespace {

struct Summarised {
  Json json;
  std::string brief;
  int exit_code = 0;  // with --check
};

Summarised summary_of(const WorkingDirectory& here, const Call& call) {
  const auto with = [&](const std::string& options) {
    Call more = call;
    more.options += options;
    return step(here, more);
  };
  const Outcome whole = with(""), brief = with(" --brief");
  REQUIRE(whole.exit_code == 0);
  REQUIRE(brief.exit_code == 0);
  // The long form begins with the short one.
  CHECK(whole.out.starts_with(brief.out + "\n"));
  CHECK(contains(whole.out, "VERDICT"));
  CHECK_FALSE(contains(brief.out, "VERDICT"));
  CHECK(std::count(brief.out.begin(), brief.out.end(), '\n') <= 10);
  std::istringstream lines(brief.out);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
  const Outcome checked = with(" --brief --check");
  CHECK(checked.out == brief.out);
  CHECK(checked.err.empty());
  const Outcome json = with(" --check --json -");
  CHECK(json.exit_code == checked.exit_code);
  return {Json::parse(json.out)["summary"], unwrapped(brief.out), checked.exit_code};
}

TEST_CASE("the summary of correct matrices says that nothing looks wrong, and --check passes") {
  const WorkingDirectory here;
  const Summarised found = summary_of(here, {kModel, kView, kProjection, kPoints});
  CAPTURE(found.brief);
  CHECK(found.json["seen"] == 3);
  CHECK(found.json["points"] == 3);
  CHECK(found.json["id"].is_null());
  CHECK(found.json["certainty"] == "none");
  CHECK(found.json["passes"] == true);
  CHECK(found.exit_code == 0);
  CHECK(contains(found.brief, "nothing looks wrong"));
}

TEST_CASE("the summary names the most probable slip with its mend, and --check fails") {
  const WorkingDirectory here;
  const double fovy = book::radians(60);
  Rows offset = kView;
  offset[0][3] = -3, offset[1][3] = -2, offset[2][3] = -5;
  Rows no_last_row = kModel;
  no_last_row[3] = {0, 0, 0, 0};
  const struct {
    const char* name;
    Call call;
    const char* id;
    const char* certainty;
    const char* words;
  } slips[] = {
      {"view transposed",
       {kModel, book::transposed(kView), kProjection, kPoints},
       "transposed",
       "certain",
       "mend transpose the view matrix: 3 of 3 points are then where they should be"},
      {"degrees for radians",
       {kModel, kView, book::perspective_gl(60, 1.5, 0.1, 100), kPoints},
       "degrees-as-radians",
       "certain",
       "pass radians(60)"},
      {"handedness",
       {book::identity(), kView, book::perspective_d3d_left(fovy, 1.5, 0.1, 100),
        "--point 0,0,0 --point 1,0.5,-1 --point -1,0,1"},
       "eye-hand",
       "guess",
       "turn the camera round"},
      {"a left-handed parallel projection",
       {book::identity(), kView, book::ortho_d3d(-9, 9, -6, 6, 0.1, 100, true),
        "--dialect d3d --point 0,0,0 --point 1,0.5,-1 --point -1,0,1"},
       "eye-hand",
       nullptr,
       "handedness is mixed"},
      {"the pose for the view",
       {book::identity(), book::rigid_inverse(kView), kProjection,
        "--point 0,0,0 --point 1,0.5,-1 --point -1,0,1"},
       "invert-view",
       "likely",
       "a view is its inverse"},
      {"eye and target exchanged",
       {book::identity(), book::look_at_right({0, 0, 0}, {3, 2, 5}, {0, 1, 0}), kProjection,
        "--point 0,0,0 --point 1,0.5,-1 --point -1,0,1 --point 0,-0.5,0"},
       "swap-look-at",
       nullptr,
       "exchange eye and target of look-at: 4 of 4 points"},
      {"the eye's position not rotated",
       {book::identity(), offset, kProjection, "--point -4,-2,2 --point -5,-3,0"},
       nullptr,
       nullptr,
       "rotation * translation(-eye)"},
      {"a last row of zeros",
       {no_last_row, kView, kProjection, kPoints},
       "singular",
       "certain",
       "its last row is 0 0 0 0: it is singular (its rank is 3)"},
      {"the projection twice",
       {kModel, kView, book::product(kProjection, kProjection), kPoints},
       "projection-twice",
       "certain",
       "multiply the projection in once"},
      {"a view in centimetres",
       {kModel, book::product(book::scaling(100, 100, 100), kView),
        book::perspective_gl(fovy, 1.5, 0.1, 5000), kPoints},
       "not-rigid",
       "guess",
       "they are scaled by 100"},
      {"a point that the camera does not see",
       {book::identity(), kView, kProjection, "--point 0,9,0"},
       nullptr,
       "none",
       "check the point's position"},
  };
  for (const auto& slip : slips) {
    const Summarised found = summary_of(here, slip.call);
    CAPTURE(slip.name, found.brief, found.json.dump());
    if (slip.id != nullptr) CHECK(found.json["id"] == slip.id);
    if (slip.certainty != nullptr) CHECK(found.json["certainty"] == slip.certainty);
    CHECK(contains(found.brief, slip.words));
    CHECK(found.json["passes"] == false);
    CHECK(found.exit_code == 1);
  }
}

TEST_CASE("an offset that was not rotated is named where every point is in the picture") {
  const WorkingDirectory here;
  Rows offset = kView;
  offset[0][3] = -3, offset[1][3] = -2, offset[2][3] = -9;
  const Summarised found =
      summary_of(here, {book::identity(), offset, kProjection, "--point 3,2,0 --point 4,1,1"});
  CAPTURE(found.brief);
  CHECK(found.json["seen"] == 2);
  CHECK(found.json["id"] == "offset-not-rotated");
  CHECK(found.exit_code == 1);
}

TEST_CASE("--check asks for the expected places, and without a projection only for the matrices") {
  const WorkingDirectory here;
  here.write("view.txt", plain_rows(kView));
  here.write("proj.txt", plain_rows(kProjection));
  const std::string point = "step --view view.txt --point 0,0,0 --check ";
  CHECK(here.run(point).exit_code == 0);
  const std::string placed = point + "--proj proj.txt --size 600x400 --expect ";
  CHECK(here.run(placed + "300,200").exit_code == 0);
  CHECK(here.run(placed + "300,203").exit_code == 1);
}

TEST_CASE("a place that rounding leaves open is never called visible without its bound") {
  const WorkingDirectory here;
  // The same camera and point as in kView, a long way from the world's origin.
  const double far_off = 5e6;
  const Rows view = book::look_at_right({far_off + 3, 2, 5}, {far_off, 0, 0}, {0, 1, 0});
  const Call far_away{book::identity(), view, kProjection, "--size 600x400 --point 5000000,0.5,0"};
  const Summarised world = summary_of(here, far_away);
  CAPTURE(world.brief);
  CHECK(world.json["id"] == "imprecise");
  CHECK(contains(world.brief, "px only"));
  CHECK(contains(world.brief, "subtract the eye's position"));
  CHECK(world.exit_code == 1);
  CHECK(contains(unwrapped(step(here, far_away).out), ") +- "));
  // A near plane so near that the depth orders nothing.
  const Summarised near = summary_of(
      here, {book::identity(), kView, book::perspective_gl(book::radians(60), 1.5, 1e-5, 100),
             "--size 600x400 --point 0,0,0"});
  CAPTURE(near.brief);
  CHECK(near.json["id"] == "imprecise");
  CHECK(contains(near.brief, "move the near plane away"));
  CHECK(near.exit_code == 1);
}

}  // namespace
}  // namespace glassbox::test
