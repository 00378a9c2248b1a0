// Measures lab 5 for the chart of the experiment on clipping (D-32): how far from the edges of the
// picture the vertices are that the student's clipper makes.
#include <algorithm>
#include <cmath>

#include "labs/measuring/measuring.h"
#include "study/experiments/d32_clippers.h"

namespace glassbox::labs {

namespace lab_05_measured {

using namespace study::d32;

constexpr std::size_t kTriangles = 40'000, kTimed = 8192;  // as in a quick run of the experiment

Numbers question(double size, std::size_t count) {
  const study::d32::Lens lens = course_lens();
  Numbers numbers;
  for (const EyeTriangle& triangle : random_triangles(size, count)) {
    for (const Point<Eye>& p : triangle) append_point(numbers, to_clip(lens, p));
  }
  return numbers;
}

// Whether the vertex is a corner of the triangle that no plane cuts off.
bool is_corner(const Point<Clip>& p, const double* triangle) {
  const bool is_inside = std::abs(p.x) <= p.w && std::abs(p.y) <= p.w && p.z >= 0 && p.z <= p.w;
  if (!is_inside) return false;
  for (int k = 0; k < 3; ++k, triangle += 4) {
    if (double(p.x) == triangle[0] && double(p.y) == triangle[1] && double(p.z) == triangle[2] &&
        double(p.w) == triangle[3])
      return true;
  }
  return false;
}

// The result of a clipper: how many triangles have a part in the picture, and the sum of the areas
// of these parts.
struct ClippedParts {
  double triangles = 0, area = 0;  // the area is relative to that of the picture

  template <class VertexAt>
  void add(int count, const VertexAt& vertex_at) {
    triangles += count > 0;
    double twice = 0;
    for (int i = 0; i < count; ++i) {
      const Point<Clip> p = vertex_at(i), q = vertex_at(i + 1 == count ? 0 : i + 1);
      twice +=
          (double(p.x) * double(q.y) - double(q.x) * double(p.y)) / (double(p.w) * double(q.w));
    }
    area += std::abs(twice) / 2;
  }
};

ClippedParts expected_parts(double size) {
  const ClipSpace space{course_lens()};
  ClippedParts parts;
  Outline outline;
  for (const EyeTriangle& triangle : random_triangles(size, kTriangles)) {
    clip(space, triangle, outline);
    parts.add(int(outline.count), [&](int i) { return outline.vertices[std::size_t(i)]; });
  }
  return parts;
}

// Whether the student's result is near enough to the experiment's. Rounding decides whether a
// triangle is in the picture only if it hardly reaches into it, which is rarer than one in a
// thousand for random corners. An eighth of the area is what vertices that are off by a fifth of a
// small triangle change.
bool is_clipped(const ClippedParts& mine, const ClippedParts& right) {
  return std::abs(mine.triangles - right.triangles) <= double(kTriangles) / 1000 &&
         std::abs(mine.area - right.area) <= right.area / 8;
}

// How far a vertex made by clipping is from where it should be: 0 on the near or the far plane,
// otherwise the distance from the nearest edge of the picture.
double clip_vertex_error(const Point<Clip>& p) {
  if (p.z == 0 || p.z == p.w) return 0;
  return std::min(distance_from_edge(p, 0), distance_from_edge(p, 2));
}

// The largest error of a vertex made by clipping. NaN where the answer is too short, has polygons
// that no clipping gives, or leaves out parts that are in the picture: otherwise a function that
// does not clip would be the fastest method of all.
Result<double> largest_clip_error(const Ask& ask, double size) {
  const Numbers asked = question(size, kTriangles);
  const auto answers = ask({asked});
  if (!answers) return tl::unexpected(answers.error());
  const Numbers& answer = answers->front();
  double farthest = 0;
  ClippedParts parts;
  std::size_t at = 0;
  for (std::size_t triangle = 0; triangle < kTriangles; ++triangle) {
    const double count = number_of(answer, at++);
    if (!(count >= 0 && count <= double(kMaxVertices))) return number_of({}, 0);
    const auto vertex = [&](int i) {
      const auto number = [&](std::size_t k) {
        return float(number_of(answer, at + 4 * std::size_t(i) + k));
      };
      return Point<Clip>{number(0), number(1), number(2), number(3)};
    };
    parts.add(int(count), vertex);
    for (int i = 0; i < int(count); ++i) {
      const Point<Clip> p = vertex(i);
      if (is_corner(p, asked.data() + 12 * triangle)) continue;
      const double far = clip_vertex_error(p);
      if (!(far <= farthest)) farthest = far;
      if (farthest != farthest) return farthest;
    }
    at += 4 * std::size_t(count);
  }
  return is_clipped(parts, expected_parts(size)) ? farthest : number_of({}, 0);
}

std::vector<MeasuredPoint> measured_points() {
  std::vector<MeasuredPoint> all;
  for (const double size : {1.0 / 64, 1.0 / 16, 1.0 / 4, 1.0})
    all.push_back({"yours", size, "", "",
                   [=](const Ask& ask) { return largest_clip_error(ask, size); },
                   question(size, kTimed), double(kTimed)});
  return all;
}

}  // namespace lab_05_measured

LabMeasure measured_05() {
  using namespace lab_05_measured;
  return {"D-32", "outcode, trivial_verdict, clip_to_frustum", measured_points};
}

}  // namespace glassbox::labs
