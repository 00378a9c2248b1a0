// Measures how far apart two cameras should be (D-21).
#include <algorithm>
#include <cmath>

#include <glassbox/base/random.h>
#include "study/experiment/experiment.h"
#include "study/experiments/do_not_optimize.h"
#include "views/matching/match.h"

namespace glassbox::study {
namespace d21 {

constexpr int kWidth = 160, kHeight = 96;
constexpr double kFocal = 160;              // in px
constexpr double kDepth = 5;                // distance of the wall's middle
constexpr double kSlope = 0.5;              // slope of the wall, dZ/dX
constexpr double kPillars = 0.75 * kDepth;  // distance of the pillars, in front of the wall

// A smooth random number in [0, 255] for each place of a surface, with eight random values per
// unit.
double texture(double x, double y, std::uint64_t seed) {
  const double column = std::floor(8 * x), row = std::floor(8 * y);
  const auto code = [&](double i, double j) {
    const auto at = std::uint64_t(std::int64_t(i) * 7919 + std::int64_t(j) * 104729);
    return Random(seed ^ (at * 0x9e3779b97f4a7c15u)).between(0, 255);
  };
  const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
  const double s = smooth(8 * x - column), t = smooth(8 * y - row);
  return (1 - t) * ((1 - s) * code(column, row) + s * code(column + 1, row)) +
         t * ((1 - s) * code(column, row + 1) + s * code(column + 1, row + 1));
}

struct RayHit {
  double code = 0, depth = 0;
};

// Looks from a camera at (eye, 0, 0) along (x, y, 1): sees a pillar, which is half a unit wide in
// every two units, or the wall Z = 5 + X/2.
RayHit trace_ray(double eye, double x, double y) {
  const double at = eye + kPillars * x;
  if (at - 2 * std::floor(at / 2) < 0.5) return {texture(at, kPillars * y, 1), kPillars};
  const double z = (kDepth + kSlope * eye) / (1 - kSlope * x);
  return {texture(eye + z * x, z * y, 2), z};
}

struct Pair {
  Image<Rgba8> left{kWidth, kHeight}, right{kWidth, kHeight};
  Image<double> depth{kWidth, kHeight};  // of the left picture
  double baseline = 0,
         shift = 0;  // shift: px the right picture is moved to keep the wall's middle in place
};

// Makes the pictures: each pixel has four samples, and noise of up to 3 levels (of 255).
Pair pictures(double baseline) {
  Pair pair;
  pair.baseline = baseline;
  pair.shift = std::round(kFocal * baseline / kDepth);
  Random random(21);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const auto draw = [&](double eye, double shift) {
        double sum = 0;
        for (const double dx : {0.25, 0.75}) {
          for (const double dy : {0.25, 0.75})
            sum += trace_ray(eye, (x + dx - kWidth / 2 - shift) / kFocal,
                             (y + dy - kHeight / 2) / kFocal)
                       .code;
        }
        const auto code = std::uint8_t(std::clamp(sum / 4 + random.between(-3, 3), 0.0, 255.0));
        return Rgba8{code, code, code, 255};
      };
      pair.left.at(x, y) = draw(0, 0);
      pair.right.at(x, y) = draw(baseline, pair.shift);
      pair.depth.at(x, y) =
          trace_ray(0, (x + 0.5 - kWidth / 2) / kFocal, (y + 0.5 - kHeight / 2) / kFocal).depth;
    }
  }
  return pair;
}

// The range has all disparities of the pair and a small margin.
views::MatchSettings settings_for(const Pair& pair) {
  const double product = kFocal * pair.baseline;
  double least = 0, most = 0;
  for (const double z : pair.depth.pixels) {
    least = std::min(least, product / z - pair.shift);
    most = std::max(most, product / z - pair.shift);
  }
  views::MatchSettings settings;
  settings.range = {int(std::floor(least)) - 2, int(std::ceil(most)) + 2};
  settings.threads = 1;
  return settings;
}

// The RMS of Z/Z_true - 1 over all pixels; for each pixel it is limited to 1. Pixels that the right
// camera does not see are included, because a picture of distances needs a value for them.
double depth_error(double baseline_over_depth) {
  const Pair pair = pictures(baseline_over_depth * kDepth);
  const auto match = views::match_pictures(pair.left, pair.right, settings_for(pair));
  if (!match) return INFINITY;
  double squares = 0;
  for (std::size_t i = 0; i < pair.depth.pixels.size(); ++i) {
    const double d = double(match->disparity.pixels[i]) + pair.shift;
    const double off = d > 0 ? kFocal * pair.baseline / d / pair.depth.pixels[i] - 1 : 1;
    squares += std::pow(std::min(std::abs(off), 1.0), 2);
  }
  return std::sqrt(squares / double(pair.depth.pixels.size()));
}

