// Lab 4 in a picture: the student's functions make the projection, the divide, the viewport
// transform and, in pictures of depth, turn depths back into distances.
#include <algorithm>
#include <bit>
#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "labs/drawing/drawing.h"

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/render/engine/draw_list.h>

namespace glassbox::labs {

namespace lab_04_drawing {

constexpr double u = unit_roundoff<double>;
// the largest coordinate that the snap can handle, in pixels from the picture's corner
constexpr float kMaxPixels = 32767;

double largest(std::span<const double> numbers) {
  double most = 0;
  for (const double x : numbers) most = std::max(most, std::abs(x));
  return most;
}

// ---- the reference ----

Numbers projection(RecordReader& in) {
  const bool reversed = in.number() != 0, is_perspective = in.number() != 0;
  std::array<double, 6> n{};
  for (double& each : n) each = in.number();
  const auto made = is_perspective ? perspective(n[0], n[1], {n[2], n[3]})
                                   : orthographic({n[0], n[1], n[2], n[3]}, {n[4], n[5]});
  Numbers out;
  if (made) append_matrix(out, reversed ? reverse_depth() * *made : *made);
  return out;
}

Numbers divided(RecordReader& in) {
  Numbers out;
  while (in.more()) {
    const auto p = in.point<Point<Clip, double>>();
    if (!(p.w > 0)) return {};
    append_point(out, Point<Ndc, double>(p.x / p.w, p.y / p.w, p.z / p.w));
  }
  return out;
}

Numbers placed(RecordReader& in) {
  const double left = in.number(), top = in.number();
  const double width = in.number(), height = in.number();
  Numbers out;
  while (in.more()) {
    const auto p = in.point<Point<Ndc, double>>();
    append_point(out, Point<Screen, double>(left + (p.x + 1) / 2 * width,
                                            top + (1 - p.y) / 2 * height, p.z));
  }
  return out;
}

Numbers distances(RecordReader& in) {
  const double near = in.number(), far = in.number();
  Numbers out;
  while (in.more()) {
    const double depth = in.number();
    out.push_back(1 / ((1 - depth) / near + depth / far));
  }
  return out;
}

// ---- judgement: the bounds of student.h ----

// The bound, relative to the largest entry and with u the unit roundoff: 16 u for the projection, 4
// u for the dialect, and 4 u for our own matrix.
std::optional<WrongNumber> judge_projection(const Numbers&, const Numbers& yours,
                                            const Numbers& reference) {
  return first_wrong_entry(yours, reference, 24 * u * largest(reference), "");
}

std::string coordinate(std::size_t i) {
  return fmt::format("vertex {}, {}", i / 3, "xyz"[i % 3]);
}

std::optional<WrongNumber> judge_divided(const Numbers& in, const Numbers& yours,
                                         const Numbers& reference) {
  return first_wrong(
      yours, reference,
      [&](std::size_t i) {
        const bool is_parallel = in[i / 3 * 4 + 3] == 1;
        const auto vertex = std::span(reference).subspan(i / 3 * 3, 3);
        return is_parallel ? 0 : 4 * u * largest(vertex);
      },
      "", coordinate);
}

std::optional<WrongNumber> judge_placed(const Numbers& in, const Numbers& yours,
                                        const Numbers& reference) {
  return first_wrong(
      yours, reference,
      [&](std::size_t i) {
        if (i % 3 == 2) return 0.0;  // z keeps its bits
        // For a vertex outside the picture the bound grows with the vertex's NDC coordinate.
        const double ndc = std::abs(in[4 + i]);
        return 8 * u * (std::abs(in[i % 3]) + in[2 + i % 3]) * std::max(1.0, ndc);
      },
      "px", coordinate);
}

// The bound, with z the exact distance and u the unit roundoff: 8 u z^2 / near for the student's
// distance and as much for ours.
std::optional<WrongNumber> judge_distances(const Numbers& in, const Numbers& yours,
                                           const Numbers& reference) {
  return first_wrong(
      yours, reference,
      [&](std::size_t i) {
        const double z = reference[i];
        return std::isfinite(z) ? 16 * u * z * z / in[0] : 0;
      },
      "world units",
      [&](std::size_t i) {
        return fmt::format("the distance of depth {}", in[std::min(i + 2, in.size() - 1)]);
      });
}

// ---- in the pipeline ----

class StageObserver : public Observer {
public:
  explicit StageObserver(const Viewport& viewport) : viewport_(viewport) {}

