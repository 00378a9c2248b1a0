// The exact samples of pictures in a page: rows are stored as differences from the row above,
// compressed, and encoded as text.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <glassbox/base/error.h>
#include <glassbox/compare/pixels/selection.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// The number of bytes of a sample: 1, 2 or 4.
std::size_t sample_bytes(const StoredImage& image);

// Encodes the boxes' samples, little-endian, one box after the other. In every row except the first
// of its box, each byte is stored as its difference from the byte above, modulo 256: neighbours are
// similar, so most differences are small. All boxes are one zlib stream, in base64. The boxes must
// be inside the image. page/decode.js decodes it.
Result<std::string> encode_blob(const StoredImage& image, std::span<const PixelBox> boxes);

}  // namespace glassbox
