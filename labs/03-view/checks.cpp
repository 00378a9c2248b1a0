// The expected answers of lab 3, computed by the pipeline's own view matrices; some answers are
// judged by the properties of a rotation.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>

#include "labs/03-view/generators.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_03;

constexpr double u = unit_roundoff<double>;

double length(const Direction& v) {
  return std::sqrt(dot(v, v));
}

double sine_between(const Direction& a, const Direction& b) {
  return length(cross(a * (1 / length(a)), b * (1 / length(b))));
}

// ---- views ----

struct Bounds {
  double rotation, view;
};

std::vector<Expected> view_fields(const Transform<Eye, World>& view, const Bounds& bounds) {
  return {matrix("rotation", 3, entries(view, 3, 3), bounds.rotation),
          matrix("eye_from_world", 4, entries(view), bounds.view, "world units")};
}

std::string camera_text(const Camera& camera) {
  const auto& [eye, target, up] = camera;
  return fmt::format("eye ({}, {}, {}), target ({}, {}, {}), up ({}, {}, {})", eye.x, eye.y, eye.z,
                     target.x, target.y, target.z, up.x, up.y, up.z);
}

Case expect_view(const CameraCase& input, const Bounds& bounds) {
  const Camera& camera = input.camera;
  const auto found = look_at(camera.eye, camera.target, camera.up);
  const Transform<Eye, World> view = found.value_or(Transform<Eye, World>{});
  Case c{input.what,
         fmt::format("{}; the target comes to (0, 0, {:.9g}) in eye space", camera_text(camera),
                     -length(camera.target - camera.eye)),
         view_fields(view, bounds)};
  // The mistake of looking along +z, with N = +gaze or with the slide's rotation (erratum E7): the
  // matrix is the right one after half a turn about V.
  Transform<Eye, World> backwards = view, columns = view;
  for (int j = 0; j < 4; ++j) {
    backwards.at(0, j) = -backwards.at(0, j);
    backwards.at(2, j) = -backwards.at(2, j);
  }
  // The mistake of writing U, V, N as the columns, with the right translation or with the one that
  // follows from these columns.
  const Direction t{view.at(0, 3), view.at(1, 3), view.at(2, 3)};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) columns.at(i, j) = view.at(j, i);
  }
  Transform<Eye, World> columns_times_eye = columns;
  const Direction e{camera.eye.x, camera.eye.y, camera.eye.z};
  const Direction moved =
      -Direction{columns.at(0, 0) * e.x + columns.at(0, 1) * e.y + columns.at(0, 2) * e.z,
                 columns.at(1, 0) * e.x + columns.at(1, 1) * e.y + columns.at(1, 2) * e.z,
                 columns.at(2, 0) * e.x + columns.at(2, 1) * e.y + columns.at(2, 2) * e.z};
  columns_times_eye.at(0, 3) = moved.x;
  columns_times_eye.at(1, 3) = moved.y;
  columns_times_eye.at(2, 3) = moved.z;
  // If U is N x up instead of up x N, V = N x U has the wrong sign, too.
  Transform<Eye, World> exchanged = view, forward = view, long_u = view, long_n = view;
  // The lengths of vectors that are not normalised by mistake: `u_length` for U and V, `n` for V
  // and N.
  const Direction gaze = camera.target - camera.eye;
  const double n = length(gaze), u_length = length(camera.up) * sine_between(camera.up, gaze);
  for (int j = 0; j < 4; ++j) {
    exchanged.at(0, j) = -view.at(0, j);
    exchanged.at(1, j) = -view.at(1, j);
    long_u.at(0, j) = u_length * view.at(0, j);
    long_u.at(1, j) = u_length * view.at(1, j);
    long_n.at(1, j) = n * view.at(1, j);
    long_n.at(2, j) = n * view.at(2, j);
  }
  for (int i = 0; i < 3; ++i) forward.at(i, 3) = -view.at(i, 3);
  const auto longer = [&](double by) {
    return Bounds{bounds.rotation * std::max(1.0, by), bounds.view * std::max(1.0, by)};
  };
  c.slipped = {{"z-sign", view_fields(backwards, bounds)},
               {"row-column-order", view_fields(columns, bounds)},
               {"row-column-order", view_fields(columns_times_eye, bounds)},
               {"cross-order", view_fields(exchanged, bounds)},
               {"translation-sign", view_fields(forward, bounds)},
               {"not-normalised", view_fields(long_u, longer(u_length))},
               {"not-normalised", view_fields(long_n, longer(n))}};
  return c;
}

