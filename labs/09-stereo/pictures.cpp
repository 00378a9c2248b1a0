#include "labs/09-stereo/pictures.h"

#include <algorithm>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>

#include "exact/number.h"
#include "labs/framework/compare.h"

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

// The right answer, or one with a slip: each channel is from the picture of its eye.
std::vector<Expected> anaglyph_fields(const Anaglyph& a, Ties ties, bool from_bottom) {
  const Image<Rgba8> left = picture_of(a, a.left, ties), right = picture_of(a, a.right, ties);
  std::vector<double> red, green, blue;
  for (int row = 0; row < a.height; ++row) {
    for (int x = 0; x < a.width; ++x) {
      const int y = from_bottom ? a.height - 1 - row : row;
      red.push_back(a.left_mask.r ? left.at(x, y).r : right.at(x, y).r);
      green.push_back(a.left_mask.g ? left.at(x, y).g : right.at(x, y).g);
      blue.push_back(a.left_mask.b ? left.at(x, y).b : right.at(x, y).b);
    }
  }
  return {numbers("width, height", {double(a.width), double(a.height)}, 0),
          matrix("red", a.width, red), matrix("green", a.width, green),
          matrix("blue", a.width, blue)};
}

std::string names_of(const Channels& mask) {
  std::string names;
  const auto add = [&names](bool has, const char* name) {
    if (has) names += (names.empty() ? "" : " and ") + std::string(name);
  };
  add(mask.r, "red");
  add(mask.g, "green");
  add(mask.b, "blue");
  return names;
}

std::string colour_text(const Rgba8& c) {
  return fmt::format("{}, {}, {}", c.r, c.g, c.b);
}

}  // namespace lab_09_pictures

Case expect_anaglyph(const AnaglyphCase& input) {
  using namespace lab_09_pictures;
  const Anaglyph& a = input.anaglyph;
  std::string text = fmt::format(
      "{} x {} px, background {}; {} by the left eye, {} by the right one; fragments: {} of the "
      "left eye, {} of the right one",
      a.width, a.height, colour_text(a.background), names_of(a.left_mask), names_of(a.right_mask),
      a.left.size(), a.right.size());
  if (a.left.size() + a.right.size() <= 10) {
    for (const auto* fragments : {&a.left, &a.right}) {
      for (const Fragment& f : *fragments)
        text += fmt::format("\n{}: pixel ({}, {}), depth {}, colour {}",
                            fragments == &a.left ? "left" : "right", f.x, f.y, f.depth,
                            colour_text(f.colour));
    }
  }
  return {.where = input.what,
          .restated = text,
          .expected = anaglyph_fields(a, Ties::kFirst, false),
          .slipped = {{"depth-or-equal", anaglyph_fields(a, Ties::kLast, false)},
                      {"y-direction", anaglyph_fields(a, Ties::kFirst, true)}}};
}

bool right_anaglyph(const AnaglyphCase& input, const Answer& answer) {
  using namespace lab_09_pictures;
  return has_fields(answer, anaglyph_fields(input.anaglyph, Ties::kFirst, false));
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
  return has_fields(answer, colour_fields(colour_sums(input)));
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
