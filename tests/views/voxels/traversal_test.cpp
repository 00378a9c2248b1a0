// The orders in which voxels are visited, compared with brute force, and the statistics of one
// voxel.
#include <tests/support/catch.h>

#include <cmath>

#include <glassbox/base/random.h>

#include "views/voxels/footprint.h"
#include "views/voxels/statistics.h"
#include "views/voxels/traversal.h"
#include "views/voxels/voxel_layers.h"

namespace glassbox::views {
namespace {

const Vector3d kLow(-1, -1, -1), kHigh(1, 1, 1);

std::vector<Vector3d> ring(int count, double radius, double height) {
  std::vector<Vector3d> cameras;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    cameras.emplace_back(radius * std::cos(angle), height, radius * std::sin(angle));
  }
  return cameras;
}

}  // namespace

TEST_CASE("cameras of the slides' cases are told apart (S1-38)") {
  CHECK(classify({{3, 4, 5}}, kLow, kHigh).kind == TraversalKind::kOctant);
  CHECK(classify({{3, 4, 0}}, kLow, kHigh).kind == TraversalKind::kQuadrant);
  CHECK(classify({{3, 4, 0}, {-3, 4, 0}}, kLow, kHigh).kind == TraversalKind::kHalfSpace);
  const Traversal above = classify(ring(8, 5, 3), kLow, kHigh);
  CHECK(above.kind == TraversalKind::kHalfSpace);
  CHECK(above.away == std::array<int, 3>{0, -1, 0});
  CHECK(classify({{3, 3, 0}, {3.5, 0.5, 0}, {0.5, 3.5, 0}}, kLow, kHigh).kind ==
        TraversalKind::kOblique);
  // Cameras inside the box, then all around it (C-90).
  CHECK(classify({{0.5, 0, 0}, {-0.5, 0, 0.2}}, kLow, kHigh).kind == TraversalKind::kEmbedded);
  CHECK(classify(ring(16, 5, 0), kLow, kHigh).kind == TraversalKind::kSurrounded);
  CHECK(classify({{0, 0, 0}, {5, 0, 0}, {-5, 0, 0}}, kLow, kHigh).kind ==
        TraversalKind::kSurrounded);
}

TEST_CASE("no voxel that hides another comes after it in an order that is called one (S1-15)") {
  Random random(23);
  int orders = 0, oblique = 0;
  for (int round = 0; round < 400; ++round) {
    std::vector<Vector3d> cameras;
    const auto anywhere = [&](double far) {
      return Vector3d{random.between(-far, far), random.between(-far, far),
                      random.between(-far, far)};
    };
    const Vector3d middle = anywhere(4);
    const auto count = random.integer(1, 5);
    for (int i = 0; i < count; ++i) cameras.push_back(middle + anywhere(1.5));
    // Every other round spreads the cameras over a plane outside a corner of the box, where no axis
    // has an order.
    if (round % 2 == 1) {
      const Vector3d beyond = anywhere(1).normalized();
      const double least = beyond.cwiseAbs().sum() + 0.2;
      cameras.clear();
      for (int i = 0; i < 5; ++i) {
        const Vector3d place = anywhere(6);
        cameras.push_back(place + (least + random.unit() - beyond.dot(place)) * beyond);
      }
    }
    const Traversal traversal = classify(cameras, kLow, kHigh);
    oblique += traversal.kind == TraversalKind::kOblique;
    for (int pair = 0; pair < 50; ++pair) {
      // Q is anywhere in the box, P is on the line from a camera to it.
      const Vector3d q{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      const Vector3d& camera =
          cameras[std::size_t(random.integer(0, std::int64_t(cameras.size()) - 1))];
      const Vector3d p = camera + random.between(0.01, 0.99) * (q - camera);
      if ((p.array() < -1).any() || (p.array() > 1).any()) continue;
      INFO("round " << round << ", camera " << camera.transpose() << ", P " << p.transpose()
                    << ", Q " << q.transpose());
      for (int axis = 0; axis < 3; ++axis) {
        const int away = traversal.away[std::size_t(axis)];
        if (away == 0) continue;
        ++orders;
        CHECK(away * p[axis] < away * q[axis]);
      }
      if (traversal.kind == TraversalKind::kOblique)
        CHECK(traversal.direction->dot(p) < traversal.direction->dot(q));
    }
  }
  CHECK(orders > 1000);
  CHECK(oblique > 100);
}

TEST_CASE("cameras that brute force finds an order for are not called surrounded") {
  Random random(24);
  for (int round = 0; round < 200; ++round) {
    // All cameras are beyond a plane that is 0.05 from the box, near a corner.
    const Vector3d direction =
        Vector3d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}.normalized();
    const double least = -direction.cwiseAbs().sum() - 0.05;
    std::vector<Vector3d> cameras;
    for (int i = 0; i < 12; ++i) {
      Vector3d place{random.between(-6, 6), random.between(-6, 6), random.between(-6, 6)};
      const double along = direction.dot(place);
      if (along > least) place -= (along - least + random.between(0, 2)) * direction;
      cameras.push_back(place);
    }
    INFO("round " << round << ", direction " << direction.transpose());
    CHECK(classify(cameras, kLow, kHigh).kind < TraversalKind::kEmbedded);
  }
}

