// The complete result for one pair of pictures, which all reports are made from.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/compare/metrics/metric.h>
#include <glassbox/compare/pictures/pairing.h>
#include <glassbox/compare/pixels/canvas.h>
#include <glassbox/compare/pixels/differences.h>
#include <glassbox/compare/pixels/selection.h>
#include <glassbox/compare/pixels/tolerance.h>
#include <glassbox/images/recipe.h>

namespace glassbox {

enum class Verdict : std::uint8_t {
  kSame,             // every compared sample is equal
  kWithinTolerance,  // different, but the given tolerance allows it
  kDifferent,
  kNew,         // there is no reference
  kMissing,     // there is no test picture
  kUncompared,  // a picture cannot be read, or an option does not fit: see `error`
};

inline bool passes(Verdict verdict) {
  return verdict == Verdict::kSame || verdict == Verdict::kWithinTolerance;
}

enum class AlphaRule : std::uint8_t {
  kLenient,  // a picture whose alpha is opaque everywhere is the same as one without alpha
  kStrict,   // it is another kind of picture
};

// Which of two pictures has an alpha channel that is opaque everywhere, and that the other one does
// not have. It is not compared.
enum class OpaqueAlpha : std::uint8_t { kNone, kReference, kTest };

struct CompareOptions {
  Tolerance tolerance;
  std::vector<MetricRequest> metrics;
  std::vector<PixelBox> ignore;
  std::string mask;  // file; empty: none
  bool nan_equals_nan = false;
  AlphaRule alpha = AlphaRule::kLenient;
  Alignment alignment = Alignment::kTopLeft;  // of pictures whose sizes differ
  bool ignore_size = false;        // pictures of different sizes pass if their overlap does
  bool suggest_tolerance = false;  // fill in Comparison::suggestions
  bool keep_pixels = false;        // fill in Comparison::pixels
  // Returns the command that shows how a pixel of a picture made by this recipe was computed; empty
  // where there is none.
  std::function<std::string(const Recipe& recipe, PixelPosition pixel)> inspect_command;
};

// The properties of a picture that are known before its samples are compared.
struct PictureFacts {
  std::string path;
  int width = 0, height = 0;  // in px
  std::string channels;       // "RGB"
  std::string format;         // "8 bits"
};

struct PreparedPair;  // prepared_pair.h

struct Comparison {
  // The name of the pair: its path below the two directories, or the test's path.
  std::string name;
  PictureFacts reference, test;
  Verdict verdict = Verdict::kSame;
  std::optional<Error> error;              // for kNew, kMissing and kUncompared
  std::optional<Differences> differences;  // none where channels or formats differ
  // Where the pictures lie if their sizes differ. Positions of differences are counted on it.
  std::optional<Canvas> canvas;
  OpaqueAlpha opaque_alpha = OpaqueAlpha::kNone;
  SetAside set_aside;  // what was not counted as a difference
  double seconds = 0;  // that the comparison took, if it was measured
  // The pictures, for reports that would otherwise read them again; null unless they were asked for
  // and can be compared.
  std::shared_ptr<const PreparedPair> pixels;
  std::vector<MetricValue> metrics;
  // The reasons why the pictures are not the same, or too different: sentences, the decisive one
  // first.
  std::vector<std::string> reasons;
  // Possible causes: a shift, a flip, swapped channels, another recipe.
  std::vector<std::string> hints;
  std::vector<std::string>
      notes;  // tolerances that allow more than needed, options that were overruled
  std::vector<std::string> suggestions;  // options that would let the pictures pass, if asked for
  std::string tolerance;         // the tolerance that was used, as one would write it; empty: none
  std::string tolerance_reason;  // as given in the sidecar
  std::string inspect_command;  // shows how glassbox made the first differing pixel; empty: unknown
  std::vector<PixelBox> ignore;  // the boxes that were left out, including the sidecar's
  std::string mask;              // file
  bool nan_equals_nan = false;
};

// Reads both files and compares them. Pictures of different sizes are compared where both are, and
// are different, unless options.ignore_size is set. The sidecar of the reference adds its boxes and
// its mask; its tolerance is used if the options have none (otherwise the options' tolerance is
// used, and a note says so). Pictures pass if they are the same, or if a fuzzy annotation, a number
// of ulps or limits on metrics are given and all of them hold. If the pictures cannot be compared,
// the reason is in `error`. The first frames of animations are compared; they pass only if the
// bytes of the other frames are the same.
Comparison compare_files(const std::string& reference, const std::string& test,
                         const CompareOptions& options = {});

// Compares the two files of a pair, under the pair's name; kNew or kMissing if the reference or the
// test picture does not exist.
Comparison compare_pair(const PicturePaths& paths, const CompareOptions& options = {});

// The pixels that a comparison used, for code that displays them. Computed again from its boxes and
// its mask.
Result<Selection> selection_of(const StoredImage& reference, const std::vector<PixelBox>& ignore,
                               const std::string& mask);

}  // namespace glassbox
