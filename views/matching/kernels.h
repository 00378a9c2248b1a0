// The inner loops over disparities, compiled once for each instruction set. They compute with
// integers, or with floats in exactly the order of operations in the source, so that every
// instruction set gives the same results.
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

  // One row of the paths in one direction. For each pixel and disparity: value = cost + min(before,
  // before at a neighbouring disparity + p1, least before + jump) - least before, where `before`
  // are the values at the previous pixel of the path. The values are added to the sums, or, if
  // begins_sums, stored there. A pixel's values can be read from index -1 to `stride`.
  struct PathRow {
    int width, stride,
        cell;        // in pixels; disparities of a pixel; distance between two pixels' values
    int from;        // a path comes to pixel x from pixel x - from
    bool leftwards;  // the row's pixels are processed from the last one on
    bool begins_sums;
    std::uint16_t p1;
    const std::uint16_t* jumps;  // [256], penalty for a jump of disparity, by the change of grey
    const std::uint16_t* costs;
    const std::uint8_t *grey, *grey_before;
    const std::uint16_t *before,
        *least_before;             // of the row that the paths come from; null if there is none
    const std::uint16_t* nothing;  // zeros, in place of values before a path's first pixel
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
  // difference of two infinite numbers is NaN and fulfils no condition.
  void (*add_near)(const float* own, const float* values, int count, float near, float* sums,
                   float* counts);
};

const MatchKernels& match_kernels(Target target);

}  // namespace glassbox::views
