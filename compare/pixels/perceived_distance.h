// How far apart two colours look: the distance that odiff, reg-cli, Playwright and pixelmatch (up
// to its version 7) use for their thresholds.
#pragma once

#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

// The distance of a pixel's two colours: 0 for the same colour, 0.966 for black and white, and 1
// for the two opaque colours that are farthest apart. The samples (0 to 255, as they are stored)
// are transformed to YIQ, and the distance is
//
//     sqrt((0.5053 dY^2 + 0.299 dI^2 + 0.1957 dQ^2) / 35215)
//
// (Kotsarenko and Ramos: Measuring perceived color difference using YIQ NTSC transmission color
// space in mobile applications. Programación Matemática y Software 2(2), 2010). 16-bit samples are
// divided by 257. If a pixel is not opaque, both colours are placed over black and over white, and
// the larger distance counts. For pictures of floats the distance is infinite.
double perceived_distance(const PicturePair& pair, PixelPosition pixel);

// Makes the pixels of row y that are kDifferent kBelowThreshold, where their distance is at most
// the threshold that the pair has. `kinds` has one element per pixel.
void mark_below_threshold(const PicturePair& pair, int y, std::span<PixelKind> kinds);

// The largest distance of the pixels that differ and are not set aside; 0 where there are none.
double largest_distance(const PicturePair& pair);

}  // namespace glassbox
