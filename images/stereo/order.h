// Whether each eye has its own picture (C-78).
#pragma once

#include <cstdint>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stereo/anaglyph.h>

namespace glassbox {

enum class EyeOrder { kInOrder, kSwapped, kUnknown };

// Of windows of 7x7 pixels with some texture, whose pixels the disparity displaces by at least one.
struct OrderEvidence {
  EyeOrder order = EyeOrder::kUnknown;
  std::uint64_t windows = 0;   // compared
  std::uint64_t in_order = 0;  // that fit better where the disparity puts them
  std::uint64_t swapped = 0;   // that fit better with the eyes interchanged
  double in_order_fit = 0;     // mean correlation of all windows, 1 for the same pattern
  double swapped_fit = 0;
};

// `disparity` is ground truth on the left eye's pixels, in px, right minus left, so that a point seen at x by the left
// eye is seen at x + disparity by the right one: near objects further left (negative). NaN and infinity are left out.
//
// Each window is compared with the one it would match if the eyes are in order, and with the one it would match if they
// are interchanged, by normalised correlation of luma; where one is better by 0.1, it votes. Known is the order for
// which there are at least 32 votes and two in three: chance gives half. Without texture or parallax it is unknown.
Result<OrderEvidence> pair_order(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                 const Image<float>& disparity);

// The same for the channels of an anaglyph: swapped where the left lens's channels have the right eye's picture. What is
// bright in one eye may be dark in the other, so the correlation's sign does not count.
Result<OrderEvidence> anaglyph_order(const Image<Rgba8>& anaglyph, Glasses glasses,
                                     const Image<float>& disparity);

}  // namespace glassbox
