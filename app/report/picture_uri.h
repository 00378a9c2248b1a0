// A picture in a page.
#pragma once

#include <string>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::app {

// data:image/png;base64,..., of which a browser shows the very bytes.
Result<std::string> picture_uri(const Image<Rgba8>& image);

}  // namespace glassbox::app
