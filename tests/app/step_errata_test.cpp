// The errata of the slides (docs/references.md) that make something vanish, mirror it or destroy
// its depth, as a student meets them: the matrices are given on the command line, and the verdict
// and the convention have to be printed. The errata about faces (E11, E18) show in a single vertex
// only if a matrix mirrors; those about meshes or pairs of images (E1, E3 .. E6, E9, E14, E17, E19)
// do not show at all.
#include <cmath>

#include "tests/app/step_run.h"

namespace glassbox::test {
namespace {

using book::Vector3;

const Vector3 kEye{3, 2, 5}, kTarget{0, 0, 0}, kUp{0, 1, 0};
const double kFovy = book::radians(60);

// The view of S4.5: N = -g, the eye looks down -z.
Rows s4_5() {
  return book::look_at_right(kEye, kTarget, kUp);
}

// The projection of S4.18, with d near, f far, h half of the window's height, and w = z.
Rows s4_18(double d, double f, double h) {
  return {
      {{d / h, 0, 0, 0}, {0, d / h, 0, 0}, {0, 0, f / (f - d), -d * f / (f - d)}, {0, 0, 1, 0}}};
}

// The view of S3.37: a rotation about the axis v x z by the angle between them turns the gaze v to
// +z, then a rotation about z brings the up vector to y.
Rows s3_37(const Vector3& eye, const Vector3& target, const Vector3& up) {
  const Vector3 v = book::unit(book::minus(target, eye)), z{0, 0, 1};
  const Vector3 a = book::unit(book::cross(v, z));  // 0/0 for v = +-z (E8)
  const double c = book::dot(v, z), s = std::sqrt(1 - c * c);
  Rows to_z = book::identity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 e{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0};
    const Vector3 turned = book::cross(a, e);  // Rodrigues' rotation formula
    for (std::size_t r = 0; r < 3; ++r) {
      to_z[r][i] = c * e[r] + s * turned[r] + (1 - c) * book::dot(a, e) * a[r];
    }
  }
  double x = 0, y = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    x += to_z[0][k] * up[k];
    y += to_z[1][k] * up[k];
  }
  const double length = std::sqrt(x * x + y * y);
  const Rows roll{{{y / length, -x / length, 0, 0},
                   {x / length, y / length, 0, 0},
                   {0, 0, 1, 0},
                   {0, 0, 0, 1}}};
  return book::product(roll, book::product(to_z, book::translation(-eye[0], -eye[1], -eye[2])));
}

// The skew of S0.21: x' = x + s (1 - z/f), with a depth that grows away from the eye.
Rows skew(double s, double f) {
  Rows m = book::identity();
  m[0][2] = -s / f;
  m[0][3] = s;
  return m;
}

TEST_CASE("E2: one eye of a stereo pair is known by its distance without parallax") {
  const WorkingDirectory here;
  const Rows left = book::look_at_left(kEye, kTarget, kUp);
  const Rows eye = book::product(book::perspective_d3d_left(kFovy, 1.5, 0.1, 100), skew(0.03, 4));
  const Answer answer = run_step(here, {kModel, left, eye, kPoints});
  CAPTURE(answer.text);
  CHECK(findings(answer.json, "alarm") == Ids());
  CHECK(findings(answer.json, "hint") == Ids());
  CHECK(contains(answer.text, "it is at x = -0.03, and points at the distance 4 have no parallax"));
}

TEST_CASE("E2: the skew's sign goes with the way the eye looks") {
  const WorkingDirectory here;
  const Rows wrong = book::product(kProjection, skew(0.03, 4)),
             right = book::product(kProjection, skew(0.03, -4));
  const Answer answer = run_step(here, {kModel, kView, wrong, kPoints});
  CHECK(findings(answer.json, "hint") == Ids{"skew-sign"});
  CHECK(contains(answer.text, "no point in front of it has zero parallax (E2)"));
  CHECK(contains(run_step(here, {kModel, kView, right, kPoints}).text,
                 "points at the distance 4 have no parallax"));
}

