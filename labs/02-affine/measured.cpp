// Measures lab 2 for the chart of the experiment on methods that keep a matrix a rotation (D-13): a
// rotation is turned in small steps in double, and the student's function repairs it.
#include <algorithm>

#include <fmt/format.h>

#include "labs/measuring/measuring.h"
#include "study/experiments/d13_defect.h"

namespace glassbox::labs {

namespace lab_02_measured {

constexpr int kTimedSteps = 100'000;  // as in the experiment

Numbers question(int steps, int every) {
  Numbers numbers{double(steps), double(every)};
  for (const auto& row : study::step_matrix<double>())
    numbers.insert(numbers.end(), row.begin(), row.end());
  return numbers;
}

// The distance of a matrix from the rotation after this many steps. That rotation is a product in
// double, which drifts by only about 1e-11.
double distance_from_rotation(const study::RotationMatrix<double>& m, int steps) {
  const auto step = study::step_matrix<double>();
  study::RotationMatrix<double> turned{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int k = 0; k < steps; ++k) turned = study::operator*(turned, step);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) turned[i][j] -= m[i][j];
  }
  return study::frobenius(turned);
}

// The largest defect of all matrices in the answer, that is, how far they are from a rotation. NaN
// if an entry is not a number, or if the last matrix is more than 0.5 away from the product of all
// steps: otherwise a repair that undoes the steps would have no defect.
Result<double> largest_defect(const Ask& ask, int steps, int every) {
  const auto answers = ask({question(steps, every)});
  if (!answers) return tl::unexpected(answers.error());
  const Numbers& entries = answers->front();
  double largest = entries.size() < 9 ? number_of({}, 0) : 0;
  for (std::size_t at = 0; at + 9 <= entries.size(); at += 9) {
    study::RotationMatrix<double> m;
    for (std::size_t i = 0; i < 9; ++i) m[i / 3][i % 3] = entries[at + i];
    const double defect = study::frobenius(study::defect(m));
    if (!(defect <= largest)) largest = defect;
    if (largest != largest) break;
    if (at + 18 > entries.size() && !(distance_from_rotation(m, steps) < 0.5))
      return number_of({}, 0);
  }
  return largest;
}

std::vector<MeasuredPoint> measured_points() {
  std::vector<MeasuredPoint> all;
  for (const int every : {1, 10, 100, 1000}) {
    const std::string series =
        every == 1 ? "yours, every step" : fmt::format("yours, every {} steps", every);
    for (const int steps : {1000, 10'000, 100'000}) {
      all.push_back({series, double(steps), "", "",
                     [=](const Ask& ask) { return largest_defect(ask, steps, every); },
                     question(kTimedSteps, every), double(kTimedSteps)});
    }
  }
  return all;
}

}  // namespace lab_02_measured

LabMeasure measured_02() {
  using namespace lab_02_measured;
  return {"D-13", "repaired", measured_points};
}

}  // namespace glassbox::labs
