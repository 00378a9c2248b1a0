// The inner loops over disparities, compiled once for each instruction set. They use integers, or
// floats in one written order, so that every target gives the same bytes.
#pragma once

#include <cstdint>

#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

struct MatchKernels {
  // out[i] = weight * (number of bits in which left and right_reversed[i] differ). With growing
  // disparity the right pixels go to the left, so the right row is given in reversed order.
  void (*census_costs)(std::uint32_t left, const std::uint32_t* right_reversed, int count,
                       int weight, std::uint16_t* out);
  // out[i] = weight * |left - right_reversed[i]|
  void (*grey_costs)(std::uint8_t left, const std::uint8_t* right_reversed, int count, int weight,
                     std::uint16_t* out);

  // sums[i] = before[i] + costs[i]
  void (*running_sum)(const std::uint32_t* before, const std::uint16_t* costs, int count,
                      std::uint32_t* sums);
  // costs[i] = (after[i] - before[i]) * inverse, rounded to the nearest integer
  void (*mean)(const std::uint32_t* before, const std::uint32_t* after, float inverse, int count,
               std::uint16_t* costs);

  // One row of one direction. For each pixel: values = cost + min(before, before at a neighbouring
  // disparity + p1, least before + jump) - least before. The values are added to the sums, or, if
  // begins_sums, stored there. Values of a pixel may be read from -1 to stride.
  struct PathRow {
    int width, stride,
        cell;  // pixels; disparities of a pixel; step from the values of a pixel to the next one's
    int from;  // the pixel before pixel x is x - from
    bool leftwards;  // the row's pixels are processed from the last one on
    bool begins_sums;
    std::uint16_t p1;
    const std::uint16_t* jumps;  // [256], penalties by the change of grey
    const std::uint16_t* costs;
    const std::uint8_t *grey, *grey_before;
    const std::uint16_t *before,
        *least_before;             // of the row before, or the same one; null if there is none
    const std::uint16_t* nothing;  // zeros, used before a path's first pixel
    std::uint16_t *values, *least;
    std::uint16_t* sums;
  };
  void (*path_row)(const PathRow& row);
  // sums[i] += more[i]
  void (*add)(const std::uint16_t* more, int count, std::uint16_t* sums);
  // The least of the values; 65535 if there are none.
  std::uint16_t (*least)(const std::uint16_t* values, int count);
  // Where values[i] < best[i]: best[i] = values[i], which[i] = first_which + i.
  void (*keep_less)(const std::uint16_t* values, int count, std::uint16_t* best,
                    std::uint16_t* which, int first_which);
  // Where |values[i] - own[i]| < `near`: sums[i] += values[i] - own[i], counts[i] += 1. The
  // difference of two infinite numbers is NaN, and does not count.
  void (*add_near)(const float* own, const float* values, int count, float near, float* sums,
                   float* counts);
};

const MatchKernels& match_kernels(Target target);

}  // namespace glassbox::views
