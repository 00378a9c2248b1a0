// Corners: the two responses, which places have none, where a corner is to parts of a pixel, and
// which corners are chosen of many.
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/views/features/generated_pictures.h"
#include "views/features/corners.h"
#include "views/features/scale_level.h"
#include "views/features/spread.h"

#include <glassbox/base/elementary.h>

namespace glassbox::views {
namespace {

using Eigen::Vector2d;

TEST_CASE("the responses are those functions of the eigenvalues that their papers state") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double large = random.between(0, 100);
    const double small = large * random.unit();
    const SinCos turn = sin_cos_degrees(random.between(0, 180));
    // The matrix with these eigenvalues, whose first axis is turned.
    const double a = large * turn.cos * turn.cos + small * turn.sin * turn.sin;
    const double b = (large - small) * turn.cos * turn.sin;
    const double c = large * turn.sin * turn.sin + small * turn.cos * turn.cos;
    const double harris = large * small - 0.04 * (large + small) * (large + small);
    // 100 has an ulp of 2^-46, and its square one of 2^-39; some ten roundings.
    CHECK(std::abs(corner_response(Detector::kShiTomasi, a, b, c) - small) < 0x1p-42);
    CHECK(std::abs(corner_response(Detector::kHarris, a, b, c) - harris) < 0x1p-35);
  }
}

TEST_CASE("the peak of a quadratic function is found exactly, and no peak of any other kind") {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    const double xx = random.between(0.5, 2), yy = random.between(0.5, 2);
    const double xy = random.between(-0.5, 0.5);
    const double sign = i % 4 == 3 ? 1 : -1;  // every fourth is a minimum
    std::array<std::array<double, 3>, 3> values;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        const double dx = column - 1 - x, dy = row - 1 - y;
        values[std::size_t(row)][std::size_t(column)] =
            7 + sign * (xx * dx * dx + yy * dy * dy + xy * dx * dy);
      }
    }
    const auto [found_x, found_y] = quadratic_peak(values);
    CHECK(std::abs(found_x - (sign < 0 ? x : 0)) < 1e-12);
    CHECK(std::abs(found_y - (sign < 0 ? y : 0)) < 1e-12);
  }
  CHECK(quadratic_peak({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}) == std::array{0.0, 0.0});
}

std::vector<PictureCorner> corners_in(const Image<Rgba8>& picture, Detector detector) {
  return corners_of(response_map(finest_level(picture).grey, detector), detector, 16);
}

TEST_CASE("one colour, a ramp and a straight edge have no corners, and a wedge has one") {
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const SinCos turn = sin_cos_degrees(random.between(0, 360));
    const double low = random.between(0, 0.4);
    const double high = random.between(0.6, 1);
    const auto along = [&](const Vector2d& at) {
      return turn.cos * (at.x() - 50) + turn.sin * (at.y() - 40);
    };
    const auto across = [&](const Vector2d& at) {
      return turn.cos * (at.y() - 40) - turn.sin * (at.x() - 50);
    };
    const auto between = [&](double share) {
      return low + (high - low) * std::clamp(share + 0.5, 0.0, 1.0);
    };
    const Image<Rgba8> flat(100, 80, Rgba8{std::uint8_t(i), 7, 200, 255});
    const auto ramp = test::drawn_picture(
        100, 80, {}, 0, [&](const Vector2d& at) { return 0.5 + 0.004 * along(at); });
    const auto edge =
        test::drawn_picture(100, 80, {}, 0, [&](const Vector2d& at) { return between(along(at)); });
    const auto wedge = test::drawn_picture(100, 80, {}, 0, [&](const Vector2d& at) {
      return between(std::min(along(at), across(at)));
    });
    INFO("number " << i << ", from " << low << " to " << high);
    for (const Detector detector : kDetectors) {
      CHECK(corners_in(flat, detector).empty());
      CHECK(corners_in(ramp, detector).empty());
      // The steps of an edge that is drawn with few samples have a small eigenvalue l2. They are
      // below the threshold where the picture has a corner.
      if (detector == Detector::kHarris) CHECK(corners_in(edge, detector).empty());
      const auto corners = corners_in(wedge, detector);
      REQUIRE(corners.size() == 1);
      // The response is largest inside the wedge, as far away as the window is wide.
      CHECK(std::hypot(corners[0].x - 50, corners[0].y - 40) < 1.5 * kWindowSigma);
    }
  }
}

