#include "tests/support/catch.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glassbox/images/stereo/anaglyph.h>

#include "tests/images/stereo/pictures.h"

namespace {

using namespace glassbox;
using test::noise;

// Decodes IEC 61966-2-1 in double with the C library, independently of the program's tables.
double light_of(std::uint8_t byte) {
  const double v = byte / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
double code_of(double light) {
  return 255 * (light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

Rgba8 one_pixel(Rgba8 left, Rgba8 right, AnaglyphMethod method, Glasses glasses) {
  const auto shown = make_anaglyph({1, 1, left}, {1, 1, right}, method, glasses);
  REQUIRE(shown);
  return shown->at(0, 0);
}

double row_sum(const std::array<float, 6>& row) {
  double sum = 0;
  for (const float value : row) sum += double(value);
  return sum;
}

// Whether every row has the sum 1, so that white stays white. Matrices are printed with three
// digits or more; six numbers, each off by at most 0.0005, change a row's sum by at most 0.003. The
// largest deviation here is 0.001.
bool keeps_white(const AnaglyphMatrix& matrix) {
  return std::all_of(matrix.at.begin(), matrix.at.end(),
                     [](const auto& row) { return std::abs(row_sum(row) - 1) <= 0.0015; });
}

}  // namespace

TEST_CASE(
    "mask: A = (L.r, R.g, R.b), bit for bit, and the same rule for every pair of glasses (S0-02)") {
  Random random(31);
  const Image<Rgba8> left = noise(37, 11, random), right = noise(37, 11, random);
  const auto red_cyan = make_anaglyph(left, right, AnaglyphMethod::kMask);
  const auto green_magenta =
      make_anaglyph(left, right, AnaglyphMethod::kMask, Glasses::kGreenMagenta);
  const auto amber_blue = make_anaglyph(left, right, AnaglyphMethod::kMask, Glasses::kAmberBlue);
  REQUIRE((red_cyan && green_magenta && amber_blue));
  for (std::size_t i = 0; i < left.pixels.size(); ++i) {
    const Rgba8 l = left.pixels[i], r = right.pixels[i];
    const std::uint8_t alpha = l.a > r.a ? l.a : r.a;
    CHECK(red_cyan->pixels[i] == Rgba8{l.r, r.g, r.b, alpha});
    CHECK(green_magenta->pixels[i] == Rgba8{r.r, l.g, r.b, alpha});
    CHECK(amber_blue->pixels[i] == Rgba8{l.r, l.g, r.b, alpha});
  }
}

TEST_CASE("every channel belongs to exactly one eye") {
  for (const auto& glasses : all_glasses()) {
    CAPTURE(glasses.name);
    const EyeMasks masks = eye_masks(glasses.value);
    CHECK(masks.left.r != masks.right.r);
    CHECK(masks.left.g != masks.right.g);
    CHECK(masks.left.b != masks.right.b);
    // The glasses' name begins with the colour of the left lens.
    CHECK(masks.left.r == (glasses.name.starts_with("red") || glasses.name.starts_with("amber")));
  }
}

TEST_CASE("mask through its matrix gives the bytes that copying gives") {
  for (const auto& glasses : all_glasses()) {
    const auto matrix = anaglyph_matrix(AnaglyphMethod::kMask, glasses.value);
    REQUIRE(matrix);
    const EyeMasks masks = eye_masks(glasses.value);
    const bool from_left[3] = {masks.left.r, masks.left.g, masks.left.b};
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 6; ++column) {
        CHECK(matrix->at[row][column] == (column == (from_left[row] ? row : row + 3) ? 1 : 0));
      }
    }
  }
}

TEST_CASE(
    "white gives byte 255 and black 0 in every method, but for the channel that true leaves "
    "black") {
  const Rgba8 white{255, 255, 255, 255}, black{0, 0, 0, 255};
  for (const auto& glasses : all_glasses()) {
    for (const auto& method : all_anaglyph_methods()) {
      CAPTURE(glasses.name, method.name);
      const auto matrix = anaglyph_matrix(method.value, glasses.value);
      if (!matrix) continue;
      const Rgba8 shown = one_pixel(white, white, method.value, glasses.value);
      if (method.value == AnaglyphMethod::kTrue) {
        const bool yellow = glasses.value == Glasses::kGreenMagenta;
        CHECK(shown == (yellow ? Rgba8{255, 255, 0, 255} : Rgba8{255, 0, 255, 255}));
      } else {
        CHECK(keeps_white(*matrix));
        CHECK(shown == white);
      }
      CHECK(one_pixel(black, black, method.value, glasses.value) == black);
    }
  }
}

// White begins at 254.5/255. With row sums near 1, the light of a grey changes by at most a factor
// of 1.5e-3, which is at most 0.0015 / 2.4 * 1.055 * 255 = 0.17 of a byte.
TEST_CASE("greys stay grey to a byte") {
  for (const auto& glasses : all_glasses()) {
    for (const auto& method : all_anaglyph_methods()) {
      if (method.value == AnaglyphMethod::kTrue || !anaglyph_matrix(method.value, glasses.value)) {
        continue;
      }
      for (int byte = 0; byte < 256; ++byte) {
        CAPTURE(glasses.name, method.name, byte);
        const auto level = std::uint8_t(byte);
        const Rgba8 grey{level, level, level, 255};
        const Rgba8 shown = one_pixel(grey, grey, method.value, glasses.value);
        CHECK(std::abs(shown.r - byte) <= 1);
        CHECK(std::abs(shown.g - byte) <= 1);
        CHECK(std::abs(shown.b - byte) <= 1);
      }
    }
  }
}

TEST_CASE("row sums catch misprints that are passed around: a comma and two signs") {
  auto matrix = anaglyph_matrix(AnaglyphMethod::kDubois2001, Glasses::kRedCyan);
  REQUIRE(matrix);
  CHECK(keeps_white(*matrix));
  matrix->at[1][0] = -0.400822f;
  CHECK_FALSE(keeps_white(*matrix));

  auto green_magenta = anaglyph_matrix(AnaglyphMethod::kDubois, Glasses::kGreenMagenta);
  REQUIRE(green_magenta);
  green_magenta->at[1][5] = 0.065f;
  CHECK_FALSE(keeps_white(*green_magenta));

  auto amber_blue = anaglyph_matrix(AnaglyphMethod::kDubois, Glasses::kAmberBlue);
  REQUIRE(amber_blue);
  amber_blue->at[0][0] = 1;
  CHECK_FALSE(keeps_white(*amber_blue));
}

TEST_CASE("row sums catch a matrix read by columns where it is stored by rows (C-78)") {
  for (const auto& glasses : all_glasses()) {
    CAPTURE(glasses.name);
    const auto matrix = anaglyph_matrix(AnaglyphMethod::kDubois, glasses.value);
    REQUIRE(matrix);
    AnaglyphMatrix transposed;  // each eye's half is transposed
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        transposed.at[row][column] = matrix->at[column][row];
        transposed.at[row][column + 3] = matrix->at[column][row + 3];
      }
    }
    CHECK_FALSE(keeps_white(transposed));
  }
}

