// Lab 11 in a picture of depth: the student's functions match two pictures that the rasterizer
// draws. The pair is small, so that all its costs can be sent to the student's process and back;
// each of its pixels becomes a square.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "labs/11-matching/reference.h"
#include "labs/drawing/drawing.h"
#include "views/matching/color_planes.h"
#include "views/matching/rendered_pair.h"

namespace glassbox::labs {

namespace lab_11_drawing {

using lab_11::kNever;
using lab_11::kNone;
using lab_11::Picture;

constexpr int kLargestSide = 128;  // of the pictures of the pair, in px
constexpr int kMaxDisparities = 48;
constexpr int kReach = 2;                   // how many rows above and below a cost uses
constexpr double kStep = 120, kJump = 700;  // P1 and P2 of along_path()
constexpr double kTolerance = 1;            // px

// ---- the reference, which reads questions as stages.cpp does ----

Picture picture(RecordReader& in, int width, int height) {
  Picture made{width, height, {}};
  for (int i = 0; i < width * height; ++i) made.grey.push_back(in.integer());
  return made;
}

Numbers costs_stage(RecordReader& in) {
  const int disparities = in.integer(), width = in.integer(), height = in.integer();
  const int y = in.integer();
  const Picture left = picture(in, width, height), right = picture(in, width, height);
  const matching::Sides sides{&left, &right, -1};
  std::vector<std::uint32_t> words;
  for (int x = 0; x < width; ++x) words.push_back(matching::census(right, x, y));
  Numbers out;
  for (int x = 0; x < width; ++x) {
    const std::uint32_t word = matching::census(left, x, y);
    for (int d = 0; d < disparities; ++d) {
      const int cost = matching::sad(sides, x, y, d, 1);
      out.push_back(
          cost >= kNever ? kNever : cost + 32 * matching::hamming(word, words[std::size_t(x - d)]));
    }
  }
  return out;
}

std::vector<int> integers(RecordReader& in) {
  std::vector<int> all;
  while (in.more()) all.push_back(in.integer());
  return all;
}

Numbers paths_stage(RecordReader& in) {
  const int disparities = in.integer(), p1 = in.integer(), p2 = in.integer();
  const auto sums = matching::along_path(integers(in), disparities, p1, p2);
  return {sums.begin(), sums.end()};
}

Numbers left_stage(RecordReader& in) {
  const int disparities = in.integer();
  Numbers out;
  while (in.more()) {
    std::vector<int> costs;
    for (int d = 0; d < disparities; ++d) costs.push_back(in.integer());
    out.push_back(matching::winner(costs));
  }
  return out;
}

Numbers right_stage(RecordReader& in) {
  const int disparities = in.integer();
  const std::vector<int> costs = integers(in);
  return matching::right_winners(costs, int(costs.size()) / disparities, disparities);
}

Numbers check_stage(RecordReader& in) {
  const double tolerance = in.number();
  const int width = in.integer();
  Numbers left, right;
  for (int x = 0; x < width; ++x) left.push_back(in.number());
  for (int x = 0; x < width; ++x) right.push_back(in.number());
  return matching::left_right_check(left, right, tolerance);
}

Numbers depth_stage(RecordReader& in) {
  const double focal = in.number(), baseline = in.number();
  const lab_11::Calibration calibration{focal, baseline, in.number()};
  Numbers out;
  while (in.more()) out.push_back(matching::depth(in.number(), calibration));
  return out;
}

// ---- judgement ----

// Judges costs, or sums of costs, of all pixels and disparities. They must be exact.
std::optional<WrongNumber> judge_costs(const Numbers& in, const Numbers& yours,
                                       const Numbers& reference) {
  const auto disparities = std::size_t(in[0]);
  return first_wrong(
      yours, reference, [](std::size_t) { return 0; }, "",
      [&](std::size_t i) {
        return fmt::format("pixel {}, disparity {}", i / disparities, i % disparities);
      });
}

std::string pixel_name(std::size_t i) {
  return fmt::format("pixel {}", i);
}

std::optional<WrongNumber> judge_left(const Numbers&, const Numbers& yours,
                                      const Numbers& reference) {
  return first_wrong(
      yours, reference,
      [&](std::size_t i) {
        return std::isinf(reference[i]) ? 0 : matching::kWinnerBound * (1 + reference[i]);
      },
      "px", pixel_name);
}

std::optional<WrongNumber> judge_exactly(const Numbers&, const Numbers& yours,
                                         const Numbers& reference) {
  const auto nothing = [](std::size_t) { return 0; };
  return first_wrong(yours, reference, nothing, "px", pixel_name);
}

std::optional<WrongNumber> judge_depth(const Numbers&, const Numbers& yours,
                                       const Numbers& reference) {
  return first_wrong(
      yours, reference,
      [&](std::size_t i) {
        return std::isinf(reference[i]) ? 0 : matching::kDepthBound * reference[i];
      },
      "world units", pixel_name);
}

enum Stage : std::size_t { kCosts, kPaths, kLeft, kRight, kCheck, kDepth };
const std::vector<DrawnStage>& stages() {
  static const InputPart cost{"cost", 1, kAllThatFollow};
  static const std::vector<DrawnStage> all{
      {"costs", "screen", "sad, census, hamming", costs_stage, judge_costs,
       in_words({{"disparities"},
                 {"width, height", 2},
                 {"row"},
                 {"grey value of pixel", 1, kAllThatFollow}})},
      {"paths", "screen", "along_path", paths_stage, judge_costs,
       in_words({{"disparities"}, {"P1, P2", 2}, cost})},
      {"left", "screen", "winner", left_stage, judge_left, in_words({{"disparities"}, cost})},
      {"right", "screen", "right_winners", right_stage, judge_exactly,
       in_words({{"disparities"}, cost})},
      {"check", "screen", "left_right_check", check_stage, judge_exactly,
       in_words({{"tolerance"}, {"width"}, {"disparity", 1, kAllThatFollow}})},
      {"depths", "depth", "depth", depth_stage, judge_depth,
       in_words({{"focal length, baseline, offset", 3}, {"disparity", 1, kAllThatFollow}})}};
  return all;
}

// ---- the pair ----

struct Pair {
  Picture left, right;
  int disparities = 1;
  lab_11::Calibration calibration;
  int square = 1;  // the side in px of the square for each pixel of the pair
};

Picture grey_of(const Image<Rgba8>& image) {
  const views::ColorPlanes planes = views::color_planes(image);
  return {image.width, image.height, {planes.grey.begin(), planes.grey.end()}};
}

// Renders the pair with parallel eyes (without skew), so that disparities begin at 0, for points
// that are infinitely far away.
Result<Pair> rendered(const DrawingInput& input) {
  View view = input.view;
  const int width = int(view.viewport.width()), height = int(view.viewport.height());
  Pair pair;
  pair.square = (std::max(width, height) + kLargestSide - 1) / kLargestSide;
  view.viewport = {0, 0, float(std::max(1, width / pair.square)),
                   float(std::max(1, height / pair.square))};
  const StereoPair eyes{input.pair.half_separation};
  const auto made = views::rendered_pair(input.scene, view, eyes, input.settings);
  if (!made) return tl::unexpected(made.error());
  pair.left = grey_of(made->left);
  pair.right = grey_of(made->right);
  pair.calibration = {made->calibration.focal_px, made->calibration.baseline, 0};
  double nearest = 0;
  for (const float d : made->truth.disparity.pixels) {
    if (std::isfinite(d)) nearest = std::max(nearest, double(d));
  }
  pair.disparities = std::min(int(nearest) + 3, kMaxDisparities);
  return pair;
}

// ---- whole pictures of answers ----

// The answers with exactly `count` numbers each, clamped, so that the later stages can compute with
// them.
std::vector<Numbers> clamped_answers(std::vector<Numbers> answers, std::size_t count, double least,
                                     double most) {
  for (Numbers& answer : answers) {
    answer.resize(count);
    for (double& x : answer) x = std::isnan(x) ? least : std::clamp(x, least, most);
  }
  return answers;
}

class Matching {
public:
  Matching(const Pair& pair, AnswerSource& answer_source)
      : pair_(pair),
        answer_source_(answer_source),
        width_(std::size_t(pair.left.width)),
        height_(std::size_t(pair.left.height)),
        count_(std::size_t(pair.disparities)) {}

