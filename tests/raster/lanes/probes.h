// The functions that the kernels are built of, compiled for each instruction set and callable with
// plain arrays.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <glassbox/mesh/scene.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/lanes/target.h>
#include <glassbox/raster/shading.h>
#include <glassbox/raster/texture.h>
#include <glassbox/raster/transfer.h>

namespace glassbox::test {

// Outputs have as many entries as the inputs.
struct LaneProbes {
  void (*snap)(std::span<const float> pixels, std::int32_t* subpixels);
  void (*encode)(Transfer transfer, std::span<const float> linear, std::int32_t* bytes);
  void (*decode)(Transfer transfer, std::span<const std::int32_t> bytes, float* linear);
  void (*depth_code)(DepthFormat format, std::span<const float> depths, std::int32_t* codes);
  // `levels` has a level of detail for each coordinate.
  void (*sample)(const MipChain& texture, const Sampler& sampler, std::span<const TexCoord> at,
                 std::span<const float> levels, Rgba* colors);
  // The mean of each pixel's samples; the `count` samples of a pixel are neighbours in `samples`.
  void (*mean_color)(Transfer transfer, std::span<const Rgba8> samples, std::size_t count,
                     Rgba8* means);
  void (*level_of_detail)(int width, int height, std::span<const TextureGradient> gradients,
                          float* levels);
  void (*illuminate)(const Lighting& lighting, int shininess, bool highlights,
                     std::span<const std::array<float, 3>> positions,
                     std::span<const std::array<float, 3>> normals, Reflection* reflections);
};

// `target` must be one of available_targets().
const LaneProbes& lane_probes(Target target);

}  // namespace glassbox::test
