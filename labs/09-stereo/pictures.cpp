#include "labs/09-stereo/pictures.h"

#include <algorithm>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>
#include <glassbox/images/stereo/anaglyph.h>

#include "exact/number.h"

namespace glassbox::labs {

using namespace lab_09;
using exact::Decimal;

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

// Generated inputs have masks of their own, so each channel is taken from its eye's picture.
std::vector<Expected> anaglyph_fields(const AnaglyphCase& input) {
  using namespace lab_09_pictures;
  const Anaglyph& a = input.anaglyph;
  const Image<Rgba8> left = picture_of(a, a.left, Ties::kFirst);
  const Image<Rgba8> right = picture_of(a, a.right, Ties::kFirst);
  std::vector<double> red, green, blue;
  for (std::size_t i = 0; i < left.pixels.size(); ++i) {
    red.push_back(a.left_mask.r ? left.pixels[i].r : right.pixels[i].r);
    green.push_back(a.left_mask.g ? left.pixels[i].g : right.pixels[i].g);
    blue.push_back(a.left_mask.b ? left.pixels[i].b : right.pixels[i].b);
  }
  return {numbers("width, height", {double(a.width), double(a.height)}, 0),
          matrix("red", a.width, red), matrix("green", a.width, green),
          matrix("blue", a.width, blue)};
}

Case expect_any_anaglyph(const AnaglyphCase& input) {
  Case made = expect_anaglyph(input);
  made.expected = anaglyph_fields(input);
  made.slipped.clear();  // they are those of the masks in the usual order
  return made;
}

bool right_anaglyph(const AnaglyphCase& input, const Answer& answer) {
  return !judge_case({.where = "", .restated = "", .expected = anaglyph_fields(input)}, answer);
}

// The bound is 32 u (u = 2^-53 is the unit roundoff). Y has errors of 4 u: of a constant, a product
// and two sums. (1 - k) c + k Y has errors of 6 u, and the recoloured channel, which is at most 1,
// 9 u. With six products and five sums, that is 15 u times the sum of a row's absolute values. They
// add up to at most 2, which makes 30 u.
std::vector<double> colour_sums(const ColourCase& input) {
  const Decimal k(input.recolour.desaturate), b(input.recolour.brighten), one(1);
  std::vector<Decimal> eyes;
  for (const Colour& c : {input.left, input.right}) {
    const Decimal luma = Decimal(0.299) * Decimal(c[0]) + Decimal(0.587) * Decimal(c[1]) +
                         Decimal(0.114) * Decimal(c[2]);
    for (const double each : c)
      eyes.push_back(b + (one - b) * ((one - k) * Decimal(each) + k * luma));
  }
  std::vector<double> sums;
  for (const auto& row : input.matrix) {
    Decimal sum;
    for (std::size_t j = 0; j < 6; ++j) sum += Decimal(row[j]) * eyes[j];
    sums.push_back(double(sum));
  }
  return sums;
}

std::vector<Expected> colour_fields(const std::vector<double>& sums) {
  std::vector<double> shown;
  for (const double sum : sums) shown.push_back(std::clamp(sum, 0.0, 1.0));
  return {numbers("red, green, blue", shown, 32 * unit_roundoff<double>)};
}

bool right_colour(const ColourCase& input, const Answer& answer) {
  return !judge_case({.where = "", .restated = "", .expected = colour_fields(colour_sums(input))},
                     answer);
}

Case expect_colour(const ColourCase& input) {
  const std::vector<double> sums = colour_sums(input);
  return {
      input.what,
      fmt::format("k = {}, b = {}; left ({}), right ({}); before clamping ({:.6g})",
                  input.recolour.desaturate, input.recolour.brighten, fmt::join(input.left, ", "),
                  fmt::join(input.right, ", "), fmt::join(sums, ", ")),
      colour_fields(sums)};
}

}  // namespace glassbox::labs
