// Pictures inside an HTML page.
#pragma once

#include <string>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox {

// The picture as data:image/png;base64,..., whose bytes a browser shows unchanged.
Result<std::string> picture_uri(const Image<Rgba8>& image);

}  // namespace glassbox