TEST_CASE("matrices act in linear light and results are clamped, not wrapped (C-77)") {
  const Rgba8 red{255, 0, 0, 255}, green{0, 255, 0, 255}, blue{0, 0, 255, 255};
  // In the matrix of 2001, green of the left eye lowers the anaglyph's green by 0.0378 and its blue
  // by 0.0206, and red of the right eye lowers its red by 0.0435.
  CHECK(one_pixel(green, red, AnaglyphMethod::kDubois2001, Glasses::kRedCyan) ==
        Rgba8{std::uint8_t(std::lround(code_of(0.500484 - 0.0434706))),
              std::uint8_t(std::lround(code_of(0.378476 - 0.0378246))), 0, 255});
  // Blue alone gives 1.2209 of blue, which is clamped to 1.
  CHECK(one_pixel(blue, blue, AnaglyphMethod::kDubois2001, Glasses::kRedCyan).b == 255);
  // A matrix applied to the bytes themselves would give a red of 128 * 0.4561 = 58.
  const std::uint8_t half_red =
      one_pixel({128, 0, 0, 255}, {0, 0, 0, 255}, AnaglyphMethod::kDubois2001, Glasses::kRedCyan).r;
  CHECK(half_red == std::lround(code_of(0.4561 * light_of(128))));
  CHECK(half_red > 80);
}

