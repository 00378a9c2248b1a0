// Measures how far apart two surfaces must be so that a depth format can tell which one is in front
// (D-6).
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <glassbox/images/image.h>
#include <glassbox/mesh/builtin/images.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/interpolate.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d06_formats.h"
#include "study/experiments/d06_ladder.h"
#include "study/experiments/do_not_optimize.h"

namespace glassbox::study {

namespace d06 {

// ---- the ladder: consecutive float distances whose codes should be in order ----

double error_on_ladder(const Format& format, double z, int count) {
  const Placement place(format, {});
  const auto codes = [&](const std::vector<float>& distances) {
    std::vector<std::uint32_t> all;
    for (const float distance : distances) {
      const ScreenVertex placed = place(Point<Eye>(0, 0, -distance));
      all.push_back(code_of(format, placed.position.z, distance));
    }
    return all;
  };
  return d06::ladder_error(codes, z, count);
}

// ---- pictures ----

constexpr int kSide = 192;

struct Pixel {
  double nearest = kInfinity, shown = kInfinity;
  std::uint32_t code = kEmptyDepth;
};

using EyeTriangle = std::array<Point<Eye>, 3>;

// The distance of the snapped triangle at the pixel's centre, in double: the relative error is
// below 2^-50.
double exact_distance(const EyeTriangle& triangle, const TriangleSetup& setup,
                      const Coverage& pixel) {
  double inverse = 0;
  for (std::size_t k = 0; k < 3; ++k)
    inverse += double(pixel.edges[k]) / double(setup.double_area) /
               -double(triangle[std::size_t(setup.order[k])].z);
  return 1 / inverse;
}

// The largest distance between the surface that a pixel shows and the one that it should show,
// relative to the distance from the eye.
double picture_error(const Format& format, const std::vector<EyeTriangle>& triangles) {
  const Placement place(format, {0, 0, kSide, kSide});
  Image<Pixel> picture(kSide, kSide);
  for (const EyeTriangle& triangle : triangles) {
    const auto setup = setup_triangle({place(triangle[0]), place(triangle[1]), place(triangle[2])});
    if (!setup) continue;
    for_each_covered(*setup, {0, 0, kSide, kSide}, [&](const Coverage& covered) {
      const Fragment fragment = interpolate(*setup, covered);
      const std::uint32_t code = code_of(format, fragment.depth, 1 / fragment.inverse_w);
      const double z = exact_distance(triangle, *setup, covered);
      Pixel& pixel = picture.at(covered.x, covered.y);
      pixel.nearest = std::min(pixel.nearest, z);
      if (in_front(code, pixel.code)) pixel.code = code, pixel.shown = z;
    });
  }
  double largest = 0;
  for (const Pixel& pixel : picture.pixels) {
    if (std::isfinite(pixel.nearest))
      largest = std::max(largest, (pixel.shown - pixel.nearest) / pixel.nearest);
  }
  return largest;
}

// Adds a quad of a plane that leans away to the right. It is seen from direction (x0, y0) to (x1,
// y1), is moved nearer by the fraction `closer` of its distance, and is divided along one diagonal
// or the other.
void add_leaning_quad(double z, double x0, double y0, double x1, double y1, double closer,
                      bool other_diagonal, std::vector<EyeTriangle>& triangles) {
  const auto corner = [&](double x, double y) {
    const double distance = z / (1 - 0.3 * x) * (1 - closer);
    return Point<Eye>(float(x * distance), float(y * distance), float(-distance));
  };
  const std::array<Point<Eye>, 4> c{corner(x0, y0), corner(x1, y0), corner(x1, y1), corner(x0, y1)};
  const std::size_t first = other_diagonal ? 1 : 0;
  triangles.push_back({c[first], c[first + 1], c[(first + 2) % 4]});
  triangles.push_back({c[first], c[(first + 2) % 4], c[(first + 3) % 4]});
}

// A wall of tiles, with a decal of the same size in front of each tile, which is nearer by 2^-2 to
// 2^-26 of the distance.
std::vector<EyeTriangle> decals(double z) {
  constexpr int kTiles = 14;
  std::vector<EyeTriangle> triangles;
  for (const bool decal : {false, true}) {
    for (int i = 0; i < kTiles * kTiles; ++i) {
      const int column = i % kTiles, row = i / kTiles;
      const double x = 1.8 * column / kTiles - 0.9, y = 1.8 * row / kTiles - 0.9,
                   size = 1.7 / kTiles;
      const double closer = decal ? std::exp2(-2 - 24.0 * i / (kTiles * kTiles)) : 0;
      add_leaning_quad(z, x, y, x + size, y + size, closer, decal, triangles);
    }
  }
  return triangles;
}

// Boxes at distances from 2 to 2000 units; each has a signboard in front of its front face, from a
// thousandth of a unit to one unit nearer.
std::vector<EyeTriangle> city() {
  std::vector<EyeTriangle> triangles;
  const auto quad = [&](const Point<Eye>& a, const Point<Eye>& b, const Point<Eye>& c,
                        const Point<Eye>& d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  };
  for (std::uint64_t i = 0; i < 400; ++i) {
    const auto draw = [i](std::uint64_t k) { return random_unit(6, 8 * i + k); };
    const double z = 2 * std::exp2(10 * draw(0)), x = (2 * draw(1) - 1) * z,
                 y = (2 * draw(2) - 1) * z;
    const double size = z * (0.03 + 0.1 * draw(3)), depth = z * 0.2 * draw(4),
                 gap = std::min(z / 4, std::exp2(-10 + 10 * draw(5)));
    const auto at = [&](double sx, double sy, double away) {
      return Point<Eye>(float(x + sx * size), float(y + sy * size), float(-(z + away)));
    };
    quad(at(-1, -1, 0), at(1, -1, 0), at(1, 1, 0), at(-1, 1, 0));
    for (const double side : {-1.0, 1.0}) {
      quad(at(side, -1, 0), at(side, -1, depth), at(side, 1, depth), at(side, 1, 0));
      quad(at(-1, side, 0), at(1, side, 0), at(1, side, depth), at(-1, side, depth));
    }
    quad(at(-0.8, -0.7, -gap), at(0.8, -0.7, -gap), at(0.8, 0.7, -gap), at(-0.8, 0.7, -gap));
  }
  return triangles;
}

// ---- what is timed: the depth test of many fragments, each against a stored code ----

std::shared_ptr<const Fragments> timed_fragments() {
  return std::make_shared<const Fragments>(make_fragments(kFragments));
}

template <class Stored>
std::function<void(int)> depth_tests(const Format& format,
                                     const std::shared_ptr<const Fragments>& fragments) {
  const auto buffer = std::make_shared<std::vector<Stored>>(kFragments);
  return [=](int) {
    std::ranges::fill(*buffer, std::numeric_limits<Stored>::max());
    for (std::size_t i = 0; i < kFragments; ++i) {
      const std::uint32_t code = code_of(format, fragments->depth[i], fragments->w[i]);
      Stored& stored = (*buffer)[i];
      if (in_front(code, stored)) stored = Stored(code);
    }
    do_not_optimize(*buffer);
  };
}

std::vector<Configuration> configurations(Effort effort) {
  const int count = effort == Effort::kQuick ? 2048 : 16384;
  std::vector<double> distances{0.2, 1, 10, 100, 1000, 9000};
  const auto fragments = timed_fragments();
  std::vector<Configuration> all;
  for (const Format& format : kFormats) {
    const auto work = format.bits == 16 ? depth_tests<std::uint16_t>(format, fragments)
                                        : depth_tests<std::uint32_t>(format, fragments);
    const auto add = [&](const char* scene, double z, std::function<double()> error,
                         std::optional<double> predicted, const std::optional<Finding>& finding) {
      all.push_back({.series = format.name,
                     .parameter = z,
                     .scene = scene,
                     .error = std::move(error),
                     .predicted_error = predicted,
                     .finding = finding,
                     .work = work,
                     .items = double(kFragments)});
    };
    for (const double z : distances)
      add(
          "ladder", z, [=] { return error_on_ladder(format, z, count); }, predicted_at(format, z),
          finding_on_ladder(format));
    for (const double z : {1.0, 100.0, 1000.0})
      add(
          "coplanar decals", z, [=] { return picture_error(format, decals(z)); },
          predicted_in_picture(format, z), finding_in_picture(format));
    add("city of boxes", 2000, [=] { return picture_error(format, city()); }, std::nullopt, {});
  }
  return all;
}

}  // namespace d06

Experiment d06_depth() {
  using namespace d06;
  return {
      .id = "D-6",
      .name = "Depth formats: which surface is in front",
      .question =
          "How far apart must two surfaces be for a depth buffer to tell which is in front?",
      .axis = "distance, with the near plane at 0.1 and the far one at 10000",
      .axis_unit = "world units",
      .error = "largest relative distance dz/z of two surfaces of which the farther one is drawn",
      .error_unit = "of the distance",
      .reference =
          "the order of the test's distances; in pictures, distances interpolated in double",
      .theory =
          "The formulas are in B.3 of docs/references.md; n is the near plane and f the far plane. "
          "Codes of b bits have z (1/n - 1/f) 2^-b, reversed or not, and float with depth near 1 "
          "has the same with 2^-24. Reversed float has 2^-23 everywhere. Depth that is reversed by "
          "way of [-1, 1] has the step of floats at -1, 2^-25. Linear w has (f - n) 2^-b/z, and "
          "logarithmic depth has ln(f/n) 2^-b. The distance that is told apart is never smaller "
          "than that of positions as floats, 2^-23, and never reaches beyond the far plane.",
      .item = "fragment",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
