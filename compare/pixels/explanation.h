// What may be behind a difference: the usual slips, each tried exactly.
#pragma once

#include <string>
#include <vector>

#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

// Sentences about `differences`, the likeliest first; empty where no known slip explains nine of ten differing pixels
// and more than one channel differs. Tried are moves by up to two pixels, mirrorings, red and blue in each other's place,
// a constant added to every sample, inverted colours, and an sRGB encoding too many or too few. Each costs at most two
// passes over the picture, and ends as soon as it has failed.
std::vector<std::string> explain_differences(const PicturePair& pair,
                                             const Differences& differences);

// Why two pictures of different sizes, channels or formats cannot be compared, and what may be behind it; the first
// sentence says what differs. Empty where they can.
std::vector<std::string> explain_shapes(const StoredImage& reference, const StoredImage& test);

}  // namespace glassbox
