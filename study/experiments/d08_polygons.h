// The polygons of the normals experiment (D-8), turned at random, and their exact normals.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glassbox/base/random.h>
#include <glassbox/base/spaces.h>
#include <glassbox/base/trig.h>

#include "exact/number.h"
#include "study/experiments/d01_scenes.h"

namespace glassbox::study {

inline constexpr std::size_t kPolygonCorners = 8;
using ExactVector = Vector<Object, double>;
using ExactPolygon = std::array<Point<Object, double>, kPolygonCorners>;
using FloatPolygon = std::array<Point<Object>, kPolygonCorners>;

inline constexpr double kNoise = 1e-4;

struct PlanePoint {
  double x, y;
};
using PlanePolygon = std::array<PlanePoint, kPolygonCorners>;

inline PlanePolygon regular_octagon() {
  PlanePolygon p;
  for (std::size_t i = 0; i < kPolygonCorners; ++i) {
    const SinCos at = sin_cos_degrees(45.0 * double(i));
    p[i] = {at.cos, at.sin};
  }
  return p;
}

// The second corner is moved inwards until it is `bend` away from the line between its neighbours.
inline PlanePolygon bent_octagon(double bend) {
  PlanePolygon p = regular_octagon();
  // The chord from p[0] to p[2] has its middle in the direction of p[1], seen from the centre.
  const double cos = p[1].x, sin = p[1].y;
  const double chord = (p[0].x + p[2].x) / 2 * cos + (p[0].y + p[2].y) / 2 * sin;
  p[1] = {(chord + bend) * cos, (chord + bend) * sin};
  return p;
}

struct NormalCase {
  FloatPolygon corners;
  ExactVector normal;  // the exact normal, with which the computed one is compared
};

inline ExactVector in_space(const glm::dmat3& turn, double x, double y, double z) {
  return ExactVector(turn * glm::dvec3(x, y, z));
}

// Corners are moved out of the plane by up to kNoise sqrt(3) to either side, which is a standard
// deviation of kNoise. The right normal is that of the plane.
inline NormalCase noisy_case(std::uint64_t seed, double bend) {
  Random random(seed);
  const glm::dmat3 turn = rounded(exact::pythagorean_rotation(random));
  const PlanePolygon flat = bent_octagon(bend);
  NormalCase c;
  for (std::size_t i = 0; i < kPolygonCorners; ++i) {
    const double height = random.between(-1, 1) * kNoise * std::sqrt(3.0);
    const ExactVector p = in_space(turn, flat[i].x, flat[i].y, height);
    c.corners[i] = {float(p.x), float(p.y), float(p.z)};
  }
  c.normal = in_space(turn, 0, 0, 1);
  return c;
}

// Newell's vector of the corners, computed without rounding errors.
inline ExactVector exact_newell(const FloatPolygon& p) {
  using exact::Decimal;
  std::array<Decimal, 3> m;
  const auto at = [&](std::size_t i, std::size_t axis) {
    const auto& q = p[i % kPolygonCorners];
    return Decimal(double(axis == 0 ? q.x : axis == 1 ? q.y : q.z));
  };
  for (std::size_t i = 0; i < kPolygonCorners; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
      m[axis] += (at(i, y) - at(i + 1, y)) * (at(i, z) + at(i + 1, z));
    }
  }
  return {double(m[0]), double(m[1]), double(m[2])};
}

// The precision of floats at this offset, in bits after the binary point, with one bit to spare:
// differences and sums of two coordinates are exact.
inline int grid_bits(double offset) {
  int exponent = 0;
  std::frexp(2 * offset + 2, &exponent);
  return 23 - exponent;
}

// An octagon with a radius of about 1, `offset` away from the origin in a random direction.
// Rounding its corners would bend it, and then no normal would be right. So each corner is an
// integer combination of two vectors on the grid of the floats there, and all corners stay in one
// plane.
inline NormalCase far_case(std::uint64_t seed, double offset) {
  Random random(seed);
  const int bits = grid_bits(offset);
  const double step = std::ldexp(1.0, -bits);
  const auto on_grid = [&](double x) { return std::floor(x / step + 0.5) * step; };
  const auto third = [&] { return on_grid(random.between(-0.4, 0.4)); };
  ExactVector u, v;
  do {
    u = {third(), third(), third()}, v = {third(), third(), third()};
  } while (dot(u, u) < 0.05 || dot(v, v) < 0.05 ||
           dot(cross(u, v), cross(u, v)) < 0.5 * dot(u, u) * dot(v, v));
  const ExactVector away = random_direction<Object>(random) * offset;
  constexpr std::array<PlanePoint, kPolygonCorners> kRound{
      {{3, 0}, {2, 2}, {0, 3}, {-2, 2}, {-3, 0}, {-2, -2}, {0, -3}, {2, -2}}};
  NormalCase c;
  for (std::size_t i = 0; i < kPolygonCorners; ++i) {
    const ExactVector p = u * kRound[i].x + v * kRound[i].y;
    c.corners[i] = {float(on_grid(away.x) + p.x), float(on_grid(away.y) + p.y),
                    float(on_grid(away.z) + p.z)};
  }
  c.normal = exact_newell(c.corners);
  return c;
}

}  // namespace glassbox::study
