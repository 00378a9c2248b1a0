// Reads hostile image files: all that have 8 or 16 bits with decode_image; PBM, PGM, PPM, PAM and
// PFM with their own readers, too.
#include <cstddef>
#include <cstdint>
#include <span>

#include <glassbox/images/decode.h>
#include <glassbox/images/read.h>

#include "tests/fuzz/promises.h"

namespace {

using glassbox::fuzz::require;

constexpr glassbox::DecodeLimits kLimits{.max_pixels = 1 << 16, .max_side = 4096};

template <class Pixel>
void check(const glassbox::Result<glassbox::Image<Pixel>>& image) {
  if (!image) {
    glassbox::fuzz::check_error(image.error());
    return;
  }
  const auto pixels = std::uint64_t(image->width) * std::uint64_t(image->height);
  require(image->width >= 1 && image->height >= 1, "a size above zero");
  require(pixels <= kLimits.max_pixels, "pixels within the limit");
  require(image->pixels.size() == pixels, "as many pixels as the size says");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  check(glassbox::decode_image(bytes, kLimits));
  check(glassbox::decode_pnm(bytes, kLimits));
  check(glassbox::decode_pfm(bytes, kLimits));
  check(glassbox::decode_pfm_rgb(bytes, kLimits));
  return 0;
}