TEST_CASE(
    "shells around cameras have every voxel once, and what hides never after what it hides "
    "(S1-38)") {
  VoxelGrid grid;
  grid.count = {20, 15, 11};
  const std::vector<Vector3d> cameras{{8.5, 7.5, 5.5}, {10.5, 6.2, 5.1}, {9.9, 8.8, 6.7}};
  const ShellLayers shells(grid, cameras);
  std::vector<int> shell_of(std::size_t(grid.voxels()), -1);
  const auto index = [&](const VoxelPosition& at) {
    return std::size_t((at.z * 15 + at.y) * 20 + at.x);
  };
  std::int64_t visited = 0;
  for (int k = 0; k < shells.count(); ++k) {
    for (const VoxelRun& run : shells.runs(k)) {
      for (int i = 0; i < run.count; ++i, ++visited) {
        CHECK(shell_of[index(run.at(i))] == -1);
        shell_of[index(run.at(i))] = k;
      }
    }
  }
  // All voxels except the box of those that contain the cameras: 3 x 3 x 2.
  CHECK(visited == grid.voxels() - 18);
  Random random(38);
  for (int round = 0; round < 5000; ++round) {
    const Vector3d q{random.between(0, 20), random.between(0, 15), random.between(0, 11)};
    const Vector3d& camera = cameras[std::size_t(random.integer(0, 2))];
    const Vector3d p = camera + random.unit() * (q - camera);
    const auto shell = [&](const Vector3d& at) {
      return shell_of[index({int(at.x()), int(at.y()), int(at.z())})];
    };
    CHECK(shell(p) <= shell(q));
  }
}

