// The heat map of a comparison as a picture file.
#pragma once

#include <cstdint>
#include <string>

#include <glassbox/base/error.h>
#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/images/image.h>

namespace glassbox {

enum class HeatMapKind : std::uint8_t {
  kSteps,  // the largest difference of a channel
  kFlip,   // the error that FLIP computes
};

// Returns the levels of compare/pixels/heat_map.h, one per pixel. An error if
// the pictures cannot be compared pixel by pixel.
Result<Image<std::uint8_t>> heat_levels(const Comparison& comparison,
                                        HeatMapKind of = HeatMapKind::kSteps);

// Computes the levels and writes them as a picture, .png (with a palette) or .ppm.
Result<void> write_heat_map(const std::string& path, const Comparison& comparison,
                            HeatMapKind of = HeatMapKind::kSteps);

}  // namespace glassbox
