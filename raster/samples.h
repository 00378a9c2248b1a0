// Defines several samples per pixel, and finds the samples that a triangle covers.
//
// The positions of the samples are Direct3D's standard patterns
// (D3D11_STANDARD_MULTISAMPLE_QUALITY_LEVELS), in 1/16 pixel. The snap's 1/256 pixel represents
// them exactly, so the test of a sample is as exact as that of a pixel's centre, and the top-left
// rule holds for each sample. Samples are within the pixel, which includes its left and top sides
// and excludes the right and bottom ones.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <glassbox/raster/stages.h>
#include <glassbox/raster/triangle_setup.h>

namespace glassbox {

inline constexpr int kMaxSamples = 16;

constexpr bool is_sample_count(int count) {
  return count == 1 || count == 2 || count == 4 || count == 8 || count == 16;
}

// The offset of a sample from the pixel's centre, in 1/256 pixel; y points down.
struct SampleOffset {
  std::int32_t x = 0, y = 0;
};

namespace samples_detail {

constexpr SampleOffset sixteenths(int x, int y) {
  return {x * (kSubpixels / 16), y * (kSubpixels / 16)};
}

inline constexpr std::array kOne{sixteenths(0, 0)};
inline constexpr std::array kTwo{sixteenths(4, 4), sixteenths(-4, -4)};
inline constexpr std::array kFour{sixteenths(-2, -6), sixteenths(6, -2), sixteenths(-6, 2),
                                  sixteenths(2, 6)};
inline constexpr std::array kEight{sixteenths(1, -3),  sixteenths(-1, 3), sixteenths(5, 1),
                                   sixteenths(-3, -5), sixteenths(-5, 5), sixteenths(-7, -1),
                                   sixteenths(3, 7),   sixteenths(7, -7)};
inline constexpr std::array kSixteen{
    sixteenths(1, 1),   sixteenths(-1, -3), sixteenths(-3, 2),  sixteenths(4, -1),
    sixteenths(-5, -2), sixteenths(2, 5),   sixteenths(5, 3),   sixteenths(3, -5),
    sixteenths(-2, 6),  sixteenths(0, -7),  sixteenths(-4, -6), sixteenths(-6, 4),
    sixteenths(-8, 0),  sixteenths(7, -4),  sixteenths(6, 7),   sixteenths(-7, -8)};

}  // namespace samples_detail

// `count` is one of 1, 2, 4, 8 and 16.
inline std::span<const SampleOffset> sample_offsets(int count) {
  assert(is_sample_count(count));
  switch (count) {
    case 2:
      return samples_detail::kTwo;
    case 4:
      return samples_detail::kFour;
    case 8:
      return samples_detail::kEight;
    case 16:
      return samples_detail::kSixteen;
    default:
      return samples_detail::kOne;
  }
}

// The differences of a triangle's edge functions between a pixel's centre and its samples.
struct SampleSteps {
  SampleSteps(const TriangleSetup& triangle, std::span<const SampleOffset> offsets)
      : count(int(offsets.size())) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t s = 0; s < offsets.size(); ++s) {
        add[s][k] = triangle.edges[k].a * offsets[s].x + triangle.edges[k].b * offsets[s].y;
        most[k] = std::max(most[k], add[s][k]);
      }
    }
  }

  // Returns the edge functions at a sample, given the edge functions at the centre.
  Coverage at(const Coverage& centre, int sample) const {
    Coverage moved = centre;
    for (std::size_t k = 0; k < 3; ++k) moved.edges[k] += add[std::size_t(sample)][k];
    return moved;
  }

  int count;
  std::array<std::array<std::int64_t, 3>, kMaxSamples> add{};
  std::array<std::int64_t, 3> most{};  // for each edge, the largest of `add` and 0
};

// A pixel whose centre or samples a triangle covers.
struct SampledPixel {
  Coverage centre;
  bool covers_centre = false;
  std::uint32_t samples = 0;  // bit s: sample s is covered
};

// Returns where the pixel is shaded: at its centre if that is covered, otherwise at the first
// covered sample. So nothing is ever extrapolated beyond the triangle (Direct3D 11.3 functional
// specification, centroid sampling).
inline Coverage shading_point(const SampledPixel& pixel, const SampleSteps& steps) {
  if (pixel.covers_centre) return pixel.centre;
  int first = 0;
  while ((pixel.samples >> first & 1u) == 0) ++first;
  return steps.at(pixel.centre, first);
}

// The pixels of which a triangle may cover samples, given the pixels whose centres it may cover.
inline PixelRect sampled_bounds(const PixelRect& bounds) {
  return {bounds.x0 - 1, bounds.y0 - 1, bounds.x1 + 1, bounds.y1 + 1};
}

// Calls visit(SampledPixel) for every pixel within `window` whose centre or a sample the triangle
// covers, row by row from the top, left to right.
template <class Visit>
void for_each_sampled(const TriangleSetup& triangle, const SampleSteps& steps,
                      const PixelRect& window, Visit&& visit) {
  const PixelRect box = intersect(sampled_bounds(triangle.bounds), window);
  const auto covers = [&](const Coverage& at) {
    return triangle.edges[0].covers(at.edges[0]) && triangle.edges[1].covers(at.edges[1]) &&
           triangle.edges[2].covers(at.edges[2]);
  };
  for (int y = box.y0; y < box.y1; ++y) {
    const std::int64_t centre_x = std::int64_t(box.x0) * kSubpixels + kPixelCentre;
    const std::int64_t centre_y = std::int64_t(y) * kSubpixels + kPixelCentre;
    SampledPixel pixel;
    pixel.centre = {box.x0, y, {}};
    for (std::size_t k = 0; k < 3; ++k) {
      pixel.centre.edges[k] = triangle.edges[k].at(centre_x, centre_y);
    }
    for (; pixel.centre.x < box.x1; ++pixel.centre.x) {
      const std::array<std::int64_t, 3>& e = pixel.centre.edges;
      if (e[0] + steps.most[0] >= 0 && e[1] + steps.most[1] >= 0 && e[2] + steps.most[2] >= 0) {
        pixel.covers_centre = covers(pixel.centre);
        pixel.samples = 0;
        for (int s = 0; s < steps.count; ++s) {
          pixel.samples |= std::uint32_t(covers(steps.at(pixel.centre, s))) << s;
        }
        if (pixel.covers_centre || pixel.samples != 0) visit(std::as_const(pixel));
      }
      for (std::size_t k = 0; k < 3; ++k) {
        pixel.centre.edges[k] += triangle.edges[k].a * kSubpixels;
      }
    }
  }
}

}  // namespace glassbox