  Result<std::vector<Numbers>> depths() {
    const auto costs = ask(kCosts, rows_of_pictures(), width_ * count_, 0, kNever);
    if (!costs) return costs;
    const auto sums = sums_of_paths(*costs);
    if (!sums) return sums;
    std::vector<Question> questions;
    for (const Numbers& row : *sums) questions.push_back({concatenated({double(count_)}, row)});
    const auto left = ask(kLeft, questions, width_, 0, kNone);
    if (!left) return left;
    const auto right = ask(kRight, questions, width_, 0, kNone);
    if (!right) return right;
    for (std::size_t y = 0; y < height_; ++y)
      questions[y].numbers =
          concatenated(concatenated({kTolerance, double(width_)}, (*left)[y]), (*right)[y]);
    const auto checked = ask(kCheck, questions, width_, 0, kNone);
    if (!checked) return checked;
    const auto& c = pair_.calibration;
    for (std::size_t y = 0; y < height_; ++y)
      questions[y].numbers = concatenated({c.focal, c.baseline, c.offset}, (*checked)[y]);
    return ask(kDepth, questions, width_, 0, kNone);
  }

private:
  static Numbers concatenated(Numbers head, const Numbers& more) {
    head.insert(head.end(), more.begin(), more.end());
    return head;
  }

  Result<std::vector<Numbers>> ask(Stage stage, const std::vector<Question>& questions,
                                   std::size_t count, double least, double most) {
    auto answers = answer_source_.ask(stages()[stage], questions);
    if (!answers) return answers;
    return clamped_answers(std::move(*answers), count, least, most);
  }

