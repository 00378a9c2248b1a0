// Compares clipping against the viewing pyramid in eye space with clipping against the box in clip
// space (D-32, S3-11).
#include <algorithm>
#include <cmath>

#include <glassbox/base/random.h>
#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/projection.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d32_clippers.h"
#include "study/experiments/do_not_optimize.h"

namespace glassbox::study {

namespace d32 {

Lens course_lens() {
  constexpr double kNear = 0.5, kFar = 64;
  const auto m = perspective_degrees(60, kWidth / kHeight, {kNear, kFar}).value();
  return {float(m.at(0, 0)), float(m.at(1, 1)), float(m.at(2, 2)),
          float(m.at(2, 3)), float(kNear),      float(kFar)};
}

std::vector<EyeTriangle> random_triangles(double size, std::size_t count) {
  const Lens lens = course_lens();
  Random random(32);
  std::vector<EyeTriangle> triangles(count);
  for (EyeTriangle& triangle : triangles) {
    const double x = random.between(-1.1, 1.1), y = random.between(-1.1, 1.1);
    const double distance = random.scaled(1, 2, -1, 5);
    for (Point<Eye>& p : triangle) {
      const double z = distance * random.between(1 - size / 4, 1 + size / 4);
      p = {float((x + random.between(-2, 2) * size) * z / double(lens.a)),
           float((y + random.between(-2, 2) * size) * z / double(lens.b)), float(-z)};
    }
  }
  return triangles;
}

template <class Space>
double farthest_off(double size, std::size_t count) {
  const Space space{course_lens()};
  double farthest = 0;
  Outline outline;
  for (const EyeTriangle& triangle : random_triangles(size, count)) {
    clip(space, triangle, outline);
    for (std::size_t i = 0; i < outline.count; ++i) {
      const auto plane = outline.cut_by[i];
      if (plane >= 0 && plane < 4)
        farthest = std::max(farthest, distance_from_edge(outline.vertices[i], plane));
    }
  }
  return farthest;
}

template <class Space>
void add_series(std::vector<Configuration>& all, const char* series, double predicted,
                Effort effort) {
  constexpr std::size_t kTimed = 8192;
  const std::size_t count = effort == Effort::kFull ? 400'000 : 40'000;
  for (const double size : {1.0 / 64, 1.0 / 16, 1.0 / 4, 1.0}) {
    all.push_back(
        {.series = series,
         .parameter = size,
         .error = [=] { return farthest_off<Space>(size, count); },
         .predicted_error = predicted,
         .work =
             [triangles = random_triangles(size, kTimed), space = Space{course_lens()}](int) {
               Outline outline;
               for (const EyeTriangle& triangle : triangles) {
                 clip(space, triangle, outline);
                 do_not_optimize(outline);
               }
             },
         .items = double(kTimed)});
  }
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  // The bound in px: three rounding errors of relative size u (the unit roundoff, 2^-24), of the
  // crossing's x and z and of the product of the projection, at half of the width.
  const double bound = 3 * double(unit_roundoff<float>) * kWidth / 2;
  add_series<EyeSpace>(all, "eye space, against the viewing pyramid", bound, effort);
  add_series<ClipSpace>(all, "clip space, against the box", 0, effort);
  return all;
}

}  // namespace d32

Experiment d32_clipping() {
  using namespace d32;
  return {
      .id = "D-32",
      .name = "Clipping: in eye space or in clip space",
      .question =
          "Is clipping against a box faster or more exact than against the viewing pyramid?",
      .axis = "length of a triangle's edges over the picture's width",
      .error =
          "largest distance of a vertex that clipping made from the edge of the picture at which "
          "it was made",
      .error_unit = "px",
      .reference = "the edge itself",
      .theory =
          "The distances from a plane of the pyramid and from a plane of the box are the same "
          "number, so in exact arithmetic both leave the same polygon. In floats, x = w can be set "
          "exactly, but x = z/a only rounded: x, z and the projection's product by u = 2^-24 each, "
          "3 u W/2 px in a picture of width W. Each side of the pyramid costs one more product per "
          "vertex; the box costs the projection of vertices that are discarded later, and a fourth "
          "coordinate for each crossing",
      .item = "triangle",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
