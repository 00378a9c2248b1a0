// Reads image files to pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/decode.h>
#include <glassbox/images/image.h>

namespace glassbox {

// Returns all bytes of a file of at most `max_bytes`.
Result<std::vector<std::byte>> read_file(const std::string& path,
                                         std::uint64_t max_bytes = std::uint64_t(1) << 30);

// Reads what decode_image reads, recognised by the content.
Result<Image<Rgba8>> read_image(const std::string& path, const DecodeLimits& limits = {},
                                Orientation orientation = Orientation::kUpright);

// Decodes PBM, PGM or PPM, binary or plain, or PAM (P1 to P7), with up to 16 bits a channel.
Result<Image<Rgba8>> decode_pnm(std::span<const std::byte> bytes, const DecodeLimits& limits = {});

// Decodes PFM of either byte order; read_pfm takes one channel, read_pfm_rgb three.
Result<Image<float>> decode_pfm(std::span<const std::byte> bytes, const DecodeLimits& limits = {});
Result<Image<Rgb32f>> decode_pfm_rgb(std::span<const std::byte> bytes,
                                     const DecodeLimits& limits = {});
Result<Image<float>> read_pfm(const std::string& path, const DecodeLimits& limits = {});
Result<Image<Rgb32f>> read_pfm_rgb(const std::string& path, const DecodeLimits& limits = {});

}  // namespace glassbox
