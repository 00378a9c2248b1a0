// Pictures that are compared by their colours.
#pragma once

#include <string>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

// Reads a picture. Pixels that are not opaque are an error, because their colours are undefined.
Result<Image<Rgba8>> read_opaque(const std::string& path);

}  // namespace glassbox::views