  void draw(const Draw& draw) override { draw_ = &draw; }

  void clipped(const PrimitiveStage&, const Triangle& triangle, const std::array<ClipVertex, 3>&,
               ClipPolygon& polygon) override {
    number_ = draw_->first_number + triangle.number;
    count_ = std::size_t(polygon.count);
    vertex_ = 0;
    if (!gathering_ || count_ == 0) return;
    Question question{{}, number_};
    for (std::size_t i = 0; i < count_; ++i) {
      const Point<Clip>& p = polygon.vertices[i].position;
      append_point(question.numbers, p);
    }
    divide_questions.push_back(std::move(question));
  }

  void divided(const ClipVertex&, NdcVertex& ndc) override {
    if (!gathering_ && vertex_ < count_) place(ndcs_, ndc.position);
  }

  void mapped_to_screen(const NdcVertex&, ScreenVertex& screen) override {
    if (gathering_ || vertex_ >= count_) return;
    place(screens_, screen.position);
    screen.position.x = std::clamp(screen.position.x, -kMaxPixels, kMaxPixels);
    screen.position.y = std::clamp(screen.position.y, -kMaxPixels, kMaxPixels);
    ++vertex_;
  }

  // Makes the questions to to_screen. It gets NDC in double; the numbers are rounded to float only
  // for the later stages.
  std::vector<Question> take_ndcs(std::vector<Numbers> answers) {
    std::vector<Question> placing;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const std::uint32_t number = divide_questions[i].triangle;
      Question question{{viewport_.left, viewport_.top, viewport_.width(), viewport_.height()},
                        number};
      for (const double x : answers[i]) question.numbers.push_back(std::isfinite(x) ? x : 0);
      question.numbers.resize(4 + divide_questions[i].numbers.size() / 4 * 3);
      placing.push_back(std::move(question));
      keep(ndcs_, number, std::move(answers[i]));
    }
    return placing;
  }
  void take_screens(const std::vector<Question>& questions, std::vector<Numbers> answers) {
    for (std::size_t i = 0; i < answers.size(); ++i)
      keep(screens_, questions[i].triangle, std::move(answers[i]));
    gathering_ = false;
  }

  std::vector<Question> divide_questions;

private:
  static void keep(std::vector<Numbers>& places, std::uint32_t number, Numbers answer) {
    places.resize(std::max(places.size(), std::size_t(number) + 1));
    places[number] = std::move(answer);
  }

  template <class P>
  void place(const std::vector<Numbers>& places, P& position) const {
    const Numbers* given = number_ < places.size() ? &places[number_] : nullptr;
    const auto at = [&](std::size_t k) {
      const std::size_t i = 3 * vertex_ + k;
      return given != nullptr && i < given->size() ? to_finite_float((*given)[i]) : 0.0f;
    };
    position = {at(0), at(1), at(2)};
  }

