// Exact samples in a page: rows as differences from the row above, compressed, as text.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <glassbox/base/error.h>
#include <glassbox/compare/pixels/selection.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// Bytes of a sample: 1, 2 or 4.
std::size_t sample_bytes(const StoredImage& image);

// The boxes' samples, little-endian, one box after the other. Each byte of a row but the first of its box is stored as
// its difference from the one above, modulo 256: neighbours are alike, so most become small. All of it is one zlib
// stream, in base64. The boxes lie inside of the image. page/decode.js is the way back.
Result<std::string> encode_blob(const StoredImage& image, std::span<const PixelBox> boxes);

}  // namespace glassbox
