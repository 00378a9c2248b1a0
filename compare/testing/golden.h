// Implements MatchesGolden without a test framework. The matchers for Catch2 and GoogleTest are in
// catch2.h and gtest.h beside this file.
//
// A golden image is a picture that somebody has checked; it is stored with the tests. A test makes
// the picture again and compares it, exactly unless a sidecar (NAME.fuzzy, see
// compare/pictures/sidecar.h) allows more. Where they differ, the test's picture, a heat map and a
// page for a browser are written to the folder golden-failures below the directory in which the
// test runs (or to the folder named by the environment variable GLASSBOX_FAILURES).
//
// With GLASSBOX_APPROVE=1 in the environment, pictures that differ and those that have no golden
// image yet become golden images; this is refused where CI is set.
#pragma once

#include <string>

#include <glassbox/images/image.h>
#include <glassbox/images/stored_image.h>

namespace glassbox {

// A picture file that the code under test has written. When it is approved, the golden image is a
// copy of the file.
struct PictureFile {
  std::string path;
};

struct GoldenOutcome {
  bool matches = false;
  std::string message;  // how the picture differs and where to look; or what has been approved
};

// `golden` is a .png file, or .pfm for floats. A relative path is relative to the directory of
// `source_file`, which is the test's own source file: __FILE__.
GoldenOutcome check_golden(const StoredImage& image, const std::string& golden,
                           const std::string& source_file);
GoldenOutcome check_golden(const PictureFile& picture, const std::string& golden,
                           const std::string& source_file);

template <class Pixel>
GoldenOutcome check_golden(const Image<Pixel>& image, const std::string& golden,
                           const std::string& source_file) {
  return check_golden(as_stored(image), golden, source_file);
}

}  // namespace glassbox
