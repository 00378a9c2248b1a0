// EXPECT_THAT(image, MatchesGolden("images/teapot.png")) for GoogleTest with GoogleMock. See
// golden.h for what it does.
#pragma once

#include <gmock/gmock.h>

#include <ostream>
#include <string>
#include <utility>

#include <glassbox/compare/testing/golden.h>

namespace glassbox {

// Matches an Image of Rgba8, Rgb32f or float, a StoredImage, and a PictureFile.
class GoldenMatcher {
public:
  GoldenMatcher(std::string golden, std::string source_file)
      : golden_(std::move(golden)), source_file_(std::move(source_file)) {}

  template <class Picture>
  bool MatchAndExplain(const Picture& picture, testing::MatchResultListener* listener) const {
    const GoldenOutcome outcome = check_golden(picture, golden_, source_file_);
    *listener << outcome.message;
    return outcome.matches;
  }

  void DescribeTo(std::ostream* out) const { *out << "matches the golden image " << golden_; }
  void DescribeNegationTo(std::ostream* out) const {
    *out << "does not match the golden image " << golden_;
  }

private:
  std::string golden_, source_file_;
};

inline testing::PolymorphicMatcher<GoldenMatcher> MatchesGolden(
    std::string golden, const char* source_file = __builtin_FILE()) {
  return testing::MakePolymorphicMatcher(GoldenMatcher(std::move(golden), source_file));
}

// Tells GoogleTest how to print a picture in its messages.
template <class Pixel>
void PrintTo(const Image<Pixel>& image, std::ostream* out) {
  *out << "the picture of " << image.width << " x " << image.height;
}
inline void PrintTo(const StoredImage& image, std::ostream* out) {
  *out << "the picture of " << image.width << " x " << image.height;
}
inline void PrintTo(const PictureFile& picture, std::ostream* out) {
  *out << picture.path;
}

}  // namespace glassbox
