// Pixels to image files: PNG for 8 and 16 bits a channel, PPM for 8, PFM for floats.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// A keyword (1 to 79 printable ASCII characters) and a UTF-8 text, kept with the picture.
using TextEntry = std::pair<std::string, std::string>;

// PNG, 8 bits a channel: RGB where every alpha is 255, else RGBA. The same pixels and text always give the same bytes
// with one version of zlib.
Result<std::vector<std::byte>> encode_png(const Image<Rgba8>& image,
                                          std::span<const TextEntry> text = {});

// PNG of the samples as they are, 8 or 16 bits, grey to RGBA. Floats are an error: encode_pfm writes them.
Result<std::vector<std::byte>> encode_png(const StoredImage& image,
                                          std::span<const TextEntry> text = {});

// Binary PPM (P6). It has no alpha: the colours are written as they are.
std::vector<std::byte> encode_ppm(const Image<Rgba8>& image);

// PFM: 32-bit little-endian floats ("-1.0"), one channel ("Pf") or three ("PF"), rows bottom-up as the format says.
std::vector<std::byte> encode_pfm(const Image<float>& image);
std::vector<std::byte> encode_pfm(const Image<Rgb32f>& image);
// An error unless the samples are floats of one channel or three.
Result<std::vector<std::byte>> encode_pfm(const StoredImage& image);

// Encodes as the extension of `path` says (.png, .ppm) and writes the file, wholly or not at all. PPM has no room for
// `text`.
Result<void> write_image(const std::string& path, const Image<Rgba8>& image,
                         std::span<const TextEntry> text = {});

// Whether write_image knows the extension: worth asking before a long run.
Result<void> check_image_path(const std::string& path);

}  // namespace glassbox