// The bound of -U.e (e: the position of the eye) that follows from the bound of the axes: it covers
// three products with the eye's coordinates, and their own roundings.
double with_eye(double bound, const Camera& camera) {
  const double largest =
      std::max({std::abs(camera.eye.x), std::abs(camera.eye.y), std::abs(camera.eye.z)});
  return bound * (1 + 2 * largest);
}

// With u the unit roundoff, the error of N is at most 4 u, and that of up x N, whose length is s,
// at most 10 u. So the error of U is 10 u / s, and that of V = N x U is larger by that of a
// product. The pipeline's own axes are within (8 + 4/s) u. Together this is less than
// 32 u (1 + 1/s). The three products of U.e (e: the position of the eye) sum up to at most sqrt(3)
// times the largest coordinate, since U has length 1.
Bounds uvn_bounds(const Camera& camera) {
  const double s = sine_between(camera.up, camera.target - camera.eye);
  const double bound = 32 * u * (1 + 1 / s);
  return {bound, with_eye(bound, camera)};
}

Case expect_uvn(const CameraCase& input) {
  return expect_view(input, uvn_bounds(input.camera));
}

bool right_view(const Transform<Eye, World>& view, const Answer& answer, const Bounds& bounds) {
  return has_numbers(answer, "rotation", entries(view, 3, 3), bounds.rotation) &&
         has_numbers(answer, "eye_from_world", entries(view), bounds.view);
}

// A camera that may have no view.
Case expect_any_uvn(const CameraCase& input) {
  const Camera& camera = input.camera;
  const bool has_view = look_at(camera.eye, camera.target, camera.up).has_value();
  const Expected there = numbers("there is a view", {has_view ? 1.0 : 0.0});
  if (!has_view)
    return {input.what, camera_text(camera) + "; 1: there is a view, 0: std::nullopt", {there}};
  Case c = expect_uvn(input);
  c.expected.insert(c.expected.begin(), there);
  for (ExpectedWithSlip& slip : c.slipped) slip.expected.insert(slip.expected.begin(), there);
  return c;
}

bool right_uvn(const CameraCase& input, const Answer& answer) {
  const Camera& camera = input.camera;
  const auto view = look_at(camera.eye, camera.target, camera.up);
  const std::vector<double> there{view ? 1.0 : 0.0};
  if (!has_numbers(answer, "there is a view", there, 0)) return false;
  return !view || right_view(*view, answer, uvn_bounds(camera));
}

// u is the unit roundoff, s the sine of the angle between the gaze and `up`. With the unit gaze
// (x, y, z), the first rotation's axis is its cross product with (0, 0, -1), which is (-y, x, 0)
// exactly. So x and y have relative errors of 3 u, apart from those of a factor that they share,
// even where they are so small that the gaze is nearly along +z. The matrix is then off by 8 u from
// the axis' direction, 16 u from its length, 10 u from the angle, and 10 u from products and sums:
// 44 u in all. The second rotation's angle comes from the turned `up`, whose x and y are off by
// 48 u of its length: by 48 u / s; its own roundings are 5 u. The pipeline's axes are within
// (8 + 4/s) u. Together this is less than 64 u (1 + 1/s).
Bounds axis_angle_bounds(const Camera& camera) {
  const double s = sine_between(camera.up, camera.target - camera.eye);
  const double bound = 64 * u * (1 + 1 / s);
  return {bound, with_eye(bound, camera)};
}

