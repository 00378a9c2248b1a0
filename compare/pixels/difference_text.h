// Text for pixels and differences.
#pragma once

#include <cstdint>
#include <string>

#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// "(12, 0, 255)": the samples of a pixel; floats have the fewest digits that are read back as the
// same float.
std::string pixel_text(const StoredImage& image, PixelPosition pixel);

// A text such as "3/255", "3/65535" or "3 ulps"; "an infinite difference" for kUnbounded.
std::string steps_text(std::uint32_t steps, const StoredImage& image);

// "12 of 57600 pixels differ, by up to 3/255, in 2 regions; first (2, 1): (0, 0, 0) became (0, 0,
// 1)". Pixels that are set aside follow: "; set aside: 40 pixels at moved edges (by up to 9/255)".
// There must be differences.
std::string differences_text(const PicturePair& pair, const Differences& found);

// A fuzzy annotation that allows the differences and everything smaller; for kUnbounded a sentence
// that there is none.
std::string suggested_fuzzy(const Differences& found);

// "--max-differing 12, or --threshold 0.0312": options that allow the differences; empty where
// there are none.
std::string suggested_options(const PicturePair& pair, const Differences& found);

}  // namespace glassbox
