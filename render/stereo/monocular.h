// What only one of the two eyes sees (C-73).
#pragma once

#include <cstdint>

#include <glassbox/images/image.h>

namespace glassbox {

// What the other eye has of a pixel's point.
enum class OtherEye : std::uint8_t {
  kNothingDrawn,  // there is no point
  kSeesIt,
  kBesideIt,  // the point lies beside the other eye's picture
  kHidden,    // something nearer stands before it
  kMissing,   // the other picture shows something farther there, or nothing
};

// Of the left eye's pixels and of the right eye's.
struct MonocularMaps {
  Image<OtherEye> left, right;
};

// The disparity of every pixel (disparity.h) says where the other eye has the point. There the other picture's own
// disparity, of the pixel nearest to that place, is compared. Half a pixel either way counts as the same: the pixel's
// centre is up to half a pixel away, and disparity changes by less than a pixel a pixel on a surface that the other eye
// sees at least half as wide. A step in depth that hides less than half a column is not found then. kMissing looks at
// the two pixels beside that one as well, because at outlines the eyes' pixel centres fall differently; what is left are
// surfaces that face away from the other eye, and things thinner than a pixel.
//
// Both maps are of one size.
MonocularMaps monocular_maps(const Image<float>& left_disparity,
                             const Image<float>& right_disparity);

struct MonocularCounts {
  std::uint64_t beside = 0, hidden = 0, missing = 0;
  std::uint64_t all() const { return beside + hidden + missing; }
};
MonocularCounts count(const Image<OtherEye>& map);

}  // namespace glassbox