  const Viewport viewport_;
  bool gathering_ = true;
  const Draw* draw_ = nullptr;
  std::uint32_t number_ = 0;
  std::size_t count_ = 0, vertex_ = 0;
  std::vector<Numbers> ndcs_, screens_;  // one for each triangle
};

std::string restated_projection(const Numbers& in) {
  const InputPart range{"range", 1, 1, {"depth from 0 to 1", "reversed depth from 1 to 0"}};
  const InputPart kind{"kind", 1, 1, {"parallel", "perspective"}};
  const bool is_perspective = in.size() > 1 && in[1] == 1;
  return is_perspective ? in_words({range, kind, {"fovy, aspect, near, far", 4}})(in)
                        : in_words({range, kind, {"left, right, bottom, top, near, far", 6}})(in);
}

const std::vector<DrawnStage>& stages() {
  static const std::vector<DrawnStage> all{
      {"projection", "clip", "perspective, orthographic, in_dialect", projection, judge_projection,
       restated_projection},
      {"divide", "ndc", "divide", divided, judge_divided,
       in_words({{"vertex", 4, kAllThatFollow}})},
      {"viewport", "screen", "to_screen", placed, judge_placed,
       in_words({{"viewport left, top, width, height", 4}, {"vertex", 3, kAllThatFollow}})},
      {"distances", "depth", "distance_of", distances, judge_distances,
       in_words({{"near"}, {"far"}, {"depth", 1, kAllThatFollow}})}};
  return all;
}

Result<Question> projection_question(const DrawingInput& input) {
  const View& view = input.view;
  const double aspect = double(view.viewport.width()) / double(view.viewport.height());
  const double reversed = view.depth_range == DepthRange::kReversed ? 1 : 0;
  if (const auto* lens = std::get_if<PerspectiveLens>(&input.camera.lens))
    return Question{{reversed, 1, lens->fovy_radians, aspect, view.near, view.far}};
  if (const auto* lens = std::get_if<OrthographicLens>(&input.camera.lens)) {
    const double h = lens->half_height, w = h * aspect;
    return Question{{reversed, 0, -w, w, -h, h, view.near, view.far}};
  }
  return fail("--frustum",
              "lab 4 has no function for a view that is given by the sides of a window on the near "
              "plane (--frustum)",
              "give the view with --fov or --ortho");
}

// Replaces the distances that the pipeline computes from 1/w by the student's.
Result<void> ask_for_distances(PictureSetup& made, AnswerSource& answer_source) {
  RenderSettings settings = made.settings;
  settings.want_depth = true;
  const Framebuffer plane =
      render_staged(made.scene, made.view, settings, made.stages.get()).buffers;
  Question question{{made.view.near, made.view.far}, kNone};
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < plane.depth.pixels.size(); ++i) {
    if (plane.depth.pixels[i] == kEmptyDepth) continue;
    question.numbers.push_back(std::min(1.0, double(std::bit_cast<float>(plane.depth.pixels[i]))));
    pixels.push_back(i);
  }
  const auto answer = answer_source.ask(stages()[3], std::array{question});
  if (!answer) return tl::unexpected(answer.error());
  made.finish = show_distances(std::move(pixels), answer->front());
  return {};
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  PictureSetup made{input.scene, input.view, input.settings, nullptr, {}};
  const auto question = projection_question(input);
  if (!question) return tl::unexpected(question.error());
  const auto matrix = answer_source.ask(stages()[0], std::array{*question});
  if (!matrix) return tl::unexpected(matrix.error());
  if (matrix->front().size() == 16) {
    RecordReader reader(matrix->front().data(), 16);
    made.view.clip_from_eye = reader.matrix<Transform<Clip, Eye>>();
  }
  auto stage_observer = std::make_shared<StageObserver>(input.view.viewport);
  observe_run(made, *stage_observer);
  auto ndcs = answer_source.ask(stages()[1], stage_observer->divide_questions);
  if (!ndcs) return tl::unexpected(ndcs.error());
  const std::vector<Question> placing = stage_observer->take_ndcs(std::move(*ndcs));
  auto screens = answer_source.ask(stages()[2], placing);
  if (!screens) return tl::unexpected(screens.error());
  stage_observer->take_screens(placing, std::move(*screens));
  made.stages = stage_observer;
  const bool float_depth = input.settings.depth == DepthFormat::kFloat32;
  if (input.settings.show == Show::kDepth && input.view.perspective && float_depth) {
    const auto asked = ask_for_distances(made, answer_source);
    if (!asked) return tl::unexpected(asked.error());
  }
  return made;
}

}  // namespace lab_04_drawing

LabDrawing drawing_04() {
  using namespace lab_04_drawing;
  return {stages(), draw, ""};
}

}  // namespace glassbox::labs
