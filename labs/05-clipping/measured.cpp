// Lab 5 in the chart of D-32: how far from the edges of the picture the student's clipper leaves its vertices.
#include <algorithm>

#include "labs/measuring/measuring.h"
#include "study/experiments/d32_clippers.h"

namespace glassbox::labs {

namespace {

using namespace study::d32;

constexpr std::size_t kTriangles = 40'000, kTimed = 8192;  // as in a quick run

Numbers question(double size, std::size_t count) {
  const study::d32::Lens lens = course_lens();
  Numbers numbers;
  for (const EyeTriangle& triangle : random_triangles(size, count)) {
    for (const Point<Eye>& p : triangle) append_place(numbers, to_clip(lens, p));
  }
  return numbers;
}

bool is_corner(const Point<Clip>& p, const double* triangle) {
  for (int k = 0; k < 3; ++k, triangle += 4) {
    if (double(p.x) == triangle[0] && double(p.y) == triangle[1] && double(p.z) == triangle[2] &&
        double(p.w) == triangle[3])
      return true;
  }
  return false;
}

// A vertex that clipping made lies on the near or the far plane, or is as far off as from the next edge of the picture.
double off(const Point<Clip>& p) {
  if (p.z == 0 || p.z == p.w) return 0;
  return std::min(off_the_edge(p, 0), off_the_edge(p, 2));
}

// No number where the answer breaks off, or has polygons that no clipping leaves.
Result<double> farthest_off(const Ask& ask, double size) {
  const Numbers asked = question(size, kTriangles);
  const auto answers = ask({asked});
  if (!answers) return tl::unexpected(answers.error());
  const Numbers& answer = answers->front();
  double farthest = 0;
  std::size_t at = 0;
  for (std::size_t triangle = 0; triangle < kTriangles; ++triangle) {
    const double count = number_of(answer, at++);
    if (!(count >= 0 && count <= double(kMostVertices))) return number_of({}, 0);
    for (int i = 0; i < int(count); ++i, at += 4) {
      const auto number = [&](std::size_t k) { return float(number_of(answer, at + k)); };
      const Point<Clip> p{number(0), number(1), number(2), number(3)};
      if (is_corner(p, asked.data() + 12 * triangle)) continue;
      const double far = off(p);
      if (!(far <= farthest)) farthest = far;
      if (farthest != farthest) return farthest;
    }
  }
  return farthest;
}

std::vector<MeasuredPlace> places() {
  std::vector<MeasuredPlace> all;
  for (const double size : {1.0 / 64, 1.0 / 16, 1.0 / 4, 1.0})
    all.push_back({"yours", size, "", "", [=](const Ask& ask) { return farthest_off(ask, size); },
                   question(size, kTimed), double(kTimed)});
  return all;
}

}  // namespace

LabMeasure measured_05() {
  return {"D-32", "outcode, trivial_verdict, clip_to_frustum", places};
}

}  // namespace glassbox::labs
