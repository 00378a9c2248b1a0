#include "study/extremes/common/depth.h"
#include "study/extremes/common/extreme_case.h"
#include "study/naive/depth.h"

#include <glassbox/base/random.h>

namespace glassbox::study {
namespace c58 {

constexpr int kSide = 256;

// Scales a vertex to an eighth and moves it to some place in the picture, so that the tile engine
// treats the triangle as a small one.
ScreenVertex shrunk(const ScreenVertex& v, int i) {
  const float x = float(i * 37 % 200), y = float(i * 59 % 200);
  return screen_vertex(double(v.position.x / 8 + x), double(v.position.y / 8 + y), v.position.z);
}

// Each triangle, followed by the same triangle with another first vertex.
std::vector<ScreenTriangle> pairs() {
  Random random(58);
  std::vector<ScreenTriangle> all;
  for (int i = 0; i < 60; ++i) {
    ScreenTriangle t;
    for (ScreenVertex& v : t) {
      const double x = double(random.integer(0, 4 * kSide)) / 4;
      const double y = double(random.integer(0, 4 * kSide)) / 4;
      v = screen_vertex(x, y, float(random.between(0.125, 0.875)));
      if (i % 3 == 0) v = shrunk(v, i);
    }
    all.push_back(t);
    std::rotate(t.begin(), t.begin() + 1 + i % 2, t.end());
    all.push_back(t);
  }
  return all;
}

// Counts the pixels that show a copy instead of the triangle drawn before it. Copies have even
// numbers.
Outcome measure_error(const Image<int>& seen) {
  const auto copies =
      std::ranges::count_if(seen.pixels, [](int id) { return id > 0 && id % 2 == 0; });
  const auto drawn = std::ranges::count_if(seen.pixels, [](int id) { return id > 0; });
  return must_be_zero(
      double(copies),
      fmt::format("{} of {} pixels show the triangle that was drawn second", copies, drawn));
}

Image<Rgba8> stipple(const Image<int>& seen) {
  Image<Rgba8> picture(seen.width, seen.height);
  for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
    const int id = seen.pixels[i];
    picture.pixels[i] = id == 0       ? Rgba8{40, 44, 52, 255}
                        : id % 2 == 0 ? Rgba8{213, 94, 0, 255}
                                      : Rgba8{86, 180, 233, 255};
  }
  return picture;
}

const ZBuffer kGivenOrder{.depth = naive::depth_in_given_order};

Outcome measure_drawn_error(const TestedEngine& engine) {
  return measure_error(visible_triangles(engine, pairs(), kSide));
}

}  // namespace c58

ExtremeCase c58_same_twice() {
  using namespace c58;
  return {
      .id = "C-58",
      .name = "The same triangle twice",
      .construction =
          "60 random triangles, a third of them small, each drawn again beginning at another "
          "vertex",
      .stage = "depth test",
      .right_answer =
          "the first stays everywhere, because depth is summed from the nearest vertex whatever "
          "the order of the vertices is, and an equal depth does not pass the test",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"the staged reference", [] { return measure_drawn_error(tested_engines()[0]); }},
      .naive = {"depth is summed in the order of the vertices",
                [] { return measure_error(z_buffered(pairs(), kSide, kGivenOrder)); }},
      .mutants = {{"equal depths pass the test",
                   [] {
                     return measure_error(
                         z_buffered(pairs(), kSide, {.passes = naive::in_front_or_equal}));
                   }}},
      .drawn = measure_drawn_error,
      .pictures = {{"naive",
                    [] { return png_of(stipple(z_buffered(pairs(), kSide, kGivenOrder)), 2); }},
                   {"ours",
                    [] {
                      return png_of(stipple(visible_triangles(tested_engines()[0], pairs(), kSide)),
                                    2);
                    }}},
  };
}

}  // namespace glassbox::study
