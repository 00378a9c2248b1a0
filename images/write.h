// Writes pixels to image files: PNG for 8 and 16 bits a channel, PPM for 8, PFM for floats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// The functions that encode throw std::bad_alloc where there is not enough memory.

// A keyword (1 to 79 printable ASCII characters) and a UTF-8 text, stored with the picture.
using TextEntry = std::pair<std::string, std::string>;

// Encodes PNG, 8 bits a channel: RGB where every alpha is 255, otherwise RGBA. With one version of
// zlib, the same pixels and text always give the same bytes.
Result<std::vector<std::byte>> encode_png(const Image<Rgba8>& image,
                                          std::span<const TextEntry> text = {});

// Encodes PNG with the samples as they are, 8 or 16 bits, grey to RGBA. Floats are an error: use
// encode_pfm.
Result<std::vector<std::byte>> encode_png(const StoredImage& image,
                                          std::span<const TextEntry> text = {});

// Encodes PNG with a palette of up to 256 colours: each pixel is the index of its colour. Alpha is
// not written. An error if an index has no colour.
Result<std::vector<std::byte>> encode_png(const Image<std::uint8_t>& indices,
                                          std::span<const Rgba8> palette);

// Encodes binary PPM (P6). It has no alpha: the colours are written as they are.
std::vector<std::byte> encode_ppm(const Image<Rgba8>& image);

// Encodes PFM: 32-bit little-endian floats ("-1.0"), one channel ("Pf") or three ("PF"), rows
// bottom-up as the format requires.
std::vector<std::byte> encode_pfm(const Image<float>& image);
std::vector<std::byte> encode_pfm(const Image<Rgb32f>& image);
// Refuses samples that are not floats of one or three channels.
Result<std::vector<std::byte>> encode_pfm(const StoredImage& image);

// Encodes in the format of the extension of `path` (.png, .ppm) and writes the file, completely or
// not at all. PPM cannot store `text`.
Result<void> write_image(const std::string& path, const Image<Rgba8>& image,
                         std::span<const TextEntry> text = {});

// The same for indices of a palette; PPM has the colours themselves.
Result<void> write_image(const std::string& path, const Image<std::uint8_t>& indices,
                         std::span<const Rgba8> palette);

// Returns an error unless write_image supports the extension: useful to check before a long run.
Result<void> check_image_path(const std::string& path);

}  // namespace glassbox
