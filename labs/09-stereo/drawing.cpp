// Lab 9 in a picture for red and cyan glasses: the student's functions make the eyes' projections,
// cull the triangles that neither eye sees, and fill the common colour buffer of both eyes.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "labs/drawing/drawing.h"

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/stereo/culling.h>
#include <glassbox/raster/blend.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/primitives.h>

namespace glassbox::labs {

namespace lab_09_drawing {

constexpr double u = unit_roundoff<double>;
constexpr double kDraw = 1, kCull = 2;  // the values of lab_09::Verdict
// The number of rows of the picture in one question of the stage "anaglyph".
constexpr int kRows = 16;
constexpr std::size_t kSizes = 2;  // an answer has the width and height before the pixels
using Projection = Transform<Clip, Eye>;

// ---- the reference ----

Numbers eye(RecordReader& in) {
  const double s = in.number(), f = in.number();
  const double shift = in.number() == 0 ? s : -s;
  const auto centre = in.matrix<Projection>();
  Numbers out;
  append_matrix(out, s == 0 ? centre : centre * stereo_skew(shift, f));
  return out;
}

struct Corner {
  double left_x = 0, right_x = 0, y = 0, z = 0, w = 0;
};

using HorizontalCoordinate = double Corner::*;

// Whether all corners are outside the same plane of an eye's frustum. `x` is left_x or right_x.
bool is_outside_frustum(const std::array<Corner, 3>& corners, HorizontalCoordinate x) {
  const auto all = [&](auto outside) {
    return std::all_of(corners.begin(), corners.end(), outside);
  };
  return all([&](const Corner& c) { return c.*x < -c.w; }) ||
         all([&](const Corner& c) { return c.*x > c.w; }) ||
         all([](const Corner& c) { return c.y < -c.w; }) ||
         all([](const Corner& c) { return c.y > c.w; }) ||
         all([](const Corner& c) { return c.z < 0; }) ||
         all([](const Corner& c) { return c.z > c.w; });
}

Numbers verdict(RecordReader& in) {
  std::array<Corner, 3> corners;
  for (Corner& c : corners) c = {in.number(), in.number(), in.number(), in.number(), in.number()};
  const bool unseen =
      is_outside_frustum(corners, &Corner::left_x) && is_outside_frustum(corners, &Corner::right_x);
  return {unseen ? kCull : kDraw};
}

// Makes the picture of both eyes: red is the left eye's, green and blue are the right eye's.
Numbers anaglyph(RecordReader& in) {
  const auto width = std::size_t(in.number()), height = std::size_t(in.number());
  const auto background = std::uint32_t(in.number());
  const double of_left = in.number();
  struct Pixel {
    std::uint32_t colour = 0;
    float depth = INFINITY;
  };
  std::array<std::vector<Pixel>, 2> eyes;
  eyes.fill(std::vector<Pixel>(width * height, {background}));
  for (double i = 0; in.more(); ++i) {
    const auto x = std::size_t(in.number()), y = std::size_t(in.number());
    const float depth = in.real();
    const auto colour = std::uint32_t(in.number());
    Pixel& pixel = eyes[i < of_left ? 0 : 1][y * width + x];
    if (depth < pixel.depth) pixel = {colour, depth};
  }
  Numbers out{double(width), double(height)};
  for (std::size_t p = 0; p < width * height; ++p)
    out.push_back(double((eyes[0][p].colour & 0xff0000) | (eyes[1][p].colour & 0x00ffff)));
  return out;
}

// ---- judgement ----

// The rows of y, z and w must be right bit for bit. The bound of the row of x is 8 u (u = 2^-53)
// times the largest of |m00 s/f|, |m02|, |m00 s| and |m03| for the student's matrix, and as much
// again for the reference's; m is the centre's projection.
std::optional<WrongNumber> judge_eye(const Numbers& in, const Numbers& yours,
                                     const Numbers& reference) {
  const double s = in[0], f = in[1], m00 = in[3], m02 = in[5], m03 = in[6];
  const double largest =
      std::max({std::abs(m00 * s / f), std::abs(m02), std::abs(m00 * s), std::abs(m03)});
  const double bound = s == 0 ? 0 : 16 * u * largest;
  return first_wrong(
      yours, reference, [&](std::size_t i) { return i < 4 ? bound : 0; }, "",
      [](std::size_t i) { return fmt::format("row {}, column {}", i / 4, i % 4); });
}

std::optional<WrongNumber> judge_verdict(const Numbers&, const Numbers& yours,
                                         const Numbers& reference) {
  return first_wrong(
      yours, reference, [](std::size_t) { return 0; }, "",
      [](std::size_t) { return std::string("1 draw, 2 cull"); });
}

std::optional<WrongNumber> judge_anaglyph(const Numbers& in, const Numbers& yours,
                                          const Numbers& reference) {
  const auto width = std::size_t(in[0]);
  auto wrong = first_wrong(
      yours, reference, [](std::size_t) { return 0; }, "",
      [&](std::size_t i) {
        if (i < kSizes) return std::string(i == 0 ? "width" : "height");
        const std::size_t p = i - kSizes;
        return fmt::format("row {} of {}, column {}", p / width, kRows, p % width);
      });
  const bool of_pixel = wrong && wrong->element.starts_with("row");
  if (of_pixel && wrong->explanation.empty())
    wrong->explanation =
        fmt::format("#{:06x} for #{:06x}", std::uint32_t(std::abs(wrong->yours)) & 0xffffff,
                    std::uint32_t(wrong->reference));
  return wrong;
}

// ---- in the pipeline ----

struct EyeFragment {
  int x = 0, y = 0;
  float depth = 0;
  double colour = 0;
};

double packed(const Rgba8& c) {
  return 65536.0 * c.r + 256.0 * c.g + c.b;
}

// Observes the drawing of one eye's picture. In the first run it collects the corners of all
// triangles. In later runs it removes the culled triangles, and it can collect the fragments that
// are written.
class StageObserver : public Observer {
public:
  void draw(const Draw& draw) override { draw_ = &draw; }