// A checker of squares of `side` px, turned about a corner at `origin`.
struct Checker {
  double side = 20;
  SinCos turn;
  Vector2d origin{0, 0};

  double grey(const Vector2d& at) const {
    const Vector2d from = at - origin;
    const double u = (turn.cos * from.x() + turn.sin * from.y()) / side;
    const double v = (turn.cos * from.y() - turn.sin * from.x()) / side;
    const auto cell = std::int64_t(std::floor(u)) + std::int64_t(std::floor(v));
    return cell % 2 == 0 ? 0.2 : 0.8;
  }
  Vector2d corner(int column, int row) const {
    return origin +
           side * Vector2d(turn.cos * column - turn.sin * row, turn.sin * column + turn.cos * row);
  }
};

TEST_CASE(
    "the corners of a drawn checker are where they were drawn, to a third of rounding to pixels") {
  Random random(4);
  constexpr int kWidth = 160, kHeight = 120;
  for (const Detector detector : kDetectors) {
    double squares = 0, largest = 0;
    int corners = 0, missing = 0, extra = 0;
    for (int seed = 0; seed < 30; ++seed) {
      Checker checker;
      checker.side = random.between(14, 24);
      checker.turn = sin_cos_degrees(random.between(0, 90));
      const double x = random.between(70, 90);
      const double y = random.between(50, 70);
      checker.origin = {x, y};
      const auto picture = test::drawn_picture<8>(
          kWidth, kHeight, {}, 0, [&](const Vector2d& at) { return checker.grey(at); });
      std::vector<PictureCorner> found = corners_in(picture, detector);
      for (int row = -12; row <= 12; ++row) {
        for (int column = -12; column <= 12; ++column) {
          const Vector2d truth = checker.corner(column, row);
          if (truth.x() < 18 || truth.y() < 18 || truth.x() > kWidth - 18 ||
              truth.y() > kHeight - 18) {
            continue;
          }
          const auto nearest = std::ranges::min_element(found, {}, [&](const PictureCorner& c) {
            return (Vector2d(c.x, c.y) - truth).norm();
          });
          const double off = nearest == found.end()
                                 ? std::numeric_limits<double>::infinity()
                                 : (Vector2d(nearest->x, nearest->y) - truth).norm();
          if (off > 1) {
            ++missing;
            continue;
          }
          ++corners;
          squares += off * off;
          largest = std::max(largest, off);
          found.erase(nearest);
        }
      }
      extra += int(std::ranges::count_if(found, [&](const PictureCorner& c) {
        return c.x > 20 && c.y > 20 && c.x < kWidth - 20 && c.y < kHeight - 20;
      }));
    }
    INFO(name_of(detector) << ": " << corners << " corners, rms " << std::sqrt(squares / corners)
                           << " px, largest error " << largest << " px");
    CHECK(corners > 500);
    CHECK(missing == 0);
    CHECK(extra == 0);
    // Rounding to pixel centres is off by up to 0.71 px, and by sqrt(2/12) = 0.41 px rms.
    const double part = detector == Detector::kHarris ? 1.0 / 3 : 2.0 / 3;
    CHECK(std::sqrt(squares / corners) < part * 0.41);
    CHECK(largest < 0.71);
  }
}

