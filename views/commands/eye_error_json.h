// The error of a right eye's picture as JSON for reports.
#pragma once

#include <nlohmann/json.hpp>

#include "views/layers/second_eye_error.h"

namespace glassbox::views {

inline nlohmann::ordered_json eye_error_json(const views::EyeError& error) {
  return {{"wrong_pixels", error.wrong}, {"rms", error.rms}, {"largest", error.largest}};
}

}  // namespace glassbox::views
