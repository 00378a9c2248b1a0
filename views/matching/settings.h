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
  // Odd, 1 to 15: costs are averaged over such a square. For NCC and ZNCC it is the correlation's
  // window.
  int window = 1;
  // How often the costs are averaged over arms that stop where the colour changes (Zhang, Lu and
  // Lafruit 2009), 0 to 4.
  int adaptive = 0;
  // The number of directions along which smoothness is summed (Hirschmueller 2008): 2, 4, 8, 16; 0:
  // the winner of each pixel by itself.
  int paths = 8;
  // Uses only the paths that do not come from below, in bands of rows, with very little memory.
  // Costs that are averaged over pixels need their whole volume, and are summed along all paths.
  bool single_sweep = false;
  bool subpixel = true;
  // If left and right disparity differ by more than this, both are invalid; absent: not checked.
  std::optional<int> left_right = 1;
  // Least peak ratio: (second - best) / second of the costs, where the neighbours of the best do
  // not count as second. Below it a pixel is invalid.
  float confidence = 0;
  // Rounds in which slanted planes are fitted to the disparities of the paths: 0 to 8.
  int planes = 0;
  int speckle = 0;     // connected pieces of fewer pixels are invalid
  bool median = true;  // 3x3
  bool smooth = true;  // subpixel values are averaged where they differ little
  // Before holes are filled, an invalid pixel may take the disparity of the surrounding pixels of
  // similar colour.
  bool vote = true;
  // The remaining invalid pixels take the disparity of the background beside them.
  bool fill = true;
  bool keep_sums = false;  // keeps the sums of every pixel and disparity, for inspection
  Target target = best_target();
  int threads = 0;  // at most; 0: as many as the machine has
};

// Whether the single sweep is possible with these costs.
inline bool sweeps_once(const MatchSettings& settings) {
  return settings.single_sweep && settings.paths > 0 && settings.adaptive == 0 &&
         (settings.window == 1 || is_correlation(settings.cost));
}

// "default", "fast", "winner" (each pixel by itself: SAD over a square of 11).
std::optional<MatchSettings> settings_named(std::string_view name);

// An error if the settings are invalid, regardless of the pictures.
Result<void> check_settings(const MatchSettings& settings);

}  // namespace glassbox::views
