// Finds what only one of the two eyes sees (C-73).
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox {

// Whether the other eye sees the point that a pixel shows.
enum class OtherEyeVisibility : std::uint8_t {
  kNothingDrawn,  // there is no point
  kVisible,
  kOutsidePicture,  // the point is outside the other eye's picture
  kHidden,          // something nearer is in front of it
  kMissing,         // the other picture shows something farther there, or nothing
};

// One map for the left eye's pixels and one for the right eye's.
struct MonocularMaps {
  Image<OtherEyeVisibility> left, right;
};

// Finds for each pixel of both eyes whether the other eye sees its point.
//
// The disparity of a pixel (disparity.h) gives the place of its point in the other picture. It is
// compared with the other picture's own disparity at the pixel nearest to that place. Differences
// up to half a pixel count as equal: the pixel's centre is up to half a pixel away from the place,
// and disparity changes by less than one pixel per pixel on a surface that the other eye sees at
// least half as wide. So a step in depth that hides less than half a column of pixels is not found.
// A point is kMissing only if the two neighbouring pixels do not show it either, because at
// outlines the pixel centres of the two eyes see different points. The points that remain are on
// surfaces that face away from the other eye, and on things thinner than a pixel.
//
// Both maps have the same size.
MonocularMaps monocular_maps(const Image<float>& left_disparity,
                             const Image<float>& right_disparity);

struct MonocularCounts {
  std::uint64_t beside = 0, hidden = 0, missing = 0;
  std::uint64_t all() const { return beside + hidden + missing; }
};
MonocularCounts count_monocular(const Image<OtherEyeVisibility>& map);

}  // namespace glassbox
