#include <cstdlib>

#include <glassbox/base/random.h>
#include <glassbox/raster/line.h>
#include <glassbox/raster/point.h>

#include "study/extremes/common/coverage.h"
#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/screen_scene.h"
#include "study/naive/lines.h"

namespace glassbox::study {
namespace c55 {

constexpr PixelRect kWindow{0, 0, 24, 24};

void pipeline_line(const SnappedVertex& a, const SnappedVertex& b, const PixelVisitor& visit) {
  for_each_line_pixel(a, b, kWindow, [&](const LinePixel& pixel) { visit(pixel.x, pixel.y); });
}

using DrawsLine =
    std::function<void(const SnappedVertex&, const SnappedVertex&, const PixelVisitor& visit)>;

// Draws a line as a whole, and then as two lines that meet in one of its points: the pixels must be
// the same, and none may be drawn twice. All these points are on a lattice, so that nothing is
// rounded. There are horizontal, vertical and diagonal lines; the joints are at pixel centres, on
// borders of diamonds, and elsewhere.
std::int64_t joint_faults(const DrawsLine& draws) {
  Random random(55);
  std::int64_t faults = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto lattice = [&](int low, int high) {
      return std::int32_t(random.integer(low, high)) * 64;
    };
    const SnappedVertex a{lattice(8, 88), lattice(8, 88)};
    const int steps = int(random.integer(2, 6)), cut = int(random.integer(1, steps - 1));
    const std::int32_t dx = std::int32_t(random.integer(-3, 3)) * 64,
                       dy = std::int32_t(random.integer(-3, 3)) * 64;
    if (dx == 0 && dy == 0) continue;
    const auto at = [&](int step) { return SnappedVertex{a.x + step * dx, a.y + step * dy}; };
    Image<int> whole(24, 24), parts(24, 24);
    const auto count = [](Image<int>& times) {
      return [&times](int x, int y) {
        if (x >= 0 && x < 24 && y >= 0 && y < 24) ++times.at(x, y);
      };
    };
    draws(a, at(steps), count(whole));
    draws(a, at(cut), count(parts));
    draws(at(cut), at(steps), count(parts));
    for (std::size_t p = 0; p < whole.pixels.size(); ++p) {
      faults += whole.pixels[p] != parts.pixels[p] || whole.pixels[p] > 1;
    }
  }
  return faults;
}

// The example of the Direct3D and OpenGL rules: a line from (1.5, 1.5) to (5.5, 1.5) covers columns
// 1 to 4, because it leaves their diamonds, but not column 5, because it ends inside that diamond.
// The same holds downwards and diagonally.
std::int64_t fixture_faults(const DrawsLine& draws) {
  std::int64_t faults = 0;
  for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 0}, {0, -1}, {-1, -1}}) {
    Image<int> times(24, 24);
    const SnappedVertex a{10 * 256 + 128, 10 * 256 + 128};
    draws(a, {a.x + dx * 4 * 256, a.y + dy * 4 * 256}, [&](int x, int y) { ++times.at(x, y); });
    for (int i = 0; i < 4; ++i) faults += times.at(10 + i * dx, 10 + i * dy) != 1;
    faults += times.at(10 + 4 * dx, 10 + 4 * dy) != 0;
  }
  return faults;
}

Outcome measure_error(const DrawsLine& draws) {
  const std::int64_t joints = joint_faults(draws), fixtures = fixture_faults(draws);
  return must_be_zero(double(joints + fixtures),
                      fmt::format("{} pixels are wrong where 4,000 lines join, and {} in lines and "
                                  "points with known pixels",
                                  joints, fixtures));
}

// Also tests points at quarters of pixels: a point at p covers the one pixel whose centre c has p -
// 1/2 <= c < p + 1/2.
Outcome measure_our_error() {
  Outcome outcome = measure_error(pipeline_line);
  for (std::int32_t x = -1024; x <= 1024; x += 64) {
    const int column = point_pixel({x, 128}).x;
    const double centre = column + 0.5, p = x / 256.0;
    if (!(p - 0.5 <= centre && centre < p + 0.5)) ++outcome.error;
  }
  return outcome;
}

constexpr int kSide = 2048, kCell = 24;

using ScreenLine = std::array<SnappedVertex, 2>;

