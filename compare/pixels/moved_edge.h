// Recognises pixels that differ only because an edge lies a part of a pixel elsewhere.
#pragma once

#include <span>

#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

// The largest movement that is an explanation, in px along each axis.
inline constexpr double kMaxEdgeShift = 0.75;

// The largest number of rows that mark_moved_edges takes at once.
inline constexpr int kMovedEdgeRows = 32;

// Finds the pixels whose difference is explained by an edge that moved. Two things must hold:
//
// 1. There is an edge in both pictures. In each channel, each picture's value lies in the range of
//    the other picture's 3 x 3 pixels, widened by its own length on both sides. (A line thinner
//    than a pixel that moves to the middle of a pixel makes this pixel darker than any was.) In
//    some channel, both ranges are longer than rounding makes them: a dot on a plain background
//    fails, and so does a plain background of another colour.
// 2. The pixels around it moved in the same way. The other pixels of the 7 x 7 around it give the
//    movement by least squares (Lucas and Kanade: An Iterative Image Registration Technique with an
//    Application to Stereo Vision. IJCAI 1981). It is cut to kMaxEdgeShift. Pixel values are means
//    over pixels. So the value after a movement has bounds: it consists of parts of up to four
//    pixels, and of each part only the mean of its pixel is known, and the range of the 5 x 5
//    pixels in both pictures. The value must be within these bounds, plus a quarter of this range,
//    when one of the pictures is moved to the other. A pixel that changed beside edges that did not
//    move fails.
//
// Colours are multiplied by their alpha. Where the selection leaves pixels out, both pictures have
// the reference's values. A pixel near NaN or an infinity is no moved edge.
//
// `kinds` are those of rows y, y + 1, ... of the pair, one element per pixel, and at most
// kMovedEdgeRows rows. Those that are kDifferent are judged, and become kMovedEdge where the rule
// holds. The verdict on a pixel does not depend on which others are judged.
void mark_moved_edges(const PicturePair& pair, int y, std::span<PixelKind> kinds);

}  // namespace glassbox
