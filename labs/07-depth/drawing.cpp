// Lab 7 in a picture: the student's functions make the depth row of the projection, the codes of
// the buffer, find the visible fragment of each pixel and, in pictures of depth, turn depths back
// into distances.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "labs/drawing/drawing.h"

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/raster/depth.h>
#include <glassbox/render/engine/draw_list.h>

namespace glassbox::labs {

namespace lab_07_drawing {

constexpr int kRows = 8;  // how many rows of the picture one question of "seen" has
constexpr double u53 = unit_roundoff<double>;

// The pipeline's depth formats, in the order of lab_07::Format.
constexpr DepthFormat kFormats[] = {DepthFormat::kUnorm16, DepthFormat::kUnorm24,
                                    DepthFormat::kFloat32, DepthFormat::kFloat32Reversed};
double number_of(DepthFormat format) {
  return double(std::find(std::begin(kFormats), std::end(kFormats), format) - kFormats);
}

DepthRange range_of(double number) {
  return number == 0 ? DepthRange::kStandard : DepthRange::kReversed;
}

// ---- the reference ----

Numbers row(RecordReader& in) {
  const double near = in.number(), far = in.number();
  const auto made = perspective_degrees(90, 1, {near, far, range_of(in.number())});
  return made ? Numbers{made->at(2, 2), made->at(2, 3)} : Numbers{0, 0};
}

Numbers codes(RecordReader& in) {
  const DepthFormat format = kFormats[in.integer()];
  Numbers out;
  while (in.more()) out.push_back(double(depth_code(format, in.real())));
  return out;
}

Numbers seen(RecordReader& in) {
  const DepthFormat format = kFormats[in.integer()];
  const auto pixels = std::size_t(in.integer());
  Numbers winners(pixels, -1);
  std::vector<std::uint32_t> buffer(pixels, kEmptyDepth);
  for (double fragment = 0; in.more(); ++fragment) {
    const auto pixel = std::size_t(in.integer());
    const std::uint32_t code = depth_code(format, in.real());
    if (!in_front(code, buffer[pixel])) continue;
    buffer[pixel] = code;
    winners[pixel] = fragment;
  }
  return winners;
}

// Interpolates 1/d (d: the distance) linearly from 1/near to 1/far; the depth is the weight.
Numbers distances(RecordReader& in) {
  const double near = in.number(), far = in.number();
  const bool reversed = range_of(in.number()) == DepthRange::kReversed;
  Numbers out;
  while (in.more()) {
    const double depth = in.number();
    const double from_near = reversed ? 1 - depth : depth, from_far = reversed ? depth : 1 - depth;
    out.push_back(1 / (from_far / near + from_near / far));
  }
  return out;
}

// ---- judgement ----

// The student's entries and ours are each within 4 ulps of the exact value, so they differ by at
// most 8 ulps.
std::optional<WrongNumber> judge_row(const Numbers&, const Numbers& yours,
                                     const Numbers& reference) {
  return first_wrong(
      yours, reference, [&](std::size_t i) { return 8 * ulp(reference[i]); }, "",
      [](std::size_t i) { return std::string(i == 0 ? "a" : "b"); });
}

std::optional<WrongNumber> judge_codes(const Numbers& in, const Numbers& yours,
                                       const Numbers& reference) {
  return first_wrong(
      yours, reference, [](std::size_t) { return 0; }, "",
      [&](std::size_t i) {
        return fmt::format("the code of depth {}", in[std::min(i + 1, in.size() - 1)]);
      });
}

std::optional<WrongNumber> judge_visible(const Numbers& in, const Numbers& yours,
                                         const Numbers& reference) {
  const std::size_t width = std::size_t(in[1]) / kRows;
  return first_wrong(
      yours, reference, [](std::size_t) { return 0; }, "",
      [&](std::size_t i) {
        return fmt::format("row {} of {}, column {}: visible fragment", i / width, kRows,
                           i % width);
      });
}

// The student's distances and ours are each within 16 u of the exact distance (u: the unit
// roundoff), so they differ by at most 32 u.
std::optional<WrongNumber> judge_distances(const Numbers& in, const Numbers& yours,
                                           const Numbers& reference) {
  return first_wrong(
      yours, reference,
      [&](std::size_t i) { return std::isfinite(reference[i]) ? 32 * u53 * reference[i] : 0; },
      "world units",
      [&](std::size_t i) {
        return fmt::format("the distance of depth {}", in[std::min(i + 3, in.size() - 1)]);
      });
}

// ---- in the pipeline ----

struct TestedFragment {
  int x = 0, y = 0;
  float depth = 0;
  std::uint32_t triangle = 0;
};

// In the first run, gathers the fragments that reach the depth test; in a later run decides which
// of them pass.
class StageObserver : public Observer {
public:
  void draw(const Draw& draw) override {
    if (fragments.empty() && gathering_) first_instance_ = draw.instance;
    if (draw.instance == first_instance_) next_ = 0;  // a new run begins
  }

