// Reads OpenEXR files for stored_image.h and stored_file.h.
#pragma once

#include <cstddef>
#include <span>

#include <glassbox/images/decode.h>
#include <glassbox/images/stored_file.h>

namespace glassbox {

// Reads the pixels of the data window. The picture is made of the channels R, G and B, or else of
// Y, with A if there is one, or else of the only channel. A half becomes the float of the same
// value, and a NaN keeps its payload.
Result<StoredImage> decode_exr_stored(std::span<const std::byte> bytes, const DecodeLimits& limits);

// As decode_exr_stored. StoredFile::rest has the samples of all further channels, and where the
// data window lies if it is not the display window.
Result<StoredFile> decode_exr_file(std::span<const std::byte> bytes, const DecodeLimits& limits);

Result<StoredHeader> stored_header_of_exr(std::span<const std::byte> bytes,
                                          const DecodeLimits& limits);

}  // namespace glassbox
