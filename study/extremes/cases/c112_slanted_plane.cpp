#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/matching_pair.h"

namespace glassbox::study {
namespace c112 {

constexpr int kWidth = 160, kHeight = 60;

double disparity_at(double x, double y) {
  return 4 + 0.1 * x + 0.05 * y;
}

// Smooth noise as the texture of the plane, in pixels of the right picture: a random value every
// five pixels, with cubic interpolation between them.
class Texture {
public:
  Texture() : codes_(grey_noise(kWidth, kHeight, 112)) {}
  double at(double x, double y) const {
    const double column = std::max(x, 0.0) / 5, row = y / 5;
    const int i = std::min(int(column), kWidth - 2), j = std::min(int(row), kHeight - 2);
    const double s = smooth(column - i), t = smooth(row - j);
    const auto code = [&](int a, int b) { return double(codes_.at(a, b).g); };
    return (1 - t) * ((1 - s) * code(i, j) + s * code(i + 1, j)) +
           t * ((1 - s) * code(i, j + 1) + s * code(i + 1, j + 1));
  }

private:
  static double smooth(double x) { return x * x * (3 - 2 * x); }
  Image<Rgba8> codes_;
};

struct Pictures {
  Image<Rgba8> left{kWidth, kHeight}, right{kWidth, kHeight};
};
Pictures pictures() {
  const Texture texture;
  Pictures made;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const auto grey = [](double code) {
        const auto value = std::uint8_t(code + 0.5);
        return Rgba8{value, value, value, 255};
      };
      made.right.at(x, y) = grey(texture.at(x, y));
      made.left.at(x, y) = grey(texture.at(x - disparity_at(x, y), y));
    }
  }
  return made;
}

// Chooses the final disparity from the `refined` one, which has a fraction of a pixel, and the one
// in `whole` pixels.
using ChooseDisparity = double (*)(double refined, double whole);

// The root mean square error over the pixels that the right picture also shows; a pixel without an
// answer counts as an error of one pixel.
Outcome measure_error(ChooseDisparity answer) {
  const Pictures pair = pictures();
  views::MatchSettings settings = plain_settings("default", {0, 47});
  const views::DenseMatch refined = matched(pair.left, pair.right, settings);
  settings.subpixel = false;
  const views::DenseMatch whole = matched(pair.left, pair.right, settings);
  double squares = 0;
  int answered = 0, all = 0;
  for (int y = 4; y < kHeight - 4; ++y) {
    for (int x = 20; x < kWidth - 8; ++x, ++all) {
      const double a = double(refined.disparity.at(x, y)), b = double(whole.disparity.at(x, y));
      const bool is_answered = std::isfinite(a) && std::isfinite(b);
      squares += is_answered ? std::pow(answer(a, b) - disparity_at(x, y), 2) : 1;
      answered += is_answered;
    }
  }
  const double rms = std::sqrt(squares / all);
  return {rms, 0.25, {}, fmt::format("{} of {} pixels have a disparity", answered, all)};
}

double part_of_pixel(double refined, double) {
  return refined;
}
double whole_pixels(double, double whole) {
  return whole;
}
double other_way(double refined, double whole) {
  return whole - (refined - whole);
}
double cut_off(double refined, double) {
  return std::floor(refined);
}

}  // namespace c112

ExtremeCase c112_slanted_plane() {
  using namespace c112;
  return {
      .id = "C-112",
      .name = "A slanted plane",
      .construction = "smooth noise with the disparities 4 + x/10 + y/20, 160 x 60 px",
      .stage = "matching",
      .right_answer =
          "an RMS error of at most 1/4 px; with whole pixels it cannot be below 1/sqrt(12) = 0.289 "
          "px, the error of rounding",
      .unit = "px",
      .oracle = Oracle::kAnalytic,
      .ours = {"fractions of a pixel", [] { return measure_error(part_of_pixel); }},
      .naive = {"whole pixels", [] { return measure_error(whole_pixels); }},
      .mutants = {{"the fraction has the opposite sign", [] { return measure_error(other_way); }},
                  {"the fraction is cut off", [] { return measure_error(cut_off); }}},
      .not_drawn = "the case computes disparities from given pictures; no engine draws them",
  };
}

}  // namespace glassbox::study