TEST_CASE("a grid along a direction has right-handed unit axes") {
  for (const Vector3d& direction : {Vector3d(0, 0, 1), Vector3d(0, 0, -1), Vector3d(-1, 0, 0),
                                    Vector3d(1, 2, -3), Vector3d(1, 1, 1), Vector3d(-5, 5, 0.1)}) {
    const Matrix3d axes = axes_along(direction.normalized());
    // A few roundings of numbers up to 1.
    CHECK((axes.transpose() * axes - Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-14);
    CHECK(axes.determinant() > 0);
    CHECK((axes.col(2) - direction.normalized()).norm() < 1e-14);
  }
}

TEST_CASE("the axes along any direction are those of Eigen's rotation, to the last bit") {
  Random random(41);
  for (int i = 0; i < 20000; ++i) {
    // Components of many magnitudes, some of them 0.
    Vector3d direction;
    for (double& component : direction)
      component = random.integer(0, 4) == 0 ? 0 : random.scaled(-1, 1, -10, 10);
    if (direction.isZero()) continue;
    const Matrix3d axes = axes_along(direction);
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    const Vector3d from = Vector3d::Unit(axis) * (direction[axis] > 0 ? 1 : -1);
    Eigen::Quaterniond turn;
    turn.setFromTwoVectors(from, direction);
    CHECK(axes.col(2) == turn.toRotationMatrix() * from);
    CHECK(axes.col(0) == turn.toRotationMatrix() * Vector3d::Unit((axis + 1) % 3));
  }
}

TEST_CASE("the variance of numbers far from 0 is theirs, where E[x^2] - E[x]^2 cancels (C-93)") {
  constexpr int kCount = 1000;
  Random random(93);
  Welford welford;
  float sum = 0, squares = 0;
  std::vector<double> numbers;
  for (int i = 0; i < kCount; ++i) {
    const double x = 250 + random.between(-0.01, 0.01);
    numbers.push_back(x);
    welford.add(x);
    sum += float(x);
    squares += float(x) * float(x);
  }
  long double mean = 0, exact = 0;
  for (const double x : numbers) mean += static_cast<long double>(x) / kCount;
  for (const double x : numbers) exact += (x - mean) * (x - mean) / (kCount - 1);
  // The relative error of Welford's method is at most n u kappa, kappa = sqrt(1 + (mean / sigma)^2)
  // = 250 / 0.0058 (Chan, Golub and LeVeque 1983).
  const double bound = kCount * 0x1p-53 * 250 / std::sqrt(double(exact));
  CHECK(std::abs(welford.variance() - double(exact)) <= bound * double(exact));
  const float naive = squares / kCount - (sum / kCount) * (sum / kCount);
  CHECK(std::abs(double(naive) - double(exact)) > 10 * double(exact));

  // For whole numbers the sums are exact up to one division.
  ColorSums sums;
  Welford channels[3];
  for (int i = 0; i < kCount; ++i) {
    const std::int64_t code = 1000 + random.integer(0, 1);
    sums.add(code, code, 1023);
    channels[0].add(double(code));
    channels[1].add(double(code));
    channels[2].add(1023);
  }
  const double pooled = (channels[0].variance() + channels[1].variance()) / 3;
  CHECK(std::abs(sums.variance() - pooled) <= 10 * 0x1p-53 * pooled + bound * pooled);
  CHECK(ColorSums{}.variance() == 0);
}

TEST_CASE("the law of the likelihood ratio has the quantiles of the tables (S1-19)") {
  // Abramowitz and Stegun, table 26.8, with its six digits.
  CHECK(std::abs(chi_squared_quantile(1, 0.05) - 3.84146) < 5e-6);
  CHECK(std::abs(chi_squared_quantile(10, 0.01) - 23.2093) < 5e-5);
  CHECK(std::abs(chi_squared_quantile(60, 0.001) - 99.6072) < 5e-5);
  CHECK(std::abs(chi_squared_quantile(2, 0.5) - 1.38629) < 5e-6);
  CHECK(std::abs(chi_squared_tail(2, 3) - std::exp(-1.5)) < 1e-14);
  CHECK(chi_squared_tail(5, 0) == 1);
}

TEST_CASE("good voxels are rejected as often as the law says (S1-19)") {
  Random random(19);
  // Three channels of K pictures with noise sigma; the sum of 12 uniform numbers is close enough to
  // a normal distribution here.
  const auto noise = [&] {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += random.unit();
    return sum;
  };
  constexpr int kPictures = 8, kVoxels = 20000;
  constexpr double kSigma = 40, kSignificance = 0.05;  // in codes, whose rounding adds 1/12 to 1600
  const double degrees = 3 * (kPictures - 1);
  const double most = chi_squared_quantile(degrees, kSignificance);
  int rejected = 0;
  for (int i = 0; i < kVoxels; ++i) {
    ColorSums sums;
    for (int k = 0; k < kPictures; ++k) {
      const auto code = [&] { return std::int64_t(std::floor(500 + kSigma * noise() + 0.5)); };
      const std::int64_t a = code(), b = code(), c = code();
      sums.add(a, b, c);
    }
    rejected += sums.deviations() / (kSigma * kSigma) >= most;
  }
  // Four deviations of the binomial distribution; the sum of twelve numbers has thinner tails than
  // a normal distribution, by 3 % of this share.
  const double expected = kVoxels * kSignificance;
  const double room = 4 * std::sqrt(expected * (1 - kSignificance)) + 0.03 * expected;
  CHECK(std::abs(rejected - expected) < room);
}

namespace {

// Whether a point is within the projection of a voxel, tested with the triangles of its faces.
bool is_in_projection(const std::array<Vector2d, 8>& c, const Vector2d& p) {
  constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  const auto side = [&](const Vector2d& a, const Vector2d& b) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
  };
  for (const auto& face : kFaces) {
    for (const int last : {2, 3}) {
      const auto at = [&](int i) { return c[std::size_t(face[i])]; };
      const double a = side(at(0), at(last - 1)), b = side(at(last - 1), at(last)),
                   d = side(at(last), at(0));
      if ((a >= 0 && b >= 0 && d >= 0) || (a <= 0 && b <= 0 && d <= 0)) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("footprints have the pixels that brute force finds, and at least the centre's (C-87)") {
  Random random(87);
  for (const double size : {0.1, 0.5, 1.0, 3.0, 10.0}) {
    for (int round = 0; round < 15; ++round) {
      VoxelGrid grid;
      grid.axes =
          axes_along(Vector3d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)}
                         .normalized());
      grid.size = size;
      // 100 px away with f = 100 px, so that a unit is a pixel.
      PackedPicture picture;
      PinholeCamera camera;
      camera.intrinsic << 100, 0, 32, 0, 100, 32, 0, 0, 1;
      const Vector3d middle{random.between(-20, 20), random.between(-20, 20), 100};
      grid.corner = middle - grid.axes * Vector3d::Constant(size / 2);
      picture.pixel_from_world = projection_of(camera);
      picture.width = picture.height = 64;
      const GridPicture lens = grid_picture(grid, picture);
      const Projected centre = projected(row_of(lens, picture, {}, 0), 0);
      std::array<Vector2d, 8> corners;
      for (int i = 0; i < 8; ++i)
        corners[std::size_t(i)] = project(camera, grid.world(i & 1, i >> 1 & 1, i >> 2)).head<2>();
      Image<int> found[3] = {{64, 64, 0}, {64, 64, 0}, {64, 64, 0}};
      const PixelPosition pixel = centre_pixel(centre, 64, 64);
      for (const Footprint footprint : {Footprint::kCentre, Footprint::kBox, Footprint::kHull}) {
        for_each_pixel(lens, centre, footprint,
                       [&](int x, int y) { ++found[std::size_t(footprint)].at(x, y); });
        REQUIRE(found[std::size_t(footprint)].at(pixel.column, pixel.row) == 1);
      }
      // A corner's three products are rounded in double and once to float; then the voxel's centre
      // is added in float, and the sum is divided: 8 roundings of numbers up to 64 px.
      constexpr double kOff = 8 * 64 * 0x1p-24;
      Vector2d least = corners[0], most = corners[0];
      for (const Vector2d& corner : corners) {
        least = least.cwiseMin(corner);
        most = most.cwiseMax(corner);
      }
      for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
          const bool is_centre = x == pixel.column && y == pixel.row;
          const Vector2d p(x + 0.5, y + 0.5);
          // How far the point is inside the bounding box of the corners; negative if outside.
          const double inside = std::min((p - least).minCoeff(), (most - p).minCoeff());
          // Moving the hull's corners away from its middle or towards it by this share moves them
          // by at least kOff.
          const double share = kOff / (size / 2);
          const auto is_near = [&](double room) {
            std::array<Vector2d, 8> larger = corners;
            const Vector2d at = project(camera, middle).head<2>();
            for (Vector2d& corner : larger) corner = at + (corner - at) * (1 + room);
            return is_in_projection(larger, p);
          };
          INFO("voxel of " << size << " px, round " << round << ", pixel " << x << ", " << y);
          CHECK(found[0].at(x, y) == int(is_centre));
          if (!is_centre && is_near(-share)) CHECK(found[2].at(x, y) == 1);
          if (!is_centre && !is_near(share)) CHECK(found[2].at(x, y) == 0);
          if (!is_centre && inside > kOff) CHECK(found[1].at(x, y) == 1);
          if (!is_centre && inside < -kOff) CHECK(found[1].at(x, y) == 0);
          CHECK(found[2].at(x, y) <= found[1].at(x, y));
          CHECK(found[1].at(x, y) <= 1);
        }
      }
    }
  }
}

}  // namespace glassbox::views
