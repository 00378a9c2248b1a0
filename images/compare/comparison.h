// The whole verdict on one pair of pictures: what every report is made from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/compare/differences.h>
#include <glassbox/images/compare/tolerance.h>
#include <glassbox/images/metrics/metric.h>

namespace glassbox {

enum class Verdict : std::uint8_t {
  kSame,             // every compared sample
  kWithinTolerance,  // different, and a tolerance that was asked for allows it
  kDifferent,
  kNew,      // there is no reference
  kMissing,  // there is no test picture, or one of the two cannot be compared: see `error`
};

struct CompareOptions {
  Tolerance tolerance;
  std::vector<PixelBox> ignore;
  std::string mask;  // file; empty: none
  bool nan_equals_nan = false;
  std::vector<MetricRequest> metrics;
  bool use_sidecar = true;
};

// What is known of a picture before its samples are looked at.
struct PictureFacts {
  std::string path;
  int width = 0, height = 0;  // px
  std::string channels;       // "RGB"
  std::string format;         // "8 bits"
};

struct Comparison {
  std::string
      name;  // what people call the pair: its path below the two directories, or the test's path
  PictureFacts reference, test;
  Verdict verdict = Verdict::kSame;
  std::optional<Error> error;              // of kMissing
  std::optional<Differences> differences;  // none where sizes, channels or formats differ
  std::vector<MetricValue> metrics;
  std::vector<std::string>
      reasons;  // why it is not the same, or too different: sentences, the decisive one first
  std::vector<std::string>
      hints;  // what may be behind it: a shift, a flip, swapped channels, another recipe
  std::vector<std::string>
      notes;              // about the test itself: a stale tolerance, an option that was overruled
  std::string tolerance;  // the one that applied, as written; empty: none
  std::string tolerance_reason;  // of the sidecar
  std::string inspect_command;  // shows how glassbox made the first differing pixel; empty: unknown
};

// Reads both files and compares them. Whatever stands in the way of a verdict is in `error`.
Comparison compare_files(const std::string& reference, const std::string& test,
                         const CompareOptions& options = {});

}  // namespace glassbox
