// The page of glassbox views layers draw --html: the layers side by side, and from wherever the reader looks at them.
#pragma once

#include <string>

#include <glassbox/base/error.h>

#include "views/layers/layer_file.h"

namespace glassbox::app {

// `file` is what the layers are called. An error where they would be too many for a browser.
Result<std::string> make_layers_page(const views::StoredLayers& layers, const std::string& file);

}  // namespace glassbox::app
