// The reference: takes a triangle through every stage, in order. The first step goes from its
// corners to triangles on the screen, the second step to the pixels. There are two steps because
// each is timed, and because the tile engine sorts triangles into tiles between them. `watch` is
// one of the types of watch.h; it is called with each stage's result.
#pragma once

#include <optional>
#include <vector>

#include <glassbox/raster/fan.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>
#include <glassbox/render/staged/corners.h>
#include <glassbox/render/staged/covered_fragments.h>
#include <glassbox/render/staged/fragment_color.h>
#include <glassbox/render/staged/fragment_write.h>
#include <glassbox/render/staged/prepare_lines.h>

namespace glassbox {

// Appends what is left of a triangle of the mesh after clipping and culling: nothing, the triangle
// itself, or the fan of its clipped polygon. With RenderSettings::wireframe its edges are appended
// to `lines` instead.
template <class Watch>
void prepare_triangle(const PrimitiveStage& stage, const Watch& watch, const Triangle& triangle,
                      std::vector<ReadyTriangle>& triangles, std::vector<ReadyLine>& lines) {
  const std::array<ClipVertex, 3> corners = clip_vertices(stage, triangle);    // transform
  const std::array<Outcode, 3> codes = outcodes_of(stage, triangle, corners);  // outcode
  const ClipVerdict verdict = trivial_verdict(codes);
  if (is_culled_early(stage, triangle, verdict)) return watch.count_culled_early();
  ClipPolygon polygon = clip_to_view(stage, corners, verdict);  // clip
  watch.count_clipped(verdict, polygon);
  watch.notify(&Observer::clipped, stage, triangle, corners, polygon);

  const std::size_t count = std::size_t(polygon.count);
  std::array<ScreenVertex, kMaxClipVertices> screen;
  std::array<SnappedVertex, kMaxClipVertices> snapped;
  for (std::size_t k = 0; k < count; ++k) {
    screen[k] = screen_vertex_of(stage, watch, polygon.vertices[k]);  // divide, viewport
    snapped[k] = snap(screen[k]);                                     // snap
  }
  int apex = fan_apex(std::span(snapped).first(count));
  watch.notify(&Observer::fanned, std::span(snapped).first(count), apex);

  const std::uint32_t number = stage.draw.first_number + triangle.number;
  // The corners' attributes, computed when the first triangle of the fan is not culled, for the
  // side of it that is seen.
  std::optional<std::array<Varyings, 3>> visible;
  for (int i = 0; i < fan_size(polygon); ++i) {
    const std::array<std::size_t, 3> piece = fan_vertices(apex, polygon.count, i);
    const std::array<ScreenVertex, 3> vertices{screen[piece[0]], screen[piece[1]],
                                               screen[piece[2]]};
    std::optional<TriangleSetup> setup = setup_triangle(  // set up
        vertices, {snapped[piece[0]], snapped[piece[1]], snapped[piece[2]]});
    watch.notify(&Observer::set_up, std::uint32_t(i), vertices, setup);
    watch.count_set_up(setup);
    if (!setup) continue;
    const bool front = shows_front(stage.draw, *setup);
    bool culled = is_culled(stage.draw, stage.settings.cull, front);  // cull
    watch.notify(&Observer::facing_tested, *setup, front, culled);
    watch.count_faced(culled);
    if (culled) continue;
    if (!visible) visible = triangle_attributes(stage, triangle, front);
    if (stage.settings.wireframe) break;
    ReadyTriangle ready{*setup, {}, number, std::uint32_t(i)};
    for (std::size_t k = 0; k < 3; ++k) {
      const ClipVertex& vertex = polygon.vertices[piece[std::size_t(setup->order[k])]];
      ready.vertices[k] = attributes_at(*visible, vertex.weights);
    }
    triangles.push_back(ready);
  }
  if (stage.settings.wireframe && visible) {
    prepare_edges(stage, watch, corners, *visible, number, lines);
  }
  watch.notify(&Observer::triangle_finished, triangle);
}

// Takes a fragment from the depth test to the pixel, or with several samples to the samples that it
// covers.
template <class Watch>
FragmentResult draw_fragment(const FragmentStage& stage, const Watch& watch, const Surface& surface,
                             CoveredFragment& fragment) {
  test_depth(stage, watch, surface.source, fragment);  // depth test
  if (fragment.is_empty()) return FragmentResult::kHidden;
  Varyings at = interpolate(surface.vertices, fragment.place.weights);  // interpolate
  watch.notify(&Observer::attributes_interpolated, fragment.place, at);
  const StagedFragment<Watch> of{{}, stage, watch, surface, at, fragment.place};
  const auto [own, alpha] = surface_color(of);  // texture
  Rgba base{own[0], own[1], own[2], alpha};
  watch.notify(&Observer::textured, at, base);
  if (is_discarded(*stage.draw.material, base)) return FragmentResult::kDiscarded;
  const bool blended = is_blended(stage);
  if (shows_color(stage, fragment)) {
    write_color(stage, watch, fragment, fragment_color(of, base), !blended);  // light, blend, write
  }
  if (fragment.centre) write_planes(stage, fragment, surface.id, !blended);
  return blended ? FragmentResult::kBlended : FragmentResult::kWritten;
}

template <class Watch>
void finish_fragment(const FragmentStage& stage, const Watch& watch, const Surface& surface,
                     CoveredFragment& fragment) {
  const FragmentResult result = draw_fragment(stage, watch, surface, fragment);
  watch.count_finished(result);
  watch.notify(&Observer::fragment_finished, surface.source, fragment.place, result);
}

template <class Watch>
void rasterise_surface(const FragmentStage& stage, const Watch& watch, const TriangleSetup& setup,
                       const Surface& surface) {
  for_each_fragment(stage, watch, setup, surface, [&](CoveredFragment& fragment) {  // cover
    finish_fragment(stage, watch, surface, fragment);
  });
}

template <class Watch>
void rasterise(const FragmentStage& stage, const Watch& watch, const ReadyTriangle& triangle) {
  watch.notify(&Observer::piece_ready, triangle);
  rasterise_surface(stage, watch, triangle.setup, surface_of(stage, triangle));
}

}  // namespace glassbox