  void compared(const FragmentSource& source, const Fragment& fragment, std::uint32_t,
                std::uint32_t, bool& in_front) override {
    if (gathering_) {
      fragments.push_back(
          {fragment.x, fragment.y, fragment.depth, source.is_triangle ? source.number : kNone});
    } else {
      in_front = next_ < passes_.size() && passes_[next_];
      ++next_;
    }
  }

  // Decides which fragments pass the depth test: at each pixel those that are nearer, by the
  // student's codes, than all before them, up to the fragment that is visible at the end. That one
  // always passes.
  void take(const std::vector<double>& code, const std::vector<double>& winner, int width) {
    std::vector<double> nearest(winner.size(), std::numeric_limits<double>::infinity());
    passes_.resize(fragments.size());
    for (std::size_t i = 0; i < fragments.size(); ++i) {
      const std::size_t pixel = pixel_of(fragments[i], width);
      const bool nearer = code[i] < nearest[pixel];
      passes_[i] = double(i) == winner[pixel] || (nearer && double(i) < winner[pixel]);
      if (nearer) nearest[pixel] = code[i];
    }
    gathering_ = false;
  }

  static std::size_t pixel_of(const TestedFragment& at, int width) {
    return std::size_t(at.y) * std::size_t(width) + std::size_t(at.x);
  }

