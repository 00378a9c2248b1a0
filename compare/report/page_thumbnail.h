// Small pictures for the list of a page.
#pragma once

#include <span>

#include <glassbox/compare/report/page_pictures.h>
#include <glassbox/images/image.h>

namespace glassbox {

inline constexpr int kThumbnailWidth = 96, kThumbnailHeight = 64;  // px, at most

// Draws the test picture, or the reference if there is no test, not larger than it is. A pixel of
// the thumbnail stands for a box of the picture: [i W / w, (i + 1) W / w) of W columns if the
// thumbnail has w, and rows in the same way. Each sample is first rounded to 8 bits: 16 bits to
// the nearest number to 255/65535 of them, floats from the least finite sample of the picture (0)
// to the greatest one (255), NaN as 0. The pixel has the mean of these numbers, to the nearest,
// computed with whole numbers. What is transparent lies on light grey.
//
// With a heat map, the picture is faded, and the differences lie over it: a pixel has the colour of
// the largest difference in its box and in the eight boxes around it, so that a single differing
// pixel is seen. Where the box has pixels that are set aside, or where all of it is not compared,
// it has their colour. If more than a sixteenth of the boxes differ, each has only its own colour,
// mixed half and half with the picture, so that the picture is still recognised.
//
// `pictures` are those of page_pictures; there is at least one.
Image<Rgba8> page_thumbnail(std::span<const PagePicture> pictures);

}  // namespace glassbox
