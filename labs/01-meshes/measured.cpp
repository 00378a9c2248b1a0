// Measures lab 1 for the chart of the experiment on polygon normals (D-8): the errors of the
// student's newell_vector on bent, noisy and far polygons.
#include <cmath>

#include "labs/measuring/measuring.h"
#include "study/experiments/d08_polygons.h"

#include <glassbox/mesh/normals.h>

namespace glassbox::labs {

namespace lab_01_measured {

using study::NormalCase;
using MakeCase = NormalCase (*)(std::uint64_t seed, double parameter);

constexpr int kPolygons = 500, kTimed = 4096;  // as in a quick run of the experiment

void append_polygon(Numbers& numbers, const NormalCase& of) {
  for (const Point<Object>& corner : of.corners) append_point(numbers, corner);
}

Result<double> rms_angle(const Ask& ask, MakeCase make, double parameter) {
  Numbers question{double(study::kPolygonCorners)};
  for (int i = 0; i < kPolygons; ++i)
    append_polygon(question, make(std::uint64_t(i) + 1, parameter));
  const auto answers = ask({question});
  if (!answers) return tl::unexpected(answers.error());
  double sum = 0;
  for (int i = 0; i < kPolygons; ++i) {
    const auto at = [&](int k) { return number_of(answers->front(), std::size_t(3 * i + k)); };
    const study::ExactVector normal = make(std::uint64_t(i) + 1, parameter).normal;
    // The error is NaN for the zero vector, which has no direction and is no normal.
    if (at(0) == 0 && at(1) == 0 && at(2) == 0) return number_of({}, 0);
    const double angle = angle_between(study::ExactVector(at(0), at(1), at(2)), normal);
    sum += angle * angle;
  }
  return std::sqrt(sum / kPolygons);
}

Numbers timed_polygons() {
  Numbers question{double(study::kPolygonCorners)};
  for (int i = 0; i < kTimed; ++i)
    append_polygon(question, study::noisy_case(std::uint64_t(i % 64) + 1, 0.1));
  return question;
}

std::vector<MeasuredPoint> measured_points() {
  std::vector<MeasuredPoint> all;
  const auto add = [&](const char* scene, MakeCase make, double parameter) {
    all.push_back({"yours", parameter, scene, "",
                   [=](const Ask& ask) { return rms_angle(ask, make, parameter); },
                   timed_polygons(), double(kTimed)});
  };
  for (const double bend : {1e-4, 1e-3, 1e-2, 1e-1})
    add("octagon whose second corner is bent by the value of the axis, heights wrong by up to 1e-4",
        study::noisy_case, bend);
  for (const double offset : {1.0, 1e2, 1e4, 1e6})
    add("flat octagon, as far from the origin as the value of the axis", study::far_case, offset);
  return all;
}

}  // namespace lab_01_measured

LabMeasure measured_01() {
  using namespace lab_01_measured;
  return {"D-8", "newell_vector", measured_points};
}

}  // namespace glassbox::labs
