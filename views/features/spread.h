// Chooses corners that are strong and spread over the whole picture.
#pragma once

#include <vector>

#include "views/features/corners.h"

namespace glassbox::views {

// A corner's radius is the distance to the nearest corner that is clearly stronger: kClearlyWeaker
// times the other's strength is still above its own. Returns the `count` corners of largest radius,
// the strongest first; all corners if there are fewer. (Adaptive non-maximal suppression: Brown,
// Szeliski and Winder, Multi-image matching using multi-scale oriented patches, CVPR 2005, section
// 3.)
//
// Radii above R = 2 sqrt(width height/(pi count)) count as R: about `count` corners can be R apart
// from each other, because circles of half that radius around them do not overlap. If radii are
// equal, the stronger corner counts.
inline constexpr double kClearlyWeaker = 0.9;
std::vector<PictureCorner> spread_out(std::vector<PictureCorner> corners, int count, int width,
                                      int height);

}  // namespace glassbox::views