bool right_axis_angle(const CameraCase& input, const Answer& answer) {
  const Camera& camera = input.camera;
  const auto view = look_at(camera.eye, camera.target, camera.up);
  return right_view(view.value_or(Transform<Eye, World>{}), answer, axis_angle_bounds(camera));
}

Case expect_axis_angle(const CameraCase& input) {
  Case c = expect_view(input, axis_angle_bounds(input.camera));
  // In this task no U and V are computed, so there is no cross product whose factors could be
  // swapped.
  std::erase_if(c.slipped, [](const ExpectedWithSlip& each) { return each.slip == "cross-order"; });
  return c;
}

Case expect_refused(const RefusedCase& input) {
  return {input.what,
          "without a view: " + camera_text(input.bad) +
              "; with a view: " + camera_text(input.good) + "; 1: a matrix, 0: std::nullopt",
          {numbers("answer without a view", {0}), numbers("answer with a view", {1})}};
}

// ---- one direction onto another ----

std::string onto_text(const OntoCase& input) {
  const auto& [what, from, to] = input;
  return fmt::format("from ({}, {}, {}) to ({}, {}, {})", from.x, from.y, from.z, to.x, to.y, to.z);
}

// The vector divided by its length. It is divided by its largest component first, since F may be a
// format in which squares of doubles overflow or become 0.
template <class F>
Vector<World, F> unit(const Direction& d) {
  const double largest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  const Vector<World, F> v(F(d.x) / largest, F(d.y) / largest, F(d.z) / largest);
  const F size = std::sqrt(dot(v, v));
  return {v.x / size, v.y / size, v.z / size};
}

struct Onto {
  std::vector<double> rotation;
  double bound = 0;
  Direction axis;
  double radians = 0;
};

// With the unit vectors f and t of the two directions, v = f x t, cos = f.t, and [v]x the matrix of
// the cross product with v, the rotation is R = cos I + [v]x + v v^T / (1 + cos). Beyond a right
// angle 1 + cos is computed as |v|^2 / (1 - cos), where no digits cancel.
Onto onto_of(const OntoCase& input) {
  using Long = Vector<World, long double>;
  const Long f = unit<long double>(input.from), t = unit<long double>(input.to);
  const Long across = cross(f, t);
  const long double cosine = dot(f, t), square = dot(across, across);
  const long double factor = cosine >= 0 ? 1 / (1 + cosine) : (1 - cosine) / square;
  const long double v[3] = {across.x, across.y, across.z};
  Onto made;
  made.rotation.resize(9);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    made.rotation[3 * i + i] = double(cosine + v[i] * v[i] * factor);
    made.rotation[3 * i + j] = double(v[i] * v[j] * factor - v[k]);
    made.rotation[3 * j + i] = double(v[i] * v[j] * factor + v[k]);
  }
  // The error of the axis is 10 u / sine (u: the unit roundoff). Up to a right angle the axis is
  // multiplied by the sine, so the bound has no 1 / sine.
  const double sine = double(std::sqrt(square));
  made.bound = cosine >= 0 ? 64 * u : 32 * u * (1 + 1 / sine);
  made.radians = std::atan2(sine, double(cosine));
  made.axis = {double(across.x), double(across.y), double(across.z)};
  return made;
}

Case expect_onto(const OntoCase& input) {
  const auto [rotation, bound, axis, radians] = onto_of(input);
  Case c{input.what,
         fmt::format("{}, an angle of {:.9g} radians", onto_text(input), radians),
         {matrix("rotation", 3, rotation, bound)}};
  // The mistake of half or twice the angle is an entry of this case, because slips.h cannot
  // recognise it in the matrix of a small rotation.
  for (const double factor : {0.5, 2.0}) {
    const auto slipped = rotate_degrees<World>(axis, factor * degrees_from_radians(radians));
    if (!slipped) continue;
    // The bound is doubled, because twice the angle has twice the error.
    c.slipped.push_back(
        {"half-angle", {matrix("rotation", 3, entries(*slipped, 3, 3), 2 * bound)}});
  }
  return c;
}

