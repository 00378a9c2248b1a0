// The page of glassbox views layers draw --html: it shows the layers side by side, and draws them
// from views that the reader chooses.
#pragma once

#include <string>

#include <glassbox/base/error.h>

#include "views/layers/layer_file.h"

namespace glassbox::views {

// Makes the page. `file` is the name that it shows for the layers. An error if they are too many
// for a browser.
Result<std::string> make_layers_page(const views::StoredLayers& layers, const std::string& file);

}  // namespace glassbox::views
