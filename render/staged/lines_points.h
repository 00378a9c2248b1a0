// Lines and points become fragments at pixel centres. With several samples per pixel they also
// cover samples: a line covers the samples in a rectangle around it, one pixel wide with square
// ends, and a point the samples in the unit square around it. Which pixel centres are covered does
// not depend on the number of samples.
#pragma once

#include <array>
#include <cmath>

#include <glassbox/raster/line.h>
#include <glassbox/raster/point.h>
#include <glassbox/render/staged/reference.h>

namespace glassbox {

template <class Watch>
void draw_centre(const FragmentStage& stage, const Watch& watch, const Surface& surface,
                 const Fragment& place) {
  CoveredFragment fragment;
  fragment.place = place;
  fragment.centre = true;
  fragment.centre_code = depth_code(stage.settings.depth, place.depth);
  finish_fragment(stage, watch, surface, fragment);
}

// ---- samples ----

inline ScreenVertex offset_vertex(const ScreenVertex& vertex, double x, double y) {
  ScreenVertex at = vertex;
  at.position.x = float(double(at.position.x) + x);
  at.position.y = float(double(at.position.y) + y);
  return at;
}

// Draws a quadrilateral as two triangles that share a diagonal. The corners are in order around it.
template <class Watch>
void rasterise_quad(const FragmentStage& stage, const Watch& watch,
                    const std::array<ScreenVertex, 4>& corners,
                    const std::array<const Varyings*, 4>& varyings, const FragmentSource& source) {
  for (const std::array<std::size_t, 3>& half :
       {std::array<std::size_t, 3>{0, 1, 2}, std::array<std::size_t, 3>{0, 2, 3}}) {
    const auto setup = setup_triangle({corners[half[0]], corners[half[1]], corners[half[2]]});
    if (!setup) continue;
    Surface surface;
    surface.source = source;
    for (std::size_t k = 0; k < 3; ++k) {
      surface.vertices[k] = *varyings[half[std::size_t(setup->order[k])]];
    }
    rasterise_surface(stage, watch, *setup, surface);
  }
}

// Draws the rectangle around a line. Its corners have the depth, 1/w and attributes of the line's
// end next to them, so that nothing changes across the line.
template <class Watch>
void rasterise_samples(const FragmentStage& stage, const Watch& watch, const ReadyLine& line) {
  const auto& [a, b] = line.ends;
  const double dx = double(b.position.x) - double(a.position.x);
  const double dy = double(b.position.y) - double(a.position.y);
  const double length = std::sqrt(dx * dx + dy * dy);
  if (length == 0) return;
  const double x = -dy / length / 2, y = dx / length / 2;  // half a pixel to each side
  const Varyings &at_a = line.vertices[0], &at_b = line.vertices[1];
  rasterise_quad(stage, watch,
                 {offset_vertex(a, x, y), offset_vertex(a, -x, -y), offset_vertex(b, -x, -y),
                  offset_vertex(b, x, y)},
                 {&at_a, &at_a, &at_b, &at_b}, line.source);
}

template <class Watch>
void rasterise_samples(const FragmentStage& stage, const Watch& watch, const ReadyPoint& point) {
  const ScreenVertex& p = point.position;
  const Varyings& at = point.vertex;
  rasterise_quad(stage, watch,
                 {offset_vertex(p, -0.5, -0.5), offset_vertex(p, 0.5, -0.5),
                  offset_vertex(p, 0.5, 0.5), offset_vertex(p, -0.5, 0.5)},
                 {&at, &at, &at, &at}, point.source);
}

// ---- lines and points ----

template <class Watch>
void rasterise(const FragmentStage& stage, const Watch& watch, const ReadyLine& line) {
  Surface surface;
  surface.vertices = {line.vertices[0], line.vertices[0], line.vertices[1]};
  surface.source = line.source;
  surface.id = line.id;
  for_each_line_pixel(snap(line.ends[0]), snap(line.ends[1]), stage.window,
                      [&](const LinePixel& pixel) {
                        draw_centre(stage, watch, surface, interpolate(line.ends, pixel));
                      });
  if (stage.samples != nullptr) rasterise_samples(stage, watch, line);
}

template <class Watch>
void rasterise(const FragmentStage& stage, const Watch& watch, const ReadyPoint& point) {
  if (stage.samples != nullptr) rasterise_samples(stage, watch, point);
  const PointPixel pixel = point_pixel(snap(point.position));
  const PixelRect& window = stage.window;
  if (pixel.x < window.x0 || pixel.x >= window.x1 || pixel.y < window.y0 || pixel.y >= window.y1)
    return;
  Fragment place;
  place.x = pixel.x;
  place.y = pixel.y;
  place.depth = point.position.position.z;
  place.inverse_w = point.position.inverse_w;
  Surface surface;
  surface.vertices = {point.vertex, point.vertex, point.vertex};
  surface.source = point.source;
  draw_centre(stage, watch, surface, place);
}

}  // namespace glassbox
