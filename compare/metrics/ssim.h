// SSIM: how similar the structure of two pictures is, window by window.
//
// Wang, Bovik, Sheikh, Simoncelli: Image Quality Assessment: From Error Visibility to Structural
// Similarity. IEEE Transactions on Image Processing 13(4), 2004.
#pragma once

#include <cstdint>

#include <glassbox/compare/metrics/tiles.h>
#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

inline constexpr int kSsimWindow = 11;  // px, a Gaussian of standard deviation 1.5
inline constexpr TileSize kLargestSsimTile{128, 32};

// Computed over all channels, alpha included, and all windows that are wholly inside the picture
// and whose centre is compared.
struct SsimValues {
  std::uint64_t windows = 0;  // counted once for each channel
  double mean = 0;            // error at most 2^-33: fixed_sum.h
  double min = 0;             // the smallest value of a single window
};

// Computes SSIM with the paper's constants K1 = 0.01, K2 = 0.03 and L = 1 (the range of the
// samples, which are scaled to [0, 1]). The pair must not have floats. There are no windows if the
// picture is smaller than one window. Equal pictures give exactly 1.
//
// Variances are computed as E[v^2] - E[v]^2, where v is the sum or the difference of the two
// pictures' samples and E the weighted mean. v^2 is at most 4. Each of the two terms has at most 22
// roundings with a relative error of 2^-53, so the error of a variance is below
// 2 * 22 * 4 * 2^-53 = 2e-14. The denominator of the similarity is at least K2^2 = 9e-4, so the
// error of a window is below 5e-11.
//
// Memory: 0.2 MB per thread in addition to the pictures. `tiles` (at most kLargestSsimTile) and the
// number of threads do not change the result.
SsimValues ssim(const PicturePair& pair, TileSize tiles = kLargestSsimTile);

}  // namespace glassbox
