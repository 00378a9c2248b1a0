// Both eyes' pictures in one image: side by side, one above the other, or row by row.
#pragma once

#include <span>
#include <string_view>

#include <glassbox/images/stereo/check_eyes.h>
#include <glassbox/images/stereo/named_choice.h>

namespace glassbox {

// - kPair: 2W x H, the left eye's picture on the left: for parallel viewing, and for screens that
//   take pairs.
// - kOverUnder: W x 2H, the left eye's picture above.
// - kCrossEyed: 2W x H, the right eye's picture on the left: viewed by crossing the eyes.
// - kInterlaced: W x H: rows 0, 2, 4 ... (from the top) of the left eye's picture, rows 1, 3, 5 ...
//   of the right eye's. With an odd height the left eye has one row more. Half of the rows of each
//   picture are not shown.
enum class StereoLayout { kPair, kOverUnder, kCrossEyed, kInterlaced };

std::span<const NamedChoice<StereoLayout>> all_stereo_layouts();
std::string_view name_of(StereoLayout layout);

// Makes the image of both pictures; pixels are copied with their alpha. Refuses eyes of different
// sizes, and sizes for which twice the size is too large for an int.
Result<Image<Rgba8>> make_stereo_layout(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                        StereoLayout layout);

}  // namespace glassbox
