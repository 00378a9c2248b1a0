#include "tests/support/catch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glassbox/images/stereo/rivalry.h>

#include "tests/images/stereo/pictures.h"

namespace {

using namespace glassbox;
using test::noise;
using enum AnaglyphMethod;

// White, grey, red, green, blue, yellow, cyan, magenta: the colours of the averages in the table of
// B.6.
constexpr Linear kColours[] = {{1, 1, 1}, {0.5f, 0.5f, 0.5f}, {1, 0, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 1, 0},          {0, 1, 1}, {1, 0, 1}};

double mean_rivalry(const AnaglyphViewing& viewing) {
  const Rivalry rivalry(viewing);
  double sum = 0;
  for (const Linear& colour : kColours) sum += rivalry(colour);
  return sum / double(std::size(kColours));
}

double mean_rivalry(AnaglyphMethod method) {
  const auto how = anaglyph_viewing(method);
  REQUIRE(how);
  return mean_rivalry(*how);
}

using Matrix = std::vector<std::vector<double>>;

// Solves a x = b for square matrices a by Gauss-Jordan elimination with row exchanges.
Matrix solve(Matrix a, const Matrix& b) {
  const std::size_t n = a.size();
  for (std::size_t i = 0; i < n; ++i) a[i].insert(a[i].end(), b[i].begin(), b[i].end());
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t pivot = i;
    for (std::size_t row = i; row < n; ++row) {
      if (std::abs(a[row][i]) > std::abs(a[pivot][i])) pivot = row;
    }
    std::swap(a[i], a[pivot]);
    const double scale = a[i][i];
    for (double& value : a[i]) value /= scale;
    for (std::size_t row = 0; row < n; ++row) {
      if (row == i) continue;
      const double factor = a[row][i];
      for (std::size_t k = 0; k < a[row].size(); ++k) a[row][k] -= factor * a[i][k];
    }
  }
  for (auto& row : a) row.erase(row.begin(), row.begin() + std::ptrdiff_t(n));
  return a;
}

// Returns the matrix whose light through the lenses comes closest, in the sense of least squares in
// XYZ with equal weights, to what the eyes would see of the two pictures without glasses. Then each
// row is scaled to keep white.
AnaglyphMatrix least_squares() {
  std::array<std::array<double, 3>, 6> through{};
  std::array<std::array<double, 6>, 6> wanted{};
  for (std::size_t i = 0; i < 3; ++i) {
    through[i] = kRedLensLight[i];
    through[i + 3] = kCyanLensLight[i];
    for (std::size_t j = 0; j < 3; ++j) {
      wanted[i][j] = wanted[i + 3][j + 3] = kScreenLight[i][j];
    }
  }
  Matrix normal(3, std::vector<double>(3)), right(3, std::vector<double>(6));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 6; ++k) {
      for (std::size_t j = 0; j < 3; ++j) normal[i][j] += through[k][i] * through[k][j];
      for (std::size_t j = 0; j < 6; ++j) right[i][j] += through[k][i] * wanted[k][j];
    }
  }
  const Matrix solution = solve(normal, right);
  AnaglyphMatrix matrix;
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0;
    for (const double value : solution[i]) sum += value;
    for (std::size_t j = 0; j < 6; ++j) matrix.at[i][j] = float(solution[i][j] / sum);
  }
  return matrix;
}

double furthest_entry(const AnaglyphMatrix& one, const AnaglyphMatrix& other) {
  double furthest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      furthest = std::max(furthest, std::abs(double(one.at[i][j]) - double(other.at[i][j])));
    }
  }
  return furthest;
}

}  // namespace

TEST_CASE(
    "content measure: whites, greys, yellows and magentas suit red-cyan, pure colours do not "
    "(S0-14)") {
  for (const Linear& good : {kColours[0], kColours[1], kColours[5], kColours[7]}) {
    CHECK(content_measure(good) == 1);
  }
  for (const Linear& bad : {kColours[2], kColours[3], kColours[4], kColours[6]}) {
    CHECK(content_measure(bad) == 0);
  }
  CHECK(content_measure({0, 0, 0}) == 1);
  CHECK(content_measure({0.25f, 0.5f, 0.125f}) == 0.5);
  CHECK(content_measure({0.5f, 0.125f, 0.0625f}) == 0.25);
  // The other glasses have good and bad colours of their own.
  CHECK(content_measure({1, 1, 0}, Glasses::kAmberBlue) == 0);
  CHECK(content_measure({1, 0, 1}, Glasses::kAmberBlue) == 1);
  CHECK(content_measure({1, 0, 1}, Glasses::kGreenMagenta) == 0);
  CHECK(content_measure({1, 1, 0}, Glasses::kGreenMagenta) == 1);
}