std::optional<Divergence> judge_half_turn(const OntoCase& input, const Answer& answer) {
  Divergence found;
  found.field = "rotation";
  const auto* values = find_field(answer, "rotation");
  if (values == nullptr || values->size() != 9) {
    found.kind = Divergence::Kind::kMissing;
    found.explanation = "9 numbers are expected";
    return found;
  }
  glm::dmat3 m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[j][i] = (*values)[std::size_t(3 * i + j)];
  }
  // The bound, with u the unit roundoff: if the axis has errors of 4 u, products of two rows have
  // errors of 8 u, and their sums of three terms round, too. The same holds for the image of
  // `from`.
  found.bound = 16 * u;
  found.element = "largest entry of |R^T R - I|";
  found.actual = found.distance = orthogonality_error(m);
  if (std::isnan(found.actual)) found.kind = Divergence::Kind::kNotANumber;
  if (!(found.distance <= found.bound)) return found;
  found.element = "determinant";
  found.expected = 1;
  found.actual = glm::determinant(m);
  if (!(found.actual > 0)) {
    found.distance = std::abs(found.actual - 1);
    found.explanation = "this is a mirror, not a rotation";
    return found;
  }
  const glm::dvec3 image = m * to_glm(unit<double>(input.from));
  const glm::dvec3 wanted = to_glm(unit<double>(input.to));
  for (int i = 0; i < 3; ++i) {
    found.element = fmt::format("{} of the image of `from`", "xyz"[i]);
    found.expected = wanted[i];
    found.actual = image[i];
    found.distance = std::abs(image[i] - wanted[i]);
    if (!(found.distance <= found.bound)) return found;
  }
  return std::nullopt;
}

Case expect_half_turn(const OntoCase& input) {
  return {.where = input.what,
          .restated = onto_text(input) + "; any axis perpendicular to them is right",
          .judge = [input](const Answer& answer) { return judge_half_turn(input, answer); }};
}

// Whether the directions are opposite, as the contract allows it: their lengths are equal, or both
// are along x, y or z.
bool are_opposite(const OntoCase& input) {
  if (input.to == -input.from) return true;
  return along_one_axis(input.from, input.to) &&
         (std::signbit(input.from.x + input.from.y + input.from.z) !=
          std::signbit(input.to.x + input.to.y + input.to.z));
}

Case expect_any_onto(const OntoCase& input) {
  return are_opposite(input) ? expect_half_turn(input) : expect_onto(input);
}

bool right_onto(const OntoCase& input, const Answer& answer) {
  if (are_opposite(input)) return !judge_half_turn(input, answer);
  const Onto onto = onto_of(input);
  return has_numbers(answer, "rotation", onto.rotation, onto.bound);
}

// ---- mirrors and hands ----

// Whether the matrix is neither, a rotation, a mirror: one of the three is 1.
std::vector<double> kind_numbers(const KindCase& input) {
  const glm::dmat3 m(input.matrix.columns);
  if (!(orthogonality_error(m) <= 1e-5)) return {1, 0, 0};
  if (glm::determinant(m) > 0) return {0, 1, 0};
  return {0, 0, 1};
}

bool right_kind(const KindCase& input, const Answer& answer) {
  return has_numbers(answer, "neither, rotation, mirror", kind_numbers(input), 0);
}

Case expect_kind(const KindCase& input) {
  const glm::dmat3 m(input.matrix.columns);
  std::string text = "rows";
  for (int i = 0; i < 3; ++i) text += fmt::format(" ({}, {}, {})", m[0][i], m[1][i], m[2][i]);
  return {input.what, text, {numbers("neither, rotation, mirror", kind_numbers(input))}};
}

