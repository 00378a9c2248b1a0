#include "study/extremes/common/depth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/divide.h>

#include "study/extremes/common/drawn_coverage.h"
#include "study/extremes/common/ray_scene.h"
#include "study/extremes/common/screen_scene.h"

namespace glassbox::study {

std::function<std::uint32_t(float)> depth_codes(const DepthPath& path) {
  const bool reversed = path.format == DepthFormat::kFloat32Reversed;
  const bool subtracted = path.detour == DepthPath::kSubtracted;
  const DepthRange range = reversed && !subtracted ? DepthRange::kReversed : DepthRange::kStandard;
  Transform<Clip, Eye> clip_from_eye =
      perspective_degrees(90, 1, {path.near, path.far, range}).value();
  if (path.detour == DepthPath::kThroughGl) {
    clip_from_eye = Transform<Clip, Eye>((clip_gl_from_clip() * clip_from_eye).columns);
  }
  return [path, m = round_to_float(clip_from_eye)](float distance) {
    float depth = divide(m * Point<Eye>(0, 0, -distance)).position.z;
    if (path.detour == DepthPath::kThroughGl) depth = 0.5f * depth + 0.5f;
    if (path.detour == DepthPath::kSubtracted) depth = 1.0f - depth;
    return depth_code(path.format, depth);
  };
}

double coarsest_confused(const DepthPath& path, double distance, double around) {
  const auto code = depth_codes(path);
  Random random(56);
  // The front depths of the pairs are between nearest * distance and distance. This range is wide
  // enough to contain two depths that differ by slightly less than one step of the depth format.
  const double nearest = 1 - std::clamp(around, 0.02, 0.5);
  double coarsest = 0;
  for (int k = -32; k <= 20; ++k) {
    const double separation = around * std::exp2(k / 4.0);
    for (int i = 0; i < 200; ++i) {
      const float front = float(distance * random.between(nearest, 1));
      const float back = float(double(front) * (1 + separation));
      if (!(double(back) <= path.far) || back <= front) continue;
      if (!in_front(code(front), code(back))) {
        coarsest = std::max(coarsest, (double(back) - double(front)) / double(front));
      }
    }
  }
  return coarsest;
}

double standard_separation(double distance, double near, double far, double step) {
  const double s = step * (1 / near - 1 / far) * distance;
  return s < 1 ? s / (1 - s) : std::numeric_limits<double>::infinity();
}

std::uint32_t pane_code_drawn(const TestedEngine& engine, double near, double far,
                              DepthFormat format, float distance) {
  const float d = distance;
  RayScene pane =
      make_ray_scene({{Point<Eye>{-2 * d, -2 * d, -d}, {6 * d, -2 * d, -d}, {-2 * d, 6 * d, -d}}},
                     PerspectiveLens{1, near, far}, 8);
  store_depth(pane, format);
  pane.settings.want_depth = true;
  return engine.draw(pane.scene, pane.view, pane.settings).buffers.depth.at(4, 4);
}

float depth_of_reversed_code(std::uint32_t code) {
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(1.0f) - code);
}

float pipeline_depth(const TriangleSetup& setup, const Coverage& pixel) {
  return interpolate(setup, pixel).depth;
}

long double exact_depth(const TriangleSetup& setup, const Coverage& pixel) {
  long double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += static_cast<long double>(pixel.edges[k]) * static_cast<long double>(setup.depth[k]);
  }
  return sum / static_cast<long double>(setup.double_area);
}

Image<int> z_buffered(const std::vector<ScreenTriangle>& triangles, int side,
                      const ZBuffer& buffer) {
  Image<int> seen(side, side);
  Image<std::uint32_t> codes(side, side, kEmptyDepth);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto setup = setup_triangle(triangles[i]);
    if (!setup) continue;
    for_each_covered(*setup, {0, 0, side, side}, [&](const Coverage& pixel) {
      const std::uint32_t code = depth_code(buffer.format, buffer.depth(*setup, pixel));
      std::uint32_t& stored = codes.at(pixel.x, pixel.y);
      if (!buffer.passes(code, stored)) return;
      stored = code;
      seen.at(pixel.x, pixel.y) = int(i) + 1;
    });
  }
  return seen;
}

Image<int> visible_triangles(const TestedEngine& engine,
                             const std::vector<ScreenTriangle>& triangles, int side,
                             DrawGrouping draws) {
  ScreenScene drawn = screen_scene(triangles, side, unlit_material());
  if (draws == DrawGrouping::kEach) drawn.scene = one_draw_per_triangle(drawn.scene);
  const auto ids = engine.draw(drawn.scene, drawn.view, plain_settings()).buffers.id;
  Image<int> seen(side, side);
  std::ranges::transform(ids.pixels, seen.pixels.begin(), [](std::uint32_t id) { return int(id); });
  return seen;
}

Outcome measure_depth_error(const TestedEngine& engine,
                            const std::vector<ScreenTriangle>& triangles, int side,
                            double roundoffs, const ExactDepthAt& exact) {
  const ScreenScene drawn = screen_scene(triangles, side, unlit_material());
  RenderSettings settings = plain_settings();
  settings.want_depth = true;
  const Framebuffer found = engine.draw(drawn.scene, drawn.view, settings).buffers;
  WorstError worst;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const std::uint32_t id = found.id.at(x, y);
      if (id == 0) continue;
      const long double right = exact(x, y, id - 1);
      const auto depth = static_cast<long double>(std::bit_cast<float>(found.depth.at(x, y)));
      worst.add(
          depth == right ? 0 : double(std::abs(depth - right) / right) * 0x1p24, roundoffs,
          fmt::format("{:.9g} instead of {:.9g} at ({}, {})", double(depth), double(right), x, y));
    }
  }
  return worst.count() > 0 ? worst.outcome() : must_be_zero(HUGE_VAL, "nothing was drawn");
}

}  // namespace glassbox::study
