// The lines of pixels that the perspective experiment (D-4) draws: across a wall, a floor and the
// teapot.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/teapot.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/view.h>

#include "study/experiments/kernels/reciprocal_kernels.h"

namespace glassbox::study::d04 {

using Lines = std::vector<PerspectiveLine>;

// The texture coordinate u at the fraction `far` of the line, 0 .. 1. Computed in double, whose own
// error is 2^-29 of that of float.
inline double exact_coordinate(const PerspectiveLine& line, double far) {
  const double q0 = line.inverse_w0, q1 = line.inverse_w1;
  return ((1 - far) * (line.u0 * q0) + far * (line.u1 * q1)) / ((1 - far) * q0 + far * q1);
}

// w at the far end divided by w at the near end.
inline double ratio_of(const PerspectiveLine& line) {
  const double ratio = double(line.inverse_w0) / double(line.inverse_w1);
  return std::max(ratio, 1 / ratio);
}
inline double largest_ratio(const Lines& lines) {
  double largest = 1;
  for (const PerspectiveLine& line : lines) largest = std::max(largest, ratio_of(line));
  return largest;
}

// Lines across a wall. The texture coordinate u runs from 0 to a random end between 255 and 256
// texels along 256 pixels, about one texel per pixel on average; w grows `ratio`-fold from one end
// of the line, where it is random between 1 and 2, to the other.
inline Lines wall(double ratio, int count) {
  Random random(5);
  Lines lines;
  for (int i = 0; i < count; ++i) {
    const double near = random.between(1, 2);
    lines.push_back(
        {0, float(kLinePixels - random.unit()), float(1 / near), float(1 / (near * ratio))});
  }
  return lines;
}

// Keeps every n-th line, so that at most `most` are left.
inline Lines subsample_lines(const Lines& lines, std::size_t most) {
  const std::size_t step = (lines.size() + most - 1) / most;
  Lines kept;
  for (std::size_t i = 0; i < lines.size(); i += step) kept.push_back(lines[i]);
  return kept;
}

// ---- lines of scenes, with the mipmap level that is nearest to one texel per pixel ----

inline PerspectiveLine at_its_level(double u0, double u1, double q0, double q1, int pixels) {
  const double texels = std::abs(u1 - u0) / pixels;
  const double scale = texels > 1 ? std::ldexp(1.0, -int(std::log2(texels) + 0.5)) : 1;
  return {float(u0 * scale), float(u1 * scale), float(q0), float(q1), pixels};
}

// The rows of a picture of a floor. The eye looks along the floor, 1.5 units above it, and sees it
// up to 60 units away; the vertical angle of view is 45 degrees, the picture has 256 x 256 px. u
// runs along the gaze with 64 texels per unit. The camera is rolled by 22.5 degrees: without a
// roll, w is constant along each row and there is no error.
inline Lines rolled_floor() {
  constexpr double kHeight = 1.5, kFarthest = 60, kTexels = 64;
  const double focal = kLinePixels / 2.0 / tan_half_degrees(45);
  const SinCos roll = sin_cos(kPi / 8);
  Lines lines;
  for (int y = 0; y < kLinePixels; ++y) {
    // 1/w at the left border of pixel x.
    const auto inverse_w = [&](int x) {
      const double right = x - kLinePixels / 2.0, down = y + 0.5 - kLinePixels / 2.0;
      return (right * roll.sin + down * roll.cos) / (kHeight * focal);
    };
    int first = 0;
    while (first < kLinePixels && inverse_w(first) < 1 / kFarthest) ++first;
    if (first == kLinePixels) continue;
    const double q0 = inverse_w(first), q1 = inverse_w(kLinePixels);
    lines.push_back(at_its_level(kTexels / q0, kTexels / q1, q0, q1, kLinePixels - first));
  }
  return lines;
}

// ---- the teapot, 512 x 512 px, 4 x 4 cells a patch, 256 texels along a patch ----

struct ScreenCorner {
  double x, y, q, p;  // x and y in px; 1/w and u/w
};

// Adds the rows of pixel centres inside a triangle. Values that are linear on the screen stay
// linear beyond its edges, so each row is extended to the borders of the pixels at both ends.
inline void add_rows(const std::array<ScreenCorner, 3>& t, Lines& lines) {
  const double area = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[2].x - t[0].x) * (t[1].y - t[0].y);
  const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
  for (int y = int(std::ceil(top - 0.5)); y + 0.5 < bottom; ++y) {
    double left = HUGE_VAL, right = -HUGE_VAL;
    for (std::size_t k = 0; k < 3; ++k) {
      const ScreenCorner &a = t[k], &b = t[(k + 1) % 3];
      if ((a.y <= y + 0.5) == (b.y <= y + 0.5)) continue;
      const double x = a.x + (b.x - a.x) * (y + 0.5 - a.y) / (b.y - a.y);
      left = std::min(left, x), right = std::max(right, x);
    }
    const int first = int(std::ceil(left - 0.5)), end = int(std::ceil(right - 0.5));
    if (first >= end) continue;
    using ValueOf = double ScreenCorner::*;
    const auto at = [&](int x, ValueOf value) {
      const double dx = x - t[0].x, dy = y + 0.5 - t[0].y;
      const double b = (dx * (t[2].y - t[0].y) - dy * (t[2].x - t[0].x)) / area,
                   c = (dy * (t[1].x - t[0].x) - dx * (t[1].y - t[0].y)) / area;
      return t[0].*value + b * (t[1].*value - t[0].*value) + c * (t[2].*value - t[0].*value);
    };
    const double q0 = at(first, &ScreenCorner::q), q1 = at(end, &ScreenCorner::q);
    lines.push_back(at_its_level(at(first, &ScreenCorner::p) / q0, at(end, &ScreenCorner::p) / q1,
                                 q0, q1, end - first));
  }
}

inline Lines teapot() {
  constexpr int kSide = 512, kLevel = 4, kTexels = 256;
  const View view = make_view(framing_camera(make_teapot(), 1).value(), kSide, kSide).value();
  const Mesh mesh = tessellate_teapot(kLevel);
  Lines lines;
  for (const Face& face : mesh.faces) {
    std::array<ScreenCorner, 3> seen;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner& corner = mesh.corners[face.first + k];
      const auto& p = mesh.positions[corner.position];
      const Point<Clip, double> clip =
          view.clip_from_eye * (view.eye_from_world * Point<World, double>(p.x, p.y, p.z));
      const double q = 1 / clip.w, u = kTexels * double(mesh.texcoords[corner.texcoord].u);
      seen[k] = {(1 + clip.x * q) * kSide / 2, (1 - clip.y * q) * kSide / 2, q, u * q};
    }
    const double turn = (seen[1].x - seen[0].x) * (seen[2].y - seen[0].y) -
                        (seen[2].x - seen[0].x) * (seen[1].y - seen[0].y);
    if (turn < 0) add_rows(seen, lines);  // front faces are counter-clockwise
  }
  return lines;
}

}  // namespace glassbox::study::d04
