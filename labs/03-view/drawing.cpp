// Lab 3 in a picture: the student's functions make the view matrix, change the projection for our
// eye space, and find the mirrored models.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "labs/drawing/drawing.h"

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/render/engine/draw_list.h>

namespace glassbox::labs {

namespace lab_03_drawing {

constexpr double u = unit_roundoff<double>;
constexpr double kRotation = 1, kMirror = 2;  // lab_03::Kind

struct ParsedQuestion {
  bool by_rotations = false;
  Point<World, double> eye, target;
  Vector<World, double> up;

  explicit ParsedQuestion(const Numbers& question) {
    RecordReader in(question.data(), question.size());
    by_rotations = in.number() != 0;
    eye = in.point<Point<World, double>>();
    target = in.point<Point<World, double>>();
    up = in.point<Vector<World, double>>();
  }
};

double length(const Vector<World, double>& v) {
  return std::sqrt(dot(v, v));
}

// ---- the reference ----

Numbers numbers_left(RecordReader& in) {
  Numbers numbers;
  while (in.more()) numbers.push_back(in.number());
  return numbers;
}

Numbers view(RecordReader& in) {
  const ParsedQuestion asked(numbers_left(in));
  const auto made = asked.by_rotations ? look_at_axis_angle(asked.eye, asked.target, asked.up)
                                       : look_at(asked.eye, asked.target, asked.up);
  Numbers out;
  if (made) append_matrix(out, *made);
  return out;
}

Numbers hand(RecordReader& in) {
  Numbers out;
  append_matrix(out, in.matrix<Transform<Clip, EyeLeft>>() * eye_left_from_eye());
  return out;
}

double determinant_of(const Transform<World, World>& m) {
  const auto column = [&](int k) {
    return Vector<World, double>(m.at(0, k), m.at(1, k), m.at(2, k));
  };
  return dot(cross(column(0), column(1)), column(2));
}

Numbers kind(RecordReader& in) {
  return {determinant_of(in.matrix<Transform<World, World>>()) > 0 ? kRotation : kMirror};
}

// ---- judgement ----

// The bounds of student.h, where s, g and D are explained: 32 u (1 + 1/s), or for two rotations
// 64 u (1 + 1/s + 1/g); in the last column they are multiplied by (1 + 2 D). They are doubled,
// because the reference's error is as large as the student's may be.
std::optional<WrongNumber> judge_view(const Numbers& in, const Numbers& yours,
                                      const Numbers& reference) {
  const ParsedQuestion asked(in);
  const Vector<World, double> gaze = asked.target - asked.eye;
  const double s = length(cross(asked.up, gaze)) / (length(asked.up) * length(gaze));
  const double g = std::hypot(gaze.x, gaze.y) / length(gaze);
  const double inverse_g = gaze.z > 0 && g > 0 ? 1 / g : 0;
  const double rotation =
      2 * u * (asked.by_rotations ? 64 * (1 + 1 / s + inverse_g) : 32 * (1 + 1 / s));
  const double far =
      std::max({std::abs(asked.eye.x), std::abs(asked.eye.y), std::abs(asked.eye.z)});
  return first_wrong(
      yours, reference,
      [&](std::size_t i) { return i % 4 == 3 ? rotation * (1 + 2 * far) : rotation; }, "",
      [](std::size_t i) { return fmt::format("row {}, column {}", i / 4, i % 4); });
}

std::optional<WrongNumber> judge_hand(const Numbers&, const Numbers& yours,
                                      const Numbers& reference) {
  return first_wrong_entry(yours, reference, 0, "");
}

std::optional<WrongNumber> judge_kind(const Numbers&, const Numbers& yours,
                                      const Numbers& reference) {
  return first_wrong(
      yours, reference, [](std::size_t) { return 0; }, "",
      [](std::size_t) { return std::string("0 neither, 1 rotation, 2 mirror"); });
}

// ---- in the pipeline ----

// The largest entry of R^T R - I in size, where R is the upper left 3 x 3 part of the matrix.
double from_rigid(const Transform<World, World>& m) {
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double sum = i == j ? -1 : 0;
      for (int k = 0; k < 3; ++k) sum += m.at(k, i) * m.at(k, j);
      most = std::max(most, std::abs(sum));
    }
  }
  return most;
}

// Culls faces according to the kinds of the models: a mirrored model has the opposite winding.
class StageObserver : public Observer {
public:
  StageObserver(std::map<std::uint32_t, bool> mirrored, Cull cull)
      : mirrored_(std::move(mirrored)), cull_(cull) {}

