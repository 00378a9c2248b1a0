// Lab 8 in the chart of the experiment on where the perspective division is done (D-4): errors and
// times of the student's span_coordinates for rows of pixels, with a division every 8, 16 or 32
// pixels.
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "labs/measuring/measuring.h"
#include "study/experiments/d04_lines.h"

namespace glassbox::labs {

namespace lab_08_measured {

using namespace study::d04;
using study::PerspectiveLine;

constexpr int kWallLines = 100, kTimed = 250;  // numbers of lines, as in a quick run

Numbers question(int every, const Lines& lines) {
  Numbers numbers{double(every)};
  for (const PerspectiveLine& line : lines)
    numbers.insert(numbers.end(), {double(line.u0), double(line.u1), double(line.inverse_w0),
                                   double(line.inverse_w1), double(line.pixels)});
  return numbers;
}

double pixels_of(const Lines& lines) {
  double pixels = 0;
  for (const PerspectiveLine& line : lines) pixels += line.pixels;
  return pixels;
}

struct Errors {
  double largest = 0, rms = 0;  // in texels
};

Result<Errors> errors_of(const Ask& ask, int every, const Lines& lines) {
  const auto answers = ask({question(every, lines)});
  if (!answers) return tl::unexpected(answers.error());
  Errors errors;
  double squares = 0;
  std::size_t at = 0;
  for (const PerspectiveLine& line : lines) {
    for (int x = 0; x < line.pixels; ++x) {
      const double right = exact_coordinate(line, (x + 0.5) / line.pixels);
      const double error = std::abs(number_of(answers->front(), at++) - right);
      if (!(error <= errors.largest)) errors.largest = error;
      squares += error * error;
    }
  }
  errors.rms = std::sqrt(squares / pixels_of(lines));
  if (errors.rms != errors.rms) errors.largest = errors.rms;
  return errors;
}

void add_lines(const std::string& scene, const Lines& lines, double parameter,
               std::vector<MeasuredPoint>& all) {
  const Lines timed = subsample_lines(lines, kTimed);
  for (const int every : {8, 16, 32}) {
    const auto kept = std::make_shared<std::optional<Errors>>();
    using ErrorOf = double Errors::*;
    const auto error = [=](ErrorOf which) {
      return [=](const Ask& ask) -> Result<double> {
        if (!*kept) {
          const auto found = errors_of(ask, every, lines);
          if (!found) return tl::unexpected(found.error());
          *kept = *found;
        }
        return (**kept).*which;
      };
    };
    const std::string series = fmt::format("yours, every {} pixels", every);
    all.push_back({series, parameter, scene, "", error(&Errors::largest), question(every, timed),
                   pixels_of(timed)});
    all.push_back({series, parameter, scene, "root mean square", error(&Errors::rms), {}, 1});
  }
}

std::vector<MeasuredPoint> measured_points() {
  std::vector<MeasuredPoint> all;
  for (const double ratio : {1.01, 1.41, 2.0, 5.0, 10.0, 30.0, 100.0})
    add_lines("wall", wall(ratio, kWallLines), ratio, all);
  const Lines floor = rolled_floor(), pot = teapot();
  add_lines("floor, rolled by 22.5 degrees", floor, largest_ratio(floor), all);
  add_lines("teapot", pot, largest_ratio(pot), all);
  return all;
}

}  // namespace lab_08_measured

LabMeasure measured_08() {
  using namespace lab_08_measured;
  return {"D-4", "span_coordinates", measured_points};
}

}  // namespace glassbox::labs
