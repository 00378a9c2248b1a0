// The tolerance of one picture and the reason for it, stored in a file beside its reference.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/compare/metrics/metric.h>
#include <glassbox/compare/pixels/selection.h>
#include <glassbox/compare/pixels/tolerance.h>

namespace glassbox {

// A text file of lines "key: value". The keys are those of the command line: fuzzy, max-ulp,
// threshold, max-differing, metric, ignore-antialiasing (with the value yes), ignore, mask; and
// reason, which is required. # starts a comment line; a line without a key is a fuzzy annotation.
//
//     # teapot.png.fuzzy
//     maxDifference=0-1;totalPixels=0-4
//     reason: four pixels of the rim are ties that the hardware breaks the other way
struct Sidecar {
  std::string path;
  Tolerance tolerance;
  std::vector<MetricRequest> metrics;
  std::vector<PixelBox> ignore;
  std::string mask;  // file, beside the sidecar unless absolute; empty: none
  std::string reason;
};

// Reads "NAME.fuzzy" for the reference NAME, with or without the extension of NAME
// (teapot.png.fuzzy, teapot.fuzzy). Returns none if there is no such file; an error where both
// exist.
Result<std::optional<Sidecar>> find_sidecar(const std::string& reference);

Result<Sidecar> parse_sidecar(const std::string& path, const std::string& text);

}  // namespace glassbox
