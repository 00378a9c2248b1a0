// Glyphs: their codes, the rules by which they are told from what is none, and the camera from them.
#include <tests/support/catch.h>

#include <cmath>
#include <limits>
#include <set>

#include <glassbox/base/random.h>

#include "views/glyphs/colors.h"
#include "views/glyphs/decoys.h"
#include "views/glyphs/photograph.h"
#include "views/glyphs/pose.h"
#include "views/glyphs/sweep.h"

namespace glassbox::views {
namespace {

std::array<bool, kGlyphs> all_glyphs() {
  std::array<bool, kGlyphs> all{};
  all.fill(true);
  return all;
}

std::vector<SeenPoint> points_seen(const Wall& wall, const PinholeCamera& camera, std::size_t count,
                                   std::size_t step) {
  std::vector<SeenPoint> points;
  for (std::size_t i = 0; i < count; ++i) {
    const WallGlyph& glyph = wall.glyphs[i * step % wall.glyphs.size()];
    const WallPanel& panel = wall.panels[std::size_t(glyph.panel)];
    SeenPoint point{glyph.centre, {}, wall.radius() * panel.right, wall.radius() * panel.down};
    point.pixel = centre_seen(camera, point);
    points.push_back(point);
  }
  return points;
}

}  // namespace

TEST_CASE("120 identities are 120 ordered triples of different colours, and back (S1-24)") {
  std::set<GlyphCode> codes;
  for (int identity = 0; identity < kGlyphs; ++identity) {
    const GlyphCode code = code_of(identity);
    CHECK(identity_of(code) == identity);
    CHECK(codes.insert(code).second);
  }
  for (int i = -1; i <= kPrototypes; ++i) {
    for (int j = -1; j <= kPrototypes; ++j) {
      for (int k = -1; k <= kPrototypes; ++k)
        CHECK(identity_of({i, j, k}).has_value() == codes.contains({i, j, k}));
    }
  }
}

TEST_CASE(
    "no mixture of two prototypes, or of one and paper, is taken for a third at T = 0.4 (S1-28)") {
  std::vector<Light> lights{Light(1, 1, 1)};
  const auto decoded = [](std::uint8_t code) {
    const float value = float(code) / 255;
    return std::pow((value + 0.055f) / 1.055f, 2.4f);
  };
  for (const Rgba8& color : kPrototypeColors)
    lights.emplace_back(decoded(color.r), decoded(color.g), decoded(color.b));
  int taken_by_nearest = 0;
  for (int i = 0; i <= kPrototypes; ++i) {
    for (int k = 0; k < i; ++k) {
      for (int step = 0; step <= 100; ++step) {
        const float share = float(step) / 100;
        const Light mixed = share * lights[std::size_t(i)] + (1 - share) * lights[std::size_t(k)];
        const int prototype = prototype_of(codes_of(mixed), 0.4f);
        INFO(i << " and " << k << ", " << share);
        CHECK((prototype == kNoPrototype || prototype == i - 1 || prototype == k - 1));
        const int nearest = prototype_of(codes_of(mixed), INFINITY);
        taken_by_nearest += nearest != i - 1 && nearest != k - 1;
      }
    }
  }
  // Without a threshold they are.
  CHECK(taken_by_nearest > 100);
}

TEST_CASE("each rule leaves out what no other one does, and no glyph (S1-26)") {
  const DecoyPicture picture = draw_decoys();
  const DecoyScore all = score_decoys(picture, {});
  CHECK(all.found == all.glyphs);
  CHECK(all.all_taken() == 0);
  // Of each row those that are taken without its rule, and of no other: docs/glyphs.md has them.
  constexpr std::array<int, kGlyphRules> kTaken{2, 6, 12, 12, 12, 12, 2, 12, 12};
  for (int rule = 0; rule < kGlyphRules; ++rule) {
    FindSettings some;
    some.asks[std::size_t(rule)] = false;
    std::array<int, kGlyphRules> alone{};
    alone[std::size_t(rule)] = kTaken[std::size_t(rule)];
    const DecoyScore without = score_decoys(picture, some);
    INFO("without " << name_of(GlyphRule(rule)));
    CHECK(without.found == without.glyphs);
    CHECK(without.taken == alone);
  }
}

TEST_CASE(
    "of glyphs at least 20 px across 29 of 30 are found, none is wrong, and the camera is within "
    "0.1 degree and 2 mm at 2 m") {
  const Wall wall = *make_wall({});
  GlyphScore all;
  for (const auto& [azimuth, width] :
       {std::pair(0.0, 480), std::pair(25.0, 480), std::pair(-12.0, 640)}) {
    INFO(azimuth << " degrees, " << width << " px");
    const int height = width * 3 / 4;
    const PinholeCamera camera = camera_before(2, azimuth, 3, width, height);
    const FoundGlyphs found =
        find_glyphs(photograph_of(wall, camera, width, height), {}, all_glyphs());
    auto visible = visible_glyphs(wall, camera, width, height);
    std::erase_if(visible, [](const VisibleGlyph& glyph) { return glyph.shorter < 20; });
    const GlyphScore score = score_of(found, wall, camera, visible);
    CHECK(score.visible >= 30);
    CHECK(score.wrong == 0);
    CHECK(30 * score.right >= 29 * score.visible);
    for (const LensKnown known : {LensKnown::kAll, LensKnown::kCentre, LensKnown::kSquare}) {
      const auto pose =
          find_pose(points_of(found, wall).points, {known, camera.intrinsic, width, height, 2});
      REQUIRE(pose);
      const PoseError error = pose_error(pose->camera, camera);
      CHECK(error.degrees < 0.1);
      CHECK(error.distance < 0.002);
    }
  }
}

TEST_CASE("blur, JPEG, another white and things before the wall lose glyphs, and make none wrong") {
  const Wall wall = *make_wall({});
  const int width = 640, height = 480;
  const PinholeCamera camera = camera_before(2, 8, 3, width, height);
  const Image<Rgba8> picture = photograph_of(wall, camera, width, height);
  const auto score_in = [&](const Image<Rgba8>& changed, const FindSettings& settings) {
    return score_of(find_glyphs(changed, settings, all_glyphs()), wall, camera,
                    visible_glyphs(wall, camera, width, height));
  };
  const GlyphScore clean = score_in(picture, {});
  CHECK(clean.recall() > 0.95);
  for (const Image<Rgba8>& changed :
       {blurred(picture, 0.7), through_jpeg(picture, 80), with_gains(picture, {0.9, 0.7, 0.5}),
        occluded(picture, 0.2, 3).picture}) {
    const GlyphScore score = score_in(changed, {});
    CHECK(score.wrong == 0);
    CHECK(score.right > 20);
    CHECK(score.right <= clean.right);
  }
  // What the balance is good for.
  FindSettings as_they_are;
  as_they_are.balances = false;
  const Image<Rgba8> tinted = with_gains(picture, {0.9, 0.6, 0.4});
  CHECK(score_in(tinted, as_they_are).right < score_in(tinted, {}).right);
}

TEST_CASE("three points have up to four cameras, one of which is the right one") {
  Random random(3);
  const Wall wall = *make_wall({});
  int most = 0;
  for (int i = 0; i < 500; ++i) {
    const PinholeCamera camera = camera_before(random.between(1, 4), random.between(-30, 30),
                                               random.between(-40, 40), 640, 480);
    std::array<SeenPoint, 3> points;
    for (SeenPoint& point : points) {
      point = {wall.glyphs[std::size_t(random.integer(0, kGlyphs - 1))].centre, {}};
      point.pixel = project(camera, point.world).head<2>();
    }
    const double area =
        (points[1].world - points[0].world).cross(points[2].world - points[0].world).norm();
    const auto cameras = cameras_of_three(camera.intrinsic, points);
    most = std::max(most, int(cameras.size()));
    if (area < 0.02) continue;
    double least = INFINITY;
    for (const PinholeCamera& one : cameras)
      least = std::min(least, pose_error(one, camera).distance);
    INFO("run " << i << ", area " << area);
    // Twice as many digits are lost where two of the four are one.
    CHECK(least < 1e-5);
  }
  CHECK(most > 1);
  CHECK(most <= 4);
  const Vector3d a(0, 0, 0), b(1, 0, 0), c(2, 0, 0);
  CHECK(cameras_of_three(Matrix3d::Identity(), {SeenPoint{a, {0, 0}}, {b, {1, 0}}, {c, {2, 0}}})
            .empty());
}

TEST_CASE("six points of two planes decide the camera and its lens, six of one plane do not") {
  const Wall wall = *make_wall({});
  Random random(6);
  for (int i = 0; i < 50; ++i) {
    PinholeCamera camera =
        camera_before(2, random.between(-30, 30), random.between(-20, 20), 640, 480);
    camera.intrinsic << 700, 3, 300, 0, 680, 250, 0, 0, 1;
    std::vector<SeenPoint> points = points_seen(wall, camera, 12, 37);
    for (SeenPoint& point : points) point.pixel = project(camera, point.world).head<2>();
    const auto found = camera_by_dlt(points);
    REQUIRE(found);
    CHECK((found->intrinsic - camera.intrinsic).norm() < 1e-6);
    CHECK(pose_error(*found, camera).distance < 1e-8);
    std::erase_if(points, [](const SeenPoint& point) { return point.world.x() > 0; });
    if (points.size() >= 6) CHECK_FALSE(camera_by_dlt(points));
  }
}

TEST_CASE(
    "wrong glyphs are found out by those that agree, and the centre of an ellipse is not that of "
    "its disc") {
  const Wall wall = *make_wall({});
  const PinholeCamera camera = camera_before(1.2, 30, 10, 800, 600);
  std::vector<SeenPoint> points = points_seen(wall, camera, 40, 3);
  double apart = 0;
  for (const SeenPoint& point : points)
    apart = std::max(apart, (project(camera, point.world).head<2>() - point.pixel).norm());
  CHECK(apart > 0.2);
  for (std::size_t i = 0; i < 12; ++i) points[i].pixel += Vector2d(30 + double(i), -25);
  for (const LensKnown known : {LensKnown::kAll, LensKnown::kCentre}) {
    const auto pose = find_pose(points, {known, camera.intrinsic, 800, 600, 2});
    REQUIRE(pose);
    CHECK(pose->inliers == 28);
    CHECK(pose_error(pose->camera, camera).distance < 1e-6);
  }
}

TEST_CASE("cameras that too few glyphs, one plane or disagreement leave open are refused") {
  const Wall wall = *make_wall({});
  const PinholeCamera camera = camera_before(2, 0, 0, 640, 480);
  CHECK_FALSE(
      find_pose(points_seen(wall, camera, 3, 7), {LensKnown::kAll, camera.intrinsic, 640, 480, 2}));
  CHECK_FALSE(find_pose(points_seen(wall, camera, 5, 7), {LensKnown::kCentre, {}, 640, 480, 2}));
  auto flat = points_seen(wall, camera, 60, 1);
  const auto refused = find_pose(flat, {LensKnown::kCentre, {}, 640, 480, 2});
  REQUIRE_FALSE(refused);
  CHECK(refused.error().message().find("one plane") != std::string::npos);
  Random random(9);
  for (SeenPoint& point : flat) point.pixel = {random.between(0, 640), random.between(0, 480)};
  CHECK_FALSE(find_pose(flat, {LensKnown::kAll, camera.intrinsic, 640, 480, 2}));
}

TEST_CASE("walls of too many glyphs, or of glyphs that touch, are refused") {
  WallLayout layout;
  CHECK(make_wall(layout)->glyphs.size() == 120);
  layout.first = 1;
  CHECK_FALSE(make_wall(layout));
  layout.first = std::numeric_limits<int>::max();
  CHECK_FALSE(make_wall(layout));
  layout = {};
  layout.diameter = 0.11;
  CHECK_FALSE(make_wall(layout));
  layout = {};
  layout.panels = 3;
  CHECK_FALSE(make_wall(layout));
  layout = {};
  layout.pitch = std::nan("");
  CHECK_FALSE(make_wall(layout));
  layout = {};
  CHECK_FALSE(check_panel_picture(*make_wall(layout), 1e6));
}

TEST_CASE("pictures of noise, of one colour and of one pixel have no glyphs") {
  Random random(12);
  Image<Rgba8> noise(200, 150);
  for (Rgba8& pixel : noise.pixels) {
    const std::uint64_t bits = random.bits();
    pixel = {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16), 255};
  }
  CHECK(find_glyphs(noise, {}, all_glyphs()).glyphs() == 0);
  for (const std::uint8_t grey : {std::uint8_t(0), std::uint8_t(255)}) {
    CHECK(find_glyphs(Image<Rgba8>(64, 48, {grey, grey, grey, 255}), {}, all_glyphs()).glyphs() ==
          0);
    CHECK(find_glyphs(Image<Rgba8>(1, 1, {grey, 0, 0, 255}), {}, all_glyphs()).glyphs() == 0);
  }
  CHECK(find_glyphs({}, {}, all_glyphs()).regions.empty());
}

TEST_CASE("JPEG at its best quality changes greys by little, and at its worst by much") {
  Image<Rgba8> ramp(33, 17);
  for (int y = 0; y < 17; ++y) {
    for (int x = 0; x < 33; ++x) {
      const auto grey = std::uint8_t(7 * x);
      ramp.at(x, y) = {grey, grey, grey, 255};
    }
  }
  const auto worst = [&](int quality) {
    const Image<Rgba8> again = through_jpeg(ramp, quality);
    int most = 0;
    for (std::size_t i = 0; i < ramp.pixels.size(); ++i)
      most = std::max(most, std::abs(int(again.pixels[i].r) - int(ramp.pixels[i].r)));
    return most;
  };
  // Steps of 1: each of 64 coefficients is off by at most 1/2, in an orthonormal basis by 4 at the very most, then a rounding.
  CHECK(worst(100) <= 5);
  CHECK(worst(1) > 10);
}

}  // namespace glassbox::views
