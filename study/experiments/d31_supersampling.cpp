// D-31: how well samples at points estimate what share of a pixel a triangle covers.
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <memory>
#include <span>

#include <fmt/format.h>

#include <glassbox/mesh/builtin/forest.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/samples.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/draw_list.h>
#include <glassbox/render/vertex_stage.h>

#include "study/experiments/consume.h"
#include "study/experiments/experiments.h"
#include "study/experiments/shapes.h"

namespace glassbox::study {

namespace {

// A triangle in whole 1/256 px, in the order that makes its edge functions positive inside, and one pixel that it touches.
struct Piece {
  std::array<SnappedVertex, 3> corners;
  std::array<EdgeFunction, 3> edges;
  int x = 0, y = 0;
};

// ---- the share of a pixel by clipping: T is the exact rational, or double ----

template <class T>
using Polygon = std::vector<std::array<T, 2>>;

// Keeps what lies at sign * p[axis] >= sign * limit.
template <class T>
Polygon<T> clip_to(const Polygon<T>& polygon, std::size_t axis, int limit, int sign) {
  Polygon<T> kept;
  const auto inside = [&](const auto& p) { return sign > 0 ? p[axis] >= limit : p[axis] <= limit; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (inside(a)) kept.push_back(a);
    if (inside(a) == inside(b)) continue;
    const std::size_t other = 1 - axis;
    std::array<T, 2> crossing;
    crossing[axis] = limit;
    crossing[other] = T(a[other] + (b[other] - a[other]) * (limit - a[axis]) / (b[axis] - a[axis]));
    kept.push_back(crossing);
  }
  return kept;
}

// From the pixel's own corner: small numbers lose less.
template <class T>
T covered_share(const Piece& piece) {
  Polygon<T> polygon;
  for (const SnappedVertex& v : piece.corners)
    polygon.push_back({T(v.x - piece.x * kSubpixels), T(v.y - piece.y * kSubpixels)});
  for (std::size_t axis = 0; axis < 2; ++axis) {
    polygon = clip_to(polygon, axis, 0, 1);
    polygon = clip_to(polygon, axis, kSubpixels, -1);
  }
  T twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += T(a[0] * b[1] - b[0] * a[1]);
  }
  return T(twice / (2 * kSubpixels * kSubpixels));
}

// ---- samples ----

using Positions = std::vector<std::array<int, 2>>;  // 1/256 px from the pixel's corner

Positions standard(int samples) {
  Positions positions;
  for (const SampleOffset& offset : sample_offsets(samples))
    positions.push_back({kPixelCentre + offset.x, kPixelCentre + offset.y});
  return positions;
}

// As near to a square of cells as a power of two allows.
std::array<int, 2> cells(int samples) {
  const int rows = samples == 1 ? 1 : samples <= 4 ? samples / 2 : 4;
  return {samples == 4 ? 2 : samples / rows, samples == 4 ? 2 : rows};
}

// A square lattice turned by arctan(1/2), of as many points to the pixel: the one of area 256^2/S that is nearest to the
// centre, S points of it.
Positions rotated(int samples) {
  const double side = kSubpixels / std::sqrt(double(samples)), c = 2 / std::sqrt(5.0),
               s = 1 / std::sqrt(5.0);
  struct Place {
    double distance, x, y;
  };
  std::vector<Place> places;
  for (int i = -8; i <= 8; ++i) {
    for (int k = -8; k <= 8; ++k) {
      const double u = (i + (samples > 1 ? 0.5 : 0)) * side,
                   v = (k + (samples > 1 ? 0.5 : 0)) * side;
      const double x = c * u - s * v, y = s * u + c * v;
      places.push_back({std::max(std::abs(x), std::abs(y)), x, y});
    }
  }
  std::ranges::stable_sort(places, {}, &Place::distance);
  Positions positions;
  for (int i = 0; i < samples; ++i) {
    const auto inside = [](double p) { return std::clamp(int(std::lround(128 + p)), 0, 255); };
    positions.push_back({inside(places[std::size_t(i)].x), inside(places[std::size_t(i)].y)});
  }
  return positions;
}

enum class Pattern { kStandard, kRandom, kJittered, kRotated };
struct NamedPattern {
  Pattern pattern;
  const char* name;
};
constexpr NamedPattern kPatterns[] = {{Pattern::kStandard, "D3D standard"},
                                      {Pattern::kRandom, "random"},
                                      {Pattern::kJittered, "jittered"},
                                      {Pattern::kRotated, "rotated grid"}};

// Of pixel number `pixel`; those that do not change from pixel to pixel come ready made.
void place_samples(Pattern pattern, std::size_t pixel, Positions& positions) {
  const int samples = int(positions.size());
  if (pattern == Pattern::kStandard || pattern == Pattern::kRotated) return;
  const auto [columns, rows] = pattern == Pattern::kJittered ? cells(samples) : std::array{1, 1};
  for (int i = 0; i < samples; ++i) {
    const std::uint64_t bits = scramble(pixel * 16 + std::size_t(i) + 310000);
    const int width = kSubpixels / columns, height = kSubpixels / rows;
    const int column = columns * rows == 1 ? 0 : i % columns,
              row = columns * rows == 1 ? 0 : i / columns;
    positions[std::size_t(i)] = {column * width + int(bits % std::uint64_t(width)),
                                 row * height + int((bits >> 32) % std::uint64_t(height))};
  }
}

int count_covered(const Piece& piece, std::span<const std::array<int, 2>> positions) {
  int covered = 0;
  for (const auto& [dx, dy] : positions) {
    const std::int64_t x = std::int64_t(piece.x) * kSubpixels + dx,
                       y = std::int64_t(piece.y) * kSubpixels + dy;
    covered += piece.edges[0].covers(piece.edges[0].at(x, y)) &&
               piece.edges[1].covers(piece.edges[1].at(x, y)) &&
               piece.edges[2].covers(piece.edges[2].at(x, y));
  }
  return covered;
}

double estimate(Pattern pattern, const Piece& piece, std::size_t index, Positions& positions) {
  place_samples(pattern, index, positions);
  return double(count_covered(piece, positions)) / double(positions.size());
}

Positions start_positions(Pattern pattern, int samples) {
  if (pattern == Pattern::kStandard) return standard(samples);
  if (pattern == Pattern::kRotated) return rotated(samples);
  return Positions(std::size_t(samples));
}

// ---- scenes: the pixels that an edge of a triangle crosses ----

using Triangles = std::vector<std::array<ScreenVertex, 3>>;

// A star of long wedges about the middle.
Triangles star_chart() {
  constexpr int kWedges = 36;
  constexpr double kMiddle = 128.3, kRadius = 120;
  Triangles star;
  for (int i = 0; i < kWedges; ++i) {
    std::array<ScreenVertex, 3> wedge;
    for (std::size_t k = 0; k < 3; ++k) {
      const SinCos at = sin_cos(2 * kPi * (i + (k == 2 ? 0.5 : 0)) / kWedges + 0.1);
      const double r = k == 0 ? 4 : kRadius;
      wedge[k].position = {float(kMiddle + r * at.cos), float(kMiddle + r * at.sin), 0.5f};
    }
    star.push_back(wedge);
  }
  return star;
}

// The built-in forest's trees, as its first camera's pipeline places them; what is clipped is left out.
Triangles forest() {
  const Scene scene = make_forest();
  const PreparedScene prepared = prepare(scene, Transfer::kNone);
  const View view = make_view(scene.cameras.front(), 256, 160).value();
  const DrawList list = make_draw_list(scene, prepared, view);
  const auto planes = frustum_planes();
  Triangles triangles;
  for (const Draw& draw : list.draws) {
    const ClipTable table = project_vertices(draw, view);
    for (const Triangle& triangle : draw.triangulation->triangles) {
      std::array<ScreenVertex, 3> placed;
      bool whole = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point<Clip>& clip = table.positions[draw.mesh->corners[triangle.corners[k]].position];
        whole = whole && outcode(clip, planes) == 0;
        if (whole) placed[k] = to_screen(divide(clip), view.viewport);
      }
      if (whole) triangles.push_back(placed);
    }
  }
  return triangles;
}