  std::vector<TestedFragment> fragments;  // in the order in which they reach the test

private:
  bool gathering_ = true;
  std::uint32_t first_instance_ = 0;
  std::size_t next_ = 0;
  std::vector<bool> passes_;
};

std::vector<Question> code_questions(const std::vector<TestedFragment>& fragments, double format) {
  std::vector<Question> questions;
  for (const TestedFragment& fragment : fragments) {
    if (questions.empty() || questions.back().triangle != fragment.triangle)
      questions.push_back({{format}, fragment.triangle});
    questions.back().numbers.push_back(double(fragment.depth));
  }
  return questions;
}

// Makes one question for every kRows rows of the picture; order[k] becomes the indices of the
// fragments in question k.
std::vector<Question> visibility_questions(const std::vector<TestedFragment>& fragments,
                                           double format, int width, int height,
                                           std::vector<std::vector<std::size_t>>& order) {
  const auto bands = std::size_t((height + kRows - 1) / kRows);
  std::vector<Question> questions(bands, {{format, double(kRows * width)}, kNone});
  order.resize(bands);
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const TestedFragment& at = fragments[i];
    const auto band = std::size_t(at.y / kRows);
    questions[band].numbers.insert(questions[band].numbers.end(),
                                   {double(at.y % kRows * width + at.x), double(at.depth)});
    order[band].push_back(i);
  }
  return questions;
}

const std::vector<DrawnStage>& stages() {
  static const InputPart range{"range", 1, 1, {"depth from 0 to 1", "reversed depth from 1 to 0"}};
  static const InputPart format{
      "format", 1, 1, {"kUnorm16", "kUnorm24", "kFloat32", "kFloat32Reversed"}};
  static const std::vector<DrawnStage> all{
      {"row", "clip", "depth_row", row, judge_row, in_words({{"near"}, {"far"}, range})},
      {"codes", "depth", "depth_code", codes, judge_codes,
       in_words({format, {"depth", 1, kAllThatFollow}})},
      {"seen", "depth", "visible", seen, judge_visible,
       in_words({format, {"pixels"}, {"pixel and depth of fragment", 2, kAllThatFollow}})},
      {"distances", "depth", "distance_of", distances, judge_distances,
       in_words({{"near"}, {"far"}, range, {"depth", 1, kAllThatFollow}})}};
  return all;
}

Numbers planes_of(const View& view) {
  return {view.near, view.far, view.depth_range == DepthRange::kStandard ? 0.0 : 1.0};
}

Result<void> ask_for_row(PictureSetup& made, AnswerSource& answer_source) {
  const std::array question{Question{planes_of(made.view)}};
  const auto answer = answer_source.ask(stages()[0], question);
  if (!answer) return tl::unexpected(answer.error());
  const Numbers& row = answer->front();
  for (std::size_t i = 0; i < std::min<std::size_t>(2, row.size()); ++i)
    made.view.clip_from_eye.at(2, 2 + int(i)) = row[i];
  return {};
}

// Replaces the distances that the pipeline computes from 1/w by the student's.
Result<void> ask_for_distances(PictureSetup& made, const std::vector<TestedFragment>& fragments,
                               const std::vector<double>& winner, AnswerSource& answer_source) {
  Question question{planes_of(made.view), kNone};
  std::vector<std::size_t> pixels;
  for (std::size_t pixel = 0; pixel < winner.size(); ++pixel) {
    if (winner[pixel] < 0) continue;
    const float depth = fragments[std::size_t(winner[pixel])].depth;
    question.numbers.push_back(double(std::clamp(depth, 0.0f, 1.0f)));
    pixels.push_back(pixel);
  }
  const auto answer = answer_source.ask(stages()[3], std::array{question});
  if (!answer) return tl::unexpected(answer.error());
  made.finish = show_distances(std::move(pixels), answer->front());
  return {};
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  if (const auto opaque = check_opaque(input.scene, "lab 7"); !opaque)
    return tl::unexpected(opaque.error());
  PictureSetup made{input.scene, input.view, input.settings, nullptr, {}};
  const View& view = input.view;
  if (view.perspective) {
    if (const auto asked = ask_for_row(made, answer_source); !asked)
      return tl::unexpected(asked.error());
  }
  auto stage_observer = std::make_shared<StageObserver>();
  observe_run(made, *stage_observer);
  const double format = number_of(input.settings.depth);
  const auto codes =
      answer_source.ask(stages()[1], code_questions(stage_observer->fragments, format));
  if (!codes) return tl::unexpected(codes.error());
  std::vector<double> code;
  for (const Numbers& some : *codes) code.insert(code.end(), some.begin(), some.end());
  code.resize(stage_observer->fragments.size());

  const int width = int(view.viewport.width()), height = int(view.viewport.height());
  std::vector<std::vector<std::size_t>> order;
  const auto bands = answer_source.ask(
      stages()[2], visibility_questions(stage_observer->fragments, format, width, height, order));
  if (!bands) return tl::unexpected(bands.error());
  const std::size_t of_band = std::size_t(kRows) * std::size_t(width);
  std::vector<double> winner(order.size() * of_band, -1);
  for (std::size_t band = 0; band < order.size(); ++band) {
    const Numbers& some = (*bands)[band];
    for (std::size_t pixel = 0; pixel < std::min(some.size(), of_band); ++pixel) {
      const double which = some[pixel];
      if (!(which >= 0 && which < double(order[band].size()))) continue;
      // A fragment of another pixel is a wrong answer, and cannot be shown at this pixel.
      const std::size_t fragment = order[band][std::size_t(which)];
      const std::size_t here = band * of_band + pixel;
      if (StageObserver::pixel_of(stage_observer->fragments[fragment], width) == here)
        winner[here] = double(fragment);
    }
  }
  if (input.settings.show == Show::kDepth && view.perspective) {
    const auto asked = ask_for_distances(made, stage_observer->fragments, winner, answer_source);
    if (!asked) return tl::unexpected(asked.error());
  }
  stage_observer->take(code, winner, width);
  made.stages = stage_observer;
  return made;
}

}  // namespace lab_07_drawing

LabDrawing drawing_07() {
  using namespace lab_07_drawing;
  return {stages(), draw, "separation"};
}

}  // namespace glassbox::labs