TEST_CASE("of equal neighbours one is a corner, and corners are no neighbours") {
  Image<float> map(60, 60, 0.0f);
  for (int y = 20; y < 23; ++y) {
    for (int x = 30; x < 34; ++x) map.at(x, y) = 9;
  }
  const auto corners = corners_of(map, Detector::kShiTomasi, 1);
  REQUIRE(corners.size() == 1);
  CHECK(std::abs(corners[0].x - 30.5) <= 1);
  CHECK(std::abs(corners[0].y - 20.5) <= 1);

  // Where all are different, each pixel above its 8 neighbours is one.
  Random random(6);
  for (float& value : map.pixels) value = float(1 + random.unit());
  int maxima = 0;
  for (int y = 1; y < 59; ++y) {
    for (int x = 1; x < 59; ++x) {
      int below = 0;
      for (int i = 0; i < 9; ++i) below += map.at(x, y) > map.at(x + i % 3 - 1, y + i / 3 - 1);
      maxima += below == 8;
    }
  }
  CHECK(maxima > 300);
  CHECK(corners_of(map, Detector::kShiTomasi, 1).size() == std::size_t(maxima));
  for (const PictureCorner& corner : corners_of(map, Detector::kShiTomasi, 20)) {
    // The fit moves a corner by at most a pixel from the centre of its own.
    CHECK(std::abs(corner.x - 30) < 10.5);
    CHECK(std::abs(corner.y - 30) < 10.5);
  }
  CHECK(corners_of(map, Detector::kShiTomasi, 30).empty());
}

// The rule of spread.h, by comparing all pairs.
std::vector<PictureCorner> spread_slowly(std::vector<PictureCorner> corners, int count, int width,
                                         int height) {
  const double cap = 2 * std::sqrt(width * double(height) / (kPi * count));
  std::vector<std::pair<double, PictureCorner>> all;
  for (const PictureCorner& own : corners) {
    double radius = cap;
    for (const PictureCorner& other : corners) {
      if (0.9 * other.strength <= own.strength) continue;
      radius = std::min(radius, std::sqrt((other.x - own.x) * (other.x - own.x) +
                                          (other.y - own.y) * (other.y - own.y)));
    }
    all.emplace_back(radius, own);
  }
  std::ranges::stable_sort(all, [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second.strength > b.second.strength;
  });
  all.resize(std::min(all.size(), std::size_t(count)));
  std::ranges::sort(
      all, [](const auto& a, const auto& b) { return a.second.strength > b.second.strength; });
  std::vector<PictureCorner> chosen;
  for (const auto& one : all) chosen.push_back(one.second);
  return chosen;
}

std::vector<PictureCorner> random_corners(Random& random, int count, int width, int height) {
  std::vector<PictureCorner> corners;
  // Half of them are crowded into one corner of the picture, and are stronger.
  for (int i = 0; i < count; ++i) {
    const double part = i % 2 == 0 ? 1 : 0.2;
    const double x = random.between(0, part * width);
    const double y = random.between(0, part * height);
    const double strength = exponential(random.between(0, 5));
    corners.push_back({x, y, i % 2 == 0 ? strength : 200 * strength});
  }
  return corners;
}

TEST_CASE("the corners that are chosen are those of largest radius, as all pairs say") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const int width = int(random.integer(1, 400));
    const int height = int(random.integer(1, 300));
    const int count = int(random.integer(0, 600));
    const int wanted = int(random.integer(1, 300));
    const auto corners = random_corners(random, count, width, height);
    const auto chosen = spread_out(corners, wanted, width, height);
    const auto expected = spread_slowly(corners, wanted, width, height);
    INFO("seed " << seed << ": " << wanted << " of " << count);
    REQUIRE(chosen.size() == expected.size());
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      CHECK(chosen[i].x == expected[i].x);
      CHECK(chosen[i].strength == expected[i].strength);
    }
  }
  CHECK(spread_out({{1, 1, 1}}, 0, 10, 10).empty());
}

TEST_CASE("weak corners are chosen where there are no strong ones") {
  Random random(7);
  const auto corners = random_corners(random, 2000, 400, 300);
  const auto is_crowded = [](const PictureCorner& c) { return c.x < 80 && c.y < 60; };
  auto strongest = corners;
  std::ranges::sort(strongest, std::ranges::greater(), &PictureCorner::strength);
  strongest.resize(200);
  const auto chosen = spread_out(corners, 200, 400, 300);
  // A 25th of the picture has more than half of the corners, and all strong ones.
  CHECK(std::ranges::count_if(strongest, is_crowded) == 200);
  CHECK(std::ranges::count_if(chosen, is_crowded) < 40);
}

}  // namespace
}  // namespace glassbox::views