struct Samples {
  std::vector<Piece> pieces;
  std::vector<double> exact;  // the share, by rationals, rounded once; 0 < share < 1
  double squares = 0;         // mean of c (1 - c)
  double nearest = 0;         // mean of min(c, 1 - c)^2
};

// `most` pixels that are partly covered, evenly picked among the pixels that the edges' boxes meet.
Samples partly_covered(const Triangles& triangles, std::size_t most) {
  std::vector<Piece> all;
  for (const auto& triangle : triangles) {
    const auto setup = setup_triangle(triangle);
    if (!setup) continue;
    Piece piece{{}, setup->edges, 0, 0};
    for (std::size_t k = 0; k < 3; ++k)
      piece.corners[k] = snap(triangle[std::size_t(setup->order[k])]);
    const PixelRect& box = setup->bounds;
    for (piece.y = box.y0 - 1; piece.y <= box.y1; ++piece.y) {
      for (piece.x = box.x0 - 1; piece.x <= box.x1; ++piece.x) {
        const double share = covered_share<double>(piece);
        if (share > 1e-9 && share < 1 - 1e-9) all.push_back(piece);
      }
    }
  }
  Samples samples;
  const std::size_t step = std::max<std::size_t>(1, all.size() / most);
  for (std::size_t i = 0; i < all.size(); i += step) {
    const double c = double(covered_share<boost::multiprecision::cpp_rational>(all[i]));
    samples.pieces.push_back(all[i]);
    samples.exact.push_back(c);
    samples.squares += c * (1 - c);
    samples.nearest += std::min(c, 1 - c) * std::min(c, 1 - c);
  }
  samples.squares /= double(samples.exact.size());
  samples.nearest /= double(samples.exact.size());
  return samples;
}

