#include <glassbox/render/staged/sampled_fragments.h>

#include <array>
#include <bit>
#include <cmath>

#include <glassbox/raster/blend.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/samples.h>
#include <glassbox/render/staged/fragment_color.h>
#include <glassbox/render/staged/fragment_planes.h>

namespace glassbox {

namespace {

// A triangle on its way to the samples.
struct SampledTriangle {
  const TriangleSetup& setup;
  const SampleSteps steps;
  const Surface surface;
  const FragmentSource source;
  const std::uint32_t id;
  const bool has_centres;  // it writes to the planes of pixel centres, too
};

// One pixel of it.
struct SampledFragment {
  Fragment shaded;  // where it is shaded; at the centre, if that is covered
  bool centre = false;
  std::uint32_t centre_code = 0;
  std::uint32_t samples = 0;  // bit s: sample s
  std::array<std::uint32_t, kMostSamples> codes{};

  bool is_empty() const { return !centre && samples == 0; }
};

template <class Visit>
void for_each_bit(std::uint32_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(std::size_t(std::countr_zero(bits)));
}

SampledFragment fragment_of(const FragmentStage& stage, const SampledTriangle& triangle,
                            const SampledPixel& pixel) {
  const DepthFormat format = stage.settings.depth;
  SampledFragment fragment;
  const Coverage place = shading_place(pixel, triangle.steps);
  fragment.shaded = interpolate(triangle.setup, place);
  if (stage.observer != nullptr) {
    stage.observer->interpolated(triangle.source, place, fragment.shaded);
  }
  fragment.centre = pixel.covers_centre && triangle.has_centres;
  if (fragment.centre) fragment.centre_code = depth_code(format, fragment.shaded.depth);
  fragment.samples = pixel.samples;
  for_each_bit(pixel.samples, [&](std::size_t s) {
    const Coverage at = triangle.steps.at(pixel.centre, int(s));
    fragment.codes[s] = depth_code(format, interpolate_depth(triangle.setup, at));
  });
  return fragment;
}

// What of the fragment is in front of what is there.
void test_depth(const FragmentStage& stage, const SampledTriangle& triangle,
                SampledFragment& fragment) {
  const auto passes = [&](std::uint32_t code, std::uint32_t stored) {
    bool nearer = in_front(code, stored);
    if (stage.observer != nullptr) {
      stage.observer->compared(triangle.source, fragment.shaded, code, stored, nearer);
    }
    return nearer;
  };
  const int x = fragment.shaded.x, y = fragment.shaded.y;
  if (fragment.centre) {
    fragment.centre = passes(fragment.centre_code, stage.target.depth.at(x, y));
  }
  const std::span<const std::uint32_t> stored = stage.samples->depths(x, y);
  for_each_bit(fragment.samples, [&](std::size_t s) {
    if (!passes(fragment.codes[s], stored[s])) fragment.samples &= ~(1u << s);
  });
}

void write_samples(const FragmentStage& stage, const SampledFragment& fragment,
                   const FragmentColor& color, bool writes_depth) {
  const int x = fragment.shaded.x, y = fragment.shaded.y;
  const std::span<Rgba8> colors = stage.samples->colors(x, y);
  const std::span<std::uint32_t> depths = stage.samples->depths(x, y);
  for_each_bit(fragment.samples, [&](std::size_t s) {
    const Rgba8 before = colors[s];
    Rgba8 after = encoded(stage, color, before);
    if (stage.observer != nullptr) stage.observer->encoded(fragment.shaded, before, after);
    write_masked(stage.settings.mask, after, colors[s]);
    if (writes_depth) depths[s] = fragment.codes[s];
  });
}

Fate process(const FragmentStage& stage, const SampledTriangle& triangle,
             SampledFragment& fragment) {
  ++stage.statistics.covered;
  test_depth(stage, triangle, fragment);
  if (fragment.is_empty()) {
    ++stage.statistics.depth_failed;
    return Fate::kHidden;
  }
  const Varyings at = interpolate(triangle.surface.vertices, fragment.shaded.weights);
  Rgba base = surface_color(stage, triangle.surface, at, fragment.shaded);
  if (stage.observer != nullptr) stage.observer->textured(at, base);
  if (is_discarded(*stage.draw.material, base)) {
    ++stage.statistics.discarded;
    return Fate::kDiscarded;
  }
  const bool blended = is_blended(stage);
  if (blended) ++stage.statistics.blended;
  ++stage.statistics.written;
  if (fragment.samples != 0) {
    const FragmentColor color = fragment_color(stage, triangle.surface, at, fragment.shaded, base);
    write_samples(stage, fragment, color, !blended);
  }
  if (fragment.centre) {
    write_planes(stage, fragment.shaded, fragment.centre_code, triangle.id, !blended);
  }
  return blended ? Fate::kBlended : Fate::kWritten;
}

void rasterise(const FragmentStage& stage, const SampledTriangle& triangle) {
  for_each_sampled(triangle.setup, triangle.steps, stage.window, [&](const SampledPixel& pixel) {
    if (pixel.samples == 0 && !triangle.has_centres) return;
    SampledFragment fragment = fragment_of(stage, triangle, pixel);
    const Fate fate = process(stage, triangle, fragment);
    if (stage.observer != nullptr) {
      stage.observer->ended(triangle.source, fragment.shaded, fate);
    }
  });
}

SampleSteps steps_of(const FragmentStage& stage, const TriangleSetup& setup) {
  return {setup, sample_offsets(stage.samples->count())};
}

// ---- lines and points ----

ScreenVertex moved(const ScreenVertex& vertex, double x, double y) {
  ScreenVertex at = vertex;
  at.position.x = float(double(at.position.x) + x);
  at.position.y = float(double(at.position.y) + y);
  return at;
}

// A quadrilateral, whose corners run around it, as two triangles that share a diagonal.
void rasterise_quad(const FragmentStage& stage, const std::array<ScreenVertex, 4>& corners,
                    const std::array<const Varyings*, 4>& varyings) {
  for (const std::array<std::size_t, 3>& half :
       {std::array<std::size_t, 3>{0, 1, 2}, std::array<std::size_t, 3>{0, 2, 3}}) {
    const auto setup = setup_triangle({corners[half[0]], corners[half[1]], corners[half[2]]});
    if (!setup) continue;
    Surface surface;
    for (std::size_t k = 0; k < 3; ++k) {
      surface.vertices[k] = *varyings[half[std::size_t(setup->order[k])]];
    }
    rasterise(stage, {*setup, steps_of(stage, *setup), surface, kLineOrPoint, 0, false});
  }
}

}  // namespace

void rasterise_samples(const FragmentStage& stage, const ReadyTriangle& triangle) {
  rasterise(stage, {triangle.setup,
                    steps_of(stage, triangle.setup),
                    surface_of(stage, triangle),
                    {triangle.number, triangle.piece, true},
                    triangle.number + 1,
                    true});
}

// Both halves of the rectangle have the ends' depth and 1/w at the ends, so that nothing changes across the line.
void rasterise_samples(const FragmentStage& stage, const ReadyLine& line) {
  const auto& [a, b] = line.ends;
  const double dx = double(b.position.x) - double(a.position.x);
  const double dy = double(b.position.y) - double(a.position.y);
  const double length = std::sqrt(dx * dx + dy * dy);
  if (length == 0) return;
  const double x = -dy / length / 2, y = dx / length / 2;  // half a pixel across
  const Varyings &at_a = line.vertices[0], &at_b = line.vertices[1];
  rasterise_quad(stage, {moved(a, x, y), moved(a, -x, -y), moved(b, -x, -y), moved(b, x, y)},
                 {&at_a, &at_a, &at_b, &at_b});
}

void rasterise_samples(const FragmentStage& stage, const ReadyPoint& point) {
  const ScreenVertex& p = point.position;
  const Varyings& at = point.vertex;
  rasterise_quad(
      stage, {moved(p, -0.5, -0.5), moved(p, 0.5, -0.5), moved(p, 0.5, 0.5), moved(p, -0.5, 0.5)},
      {&at, &at, &at, &at});
}

}  // namespace glassbox
