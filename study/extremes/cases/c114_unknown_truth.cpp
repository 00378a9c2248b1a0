#include "study/extremes/common/extreme_case.h"
#include "study/naive/matching.h"
#include "views/matching/disparity_errors.h"
#include "views/matching/winner.h"

namespace glassbox::study {
namespace c114 {

// The calibration of the data set's motorcycle scene, in px and mm.
const views::Calibration kMotorcycle{994.978, 193.001, 31.086};

struct Subject114 {
  double (*rms)(const Image<float>& disparity, const Image<float>& truth);
  double (*depth)(double disparity, const views::Calibration& calibration);
};

double rms_of_known(const Image<float>& disparity, const Image<float>& truth) {
  return views::disparity_errors(disparity, views::known_disparities(truth, 1)).rms;
}
// Follows the documentation of the data set, which says that unknown values are NaN.
double nan_is_unknown(const Image<float>& disparity, const Image<float>& truth) {
  Image<float> known = truth, answer = disparity;
  for (std::size_t i = 0; i < known.pixels.size(); ++i) {
    if (std::isnan(known.pixels[i])) known.pixels[i] = answer.pixels[i] = 0;
  }
  return naive::rms_of_all(answer, known);
}
// Takes unknown values for 0 px, that is, for a distant point; every answer is then wrong.
double zero_is_far(const Image<float>& disparity, const Image<float>& truth) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    if (!std::isfinite(truth.pixels[i])) continue;
    sum += std::pow(double(disparity.pixels[i]) - double(truth.pixels[i]), 2);
    ++count;
  }
  return std::sqrt(sum / count);
}
double with_offset(double disparity, const views::Calibration& calibration) {
  Image<float> one(1, 1, float(disparity));
  return double(views::depths_of(one, calibration).pixels[0]);
}

// Three of seven pixels have a known disparity, and one of these has an error of 3 px. Depths are
// floats, computed with a sum, a product, a quotient and a final rounding.
Outcome measure_error(auto rms_by, auto depth_by) {
  const Subject114 subject{rms_by, depth_by};
  Image<float> truth(7, 1), disparity(7, 1);
  truth.pixels = {10, 0, INFINITY, NAN, 20, 2, INFINITY};
  disparity.pixels = {10, 50, 50, 50, 20, 5, 40};
  WorstError worst;
  const double right = std::sqrt(9.0 / 3), rms = subject.rms(disparity, truth);
  worst.add(std::abs(rms / right - 1), 0x1p-22,
            fmt::format("RMS {:.4g} px instead of {:.4g}", rms, right));
  for (const double d : {100.0, 40.0, 8.0}) {
    const double z = 994.978 * 193.001 / (d + 31.086), said = subject.depth(d, kMotorcycle);
    worst.add(std::abs(said / z - 1), 0x1p-22,
              fmt::format("{:.5g} mm instead of {:.5g} mm", said, z));
  }
  return worst.outcome();
}

}  // namespace c114

ExtremeCase c114_unknown_truth() {
  using namespace c114;
  return {
      .id = "C-114",
      .name = "Unknown truth and an offset",
      .construction =
          "a truth of 10, 0, +inf, NaN, 20, 2, +inf px, where 0 and numbers that are not finite "
          "are unknown; the motorcycle's calibration: f 994.978 px, B 193.001 mm, offset 31.086 px",
      .stage = "matching",
      .right_answer =
          "the error is that of the three known pixels, and depth is Z = f B/(d + 31.086), to four "
          "roundings of float",
      .unit = "relative",
      .oracle = Oracle::kAnalytic,
      .ours = {"only the known pixels, and the offset is added",
               [] { return measure_error(rms_of_known, with_offset); }},
      .naive = {"all pixels, and depth is f B/d",
                [] { return measure_error(naive::rms_of_all, naive::depth_without_offset); }},
      .mutants = {{"only NaN counts as unknown",
                   [] { return measure_error(nan_is_unknown, with_offset); }},
                  {"0 counts as a disparity",
                   [] { return measure_error(zero_is_far, with_offset); }},
                  {"the offset is forgotten",
                   [] { return measure_error(rms_of_known, naive::depth_without_offset); }}},
      .not_drawn = "the case computes disparities from given pictures; no engine draws them",
  };
}

}  // namespace glassbox::study