  void clipped(const PrimitiveStage&, const Triangle& triangle,
               const std::array<ClipVertex, 3>& corners, ClipPolygon& polygon) override {
    const std::uint32_t number = draw_->first_number + triangle.number;
    if (gathering_) {
      numbers.push_back(number);
      for (const ClipVertex& c : corners) clip.push_back(c.position);
    } else if (number < culled_.size() && culled_[number]) {
      polygon.count = 0;
    }
  }

  void encoded(const Fragment& fragment, const Rgba8&, Rgba8& after) override {
    if (fragments_ != nullptr)
      fragments_->push_back({fragment.x, fragment.y, fragment.depth, packed(after)});
  }

  void take(std::vector<bool> culled) {
    culled_ = std::move(culled);
    gathering_ = false;
  }
  void gather_fragments(std::vector<EyeFragment>* seen) { fragments_ = seen; }

  // numbers of the triangles, each with three corners in `clip`
  std::vector<std::uint32_t> numbers;
  std::vector<Point<Clip>> clip;

private:
  const Draw* draw_ = nullptr;
  bool gathering_ = true;
  std::vector<bool> culled_;  // one for each triangle
  std::vector<EyeFragment>* fragments_ = nullptr;
};

const std::vector<DrawnStage>& stages() {
  static const std::vector<DrawnStage> all{
      {"eye", "clip", "eye_projection", eye, judge_eye,
       in_words({{"half the separation"},
                 {"window"},
                 {"side", 1, 1, {"left eye", "right eye"}},
                 {"projection", 16}})},
      {"verdict", "clip", "cull", verdict, judge_verdict,
       in_words({{"left x, right x, y, z, w of corner", 5, 3}})},
      {"anaglyph", "anaglyph", "draw_anaglyph", anaglyph, judge_anaglyph,
       in_words({{"width, height", 2},
                 {"background"},
                 {"fragments of the left eye"},
                 {"x, y, depth, colour of fragment", 4, kAllThatFollow}})}};
  return all;
}

Result<void> ask_for_eyes(const StereoPair& pair, std::array<PictureSetup, 2>& eyes,
                          AnswerSource& answer_source) {
  std::vector<Question> questions;
  for (const double side : {0.0, 1.0}) {
    Question question{{pair.half_separation, pair.window, side}};
    append_matrix(question.numbers, eyes[0].view.clip_from_eye);
    questions.push_back(std::move(question));
  }
  const auto answers = answer_source.ask(stages()[0], questions);
  if (!answers) return tl::unexpected(answers.error());
  for (std::size_t k = 0; k < 2; ++k) {
    Numbers rows = (*answers)[k];
    rows.resize(16);
    RecordReader reader(rows.data(), 16);
    eyes[k].view.clip_from_eye = reader.matrix<Projection>();
  }
  return {};
}

// One question for each triangle: its corners, with x for both eyes. y, z and w are the left eye's;
// the right eye's are the same.
std::vector<Question> verdict_questions(const StageObserver& left, const StageObserver& right) {
  std::vector<Question> questions;
  for (std::size_t t = 0; t < left.numbers.size(); ++t) {
    Question question{{}, left.numbers[t]};
    for (std::size_t k = 3 * t; k < 3 * t + 3; ++k) {
      const Point<Clip>& p = left.clip[k];
      question.numbers.insert(question.numbers.end(), {double(p.x), double(right.clip[k].x),
                                                       double(p.y), double(p.z), double(p.w)});
    }
    questions.push_back(std::move(question));
  }
  return questions;
}

Result<void> ask_for_verdicts(std::array<PictureSetup, 2>& eyes,
                              const std::array<std::shared_ptr<StageObserver>, 2>& stage_observers,
                              AnswerSource& answer_source) {
  for (std::size_t k = 0; k < 2; ++k) observe_run(eyes[k], *stage_observers[k]);
  const std::vector<Question> questions =
      verdict_questions(*stage_observers[0], *stage_observers[1]);
  const auto answers = answer_source.ask(stages()[1], questions);
  if (!answers) return tl::unexpected(answers.error());
  std::vector<bool> culled;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    culled.resize(std::max(culled.size(), std::size_t(questions[i].triangle) + 1));
    culled[questions[i].triangle] = !(*answers)[i].empty() && (*answers)[i][0] == kCull;
  }
  for (const auto& stage_observer : stage_observers) stage_observer->take(culled);
  return {};
}

// One question for every kRows rows of the picture.
std::vector<Question> anaglyph_questions(const std::array<std::vector<EyeFragment>, 2>& seen,
                                         int width, int height, const Rgba8& background) {
  std::vector<Question> questions;
  for (int top = 0; top < height; top += kRows) {
    const int rows = std::min(kRows, height - top);
    questions.push_back({{double(width), double(rows), packed(background), 0}});
  }
  for (const std::vector<EyeFragment>& eye : seen) {
    for (const EyeFragment& at : eye) {
      Numbers& numbers = questions[std::size_t(at.y / kRows)].numbers;
      numbers.insert(numbers.end(), {double(at.x), double(at.y % kRows),
                                     double(std::clamp(at.depth, 0.0f, 1.0f)), at.colour});
      if (&eye == &seen[0]) ++numbers[3];
    }
  }
  return questions;
}

Rgba8 unpacked(double colour) {
  const auto rgb = std::uint32_t(std::clamp(colour, 0.0, double(0xffffff)));
  return {std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb), 255};
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  if (const auto opaque = check_opaque(input.scene, "lab 9"); !opaque)
    return tl::unexpected(opaque.error());
  const PictureSetup centre{input.scene, input.view, input.settings, nullptr, {}};
  std::array<PictureSetup, 2> eyes{centre, centre};
  if (const auto asked = ask_for_eyes(input.pair, eyes, answer_source); !asked)
    return tl::unexpected(asked.error());
  const std::array<std::shared_ptr<StageObserver>, 2> stage_observers{
      std::make_shared<StageObserver>(), std::make_shared<StageObserver>()};
  if (const auto asked = ask_for_verdicts(eyes, stage_observers, answer_source); !asked)
    return tl::unexpected(asked.error());
  std::array<std::vector<EyeFragment>, 2> seen;
  for (std::size_t k = 0; k < 2; ++k) {
    stage_observers[k]->gather_fragments(&seen[k]);
    observe_run(eyes[k], *stage_observers[k]);
    stage_observers[k]->gather_fragments(nullptr);
  }
  const int width = int(input.view.viewport.width()), height = int(input.view.viewport.height());
  const auto bands = answer_source.ask(
      stages()[2], anaglyph_questions(seen, width, height, input.settings.background));
  if (!bands) return tl::unexpected(bands.error());

  PictureSetup made = eyes[0];
  made.stages = stage_observers[0];
  made.finish = [bands = *bands, width](Framebuffer& picture) {
    const std::size_t of_band = std::size_t(kRows) * std::size_t(width);
    for (std::size_t p = 0; p < picture.color.pixels.size(); ++p) {
      const Numbers& band = bands[p / of_band];
      const std::size_t at = kSizes + p % of_band;
      if (at < band.size()) picture.color.pixels[p] = unpacked(band[at]);
    }
  };
  return made;
}

}  // namespace lab_09_drawing

LabDrawing drawing_09() {
  using namespace lab_09_drawing;
  return {stages(), draw, "parallax_at, anaglyph_colour and comfortable_separations"};
}

}  // namespace glassbox::labs
