#include "views/commands/opaque_picture.h"

#include <algorithm>

#include <glassbox/images/read.h>

namespace glassbox::views {

Result<Image<Rgba8>> read_opaque(const std::string& path) {
  auto image = read_image(path);
  if (!image) return image;
  if (std::ranges::any_of(image->pixels, [](const Rgba8& pixel) { return pixel.a != 255; })) {
    return tl::unexpected(Error{path, "", "has transparent pixels, whose colours are undefined",
                                "put it over a background first"});
  }
  return image;
}

}  // namespace glassbox::views
