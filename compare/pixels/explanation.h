// Possible causes of a difference: common mistakes, each tested exactly.
#pragma once

#include <string>
#include <vector>

#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

// Sentences about `differences`, the likeliest first. Empty where no known mistake explains nine of
// ten differing pixels and more than one channel differs. The tested mistakes are shifts by up to
// two pixels, mirroring, red and blue exchanged, a constant added to every sample, inverted
// colours, and one sRGB encoding too many or too few. Each test costs at most two passes over the
// picture, and ends as soon as it has failed.
std::vector<std::string> explain_differences(const PicturePair& pair,
                                             const Differences& differences);

// Why two pictures of different sizes, channels or formats cannot be compared, and possible causes;
// the first sentence says what differs. Empty where they can be compared.
std::vector<std::string> explain_format_mismatch(const StoredImage& reference,
                                                 const StoredImage& test);

}  // namespace glassbox