// The error of the matcher's disparity in px, if only noise and subpixel interpolation disturb it.
constexpr double kDisparityError = 0.25;

double predicted(double baseline_over_depth) {
  return kDisparityError / (kFocal * baseline_over_depth);
}

double wall_at(double x) {
  return kDepth / (1 - kSlope * x);
}

// The part of the left picture that the right camera does not see, and the error of a guess of its
// depth.
struct OccludedPart {
  double share = 0;             // fraction of the picture
  double least = 0, worst = 0;  // RMS of the relative errors of the best and the worst guess
};

OccludedPart predict_occluded_part(double baseline_over_depth) {
  const double product = kFocal * baseline_over_depth * kDepth, edge = kWidth / 2 / kFocal;
  const double nearest = wall_at(-edge), farthest = wall_at(edge);
  // The right camera does not see the wall behind one side of each pillar (`behind`), and at the
  // sides of the picture it does not see what is outside its own picture (`beside`).
  const double behind = product * (1 / kPillars - 1 / kDepth);   // in px
  const double beside = product * (1 / nearest - 1 / farthest);  // in px
  const double period = 2 * kFocal / kPillars;                   // in px, from pillar to pillar
  OccludedPart result{.share = std::min(behind / period + beside / kWidth, 1.0)};
  // The best guess continues the wall at the last distance that was seen, while the wall itself
  // leans away from it.
  result.least = kSlope / kFocal * behind / std::sqrt(3.0);
  // The worst guess is the distance in the whole picture that differs most.
  double squares = 0;
  for (int column = 0; column < kWidth; ++column) {
    const double z = wall_at((column + 0.5 - kWidth / 2) / kFocal);
    squares += std::pow(std::max(1 - kPillars / z, farthest / z - 1), 2);
  }
  result.worst = std::sqrt(squares / kWidth);
  return result;
}

// Explains two ranges of the axis. Disparities that differ by less than views::kSmoothed are
// averaged over 25 pixels, which removes at most four fifths of an error that is independent in
// each pixel. From a ratio of 0.1 on, the pixels whose depth is guessed matter. The pixels that
// both cameras see follow the law within a factor of two, as everywhere, and the squares of both
// errors add.
std::optional<Finding> finding(double baseline_over_depth) {
  const double step = kFocal * baseline_over_depth * kDepth * (1 / kPillars - 1 / kDepth);  // in px
  if (step < double(views::kSmoothed)) {
    return Finding{
        "every step in depth is so small that averaging with its surroundings removes it", 0.2,
        0.5};
  }
  if (baseline_over_depth < 0.1) return std::nullopt;
  const OccludedPart guessed = predict_occluded_part(baseline_over_depth);
  const auto ratio = [&](double of_law, double off) {
    return std::hypot(of_law, std::sqrt(guessed.share) * off / predicted(baseline_over_depth));
  };
  return Finding{"the depth of points that one camera does not see is guessed",
                 ratio(0.5, guessed.least), ratio(2, guessed.worst)};
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<double> ratios{0.0125, 0.025, 0.05, 0.1, 0.2, 0.4};
  if (effort == Effort::kFull)
    ratios = {0.00625, 0.0125, 0.025, 0.0375, 0.05, 0.075, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6};
  std::vector<Configuration> all;
  for (const double ratio : ratios) {
    const Pair pair = pictures(ratio * kDepth);
    all.push_back({.series = "the default matcher",
                   .parameter = ratio,
                   .error = [=] { return depth_error(ratio); },
                   .predicted_error = predicted(ratio),
                   .finding = finding(ratio),
                   .work =
                       [pair, settings = settings_for(pair)](int) {
                         do_not_optimize(views::match_pictures(pair.left, pair.right, settings));
                       },
                   .items = kWidth * kHeight});
  }
  return all;
}

}  // namespace d21

Experiment d21_baseline() {
  using namespace d21;
  return {
      .id = "D-21",
      .name = "Stereo: how far apart the cameras are",
      .question =
          "A longer baseline makes depth more exact and matching harder: where is the best one?",
      .axis = "baseline over distance",
      .error = "RMS relative error of the depth, of all pixels",
      .reference = "the depth of a leaning, textured wall behind pillars, from its formula",
      .theory =
          "sigma_Z/Z = sigma_d Z/(f B) for the depth Z, the focal length f, the baseline B and an "
          "error of the disparity of sigma_d = 1/4 px (S2-13 in docs/references.md), as long as "
          "everything is matched",
      .item = "pixel",
      .axis_is_chosen = true,
      .configurations = configurations};
}

}  // namespace glassbox::study