TEST_CASE("E2: a skew read by rows instead of columns is named, before or after the projection") {
  const WorkingDirectory here;
  const Rows left = book::look_at_left(kEye, kTarget, kUp);
  const Rows projection = book::perspective_d3d_left(kFovy, 1.5, 0.1, 100);
  const Rows turned = book::transposed(skew(0.03, 4));
  for (const Rows& m : {book::product(projection, turned), book::product(turned, projection)}) {
    const Answer answer = run_step(here, {kModel, left, m, kPoints});
    CHECK(alarms_at(answer.json, "skew-transposed"));
    CHECK(contains(answer.text, "(E2)"));
    CHECK(contains(answer.text, "m[3][0] and m[2][0]"));
  }
  // If the whole matrix is for row vectors, that is a matter of the order of its numbers.
  const Answer rows = run_step(
      here, {kModel, left, book::transposed(book::product(projection, skew(0.03, 4))), kPoints});
  CHECK(findings(rows.json, "alarm") == Ids{"transposed"});
  CHECK(rows.json["alternatives"][0]["ids"] == Json{"transpose-projection"});
}

TEST_CASE("E7: a gaze turned to +z by a proper rotation mirrors a right-handed world") {
  const WorkingDirectory here;
  const Call call{kModel, s3_37(kEye, kTarget, kUp),
                  book::perspective_d3d_left(kFovy, 1.5, 0.1, 100),
                  "--size 600x400 --point 0.5,0.25,-0.5"};
  const Answer unknown = run_step(here, call);
  CHECK(unknown.json["points"][0]["fate"] == "visible");
  CHECK(findings(unknown.json, "note") == Ids{"world-hand"});
  CHECK(contains(unknown.text, "a right-handed one is mirrored left to right (E7)"));

  Call known = call;
  known.options += " --world right";
  const Answer answer = run_step(here, known);
  CHECK(findings(answer.json, "alarm") == Ids{"world-mirrored"});
  CHECK(contains(answer.text, "a gaze that was turned to +z (E7)"));

  // The correct position of the point, which is mirrored.
  const Json correct =
      step_json(here, {kModel, s4_5(), book::perspective_d3d_right(kFovy, 1.5, 0.1, 100),
                       "--size 600x400 --dialect d3d --point 0.5,0.25,-0.5"});
  const double x = correct["points"][0]["window"]["position"][0],
               y = correct["points"][0]["window"]["position"][1];
  Call expecting = call;
  expecting.options += " --expect " + std::to_string(x) + "," + std::to_string(y);
  const Answer expected = run_step(here, expecting);
  REQUIRE(expected.json["alternatives"].size() == 1);
  CHECK(expected.json["alternatives"][0]["ids"] == Json{"flip-x"});
  CHECK(contains(expected.text, "world and eye of opposite handedness (E7)"));
}

TEST_CASE("E8: the axis of no turn is 0/0, and NaN is named where it stands") {
  const WorkingDirectory here;
  const Rows view = s3_37({0, 0, -5}, {0, 0, 0}, kUp);
  REQUIRE(std::isnan(view[0][0]));
  const Answer answer = run_step(
      here, {kModel, view, book::perspective_d3d_left(kFovy, 1.5, 0.1, 100), "--point 0,0,0"});
  CHECK(findings(answer.json, "alarm") == Ids{"not-finite"});
  CHECK(answer.json["points"][0]["fate"] == "not-finite");
  CHECK(contains(answer.text, "view: entry [0][0] is nan"));
  CHECK(contains(answer.text, "the cross product of parallel vectors is 0, E8"));
  CHECK(answer.json["alternatives"].empty());
}

TEST_CASE("E10: the last row of an affine map is 0 0 0 1 for column vectors only") {
  const WorkingDirectory here;
  const Call transposed{book::transposed(kModel), book::transposed(kView),
                        book::transposed(kProjection), kPoints};
  const Call by_columns{kModel, kView, kProjection, std::string(kPoints) + "--order columns"};
  for (const Call& call : {transposed, by_columns}) {
    const Answer answer = run_step(here, call);
    CAPTURE(answer.text);
    CHECK(alarms_at(answer.json, "transposed"));
    CHECK(contains(answer.text, "its last column is 0 0 0 1"));
    CHECK(contains(answer.text, "(E10)"));
    CHECK(answer.json["alternatives"][0]["ids"] == Json{"transpose-all"});
    CHECK(contains(answer.text, "read them in the other --order"));
  }
}

