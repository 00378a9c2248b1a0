// CHECK(MatchesGolden(image, "images/teapot.png")) for doctest, which has no matchers. See golden.h
// for what it does.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include <glassbox/compare/testing/golden.h>

namespace glassbox {

// Compares a PictureFile, a PictureView, and every picture that has a picture_view. CHECK and
// REQUIRE print the outcome's message where it is false.
template <class Picture>
GoldenOutcome MatchesGolden(const Picture& picture, const std::string& golden,
                            const char* source_file = __builtin_FILE()) {
  return check_golden(picture, golden, source_file);
}

}  // namespace glassbox

namespace doctest {

template <>
struct StringMaker<glassbox::GoldenOutcome> {
  static String convert(const glassbox::GoldenOutcome& outcome) { return outcome.message.c_str(); }
};

}  // namespace doctest