  void draw(const Draw& draw) override { draw_ = &draw; }

  void facing_tested(const TriangleSetup& setup, bool, bool& culled) override {
    const auto found = mirrored_.find(draw_->instance);
    if (found != mirrored_.end())
      culled = is_culled(*draw_, cull_, setup.clockwise == found->second);
  }

private:
  const std::map<std::uint32_t, bool> mirrored_;  // indexed by instance
  const Cull cull_;
  const Draw* draw_ = nullptr;
};

const std::vector<DrawnStage>& stages() {
  static const std::vector<DrawnStage> all{
      {"kind", "world", "kind_of", kind, judge_kind, in_words({{"model matrix", 16}})},
      {"view", "eye", "uvn_view or axis_angle_view", view, judge_view,
       in_words({{"form", 1, 1, {"by the axes U, V, N", "by two rotations"}},
                 {"eye", 3},
                 {"target", 3},
                 {"up", 3}})},
      {"hand", "clip", "for_right_handed_eye", hand, judge_hand, in_words({{"projection", 16}})}};
  return all;
}

Question camera_question(const DrawingInput& input) {
  const Transform<World, Eye>& m = input.camera.world_from_eye;
  const auto column = [&](int k) {
    return Vector<World, double>(m.at(0, k), m.at(1, k), m.at(2, k));
  };
  const Vector<World, double> place = column(3);
  const Point<World, double> eye(place.x, place.y, place.z);
  Question question{{input.formulation.view == ViewForm::kAxisAngle ? 1.0 : 0.0}};
  append_point(question.numbers, eye);
  // The camera's axes have length 1 and are perpendicular. Other lengths and directions, which give
  // the same axes, show functions that forget to normalise.
  append_point(question.numbers, eye + column(2) * -3.0);
  append_point(question.numbers, column(1) * 2.0 + column(2));
  return question;
}

Result<std::map<std::uint32_t, bool>> ask_for_kinds(const Scene& scene,
                                                    AnswerSource& answer_source) {
  // No question is asked about a matrix that is further from a rotation or mirror than this: the
  // contract of kind_of leaves the range from 10^-6 to 10^-4 open.
  constexpr double kRigid = 1e-6;
  std::vector<Question> questions;
  std::vector<std::uint32_t> instances;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Transform<World, World> m(scene.nodes[scene.instances[i].node].world_from_node.columns);
    if (from_rigid(m) > kRigid) continue;
    questions.emplace_back();
    append_matrix(questions.back().numbers, m);
    instances.push_back(i);
  }
  const auto answers = answer_source.ask(stages()[0], questions);
  if (!answers) return tl::unexpected(answers.error());
  std::map<std::uint32_t, bool> mirrored;
  for (std::size_t i = 0; i < instances.size(); ++i)
    mirrored[instances[i]] = !(*answers)[i].empty() && (*answers)[i][0] == kMirror;
  return mirrored;
}

// Asks the student's functions one question, whose answer is a matrix. Without a valid answer the
// matrix becomes 0.
template <class M>
Result<void> ask_for_matrix(const DrawnStage& stage, Question question, AnswerSource& answer_source,
                            M& matrix) {
  const auto answer = answer_source.ask(stage, std::array{std::move(question)});
  if (!answer) return tl::unexpected(answer.error());
  if (answer->front().size() != 16) {
    matrix = M(glm::dmat4(0));  // no picture can be drawn without a matrix
    return {};
  }
  RecordReader reader(answer->front().data(), 16);
  matrix = reader.matrix<M>();
  return {};
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  PictureSetup made{input.scene, input.view, input.settings, nullptr, {}};
  const auto mirrored = ask_for_kinds(input.scene, answer_source);
  if (!mirrored) return tl::unexpected(mirrored.error());
  made.settings.cull_stage = CullStage::kScreen;
  made.stages = std::make_shared<StageObserver>(*mirrored, input.settings.cull);
  if (const auto asked = ask_for_matrix(stages()[1], camera_question(input), answer_source,
                                        made.view.eye_from_world);
      !asked)
    return tl::unexpected(asked.error());
  Question projection;
  append_matrix(projection.numbers, input.view.clip_from_eye * eye_from_eye_left());
  if (const auto asked =
          ask_for_matrix(stages()[2], projection, answer_source, made.view.clip_from_eye);
      !asked)
    return tl::unexpected(asked.error());
  return made;
}

}  // namespace lab_03_drawing

LabDrawing drawing_03() {
  using namespace lab_03_drawing;
  return {stages(), draw, "rotation_onto, unless axis_angle_view calls it"};
}

}  // namespace glassbox::labs
