// The fragments of a triangle, and which of them are in front: at pixel centres, or at several
// samples per pixel. Depth is tested and stored for each sample; light is computed once for each
// pixel and triangle.
#pragma once

#include <array>
#include <bit>
#include <vector>

#include <glassbox/raster/coverage.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/samples.h>
#include <glassbox/render/staged/fragment_color.h>
#include <glassbox/render/staged/primitives.h>

namespace glassbox {

// The part of one pixel that a triangle covers.
struct CoveredFragment {
  Fragment place;  // where it is shaded: at the centre, if that is covered
  bool centre = false;
  std::uint32_t centre_code = 0;
  std::uint32_t samples = 0;                     // bit s: sample s is covered
  std::array<std::uint32_t, kMaxSamples> codes;  // the depth codes of the covered samples

  bool is_empty() const { return !centre && samples == 0; }
};

template <class Visit>
void for_each_bit(std::uint32_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(std::size_t(std::countr_zero(bits)));
}

template <class Watch>
void interpolate_at(const Coverage& coverage, const FragmentStage& stage, const Watch& watch,
                    const TriangleSetup& setup, const Surface& surface, CoveredFragment& fragment) {
  fragment.place = interpolate(setup, coverage);
  watch.notify(&Observer::interpolated, surface.source, coverage, fragment.place);
  fragment.centre_code = depth_code(stage.settings.depth, fragment.place.depth);
}

// Calls visit for each fragment at a pixel centre.
template <class Watch, class Visit>
void for_each_centre(const FragmentStage& stage, const Watch& watch, const TriangleSetup& setup,
                     const Surface& surface, const Visit& visit) {
  const auto at_centre = [&](const Coverage& pixel) {
    CoveredFragment fragment;
    fragment.centre = true;
    interpolate_at(pixel, stage, watch, setup, surface, fragment);
    visit(fragment);
  };
  if (const std::vector<Coverage>* given = watch.covered(surface.source)) {
    for (const Coverage& pixel : *given) at_centre(pixel);
  } else {
    for_each_covered(setup, stage.window, at_centre);
  }
}

// Calls visit for each fragment of a picture with several samples per pixel: it has the covered
// samples, and also the pixel's centre if the surface writes to the images of the framebuffer that
// store values of centres (depth, distance, id).
template <class Watch, class Visit>
void for_each_sampled_pixel(const FragmentStage& stage, const Watch& watch,
                            const TriangleSetup& setup, const Surface& surface,
                            const Visit& visit) {
  const SampleSteps steps(setup, sample_offsets(stage.samples->count()));
  for_each_sampled(setup, steps, stage.window, [&](const SampledPixel& pixel) {
    if (pixel.samples == 0 && !surface.has_centres) return;
    CoveredFragment fragment;
    interpolate_at(shading_point(pixel, steps), stage, watch, setup, surface, fragment);
    fragment.centre = pixel.covers_centre && surface.has_centres;
    fragment.samples = pixel.samples;
    for_each_bit(pixel.samples, [&](std::size_t s) {
      const float depth = interpolate_depth(setup, steps.at(pixel.centre, int(s)));
      fragment.codes[s] = depth_code(stage.settings.depth, depth);
    });
    visit(fragment);
  });
}

template <class Watch, class Visit>
void for_each_fragment(const FragmentStage& stage, const Watch& watch, const TriangleSetup& setup,
                       const Surface& surface, const Visit& visit) {
  if (stage.samples == nullptr) {
    for_each_centre(stage, watch, setup, surface, visit);
  } else {
    for_each_sampled_pixel(stage, watch, setup, surface, visit);
  }
}

// Whether the fragment is discarded because it is not behind the given depth
// (EyePicture::behind_depth), although nothing nearer was drawn. (No fragment is behind
// kEmptyDepth, the largest code.)
inline bool is_hidden(const FragmentStage& stage, const Fragment& place, std::uint32_t code) {
  return stage.behind_depth != nullptr && code <= stage.behind_depth->at(place.x, place.y);
}

// Removes from the fragment its centre or samples where it is not in front of the stored depth.
template <class Watch>
void test_depth(const FragmentStage& stage, const Watch& watch, const FragmentSource& source,
                CoveredFragment& fragment) {
  const auto passes = [&](std::uint32_t code, std::uint32_t stored) {
    bool nearer = in_front(code, stored) && !is_hidden(stage, fragment.place, code);
    watch.notify(&Observer::compared, source, fragment.place, code, stored, nearer);
    return nearer;
  };
  const int x = fragment.place.x, y = fragment.place.y;
  if (fragment.centre) {
    fragment.centre = passes(fragment.centre_code, stage.target.depth.at(x, y));
  }
  if (fragment.samples == 0) return;
  const std::span<const std::uint32_t> stored = stage.samples->depths(x, y);
  for_each_bit(fragment.samples, [&](std::size_t s) {
    if (!passes(fragment.codes[s], stored[s])) fragment.samples &= ~(1u << s);
  });
}

}  // namespace glassbox
