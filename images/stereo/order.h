// Decides whether each eye has its own picture (C-78).
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
  std::uint64_t windows = 0;   // compared
  std::uint64_t in_order = 0;  // windows that match better at the place given by the disparity
  std::uint64_t swapped = 0;   // windows that match better with the eyes exchanged
  double in_order_fit = 0;     // mean correlation of all windows, 1 for the same pattern
  double swapped_fit = 0;
};

// `disparity` is ground truth on the left eye's pixels, in px, right minus left, so that a point
// seen at x by the left eye is seen at x + disparity by the right one: near objects further left
// (negative). NaN and infinity are ignored.
//
// Each window is compared with the one that it would match if the eyes are in order, and with the
// one that it would match if they are exchanged, by normalised correlation of luma. If one
// correlation is better by 0.1, the window votes for it. The order is known if it has at least 32
// votes and two thirds of all votes: chance gives half. Without texture or parallax it is unknown.
Result<OrderEvidence> pair_order(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                 const Image<float>& disparity);

// The same for the channels of an anaglyph: swapped means that the left lens's channels have the
// right eye's picture. A point that is bright in one eye may be dark in the other, so the sign of
// the correlation does not count.
Result<OrderEvidence> anaglyph_order(const Image<Rgba8>& anaglyph, Glasses glasses,
                                     const Image<float>& disparity);

}  // namespace glassbox