TEST_CASE(
    "E12: S4.5 times S4.18 gives every point in front a negative w, because handedness is mixed") {
  const WorkingDirectory here;
  const Rows projection = s4_18(0.1, 100, 0.1 * std::tan(kFovy / 2));
  const Answer answer = run_step(here, {kModel, s4_5(), projection, kPoints});
  CAPTURE(answer.text);
  CHECK(answer.json["visible"] == 0);
  CHECK(answer.json["behind_eye"] == 3);
  for (const Json& point : answer.json["points"]) {
    CHECK(point["fate"] == "behind-eye");
    CHECK(double(point["steps"][2]["position"][3]) < 0);
  }
  CHECK(contains(answer.text, "every w is negative (3 of 3 points)"));
  CHECK(answer.json["alternatives"][0]["ids"] == Json{"eye-hand"});
  CHECK(contains(answer.text, "1. negate z between view and projection"));
  CHECK(contains(answer.text, "handedness is mixed (E12)"));
  // Negating z between view and projection puts the points where the right-handed projection does.
  const Json correct =
      step_json(here, {kModel, s4_5(), book::perspective_d3d_right(kFovy, 1, 0.1, 100), kPoints});
  for (const std::size_t i : {0u, 1u}) {
    CHECK(double(answer.json["alternatives"][0]["window"][i]) ==
          Approx(double(correct["points"][0]["window"]["position"][i])));
  }

  // A point behind the camera is drawn instead.
  const Json behind = step_json(here, {book::identity(), s4_5(), projection, "--point 6,4,10"});
  CHECK(behind["points"][0]["fate"] == "visible");
  // One point is enough for this finding.
  const Answer one = run_step(here, {book::identity(), s4_5(), projection, "--point 0,0,0"});
  CHECK(contains(one.text, "behind the eye (w = -6.16441)"));
  CHECK(one.json["alternatives"][0]["ids"] == Json{"eye-hand"});
}

TEST_CASE(
    "E12, the other way round: which of the two has to change follows from the world's hand") {
  const WorkingDirectory here;
  const Call call{kModel, book::look_at_left(kEye, kTarget, kUp), kProjection, kPoints};
  Call left = call;
  left.options += "--world left";
  for (const auto& [asked, change] : {std::pair{call, "turn-round"}, std::pair{left, "eye-hand"}}) {
    const Answer answer = run_step(here, asked);
    CAPTURE(answer.text);
    CHECK(contains(answer.text, "every w is negative (3 of 3 points)"));
    CHECK(contains(answer.text, "handedness is mixed (E12)"));
    CHECK(answer.json["alternatives"][0]["ids"] == Json{change});
  }
}

TEST_CASE("E13: a window's whole size taken for half of it draws everything half as large") {
  const WorkingDirectory here;
  // The matrix of S3.33 with s = ResX instead of half of it.
  Rows projection = book::perspective_d3d_left(kFovy, 16.0 / 9, 0.1, 100);
  projection[0][0] /= 2;
  projection[1][1] /= 2;
  const Answer answer =
      run_step(here, {kModel, book::look_at_left(kEye, kTarget, kUp), projection, kPoints});
  CHECK(findings(answer.json, "hint") == Ids{"half-window"});
  CHECK(contains(answer.text, "it would be 60 degrees"));
  CHECK(contains(answer.text, "(E13)"));
  // The same slip with a round horizontal angle instead of a vertical one, and a window of a round
  // size that somebody typed on purpose.
  Rows across =
      book::perspective_gl(2 * std::atan(std::tan(kFovy / 2) * 9 / 16), 16.0 / 9, 0.1, 100);
  CHECK(findings(step_json(here, {kModel, kView, across, kPoints}), "hint") == Ids());
  across[0][0] /= 2;
  across[1][1] /= 2;
  CHECK(findings(step_json(here, {kModel, kView, across, kPoints}), "hint") == Ids{"half-window"});
  const Rows typed = book::frustum_gl(-0.15, 0.15, -0.1, 0.1, 0.2, 100);
  CHECK(findings(step_json(here, {kModel, kView, typed, kPoints}), "hint") == Ids());
}

