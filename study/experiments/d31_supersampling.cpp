// Measures how well point samples estimate the fraction of a pixel that a triangle covers (D-31).
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <glassbox/mesh/builtin/forest.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/vertex_stage.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d31_pieces.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/random_triangles.h"

namespace glassbox::study {

namespace d31 {

// ---- scenes: the pixels that an edge of a triangle crosses ----

using Triangles = std::vector<std::array<ScreenVertex, 3>>;

// A star of long wedges around the middle.
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

// The trees of the built-in forest, on the screen of its first camera; triangles that would be
// clipped are left out.
Triangles forest() {
  const Scene scene = make_forest();
  const PreparedScene prepared = prepare_scene(scene, Transfer::kNone);
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
  std::vector<double> exact;  // covered fraction c, in rationals, rounded once; 0 < c < 1
  double squares = 0;         // mean of c (1 - c)
  double nearest = 0;         // mean of min(c, 1 - c)^2
};

// At most `most` partly covered pixels, evenly chosen among the pixels in the bounding boxes of the
// edges.
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
           .work =
               [=, pattern = pattern](int) {
                 Positions positions = start_positions(pattern, count);
                 for (std::size_t i = 0; i < samples->pieces.size(); ++i)
                   do_not_optimize(estimate(pattern, samples->pieces[i], i, positions));
               },
           .items = items});
    }
  }
  all.push_back({.series = "analytic area, double",
                 .parameter = 1,
                 .scene = name,
                 .error =
                     [=] {
                       double squares = 0;
                       for (std::size_t i = 0; i < samples->pieces.size(); ++i) {
                         const double e =
                             covered_share<double>(samples->pieces[i]) - samples->exact[i];
                         squares += e * e;
                       }
                       return std::sqrt(squares / items);
                     },
                 .predicted_error = 0x1p-53,
                 .finding = Finding{"long edges lose digits: the crossing of an edge with the "
                                    "pixel's border is computed from corners up to 120 px away, "
                                    "with the rounding errors of numbers of this size",
                                    2, 120},
                 .work =
                     [=](int) {
                       for (const Piece& piece : samples->pieces)
                         do_not_optimize(covered_share<double>(piece));
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

}  // namespace d31

Experiment d31_supersampling() {
  using namespace d31;
  return {
      .id = "D-31",
      .name = "Supersampling: how many samples a pixel has, and where",
      .question =
          "How smooth is an edge with a given number of samples, and where should the samples be?",
      .axis = "samples per pixel",
      .error = "RMS error of the covered fraction, over partly covered pixels",
      .error_unit = "pixel",
      .reference = "the exact area of triangle and pixel, by clipping in rationals",
      .theory =
          "Let c be the covered fraction of a pixel and m the mean of c(1 - c) over the pixels. S "
          "random samples have the error sqrt(m/S), by the binomial variance. A cell of a grid of "
          "S cells has an error only if an edge crosses it, and a line crosses sqrt(S) of the S "
          "cells on average (Cauchy-Crofton), so the error is sqrt(m) S^-3/4, which is also true "
          "for regular patterns. One sample at the centre has the RMS of min(c, 1 - c). The "
          "analytic area has a few rounding errors of numbers below one pixel, 2^-53",
      .item = "pixel",
      .axis_is_chosen = true,
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
