// Layered depth images in files (.ldi), which `glassbox views layers` writes and reads.
//
//   "glassbox-layers 1\n"
//   u32 width, height
//   u32 lens (0 perspective, 1 orthographic, 2 frustum)
//   f64[6] the lens's numbers, in the order of Scene's lenses; absent ones are infinite or 0
//   f64[16] world_from_eye, row by row
//   u8[4] background
//   u32 samples
//   u32[width * height + 1] offsets; f32[samples] depths; u8[4][samples] colours
//                                                    as in layered_image.h
//   "norm" i8[4][samples] normals and a 0            if there are any
//   "tris" u32[samples] triangles                    if there are any
//
// All numbers are little-endian.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

#include "views/layers/layered_image.h"

namespace glassbox::views {

struct StoredLayers {
  Camera camera;
  Rgba8 background;
  LayeredImage image;
};

// The layers, with the camera of a view of width x height pixels, from which the image's own
// LayerCamera is computed.
std::vector<std::byte> encode_layers(const StoredLayers& layers);

// An error names `source` and the byte at which the file is invalid. Memory is allocated only for
// numbers whose bytes are in the file.
Result<StoredLayers> decode_layers(std::span<const std::byte> bytes, const std::string& source);

bool is_layers(std::span<const std::byte> bytes);  // whether the bytes begin like such a file

}  // namespace glassbox::views
