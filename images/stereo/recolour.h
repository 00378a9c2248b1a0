// Adapts colours to the glasses: less saturated and brighter, but changed as little as possible.
#pragma once

#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/images/stereo/linear.h>
#include <glassbox/images/stereo/rivalry.h>

namespace glassbox {

// c' = b + (1 - b) lerp(c, luma(c), k), in linear light, with the strengths k and b in [0, 1]
// (S0-15). k = 0 and b = 0 change nothing.
//
// Every method without clamping is linear and gives greys no rivalry, so the rivalry of c' is
// exactly (1 - k)(1 - b) times that of c.
struct Recolour {
  double desaturate = 0;  // the strength k
  double brighten = 0;    // the strength b
};

Result<void> check_recolour(const Recolour& recolour);

// The result is never outside [0, 1]: it is a mean of colours in this range.
Linear recoloured(const Linear& colour, const Recolour& recolour);

// Recolours a picture. The bytes are taken as sRGB, alpha is unchanged. The result is reproducible:
// float operations in a fixed order and exact tables.
Result<Image<Rgba8>> recoloured(const Image<Rgba8>& picture, const Recolour& recolour);

// A compromise: the rivalry that remains after recolouring, and the difference from the original
// colours.
struct Compromise {
  Recolour recolour;
  double rivalry = 0;     // the mean over both pictures
  double difference = 0;  // the mean CIEDE2000 difference from the original
};

// Measures the compromise over all pixels of both pictures, without rounding recoloured colours to
// bytes.
Result<Compromise> measure_recolour(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                    const AnaglyphViewing& viewing, const Recolour& recolour);

struct Suggestion {
  Compromise chosen;
  bool meets_target = false;  // false where even greys have more rivalry: then `chosen` is grey
  // The best compromises for targets from no change to grey: rivalry falls, difference grows.
  std::vector<Compromise> curve;
};

// Finds the strengths that reduce the mean rivalry to `target` with the least mean difference. For
// each brightening, the least desaturation that meets the target is taken, because more
// desaturation only increases the difference. Brightenings are tried in steps of 1/32, then the
// step around the best one is halved repeatedly. Pictures of more than 4096 colours are searched by
// groups of similar colours, 16 levels a channel; `chosen` is measured on all pixels, and made
// greyer until it meets the target there, within 1e-6.
//
// Refuses eyes of different sizes, and targets that are negative or NaN. Cost: about 0.03 s for
// each of the `curve_points` (at least 2), and a sort of the pixels.
Result<Suggestion> suggest_recolour(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                    const AnaglyphViewing& viewing, double target,
                                    int curve_points = 17);

}  // namespace glassbox