// The tolerance is half of the last printed digit. B.6 prints .062 for dubois2001, which the
// least-squares matrix gives; the published matrix gives .0656.
TEST_CASE("rivalry averaged over eight colours: the table of B.6") {
  CHECK(std::abs(mean_rivalry(kMask) - 0.411) <= 0.0005);
  CHECK(std::abs(mean_rivalry(kHalf) - 0.123) <= 0.0005);
  CHECK(std::abs(mean_rivalry(kDubois) - 0.075) <= 0.0005);
  CHECK(std::abs(mean_rivalry(kDubois2001) - 0.0656) <= 0.00005);
  CHECK(std::abs(mean_rivalry({least_squares(), lenses_of(Glasses::kRedCyan)}) - 0.062) <= 0.0005);
  CHECK(std::abs(mean_rivalry(kOptimised) - 0.036) <= 0.0005);
  CHECK(mean_rivalry(kGrey) <= 1e-6);  // luma's weights add up to 1 within 2^-24 in float
  CHECK(mean_rivalry(kTrue) <= 1e-6);
}

TEST_CASE("desaturation reaches half-colour at k = .70 and the least-squares matrix at .85 (B.6)") {
  const auto mask = anaglyph_viewing(kMask);
  REQUIRE(mask);
  const double full = mean_rivalry(*mask);
  CHECK(std::abs(1 - mean_rivalry(kHalf) / full - 0.70) <= 0.005);
  CHECK(std::abs(1 - mean_rivalry({least_squares(), mask->lenses}) / full - 0.85) <= 0.005);
}

TEST_CASE(
    "unweighted least squares comes within 0.071 of every entry of Dubois 2001, and not much "
    "closer") {
  const auto published = anaglyph_matrix(kDubois2001, Glasses::kRedCyan);
  REQUIRE(published);
  const double furthest = furthest_entry(least_squares(), *published);
  CHECK(furthest <= 0.071);
  CHECK(furthest >= 0.07);
}

TEST_CASE(
    "white of the other eye leaks 15.5 % to the left and 4.6 % to the right wherever all channels "
    "are used") {
  for (const auto& method : all_anaglyph_methods()) {
    CAPTURE(method.name);
    const auto how = anaglyph_viewing(method.value);
    REQUIRE(how);
    const Ghosts leak = white_leak(*how);
    if (method.value == kTrue) {  // only red and blue leak: .0018 of .0876, .0176 of .0777
      CHECK(std::abs(leak.left - 0.0018 / 0.0876) <= 1e-6);
      CHECK(std::abs(leak.right - 0.0176 / 0.0777) <= 1e-6);
    } else {
      CHECK(std::abs(leak.left - 0.155) <= 0.0005);
      CHECK(std::abs(leak.right - 0.046) <= 0.0005);
    }
  }
  // Ideal lenses do not leak.
  const auto ideal = anaglyph_viewing(kMask, Glasses::kAmberBlue);
  REQUIRE(ideal);
  CHECK_FALSE(ideal->lenses.measured);
  CHECK(white_leak(*ideal).left == 0);
  CHECK(white_leak(*ideal).right == 0);
}

TEST_CASE("the rivalry map has each pixel's rivalry, and its mean is theirs") {
  const auto mask = anaglyph_viewing(kMask);
  REQUIRE(mask);
  Image<Rgba8> picture(4, 2, {255, 255, 255, 255});
  picture.at(1, 0) = {255, 0, 0, 255};
  picture.at(3, 1) = {0, 255, 0, 255};
  const Image<float> map = rivalry_map(picture, *mask);
  // For red .0876/.1012 - .0176/.4041, for green .0118/.1012 - .3088/.4041.
  const double red = 0.0876 / 0.1012 - 0.0176 / 0.4041, green = 0.3088 / 0.4041 - 0.0118 / 0.1012;
  CHECK(map.at(0, 0) == 0);
  CHECK(std::abs(double(map.at(1, 0)) - red) <= 1e-6);
  CHECK(std::abs(double(map.at(3, 1)) - green) <= 1e-6);
  CHECK(std::abs(mean_of(map) - (red + green) / 8) <= 1e-6);
  CHECK(mean_of(Image<float>{}) == 0);
}

// Computed by hand for the mask method: the left lens lets some of the right picture's green and
// blue through, the right lens some of the left picture's red.
TEST_CASE("ghost maps show what of the other eye's picture comes through") {
  const auto mask = anaglyph_viewing(kMask);
  REQUIRE(mask);
  Random random(17);
  const Image<Rgba8> left = noise(9, 5, random), right = noise(9, 5, random);
  const auto ghosts = ghost_maps(left, right, *mask);
  REQUIRE(ghosts);
  for (std::size_t i = 0; i < left.pixels.size(); ++i) {
    const Linear l = linear_of(left.pixels[i]), r = linear_of(right.pixels[i]);
    const double to_left = (0.0118 * double(r[1]) + 0.0018 * double(r[2])) / 0.0876;
    const double to_right = 0.0176 * double(l[0]) / (0.3088 + 0.0777);
    CHECK(std::abs(double(ghosts->left.pixels[i]) - to_left) <= 1e-6);
    CHECK(std::abs(double(ghosts->right.pixels[i]) - to_right) <= 1e-6);
  }
  CHECK_FALSE(ghost_maps(left, {1, 1}, *mask));
}

TEST_CASE("viewing refuses what has no matrix") {
  CHECK_FALSE(anaglyph_viewing(kDubois2001, Glasses::kAmberBlue));
}