// Float sums of six terms, each below 1.3, have an error below 6 * 2^-24 * 4 = 1.5e-6. Multiplied
// by the transfer function's largest slope, 12.92 * 255 bytes, that is 0.005 of a byte.
TEST_CASE("every matrix method agrees with the same sums in double to the byte") {
  Random random(7);
  const Image<Rgba8> left = noise(64, 16, random), right = noise(64, 16, random);
  for (const auto& glasses : all_glasses()) {
    for (const auto& method : all_anaglyph_methods()) {
      const auto matrix = anaglyph_matrix(method.value, glasses.value);
      if (!matrix) continue;
      CAPTURE(glasses.name, method.name);
      const auto shown = make_anaglyph(left, right, method.value, glasses.value);
      REQUIRE(shown);
      double worst = 0;
      for (std::size_t i = 0; i < left.pixels.size(); ++i) {
        const Rgba8 l = left.pixels[i], r = right.pixels[i], s = shown->pixels[i];
        const double eyes[6] = {light_of(l.r), light_of(l.g), light_of(l.b),
                                light_of(r.r), light_of(r.g), light_of(r.b)};
        const std::uint8_t bytes[3] = {s.r, s.g, s.b};
        for (std::size_t row = 0; row < 3; ++row) {
          double light = 0;
          for (std::size_t k = 0; k < 6; ++k) light += double(matrix->at[row][k]) * eyes[k];
          const double exact = code_of(std::clamp(light, 0.0, 1.0));
          worst = std::max(worst, std::abs(exact - bytes[row]));
        }
      }
      CHECK(worst <= 0.505);
    }
  }
}

TEST_CASE("grey, half, true and optimised: which eye's luma or colour each channel shows") {
  const Rgba8 l{200, 40, 90, 255}, r{30, 160, 220, 255};
  const auto luma = [](Rgba8 c) {
    return std::uint8_t(std::lround(
        code_of(0.299 * light_of(c.r) + 0.587 * light_of(c.g) + 0.114 * light_of(c.b))));
  };
  const std::uint8_t yl = luma(l), yr = luma(r);
  using enum AnaglyphMethod;
  using enum Glasses;
  CHECK(one_pixel(l, r, kGrey, kRedCyan) == Rgba8{yl, yr, yr, 255});
  CHECK(one_pixel(l, r, kGrey, kGreenMagenta) == Rgba8{yr, yl, yr, 255});
  CHECK(one_pixel(l, r, kGrey, kAmberBlue) == Rgba8{yl, yl, yr, 255});
  CHECK(one_pixel(l, r, kHalf, kRedCyan) == Rgba8{yl, r.g, r.b, 255});
  CHECK(one_pixel(l, r, kHalf, kGreenMagenta) == Rgba8{r.r, yl, r.b, 255});
  CHECK(one_pixel(l, r, kHalf, kAmberBlue) == Rgba8{l.r, l.g, yr, 255});
  CHECK(one_pixel(l, r, kTrue, kRedCyan) == Rgba8{yl, 0, yr, 255});
  CHECK(one_pixel(l, r, kTrue, kGreenMagenta) == Rgba8{yr, yl, 0, 255});
  CHECK(one_pixel(l, r, kTrue, kAmberBlue) == Rgba8{yl, 0, yr, 255});
  const auto wimmer = std::lround(code_of(0.7 * light_of(l.g) + 0.3 * light_of(l.b)));
  CHECK(one_pixel(l, r, kOptimised, kRedCyan) == Rgba8{std::uint8_t(wimmer), r.g, r.b, 255});
}

TEST_CASE(
    "methods published for red-cyan are refused for other glasses, with what to choose instead") {
  for (const AnaglyphMethod method : {AnaglyphMethod::kOptimised, AnaglyphMethod::kDubois2001}) {
    for (const Glasses glasses : {Glasses::kGreenMagenta, Glasses::kAmberBlue}) {
      const auto refused = make_anaglyph({1, 1}, {1, 1}, method, glasses);
      REQUIRE_FALSE(refused);
      CHECK(refused.error().cause.find(std::string(name_of(glasses))) != std::string::npos);
      CHECK(refused.error().remedy.find("dubois") != std::string::npos);
    }
  }
}

TEST_CASE("eyes of different sizes are refused, and the message says both") {
  const auto refused = make_anaglyph({3, 2}, {2, 3}, AnaglyphMethod::kMask);
  REQUIRE_FALSE(refused);
  CHECK(refused.error().cause.find("3x2") != std::string::npos);
  CHECK(refused.error().cause.find("2x3") != std::string::npos);
  CHECK(make_anaglyph({0, 0}, {0, 0}, AnaglyphMethod::kDubois)->pixels.empty());
}

TEST_CASE("names and descriptions stand in the order of their enum") {
  for (const auto& method : all_anaglyph_methods()) CHECK(name_of(method.value) == method.name);
  for (const auto& glasses : all_glasses()) CHECK(name_of(glasses.value) == glasses.name);
}
