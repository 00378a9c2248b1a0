// Decides whether each eye sees its own picture or the other eye's (C-78).
#pragma once

#include <cstdint>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stereo/anaglyph.h>

namespace glassbox {

enum class EyeOrder { kInOrder, kSwapped, kUnknown };

// Counts of windows of 7x7 pixels that have some texture and whose pixels are displaced by a
// disparity of at least one pixel.
struct OrderEvidence {
  EyeOrder order = EyeOrder::kUnknown;
  std::uint64_t windows = 0;   // the number of windows that were compared
  std::uint64_t in_order = 0;  // windows that match better at the place given by the disparity
  std::uint64_t swapped = 0;   // windows that match better with the eyes exchanged
  double in_order_fit = 0;     // mean correlation of all windows, 1 for the same pattern
  double swapped_fit = 0;
};

// `disparity` is ground truth for the left eye's pixels, in px, right minus left: a point seen at x
// by the left eye is seen at x + disparity by the right eye. Near objects have smaller (negative)
// disparities. NaN and infinity are ignored.
//
// A window is compared, by normalised correlation of luma, with the window that it would match if
// the eyes are in order, and with the window that it would match if they are exchanged. If one
// correlation is better by more than 0.1, the window votes for that order. The result is known if
// one order has two thirds of at least 32 votes: chance gives half. Without texture or parallax it
// is unknown.
Result<OrderEvidence> pair_order(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                 const Image<float>& disparity);

// The same decision for the channels of an anaglyph: swapped means that the left lens's channels
// have the right eye's picture. A point that is bright in one eye may be dark in the other, so the
// sign of the correlation is ignored.
Result<OrderEvidence> anaglyph_order(const Image<Rgba8>& anaglyph, Glasses glasses,
                                     const Image<float>& disparity);

}  // namespace glassbox
