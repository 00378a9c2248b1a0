// REQUIRE_THAT(image, MatchesGolden("images/teapot.png")) for Catch2, version 2 or 3. See golden.h
// for what it does.
#pragma once

#if __has_include(<catch2/matchers/catch_matchers_templated.hpp>)
#include <catch2/catch_test_macros.hpp>
#include <catch2/catch_tostring.hpp>
#include <catch2/matchers/catch_matchers_templated.hpp>
#define GLASSBOX_CATCH2_MATCHER_BASE Catch::Matchers::MatcherGenericBase
#else
#include <catch2/catch.hpp>
#define GLASSBOX_CATCH2_MATCHER_BASE Catch::Matchers::Impl::MatcherUntypedBase
#endif

#include <string>
#include <utility>

#include <glassbox/compare/testing/golden.h>

namespace glassbox {

// Matches a PictureFile, a PictureView, and every picture that has a picture_view: an Image of
// Rgba8, Rgb32f or float, a StoredImage, and your own types.
class GoldenMatcher : public GLASSBOX_CATCH2_MATCHER_BASE {
public:
  GoldenMatcher(std::string golden, std::string source_file)
      : golden_(std::move(golden)), source_file_(std::move(source_file)) {}

  template <class Picture>
  bool match(const Picture& picture) const {
    const GoldenOutcome outcome = check_golden(picture, golden_, source_file_);
    message_ = outcome.message;
    return outcome.matches;
  }

  std::string describe() const override { return message_; }

private:
  std::string golden_, source_file_;
  mutable std::string message_;  // of the last match
};

inline GoldenMatcher MatchesGolden(std::string golden, const char* source_file = __builtin_FILE()) {
  return {std::move(golden), source_file};
}

}  // namespace glassbox

#undef GLASSBOX_CATCH2_MATCHER_BASE

namespace Catch {

// Tells Catch2 how to print a picture in its messages. It prints the elements of a type that is a
// range.
template <class Picture>
struct StringMaker<
    Picture, std::enable_if_t<glassbox::has_picture_view<Picture> && !is_range<Picture>::value>> {
  static std::string convert(const Picture& picture) { return glassbox::picture_name(picture); }
};

template <>
struct StringMaker<glassbox::PictureFile> {
  static std::string convert(const glassbox::PictureFile& picture) { return picture.path; }
};

}  // namespace Catch