TEST_CASE("E13: AR is ResX/ResY, not the other way round") {
  const WorkingDirectory here;
  const double cot = 1 / std::tan(kFovy / 2), ar = 3.0 / 2;
  Rows projection = book::perspective_d3d_left(kFovy, 1.5, 0.1, 100);
  projection[0][0] = cot;
  projection[1][1] = cot / ar;  // S3.33 has AR * cot
  const Answer answer = run_step(here, {kModel, book::look_at_left(kEye, kTarget, kUp), projection,
                                        std::string(kPoints) + "--size 600x400"});
  CHECK(findings(answer.json, "hint") == Ids{"aspect"});
  CHECK(contains(answer.text, "it is height/width"));
}

TEST_CASE("E15: the matrix of rank 3 draws, and destroys depth") {
  const WorkingDirectory here;
  for (const double d : {1.0, 2.0}) {
    const Rows projection{{{d, 0, 0, 0}, {0, d, 0, 0}, {0, 0, d, 0}, {0, 0, 1, 0}}};
    const Answer answer =
        run_step(here, {kModel, book::look_at_left(kEye, kTarget, kUp), projection, kPoints});
    CAPTURE(answer.text);
    CHECK(findings(answer.json, "alarm") == Ids{"depth-lost"});
    CHECK(answer.json["matrices"]["projection"]["rank"] == 3);
    CHECK(contains(answer.text, "every distance gets the same depth"));
    CHECK(contains(answer.text, "a depth buffer cannot hide anything (E15)"));
    for (const Json& point : answer.json["points"]) CHECK(double(point["ndc"]["position"][2]) == d);
  }
}

TEST_CASE(
    "E16: near planes of the other range of depth clip too much, or waste half of the depths") {
  const WorkingDirectory here;
  // The point is 0.15 in front of the eye: farther than near = 0.1, but nearer than 0.1998.
  const Answer clipped = run_step(
      here, {book::identity(), book::identity(), kProjection, "--point 0,0,-0.15 --dialect d3d"});
  CHECK(clipped.json["points"][0]["fate"] == "outside");
  CHECK(clipped.json["points"][0]["deciding_plane"] == "near");
  CHECK(findings(clipped.json, "alarm") == Ids{"z-range"});
  CHECK(contains(clipped.text, "everything nearer than 0.1998 is clipped (E16)"));
  CHECK(clipped.json["alternatives"][0]["ids"] == Json{"depth-range"});
  // At 0.07 the point is nearer than near = 0.1, but is shown all the same.
  const Rows d3d = book::perspective_d3d_right(kFovy, 1.5, 0.1, 100);
  const Answer wasted = run_step(
      here, {book::identity(), book::identity(), d3d, "--point 0,0,-0.07 --dialect opengl"});
  CHECK(wasted.json["visible"] == 1);
  CHECK(findings(wasted.json, "alarm") == Ids{"z-range"});
  CHECK(contains(wasted.text, "half of the depth buffer is wasted"));
}

TEST_CASE("E18: a model matrix that mirrors turns front faces into back faces") {
  const WorkingDirectory here;
  const Answer answer =
      run_step(here, {book::product(kModel, book::scaling(-1, 1, 1)), kView, kProjection, kPoints});
  CHECK(findings(answer.json, "hint") == Ids{"mirror"});
  CHECK(contains(answer.text, "front faces become back faces (C-17, E18)"));
}

TEST_CASE("E20: what the standard camera culls, the camera of one eye shows") {
  const WorkingDirectory here;
  const double s = 0.05, f = 1, distance = 50;
  const Rows left_eye = book::product(kProjection, skew(s, -f));
  // The x coordinate halfway between the right edges of the two windows.
  const double edge = distance * std::tan(kFovy / 2) * 1.5;
  const double shift = s * (distance / f - 1);
  const std::string point =
      "--point " + std::to_string(edge + shift / 2) + ",0," + std::to_string(-distance);
  const Json centre = step_json(here, {book::identity(), book::identity(), kProjection, point});
  CHECK(centre["points"][0]["fate"] == "outside");
  CHECK(centre["points"][0]["deciding_plane"] == "right");
  CHECK(findings(centre, "alarm") == Ids());
  const Json eye = step_json(here, {book::identity(), book::identity(), left_eye, point});
  CHECK(eye["points"][0]["fate"] == "visible");
}

}  // namespace
}  // namespace glassbox::test
