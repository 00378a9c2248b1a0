// The rule of moved_edge.h for one pixel at a time, as a second opinion.
#pragma once

#include <glassbox/compare/pixels/differences.h>

namespace glassbox::test {

// Whether the rule calls the pixel a moved edge. `Value` is the type of the values and of the
// sums over the 7 x 7 pixels: float gives the library's verdicts for 8 and 16 bits
// exactly, and double those for floats.
template <class Value>
bool is_moved_edge_plainly(const PicturePair& pair, PixelPosition pixel);

extern template bool is_moved_edge_plainly<float>(const PicturePair&, PixelPosition);
extern template bool is_moved_edge_plainly<double>(const PicturePair&, PixelPosition);

}  // namespace glassbox::test
