#include "cli/report/picture_uri.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/html/blob.h>
#include <glassbox/images/write.h>

namespace glassbox {

Result<std::string> picture_uri(const Image<Rgba8>& image) {
  return encode_png(image).map([](const std::vector<std::byte>& png) {
    const auto* first = reinterpret_cast<const std::uint8_t*>(png.data());
    return "data:image/png;base64," + base64(std::span(first, png.size()));
  });
}

}  // namespace glassbox
