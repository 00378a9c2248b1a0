// The inner loops over disparities, compiled once for each instruction set. All are integer work, or floats in one written order:
// every target gives the same bytes.
#pragma once

#include <cstdint>

#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

struct MatchKernels {
  // out[i] = weight * (bits in which left and right_reversed[i] differ). The right pixels of growing disparity go to the left, and so
  // the row is given from its last pixel on.
  void (*census_costs)(std::uint32_t left, const std::uint32_t* right_reversed, int count,
                       int weight, std::uint16_t* out);
  // out[i] = weight * |left - right_reversed[i]|
  void (*grey_costs)(std::uint8_t left, const std::uint8_t* right_reversed, int count, int weight,
                     std::uint16_t* out);

  // sums[i] = before[i] + costs[i]
  void (*running_sum)(const std::uint32_t* before, const std::uint16_t* costs, int count,
                      std::uint32_t* sums);
  // costs[i] = (after[i] - before[i]) * inverse, to the nearest
  void (*mean)(const std::uint32_t* before, const std::uint32_t* after, float inverse, int count,
               std::uint16_t* costs);

  // One row of one direction: of each pixel, values = cost + min(before, before of a disparity beside + p1, least before + jump) -
  // least before, which are added to the sums, or begin them. Values of a pixel may be read from -1 to stride.
  struct PathRow {
    int width, stride,
        cell;        // pixels; disparities of a pixel; from the values of a pixel to the next one's
    int from;        // the pixel before pixel x is x - from
    bool leftwards;  // the row's pixels are taken from the last one on
    bool begins_sums;
    std::uint16_t p1;
    const std::uint16_t* jumps;  // [256], by the change of grey
    const std::uint16_t* costs;
    const std::uint8_t *grey, *grey_before;
    const std::uint16_t *before,
        *least_before;             // of the row before, or the same one; null where there is none
    const std::uint16_t* nothing;  // zeros, what comes before a path's first pixel
    std::uint16_t *values, *least;
    std::uint16_t* sums;
  };
  void (*path_row)(const PathRow& row);
  // sums[i] += more[i]
  void (*add)(const std::uint16_t* more, int count, std::uint16_t* sums);
  // The least of the values; 65535 of none.
  std::uint16_t (*least)(const std::uint16_t* values, int count);
  // Where values[i] < best[i]: best[i] = values[i], which[i] = i.
  void (*keep_less)(const std::uint16_t* values, int count, std::uint16_t* best,
                    std::uint16_t* which, int first_which);
  // Where values[i] is less than `near` off own[i]: sums[i] += values[i] - own[i], counts[i] += 1. Of two infinite ones the difference is
  // no number, and does not count.
  void (*add_near)(const float* own, const float* values, int count, float near, float* sums,
                   float* counts);
};

const MatchKernels& match_kernels(Target target);

}  // namespace glassbox::views
