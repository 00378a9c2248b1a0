// Lab 2 in a picture: the transform of each object. Its matrix is decomposed into a scaling, three
// shears, a rotation and a translation. The student's functions repair the rotation, find its axis
// and angle, and compose everything again.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "labs/drawing/drawing.h"

#include <glassbox/base/rounding.h>
#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox::labs {

namespace lab_02_drawing {

constexpr double u = unit_roundoff<double>;
using Map = Transform<World, Object>;

// The values of lab_02::Step::Kind.
constexpr double kTranslate = 0, kRotate = 1, kScale = 2, kShear = 3;
constexpr std::size_t kStepNumbers = 7;  // kind, v, amount, changed, by

Numbers step(double kind, const glm::dvec3& v, double amount = 0, int changed = 0, int by = 1) {
  return {kind, v.x, v.y, v.z, amount, double(changed), double(by)};
}

// ---- a matrix taken apart: linear part = turn * upper triangle (Gram and Schmidt) ----

struct Parts {
  glm::dmat3 turn{1};
  Numbers before;  // the steps before the rotation: a scaling and three shears
  glm::dvec3 shift{0};
};

Parts parts_of(const Map& m) {
  Parts parts;
  const glm::dmat3 linear(m.columns);
  glm::dmat3 q(1);
  glm::dmat3 r(0);  // r[column][row]
  for (int j = 0; j < 3; ++j) {
    glm::dvec3 rest = linear[j];
    for (int i = 0; i < j; ++i) {
      r[j][i] = glm::dot(q[i], linear[j]);
      rest -= q[i] * r[j][i];
    }
    r[j][j] = glm::length(rest);
    if (r[j][j] > 0) q[j] = rest / r[j][j];
  }
  // A mirror is represented as a negative scale, since a rotation cannot contain it.
  if (glm::determinant(q) < 0) {
    q[2] = -q[2];
    r[2][2] = -r[2][2];
  }
  parts.turn = q;
  const auto share = [&](int row, int column) {
    return r[column][column] != 0 ? r[column][row] / r[column][column] : 0;
  };
  for (const Numbers& each :
       {step(kScale, {r[0][0], r[1][1], r[2][2]}), step(kShear, {0, 0, 0}, share(0, 1), 0, 1),
        step(kShear, {0, 0, 0}, share(0, 2), 0, 2), step(kShear, {0, 0, 0}, share(1, 2), 1, 2)})
    parts.before.insert(parts.before.end(), each.begin(), each.end());
  parts.shift = glm::dvec3(m.columns[3]);
  return parts;
}

// ---- the reference ----

glm::dmat3 linear_part(std::span<const double> rows) {
  glm::dmat3 m(0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[j][i] = rows[std::size_t(4 * i + j)];
  }
  return m;
}

Numbers repaired(RecordReader& in) {
  const Map m = in.matrix<Map>();
  const auto nearest = nearest_rotation(glm::dmat3(m.columns));
  Numbers out;
  append_matrix(out, nearest ? Map(glm::dmat4(nearest->rotation)) : Map());
  return out;
}

Numbers axis(RecordReader& in) {
  const auto found = axis_angle_of(in.matrix<Map>());
  return {found.axis.x, found.axis.y, found.axis.z, found.radians};
}

Numbers composed(RecordReader& in) {
  Map m;
  while (in.more()) {
    const double kind = in.number();
    const auto v = in.point<Vector<World, double>>();
    const double amount = in.number();
    const int changed = in.integer(), by = in.integer();
    Transform<World, World> next;
    if (kind == kTranslate) next = translate<World, World>(v);
    if (kind == kScale) next = scale<World, World>(v.x, v.y, v.z);
    if (kind == kShear) next = shear<World, World>(Axis(changed), Axis(by), amount);
    if (kind == kRotate) {
      const auto turn = rotate_degrees<World, World>(v, amount);
      if (turn) next = *turn;
    }
    m = next * m;
  }
  Numbers out;
  append_matrix(out, m);
  return out;
}

// ---- judgement: the bounds of student.h ----

std::optional<WrongNumber> judge_repaired(const Numbers& in, const Numbers& yours,
                                          const Numbers& reference) {
  if (yours.size() != 16) return first_wrong_entry(yours, reference, 0, "");
  const double drift = orthogonality_error(linear_part(in));
  const double error = orthogonality_error(linear_part(yours));
  if (!(error <= 16 * u))
    return WrongNumber{"largest entry of |R^T R - I|", error, 0, 16 * u, "", ""};
  return first_wrong_entry(yours, in, 3 * drift + 16 * u, "");
}

// The bounds: the matrix is a rotation up to some u (the unit roundoff), so the angle is off by at
// most 64 u max(1, angle), and the axis by 64 u / min(1, angle).
std::optional<WrongNumber> judge_axis(const Numbers&, const Numbers& yours,
                                      const Numbers& reference) {
  constexpr double kHalfTurn = 3.14159265358979323846;
  const double angle = reference[3];
  const double angle_bound = 64 * u * std::max(1.0, angle);
  const bool any_axis = angle <= 1e-12;
  const double axis_bound = any_axis ? 2 : 64 * u / std::min(1.0, angle);
  Numbers turned = yours;
  if (kHalfTurn - angle < 1e-6 && turned.size() == 4) {  // either direction is right
    const double along =
        turned[0] * reference[0] + turned[1] * reference[1] + turned[2] * reference[2];
    for (std::size_t k = 0; k < 3; ++k) turned[k] = along < 0 ? -turned[k] : turned[k];
  }
  return first_wrong(
      turned, reference, [&](std::size_t i) { return i == 3 ? angle_bound : axis_bound; }, "",
      [](std::size_t i) {
        return i == 3 ? std::string("angle") : fmt::format("axis, {}", "xyz"[i]);
      });
}

// The bound: 64 k u times the product of the norms of the k steps (u: the unit roundoff), and as
// much again for the reference's error.
std::optional<WrongNumber> judge_composed(const Numbers& in, const Numbers& yours,
                                          const Numbers& reference) {
  double product = 1;
  for (std::size_t i = 0; i < in.size(); i += kStepNumbers) {
    RecordReader one(&in[i], kStepNumbers);
    const Numbers matrix = composed(one);
    double norm = 0;
    for (std::size_t row = 0; row < 4; ++row) {
      double sum = 0;
      for (std::size_t k = 0; k < 4; ++k) sum += std::abs(matrix[4 * row + k]);
      norm = std::max(norm, sum);
    }
    product *= norm;
  }
  const double steps = double(in.size() / kStepNumbers);
  return first_wrong_entry(yours, reference, 128 * steps * u * product, "");
}

// ---- in the scene ----

const std::vector<DrawnStage>& stages() {
  static const std::vector<DrawnStage> all{
      {"repair", "world", "repaired", repaired, judge_repaired, in_words({{"matrix", 16}})},
      {"axis", "world", "axis_angle_of", axis, judge_axis, in_words({{"matrix", 16}})},
      {"place", "world", "compose", composed, judge_composed,
       in_words({{"kind, v, amount, changed, by of step", 7, kAllThatFollow}})}};
  return all;
}

Question matrix_question(const Numbers& rows) {
  Question question{rows};
  question.numbers.resize(16);
  for (double& each : question.numbers) each = std::isfinite(each) ? each : 0;
  return question;
}

Question compose_question(const Parts& parts, Numbers turn) {
  turn.resize(4);
  for (double& each : turn) each = std::isfinite(each) ? each : 0;
  Question question{parts.before};
  const glm::dvec3 axis(turn[0], turn[1], turn[2]);
  const bool turns = glm::length(axis) > 0;
  // The axis of a step need not have length 1: functions that forget to normalise it are seen.
  const Numbers rotate = step(kRotate, turns ? 2.0 * axis : glm::dvec3(0, 0, 1),
                              turns ? std::clamp(degrees_from_radians(turn[3]), -360.0, 360.0) : 0);
  const Numbers shift = step(kTranslate, parts.shift);
  question.numbers.insert(question.numbers.end(), rotate.begin(), rotate.end());
  question.numbers.insert(question.numbers.end(), shift.begin(), shift.end());
  return question;
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  PictureSetup made{input.scene, input.view, input.settings, nullptr, {}};
  std::vector<std::uint32_t> nodes;
  for (const Instance& instance : input.scene.instances) nodes.push_back(instance.node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());

  std::vector<Parts> parts;
  std::vector<Question> questions;
  for (const std::uint32_t node : nodes) {
    parts.push_back(parts_of(input.scene.nodes[node].world_from_node));
    questions.emplace_back();
    append_matrix(questions.back().numbers, Map(glm::dmat4(parts.back().turn)));
  }
  const auto turns = answer_source.ask(stages()[0], questions);
  if (!turns) return tl::unexpected(turns.error());
  for (std::size_t i = 0; i < nodes.size(); ++i) questions[i] = matrix_question((*turns)[i]);
  const auto axes = answer_source.ask(stages()[1], questions);
  if (!axes) return tl::unexpected(axes.error());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    questions[i] = compose_question(parts[i], (*axes)[i]);
  const auto composed_matrices = answer_source.ask(stages()[2], questions);
  if (!composed_matrices) return tl::unexpected(composed_matrices.error());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Question finite = matrix_question((*composed_matrices)[i]);
    RecordReader reader(finite.numbers.data(), 16);
    made.scene.nodes[nodes[i]].world_from_node = reader.matrix<Map>();
  }
  return made;
}

}  // namespace lab_02_drawing

LabDrawing drawing_02() {
  using namespace lab_02_drawing;
  return {stages(), draw, "turn_about and fit_affine, which work in the plane"};
}

}  // namespace glassbox::labs
