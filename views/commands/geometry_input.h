// The input for the geometry of two views: the matches, and what is known about the pictures and
// the cameras.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "views/two_view/camera.h"
#include "views/two_view/match.h"

#include <glassbox/images/image.h>

namespace glassbox::views {

// For the left picture's pixels: how many points are seen in the right picture, or why they are not
// (S2-03).
struct PixelFates {
  std::uint64_t seen = 0, hidden = 0, beside = 0, missing = 0, nothing = 0;
};

struct GeometryInput {
  std::string about;       // "room, 640 x 480", "matches.csv"
  std::string made_how;    // one line on how pair and matches were made; empty for files
  views::Matches matches;  // positions in pixels from the pictures' top left corners
  std::optional<std::array<views::Matrix3d, 2>> intrinsics;  // left, right
  std::optional<views::RelativePose> truth;                  // |T| in world units
  std::vector<bool> is_outlier;  // for each match, if it is known; else empty
  std::optional<PixelFates> fates;
  std::optional<std::array<Image<Rgba8>, 2>> pictures;
  std::array<std::string, 2> picture_names{"left", "right"};
};

}  // namespace glassbox::views
