// Two pictures turned until their epipolar lines are scan lines: what `glassbox views` says of it.
#pragma once

#include <string>
#include <utility>

#include <nlohmann/json_fwd.hpp>

#include "views/two_view/rectification.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::app {

struct RectifiedPair {
  views::Rectification how;
  Image<Rgba8> left, right;  // transparent where they show nothing
};

// Pictures of one size. Refused where `rectification_of` refuses.
Result<RectifiedPair> rectify(const Image<Rgba8>& left, const Image<Rgba8>& right,
                              const views::StereoRig& rig);

// Both matrices, and what was lost.
std::string rectification_text(const views::Rectification& how);
nlohmann::ordered_json rectification_json(const views::Rectification& how);

Result<void> write_rectified(const std::pair<std::string, std::string>& names,
                             const RectifiedPair& pair);

}  // namespace glassbox::app
