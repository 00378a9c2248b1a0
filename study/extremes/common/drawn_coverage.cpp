#include "study/extremes/common/drawn_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace glassbox::study {

std::vector<ScreenTriangle> on_lattice(std::vector<ScreenTriangle> triangles) {
  const auto nearest = [](float v) { return float(std::floor(double(v) * 1024 + 0.5) / 1024); };
  for (ScreenTriangle& triangle : triangles) {
    for (ScreenVertex& v : triangle) {
      v.position.x = nearest(v.position.x);
      v.position.y = nearest(v.position.y);
    }
  }
  std::erase_if(triangles, [](const ScreenTriangle& t) {
    // This is exact in double: coordinates have 25 bits each.
    return exact::orientation<double>(t[0].position, t[1].position, t[2].position) == 0;
  });
  return triangles;
}

namespace {

bool is_culled(const SnappedTriangle& t, Cull cull) {
  const int turn = exact::orientation<std::int64_t>(t);
  return (cull == Cull::kBack && turn > 0) || (cull == Cull::kFront && turn < 0);
}

}  // namespace

TriangleCoverage covered_exactly(const std::vector<ScreenTriangle>& triangles, int side,
                                 Cull cull) {
  TriangleCoverage exact{Image<int>(side, side), Image<int>(side, side)};
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const SnappedTriangle t = exact::snapped(triangles[i]);
    if (is_culled(t, cull)) continue;
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    const auto pixel = [&](std::int32_t subpixels) { return std::clamp(subpixels >> 8, 0, side); };
    for (int y = pixel(top); y < std::min(pixel(bottom) + 1, side); ++y) {
      for (int x = pixel(left); x < std::min(pixel(right) + 1, side); ++x) {
        if (!covers_exactly(t, x, y)) continue;
        if (exact.first.at(x, y) == 0) exact.first.at(x, y) = int(i) + 1;
        exact.times.at(x, y) = std::min(exact.times.at(x, y) + 1, kMaxLayers);
      }
    }
  }
  return exact;
}

RenderSettings plain_settings() {
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  settings.transfer = Transfer::kNone;
  settings.background = {0, 0, 0, 255};
  settings.want_id = true;
  return settings;
}

Material layer_material() {
  Material material = unlit_material();
  material.base_color.a = 0.5f;
  material.alpha_mode = AlphaMode::kBlend;
  return material;
}

// The number of half-transparent white layers on black. Each layer moves the value halfway to 255
// and rounds it to a byte: 0, 128, 192, 224, 240, 248.
int layers_of(const Rgba8& color) {
  int layers = 0, byte = 0;
  while (layers < kMaxLayers && color.r > byte + (255 - byte) / 4) {
    byte = (255 + byte + 1) / 2;
    ++layers;
  }
  return layers;
}

TriangleCoverage draw_coverage(const TestedEngine& engine,
                               const std::vector<ScreenTriangle>& triangles, int side,
                               const Culling& culling) {
  RenderSettings settings = plain_settings();
  settings.cull = culling.cull;
  settings.cull_stage = culling.stage;
  TriangleCoverage found{Image<int>(side, side), Image<int>(side, side)};
  const ScreenScene opaque = screen_scene(triangles, side, unlit_material());
  const Rendering shown = engine.draw(opaque.scene, opaque.view, settings);
  std::ranges::transform(shown.buffers.id.pixels, found.first.pixels.begin(),
                         [](std::uint32_t id) { return int(id); });
  const ScreenScene layers = screen_scene(triangles, side, layer_material());
  settings.want_id = false;
  const Rendering counted = engine.draw(layers.scene, layers.view, settings);
  std::ranges::transform(counted.buffers.color.pixels, found.times.pixels.begin(), layers_of);
  return found;
}

Outcome compare(const TriangleCoverage& found, const TriangleCoverage& exact) {
  std::int64_t other = 0, times = 0;
  for (std::size_t i = 0; i < exact.first.pixels.size(); ++i) {
    other += found.first.pixels[i] != exact.first.pixels[i];
    times += found.times.pixels[i] != exact.times.pixels[i];
  }
  return must_be_zero(double(other + times),
                      fmt::format("{} pixels show another triangle, {} are covered too often or "
                                  "not often enough, of {}",
                                  other, times, exact.first.pixels.size()));
}

CoverageReference::CoverageReference(std::vector<ScreenTriangle> triangles, int side,
                                     const Culling& culling)
    : triangles_(on_lattice(std::move(triangles))),
      side_(side),
      culling_(culling),
      exact_(covered_exactly(triangles_, side, culling.cull)) {}

Outcome CoverageReference::measure_error(const TestedEngine& engine) const {
  return compare(draw_coverage(engine, triangles_, side_, culling_), exact_);
}

Outcome worst_of(const std::vector<CoverageReference>& pictures, const TestedEngine& engine) {
  Outcome worst;
  for (const CoverageReference& each : pictures)
    worst = worse_of(each.measure_error(engine), worst);
  return worst;
}

}  // namespace glassbox::study
