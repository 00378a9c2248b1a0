// The settings of a dense match, and their defaults.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// The range of disparities: a left pixel (x, y) may match the right pixels (x - d, y), first <= d
// <= last (S2-04). Negative d are allowed.
struct DisparityRange {
  int first = 0;
  int last = 63;
  int count() const { return last - first + 1; }
};

// The measure of similarity of two pixels (S2-04): absolute and squared differences of grey (SAD,
// SSD); their correlation, without and with subtraction of the means (NCC, ZNCC); the Hamming
// distance of census words (Zabih and Woodfill 1994); and absolute difference of colour together
// with census (Mei et al. 2011), which counts only the census bits of neighbours with a colour
// similar to their centre's.
enum class MatchingCost : std::uint8_t { kSad, kSsd, kNcc, kZncc, kCensus, kAdCensus };
std::string_view name_of(MatchingCost cost);
inline bool is_correlation(MatchingCost cost) {
  return cost == MatchingCost::kNcc || cost == MatchingCost::kZncc;
}

struct MatchSettings {
  DisparityRange range;
  MatchingCost cost = MatchingCost::kAdCensus;
  // The size of the square window, odd, 1 to 15 px. Costs are averaged over it, or for NCC and
  // ZNCC, the correlation is computed over it.
  int window = 1;
  // How many times the costs are averaged over crosses whose arms stop where the colour changes
  // (Zhang, Lu and Lafruit 2009), 0 to 4.
  int adaptive = 0;
  // The number of directions of paths along which costs and penalties are summed (Hirschmueller
  // 2008): 2, 4, 8 or 16. 0: no paths; each pixel takes the disparity of its own least cost.
  int paths = 8;
  // Uses only the paths that do not come from below, in bands of rows, with very little memory. It
  // has no effect if costs are averaged over pixels: they need their whole volume, and are summed
  // along all paths.
  bool single_sweep = false;
  bool subpixel = true;
  // A left pixel is invalid if its disparity differs by more than this (px) from that of the right
  // pixel that it leads to; absent: not checked.
  std::optional<int> left_right = 1;
  // The least peak ratio, (second - best) / second, of the least cost and the second least, where
  // the two neighbours of the least are left out. A pixel with a smaller ratio is invalid.
  float confidence = 0;
  // The number of rounds in which slanted planes improve the disparities (plane_fitting.h): 0 to 8.
  int planes = 0;
  int speckle = 0;     // connected regions of fewer pixels are invalid
  bool median = true;  // applies a median filter of 3 x 3
  bool smooth = true;  // averages disparities that differ by little
  // Before holes are filled, an invalid pixel may take the disparity of the surrounding pixels of
  // similar colour.
  bool vote = true;
  // The remaining invalid pixels take the disparity of the background beside them.
  bool fill = true;
  bool keep_sums = false;  // keeps the sums of every pixel and disparity, for inspection
  Target target = best_target();
  int threads = 0;  // at most; 0: as many as the machine has
};

// Whether a single sweep is asked for, and possible with these costs.
inline bool sweeps_once(const MatchSettings& settings) {
  return settings.single_sweep && settings.paths > 0 && settings.adaptive == 0 &&
         (settings.window == 1 || is_correlation(settings.cost));
}

// The settings with this name: "default", "fast" or "winner" (no paths: each pixel takes the
// disparity of least SAD over a square of 11 px). None if there is no such name.
std::optional<MatchSettings> settings_named(std::string_view name);

// An error if the settings are invalid, regardless of the pictures.
Result<void> check_settings(const MatchSettings& settings);

}  // namespace glassbox::views