double rms_error(Pattern pattern, int count, const Samples& samples) {
  Positions positions = start_positions(pattern, count);
  double sum = 0;
  for (std::size_t i = 0; i < samples.pieces.size(); ++i) {
    const double e = estimate(pattern, samples.pieces[i], i, positions) - samples.exact[i];
    sum += e * e;
  }
  return std::sqrt(sum / double(samples.pieces.size()));
}

double predicted(Pattern pattern, int count, const Samples& samples) {
  if (pattern == Pattern::kRandom || (pattern == Pattern::kJittered && count == 1))
    return std::sqrt(samples.squares / count);
  if (count == 1) return std::sqrt(samples.nearest);
  return std::sqrt(samples.squares) * std::pow(count, -0.75);
}

void add_scene(const std::string& name, const std::shared_ptr<const Samples>& samples,
               std::vector<Configuration>& all) {
  const auto items = double(samples->pieces.size());
  for (const auto& [pattern, series] : kPatterns) {
    for (const int count : {1, 2, 4, 8, 16}) {
      all.push_back(
          {.series = series,
           .parameter = double(count),
           .scene = name,
           .error = [=, pattern = pattern] { return rms_error(pattern, count, *samples); },
           .predicted_error = predicted(pattern, count, *samples),
           .finding = {},
           .work =
               [=, pattern = pattern](int) {
                 Positions positions = start_positions(pattern, count);
                 for (std::size_t i = 0; i < samples->pieces.size(); ++i)
                   consume(estimate(pattern, samples->pieces[i], i, positions));
               },
           .items = items});
    }
  }
  all.push_back(
      {.series = "analytic area, double",
       .parameter = 1,
       .scene = name,
       .error =
           [=] {
             double squares = 0;
             for (std::size_t i = 0; i < samples->pieces.size(); ++i) {
               const double e = covered_share<double>(samples->pieces[i]) - samples->exact[i];
               squares += e * e;
             }
             return std::sqrt(squares / items);
           },
       .predicted_error = 0x1p-53,
       .finding = "long edges cost digits: where an edge crosses the pixel's border is computed "
                  "from corners up to 120 px away, and rounded as numbers of that size are",
       .work =
           [=](int) {
             for (const Piece& piece : samples->pieces) consume(covered_share<double>(piece));
           },
       .items = items});
}

std::vector<Configuration> configurations(Effort effort) {
  const std::size_t most = effort == Effort::kQuick ? 1000 : 8000;
  std::vector<Configuration> all;
  add_scene("star chart", std::make_shared<const Samples>(partly_covered(star_chart(), most)), all);
  add_scene("forest", std::make_shared<const Samples>(partly_covered(forest(), most)), all);
  return all;
}

}  // namespace

Experiment d31_supersampling() {
  return {
      .id = "D-31",
      .name = "Supersampling: where the samples of a pixel lie",
      .question = "How many samples, and placed how, for how smooth an edge?",
      .axis = "samples to a pixel",
      .axis_unit = {},
      .error = "RMS error of the covered share, over partly covered pixels",
      .error_unit = "pixel",
      .reference = "the exact area of triangle and pixel, by clipping in rationals",
      .theory =
          "With m the mean of c(1 - c) over the pixels: random sqrt(m/S), the binomial variance. A "
          "cell of a grid of S errs only "
          "where an edge crosses it, and a line crosses sqrt(S) of the S cells on the average "
          "(Cauchy-Crofton): sqrt(m) S^-3/4, "
          "which regular patterns follow too. One sample at the centre: RMS of min(c, 1 - c). "
          "Analytic: a few roundings of numbers below one pixel, 2^-53",
      .item = "pixel",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