  // One question for each row, with the rows around it that the costs use.
  std::vector<Question> rows_of_pictures() const {
    std::vector<Question> questions;
    const int height = pair_.left.height;
    for (int y = 0; y < height; ++y) {
      const int top = std::max(0, y - kReach), end = std::min(height, y + kReach + 1);
      Question question{{double(count_), double(width_), double(end - top), double(y - top)}};
      for (const Picture* picture : {&pair_.left, &pair_.right}) {
        const auto row = [&](int at) { return picture->grey.begin() + at * picture->width; };
        question.numbers.insert(question.numbers.end(), row(top), row(end));
      }
      questions.push_back(std::move(question));
    }
    return questions;
  }

  // Adds up the results of along_path() for paths in four directions: along rows and along columns,
  // each forwards and backwards.
  Result<std::vector<Numbers>> sums_of_paths(const std::vector<Numbers>& costs) {
    std::vector<Numbers> sums(height_, Numbers(width_ * count_, 0));
    for (const bool along_rows : {true, false}) {
      for (const bool backwards : {false, true}) {
        const std::size_t paths = along_rows ? height_ : width_;
        const std::size_t length = along_rows ? width_ : height_;
        // Finds the first cost of pixel number `step` of a path; rows[y] has the costs of picture
        // row y.
        const auto cell = [&](auto& rows, std::size_t path, std::size_t step) {
          const std::size_t at = backwards ? length - 1 - step : step;
          const std::size_t x = along_rows ? at : path, y = along_rows ? path : at;
          return rows[y].begin() + std::ptrdiff_t(x * count_);
        };
        std::vector<Question> questions;
        for (std::size_t path = 0; path < paths; ++path) {
          Question question{{double(count_), kStep, kJump}};
          for (std::size_t step = 0; step < length; ++step) {
            const auto from = cell(costs, path, step);
            question.numbers.insert(question.numbers.end(), from, from + std::ptrdiff_t(count_));
          }
          questions.push_back(std::move(question));
        }
        const auto answers = ask(kPaths, questions, length * count_, 0, 1e9);
        if (!answers) return answers;
        for (std::size_t path = 0; path < paths; ++path) {
          for (std::size_t step = 0; step < length; ++step) {
            const auto to = cell(sums, path, step);
            const auto from = (*answers)[path].begin() + std::ptrdiff_t(step * count_);
            for (std::size_t d = 0; d < count_; ++d)
              to[std::ptrdiff_t(d)] += from[std::ptrdiff_t(d)];
          }
        }
      }
    }
    // An impossible match keeps the cost kNever. The sum of a possible one is kept below kNever.
    for (std::size_t y = 0; y < height_; ++y) {
      for (std::size_t i = 0; i < sums[y].size(); ++i)
        sums[y][i] = costs[y][i] >= kNever ? kNever : std::min<double>(sums[y][i], kNever - 1);
    }
    return sums;
  }

  const Pair& pair_;
  AnswerSource& answer_source_;
  std::size_t width_, height_, count_;
};

// White at the largest disparity that is searched, black infinitely far away, blue where the depth
// is unknown.
Rgba8 shade_of(double depth, const Pair& pair) {
  if (!std::isfinite(depth)) return {30, 40, 90, 255};
  const double d = pair.calibration.focal * pair.calibration.baseline / depth;
  // A whole code, which a whole disparity often has, may be rounded to a number just below it.
  constexpr double kBeside = 1e-9;
  const double code_of_d = 255 * d / pair.disparities + kBeside;
  const auto code = std::uint8_t(std::floor(std::clamp(code_of_d, 0.0, 255.0)));
  return {code, code, code, 255};
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  if (input.pair.half_separation == 0)
    return fail("--eye-separation", "0: both eyes see the same picture, so there is no depth",
                "give a separation above 0");
  const auto pair = rendered(input);
  if (!pair) return tl::unexpected(pair.error());
  const auto depths = Matching(*pair, answer_source).depths();
  if (!depths) return tl::unexpected(depths.error());

  PictureSetup made{input.scene,
                    eye_view(input.view, {input.pair.half_separation}, Side::kLeft),
                    input.settings,
                    nullptr,
                    {}};
  made.finish = [depths = *depths, pair = *pair](Framebuffer& picture) {
    for (int y = 0; y < picture.color.height; ++y) {
      const auto row = std::min(std::size_t(y / pair.square), depths.size() - 1);
      for (int x = 0; x < picture.color.width; ++x) {
        const auto column = std::min(std::size_t(x / pair.square), depths[row].size() - 1);
        picture.color.at(x, y) = shade_of(depths[row][column], pair);
      }
    }
  };
  return made;
}

}  // namespace lab_11_drawing

LabDrawing drawing_11() {
  using namespace lab_11_drawing;
  return {stages(), draw, ""};
}

}  // namespace glassbox::labs
