// The report of `glassbox info` on a layered depth image.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <glassbox/base/error.h>

namespace glassbox::app {

// Whether the file begins like a layered depth image; false if it cannot be read.
bool is_layer_file(const std::string& file);

struct LayersInfo {
  std::string text;
  nlohmann::ordered_json json;
};
Result<LayersInfo> layers_info(const std::string& file);

}  // namespace glassbox::app
