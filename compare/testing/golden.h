// Implements MatchesGolden without a test framework. The matchers for Catch2, GoogleTest and
// doctest are in catch2.h, gtest.h and doctest.h beside this file. They need the CMake target
// glassbox::matchers, which links nothing but zlib. C++17 is enough.
//
// A golden image is a picture that somebody has checked; it is stored with the tests. A test makes
// the picture again and compares it, exactly unless a sidecar (NAME.fuzzy, see docs/diff.md) allows
// more. A golden image that Glassbox wrote, and that is equal, is recognised here; of two files,
// only the same bytes are. The installed program, `glassbox diff`, compares everything else, equal
// pictures of other programs' files, too. Where pictures differ, the test's picture, a heat map and
// a page for a browser are written to the folder golden-failures below the directory in which the
// test runs (or to the folder named by the environment variable GLASSBOX_FAILURES).
//
// With GLASSBOX_APPROVE=1 in the environment, pictures that differ and those that have no golden
// image yet become golden images; this is refused where CI is set. GLASSBOX_PROGRAM names another
// program than the installed one.
#pragma once

#include <string>

#include <glassbox/compare/testing/picture_view.h>

// The program that compares. glassbox::matchers defines the path of the one that was installed with
// it; without a path, it is looked for in PATH.
#ifndef GLASSBOX_DIFF_PROGRAM
#define GLASSBOX_DIFF_PROGRAM "glassbox"
#endif

namespace glassbox {

// A picture file that the code under test has written. When it is approved, the golden image is a
// copy of the file.
struct PictureFile {
  std::string path;
};

struct GoldenOutcome {
  bool matches = false;
  std::string message;  // how the picture differs and where to look; or what has been approved
  explicit operator bool() const { return matches; }
};

// `golden` is a .png file for samples of 8 or 16 bits, or a .pfm file for floats; for a
// PictureFile, its extension is that of the file. A relative path is relative to the directory of
// `source_file`, which is the test's own source file: __FILE__. Samples with an alpha that is
// opaque everywhere are stored without it. `program` is a path, or a name to look for in PATH.
GoldenOutcome check_golden(const PictureView& picture, const std::string& golden,
                           const std::string& source_file,
                           const std::string& program = GLASSBOX_DIFF_PROGRAM);
GoldenOutcome check_golden(const PictureFile& picture, const std::string& golden,
                           const std::string& source_file,
                           const std::string& program = GLASSBOX_DIFF_PROGRAM);

template <class Picture, std::enable_if_t<has_picture_view<Picture>, int> = 0>
GoldenOutcome check_golden(const Picture& picture, const std::string& golden,
                           const std::string& source_file,
                           const std::string& program = GLASSBOX_DIFF_PROGRAM) {
  return check_golden(picture_view(picture), golden, source_file, program);
}

// How a message of a test names a picture: "the picture of 640 x 360", or the file's path.
inline std::string picture_name(const PictureFile& picture) {
  return picture.path;
}
template <class Picture, std::enable_if_t<has_picture_view<Picture>, int> = 0>
std::string picture_name(const Picture& picture) {
  const PictureView view = picture_view(picture);
  return "the picture of " + std::to_string(view.width) + " x " + std::to_string(view.height);
}

}  // namespace glassbox
