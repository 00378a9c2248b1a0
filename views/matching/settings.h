// What a dense match may be asked for, and what is asked for by default.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/raster/lanes/target.h>

namespace glassbox::views {

// A left pixel (x, y) may match the right pixels (x - d, y), first <= d <= last (SPEC S2-04); negative d are legal.
struct DisparityRange {
  int first = 0;
  int last = 63;
  int count() const { return last - first + 1; }
};

// What makes two pixels alike (SPEC S2-04): absolute and squared differences of grey, their correlation without and with the means
// taken away, the Hamming distance of census words (Zabih and Woodfill 1994), and absolute difference of colour and census together
// (Mei et al. 2011), of the census bits those whose neighbours are alike their centres.
enum class MatchingCost : std::uint8_t { kSad, kSsd, kNcc, kZncc, kCensus, kAdCensus };
std::string_view name_of(MatchingCost cost);
inline bool is_correlation(MatchingCost cost) {
  return cost == MatchingCost::kNcc || cost == MatchingCost::kZncc;
}

struct MatchSettings {
  DisparityRange range;
  MatchingCost cost = MatchingCost::kAdCensus;
  int window =
      1;  // odd, 1 to 15: costs are averaged over such a square. Of NCC and ZNCC it is the correlation's window
  // Averages of the costs over arms that stop where the colour changes (Zhang, Lu and Lafruit 2009): how often, 0 to 4.
  int adaptive = 0;
  // Directions along which smoothness is summed (Hirschmueller 2008): 2, 4, 8, 16; 0: the winner of each pixel alone.
  int paths = 8;
  // Only those paths that do not come from below, in bands of rows, with next to no memory. Costs that are averaged
  // over pixels need their volume, and are summed along all paths.
  bool single_sweep = false;
  bool subpixel = true;
  // Left and right disparities that differ by more are both invalid; absent: not checked.
  std::optional<int> left_right = 1;
  // Peak ratio: (second - best) / second of the costs, the neighbours of the best apart. Below it a pixel is invalid.
  float confidence = 0;
  int planes = 0;      // rounds of planes that slant, fitted to what the paths found: 0 to 8
  int speckle = 0;     // connected pieces of fewer pixels are invalid
  bool median = true;  // 3x3
  bool smooth = true;  // parts of a pixel are averaged where they differ by little
  bool vote = true;  // of the pixels of like colour around an invalid one, before holes are filled
  bool fill = true;  // invalid pixels take what stands behind them
  bool keep_sums = false;  // of every pixel and disparity, for whoever wants to look at them
  Target target = best_target();
  int threads = 0;  // at most; 0: as many as the machine has
};

// Whether it is to be had of such costs.
inline bool sweeps_once(const MatchSettings& settings) {
  return settings.single_sweep && settings.paths > 0 && settings.adaptive == 0 &&
         (settings.window == 1 || is_correlation(settings.cost));
}

// "default", "fast", "winner" (each pixel for itself: SAD of a square of 11).
std::optional<MatchSettings> settings_named(std::string_view name);

// An error where the settings cannot be, whatever the pictures.
Result<void> check_settings(const MatchSettings& settings);

}  // namespace glassbox::views
