#include "labs/09-stereo/pictures.h"

#include <algorithm>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>
#include <glassbox/images/stereo/anaglyph.h>

#include "exact/number.h"

namespace glassbox::labs {

using namespace lab_09;
using exact::Rational;

namespace lab_09_pictures {

// Which of equally near fragments is visible, the first or the last. The first one is right.
enum class Ties { kFirst, kLast };

Image<Rgba8> picture_of(const Anaglyph& anaglyph, const std::vector<Fragment>& fragments,
                        Ties ties) {
  Image<Rgba8> picture(anaglyph.width, anaglyph.height, anaglyph.background);
  for (int y = 0; y < anaglyph.height; ++y) {
    for (int x = 0; x < anaglyph.width; ++x) {
      const Fragment* nearest = nullptr;
      for (const Fragment& each : fragments) {
        const bool here = each.x == x && each.y == y;
        if (!here) continue;
        const bool nearer = nearest == nullptr || each.depth < nearest->depth;
        if (nearer || (ties == Ties::kLast && each.depth == nearest->depth)) nearest = &each;
      }
      if (nearest != nullptr) picture.at(x, y) = nearest->colour;
    }
  }
  return picture;
}

}  // namespace lab_09_pictures

// The expected picture: the pictures of both eyes, combined by make_anaglyph.
Case expect_anaglyph(const AnaglyphCase& input) {
  using namespace lab_09_pictures;
  const Anaglyph& a = input.anaglyph;
  const Glasses glasses = input.lenses == Lenses::kRedCyan        ? Glasses::kRedCyan
                          : input.lenses == Lenses::kGreenMagenta ? Glasses::kGreenMagenta
                                                                  : Glasses::kAmberBlue;
  const auto expected = [&](Ties ties, bool from_bottom) {
    const Image<Rgba8> shown =
        make_anaglyph(picture_of(a, a.left, ties), picture_of(a, a.right, ties),
                      AnaglyphMethod::kMask, glasses)
            .value();
    std::vector<double> red, green, blue;
    for (int row = 0; row < a.height; ++row) {
      for (int x = 0; x < a.width; ++x) {
        const Rgba8& pixel = shown.at(x, from_bottom ? a.height - 1 - row : row);
        red.push_back(pixel.r);
        green.push_back(pixel.g);
        blue.push_back(pixel.b);
      }
    }
    return std::vector{numbers("width, height", {double(a.width), double(a.height)}, 0),
                       matrix("red", a.width, red), matrix("green", a.width, green),
                       matrix("blue", a.width, blue)};
  };
  std::string text =
      fmt::format("{} lenses, {} x {} px; fragments: {} of the left eye, {} of the right one",
                  name_of(glasses), a.width, a.height, a.left.size(), a.right.size());
  if (a.left.size() + a.right.size() <= 10) {
    for (const auto* fragments : {&a.left, &a.right}) {
      for (const Fragment& f : *fragments)
        text += fmt::format("\n{}: pixel ({}, {}), depth {}, colour {}, {}, {}",
                            fragments == &a.left ? "left" : "right", f.x, f.y, f.depth, f.colour.r,
                            f.colour.g, f.colour.b);
    }
  }
  return {.where = input.what,
          .restated = text,
          .expected = expected(Ties::kFirst, false),
          .slipped = {{"depth-or-equal", expected(Ties::kLast, false)},
                      {"y-direction", expected(Ties::kFirst, true)}}};
}

// The bound is 32 u (u = 2^-53 is the unit roundoff). Recoloured channels are at most 1 and have
// errors of 10 u. The absolute values of a row of the matrix add up to less than 1.5, which makes
// 15 u of these errors. Six products and their sum add rounding errors of 6 u times at most 1.5,
// which is 9 u. Both together are 24 u.
Case expect_colour(const ColourCase& input) {
  using namespace lab_09_pictures;
  const Rational k(input.recolour.desaturate), b(input.recolour.brighten), one(1);
  std::vector<Rational> eyes;
  for (const Colour& c : {input.left, input.right}) {
    const Rational luma = Rational(0.299) * Rational(c[0]) + Rational(0.587) * Rational(c[1]) +
                          Rational(0.114) * Rational(c[2]);
    for (const double each : c)
      eyes.push_back(b + (one - b) * ((one - k) * Rational(each) + k * luma));
  }
  std::vector<double> shown, sums;
  for (const auto& row : input.matrix) {
    Rational sum;
    for (std::size_t j = 0; j < 6; ++j) sum += Rational(row[j]) * eyes[j];
    sums.push_back(double(sum));
    shown.push_back(std::clamp(double(sum), 0.0, 1.0));
  }
  return {
      input.what,
      fmt::format("k = {}, b = {}; left ({}), right ({}); before clamping ({:.6g})",
                  input.recolour.desaturate, input.recolour.brighten, fmt::join(input.left, ", "),
                  fmt::join(input.right, ", "), fmt::join(sums, ", ")),
      {numbers("red, green, blue", shown, 32 * unit_roundoff<double>)}};
}

}  // namespace glassbox::labs