Case expect_hand(const HandCase& input) {
  const auto given = watt_projection(input);
  Transform<Eye, Eye> other_hand;
  other_hand.at(2, 2) = -1;
  return {fmt::format("near {}, far {}, half height {}", input.d, input.f, input.h),
          fmt::format("(0, 0, {}), on the near plane, comes to z = 0, w = {} in clip space",
                      -input.d, input.d),
          {matrix("clip_from_eye", 4, entries(given * other_hand))}};
}

// S = diag(1, 1, -1, 1) changes the signs of the third column.
std::vector<double> for_the_other_hand(const ProjectionCase& input) {
  Transform<Clip, Eye> m = input.matrix;
  for (int i = 0; i < 4; ++i) m.at(i, 2) = -m.at(i, 2);
  return entries(m);
}

Case expect_any_hand(const ProjectionCase& input) {
  std::string text = "rows";
  for (int i = 0; i < 4; ++i) {
    const auto& m = input.matrix;
    text += fmt::format(" ({}, {}, {}, {})", m.at(i, 0), m.at(i, 1), m.at(i, 2), m.at(i, 3));
  }
  return {input.what, text, {matrix("clip_from_eye", 4, for_the_other_hand(input))}};
}

bool right_hand(const ProjectionCase& input, const Answer& answer) {
  return has_numbers(answer, "clip_from_eye", for_the_other_hand(input), 0);
}

}  // namespace

Lab lab_03() {
  return {
      3,
      "03-view",
      "View transforms: two constructions, mirrors and hands",
      {{"3.1", "The view matrix from U, V, N", 30},
       {"3.2", "The rotation of one direction onto another", 20},
       {"3.3", "The view matrix by two rotations", 25},
       {"3.4", "Tell rotations from mirrors", 10},
       {"3.5", "A left-handed projection for a right-handed eye", 15}},
      {check("the view from the axes of the eye", "3.1", "eye", cameras, expect_uvn),
       check("cameras without a view are refused", "3.1", "eye", refused_cameras, expect_refused),
       generated_check("any camera", "3.1", "eye", generated_cameras, expect_any_uvn, right_uvn),
       hidden_check("other cameras", "3.1", "eye", hidden_cameras, expect_uvn),
       hidden_check("other cameras without a view", "3.1", "eye", hidden_refused_cameras,
                    expect_refused),
       check("one direction onto another", "3.2", "eye", directions, expect_onto),
       check("half a turn", "3.2", "eye", opposite_directions, expect_half_turn),
       generated_check("any two directions", "3.2", "eye", generated_directions, expect_any_onto,
                       right_onto),
       hidden_check("other directions", "3.2", "eye", hidden_directions, expect_onto),
       hidden_check("other half turns", "3.2", "eye", hidden_opposite_directions, expect_half_turn),
       check("two rotations give the same view", "3.3", "eye", cameras, expect_axis_angle),
       generated_check("two rotations, any camera", "3.3", "eye", generated_views,
                       expect_axis_angle, right_axis_angle),
       hidden_check("two rotations, other cameras", "3.3", "eye", hidden_cameras,
                    expect_axis_angle),
       check("rotations, mirrors and neither", "3.4", "eye", kinds, expect_kind),
       generated_check("any matrix", "3.4", "eye", generated_kinds, expect_kind, right_kind),
       hidden_check("other matrices", "3.4", "eye", hidden_kinds, expect_kind),
       check("a left-handed projection for a right-handed eye", "3.5", "eye", hands, expect_hand),
       generated_check("any projection", "3.5", "eye", generated_projections, expect_any_hand,
                       right_hand),
       hidden_check("other projections", "3.5", "eye", hidden_hands, expect_hand)}};
}

}  // namespace glassbox::labs