// A scene whose picture has these lines and points at the given places, in units of 1/256 px. Its
// material shows the number of layers in each pixel.
ScreenScene screen_lines(const std::vector<ScreenLine>& lines,
                         const std::vector<SnappedVertex>& points) {
  ScreenScene made = screen_scene({}, kSide, layer_material());
  Mesh& mesh = made.scene.meshes[0];
  const auto corner = [&](const SnappedVertex& v) {
    const float half = float(kSide) / 2;
    mesh.positions.emplace_back(float(v.x) / 256 - half, half - float(v.y) / 256, -0.5f);
    return Corner{.position = std::uint32_t(mesh.positions.size() - 1)};
  };
  for (const auto& [from, to] : lines) mesh.lines.push_back({corner(from), corner(to)});
  for (const SnappedVertex& point : points) mesh.points.push_back(corner(point));
  return made;
}

Image<Rgba8> drawn_by(const TestedEngine& engine, const ScreenScene& scene) {
  return engine.draw(scene.scene, scene.view, plain_settings()).buffers.color;
}

// The lines of joint_faults, each in a cell of its own, and a row of points, each of which covers
// one pixel according to the rule.
Outcome measure_drawn_error(const TestedEngine& engine) {
  Random random(55);
  std::vector<ScreenLine> whole, parts;
  constexpr int kColumns = kSide / kCell;
  for (int i = 0; i < 4000; ++i) {
    const std::int32_t left = i % kColumns * kCell * 256, top = i / kColumns * kCell * 256;
    const auto lattice = [&](int low, int high) {
      return std::int32_t(random.integer(low, high)) * 64;
    };
    const SnappedVertex a{left + lattice(24, 72), top + lattice(24, 72)};
    const int steps = int(random.integer(2, 6)), cut = int(random.integer(1, steps - 1));
    const std::int32_t dx = lattice(-3, 3), dy = lattice(-3, 3);
    const auto at = [&](int step) { return SnappedVertex{a.x + step * dx, a.y + step * dy}; };
    if (dx == 0 && dy == 0) continue;
    whole.push_back({a, at(steps)});
    parts.insert(parts.end(), {{a, at(cut)}, {at(cut), at(steps)}});
  }
  const Image<Rgba8> one = drawn_by(engine, screen_lines(whole, {}));
  const Image<Rgba8> two = drawn_by(engine, screen_lines(parts, {}));
  std::int64_t joints = 0, lit = 0, points = 0;
  for (std::size_t p = 0; p < one.pixels.size(); ++p) {
    joints += one.pixels[p] != two.pixels[p] || layers_of(one.pixels[p]) > 1;
    lit += layers_of(one.pixels[p]);
  }
  for (std::int32_t quarter = 0; quarter < 16; ++quarter) {
    const SnappedVertex at{512 + quarter * 64, 640};
    const Image<Rgba8> shown = drawn_by(engine, screen_lines({}, {at}));
    for (int x = 0; x < 10; ++x) {
      const double centre = x + 0.5, p = at.x / 256.0;
      const bool is_lit = p - 0.5 <= centre && centre < p + 0.5;
      points += layers_of(shown.at(x, 2)) != int(is_lit);
    }
  }
  Outcome outcome =
      must_be_zero(double(joints + points),
                   fmt::format("{} pixels are wrong where {} lines join, and {} of points", joints,
                               whole.size(), points));
  if (lit < std::int64_t(whole.size())) outcome.error = HUGE_VAL;  // nothing was drawn
  return outcome;
}

}  // namespace c55

ExtremeCase c55_lines_and_points() {
  using namespace c55;
  return {
      .id = "C-55",
      .name = "Lines and points",
      .construction =
          "4,000 lines with ends on quarters of pixels, each also cut in two at a point on "
          "quarters of pixels; lines of four pixels in six directions; points on quarters of "
          "pixels",
      .stage = "lines",
      .right_answer =
          "the diamond-exit rule: a line that is cut in two has the same pixels as the whole line, "
          "none of them twice; a line from centre to centre over five pixels has the first four",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"the diamond-exit rule in integers", measure_our_error},
      .naive = {"Bresenham's lines with both end pixels",
                [] { return measure_error(naive::bresenham); }},
      .mutants = {{"the last pixel is drawn as well",
                   [] { return measure_error(naive::line_with_last_pixel); }},
                  {"the first pixel is drawn only if the line passes its centre",
                   [] { return measure_error(naive::line_without_start); }}},
      .drawn = measure_drawn_error,
  };
}

}  // namespace glassbox::study
