// Two pictures rectified so that their epipolar lines are scan lines, and the reports about it.
#pragma once

#include <string>
#include <utility>

#include <nlohmann/json_fwd.hpp>

#include "views/two_view/rectification.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

struct RectifiedPair {
  views::Rectification rectification;
  Image<Rgba8> left, right;  // transparent outside the original picture
};

// Rectifies pictures of equal size. Errors are those of `rectification_of`.
Result<RectifiedPair> rectify(const Image<Rgba8>& left, const Image<Rgba8>& right,
                              const views::StereoRig& rig);

// The matrices that rectify the two pictures, and the parts of the pictures that were lost.
std::string rectification_text(const views::Rectification& rectification);
nlohmann::ordered_json rectification_json(const views::Rectification& rectification);

Result<void> write_rectified(const std::pair<std::string, std::string>& names,
                             const RectifiedPair& pair);

}  // namespace glassbox::views
