// EXPECT_THAT(image, MatchesGolden("images/teapot.png")) for GoogleTest with GoogleMock. See
// golden.h for what it does.
#pragma once

#include <gmock/gmock.h>

#include <ostream>
#include <string>
#include <utility>

#include <glassbox/compare/testing/golden.h>

namespace glassbox {

// Matches a PictureFile, a PictureView, and every picture that has a picture_view: an Image of
// Rgba8, Rgb32f or float, a StoredImage, and your own types.
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

// Tells GoogleTest how to print the pictures of this namespace in its messages. A template PrintTo
// would be as good a match as GoogleTest's own, and so the call would be ambiguous.
template <class Picture>
auto operator<<(std::ostream& out, const Picture& picture)
    -> decltype(out << picture_name(picture)) {
  return out << picture_name(picture);
}

}  // namespace glassbox
