// Glyphs: their codes, walls of glyphs, and the rules that distinguish glyphs from other things.
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>

#include "views/glyphs/colors.h"
#include "views/glyphs/decoys.h"
#include "views/glyphs/glyph_score.h"
#include "views/glyphs/picture_effects.h"
#include "views/glyphs/pose.h"
#include "views/glyphs/sensor.h"
#include "views/glyphs/sweep.h"

namespace glassbox::views {
namespace {

std::array<bool, kGlyphs> all_glyphs() {
  std::array<bool, kGlyphs> all{};
  all.fill(true);
  return all;
}

struct WallPicture {
  Wall wall;
  PinholeCamera camera;
  Image<Rgba8> picture;
};
WallPicture wall_picture_by(WallPhotographer& photographer, const WallLayout& layout,
                            double azimuth, int width) {
  WallPicture seen{*make_wall(layout), {}, {}};
  const int height = width * 3 / 4;
  seen.camera = camera_in_front(2, azimuth, 3, width, height);
  seen.picture = photographer.photograph(seen.camera, width, height);
  return seen;
}

// A picture of the default wall, which is prepared once for all cases.
WallPicture wall_picture(double azimuth, int width) {
  static WallPhotographer photographer(*make_wall({}));
  return wall_picture_by(photographer, {}, azimuth, width);
}

WallPicture picture_of_wall(const WallLayout& layout, double azimuth, int width) {
  WallPhotographer photographer(*make_wall(layout));
  return wall_picture_by(photographer, layout, azimuth, width);
}

// The score of the glyphs that the camera sees at least `across` px large, in `picture`, which may
// differ from the camera's own picture.
GlyphScore score_in(const WallPicture& seen, const Image<Rgba8>& picture,
                    const FindSettings& settings, double across = 0) {
  auto visible = visible_glyphs(seen.wall, seen.camera, picture.width, picture.height);
  std::erase_if(visible, [&](const VisibleGlyph& glyph) { return glyph.shorter < across; });
  return glyph_score(find_glyphs(picture, settings, seen.wall.identities()), seen.wall, seen.camera,
                     visible);
}

// At least 29 of 30 glyphs must be right, and none may be wrong.
void check_found(const GlyphScore& score) {
  CHECK(score.visible >= 30);
  CHECK(score.wrong == 0);
  CHECK(30 * score.right >= 29 * score.visible);
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
  // 0.4 is close to the largest possible threshold: half red and half green is 82 codes from
  // yellow, whose nearest other prototype is 192 away: 0.427.
  const Light red_and_green = (lights[1] + lights[2]) / 2;
  CHECK(prototype_of(codes_of(red_and_green), 0.42f) == kNoPrototype);
  CHECK(prototype_of(codes_of(red_and_green), 0.43f) == 5);
  // Without a threshold, yellow takes all mixtures of the two that are nearer to it than to either.
  CHECK(taken_by_nearest > 100);
}

TEST_CASE("each rule leaves out what no other one does, and no glyph (S1-26)") {
  const DecoyPicture picture = draw_decoys();
  const DecoyScore all = score_decoys(picture, {});
  CHECK(all.found == all.glyphs);
  CHECK(all.all_accepted() == 0);
  // The number of decoys in each row that are taken without the row's rule; decoys of other rows
  // are not taken. docs/glyphs.md lists them.
  constexpr std::array<int, kGlyphRules> kTaken{2, 6, 12, 12, 12, 12, 2, 12, 12};
  for (int rule = 0; rule < kGlyphRules; ++rule) {
    FindSettings some;
    some.enabled_rules[std::size_t(rule)] = false;
    std::array<int, kGlyphRules> alone{};
    alone[std::size_t(rule)] = kTaken[std::size_t(rule)];
    const DecoyScore without = score_decoys(picture, some);
    INFO("without " << name_of(GlyphRule(rule)));
    CHECK(without.found == without.glyphs);
    CHECK(without.accepted == alone);
  }
}

TEST_CASE(
    "of glyphs at least 20 px across 29 of 30 are found, none is wrong, and the camera is within "
    "0.1 degree and 2 mm at 2 m") {
  for (const auto& [azimuth, width] :
       {std::pair(0.0, 480), std::pair(25.0, 480), std::pair(-12.0, 640)}) {
    INFO(azimuth << " degrees, " << width << " px");
    const WallPicture seen = wall_picture(azimuth, width);
    const FoundGlyphs found = find_glyphs(seen.picture, {}, all_glyphs());
    check_found(score_in(seen, seen.picture, {}, 20));
    const std::vector<PointCorrespondence> points = points_of(found, seen.wall).points;
    for (const KnownIntrinsics known :
         {KnownIntrinsics::kAll, KnownIntrinsics::kCentre, KnownIntrinsics::kSquare}) {
      const auto pose =
          find_pose(points, {known, seen.camera.intrinsic, width, seen.picture.height, 2});
      REQUIRE(pose);
      const PoseError error = pose_error(pose->camera, seen.camera);
      CHECK(error.degrees < 0.1);
      CHECK(error.distance < 0.002);
    }
  }
}

namespace {

// Means over all glyphs that are found: of the squared error of their centres, of the squared error
// that is allowed (both in px^2), and of how much larger than the camera's picture of them they
// are.
struct CentreErrors {
  double squares = 0, allowed = 0, larger = 0;
};
CentreErrors centre_errors(const WallPicture& seen, const Image<Rgba8>& picture) {
  const FoundGlyphs found = find_glyphs(picture, {}, all_glyphs());
  const GlyphPoints points = points_of(found, seen.wall);
  REQUIRE(points.points.size() >= 100);
  const auto visible = visible_glyphs(seen.wall, seen.camera, picture.width, picture.height);
  const double count = double(points.points.size());
  CentreErrors errors;
  for (std::size_t i = 0; i < points.points.size(); ++i) {
    const GlyphRegion& region = found.regions[points.regions[i]];
    const Vector2d off = region.ellipse.centre - project_centre(seen.camera, points.points[i]);
    errors.squares += off.squaredNorm() / count;
    const auto there = std::ranges::find(visible, region.identity, &VisibleGlyph::identity);
    if (there != visible.end())
      errors.larger += (region.ellipse.diameter() / there->diameter - 1) / count;
    // A circle of radius r crosses 8 r pixels, whose shares are off by at most an eighth, evenly
    // distributed: a variance of 1/192 each. A share moves the centre by r / (pi r^2) of its error,
    // so both axes together have 8 r / 192 / (pi r)^2.
    const double r = region.ellipse.diameter() / 2;
    errors.allowed += 8 * r / 192 / (kPi * kPi * r * r) / count;
  }
  return errors;
}

}  // namespace

TEST_CASE("where a glyph is, and how large, is known as well as four samples a pixel allow") {
  const WallPicture seen = wall_picture(5, 640);
  const CentreErrors errors = centre_errors(seen, seen.picture);
  INFO(std::sqrt(errors.squares) << " px of " << std::sqrt(errors.allowed));
  // Errors of half a pixel in one coordinate, or of counting border pixels wholly or not at all,
  // are far larger.
  CHECK(errors.squares < 2 * errors.allowed);
  // Shares that are rounded to paper are lost: 0.04 of a border pixel, 8 r of them in pi r^2, 0.5 %
  // of a diameter of 25 px.
  CHECK(std::abs(errors.larger) < 0.005);
  // With darker corners, the paper's colour is taken around each glyph: with that of the whole
  // picture a tenth of the ring would count as glyph.
  const CentreErrors darker = centre_errors(seen, apply_sensor(seen.picture, {.falloff = 0.3}, 1));
  INFO("darker: " << std::sqrt(darker.squares) << " px, " << darker.larger);
  CHECK(std::abs(darker.larger) < 0.01);
}

TEST_CASE("glyphs are found through blur, JPEG, another white, tilt, and beside each other") {
  const WallPicture seen = wall_picture(8, 640);
  check_found(score_in(seen, seen.picture, {}));
  for (const auto& [what, changed] : {std::pair("blur", blurred(seen.picture, 0.7)),
                                      {"JPEG", apply_jpeg(seen.picture, 80)},
                                      {"white", with_gains(seen.picture, {0.9, 0.6, 0.4})}}) {
    INFO(what);
    check_found(score_in(seen, changed, {}));
  }
  // Without the paper's white only glyphs far from the borders of their classes are right: blue
  // times 0.4 is code 146, not 224.
  FindSettings as_they_are;
  as_they_are.balances = false;
  const GlyphScore tinted = score_in(seen, with_gains(seen.picture, {0.9, 0.6, 0.4}), as_they_are);
  CHECK(tinted.wrong == 0);
  CHECK(2 * tinted.right < tinted.visible);
  {
    INFO("tilt");
    WallLayout flat;
    flat.panels = 1;
    flat.columns = 12;
    const WallPicture tilted = picture_of_wall(flat, 50, 800);
    check_found(score_in(tilted, tilted.picture, {}, 20));
  }
  {
    INFO("an eighth of the pitch between two");
    WallLayout close;
    close.diameter = 0.105;
    const WallPicture beside = picture_of_wall(close, 5, 640);
    const Image<Rgba8> soft = blurred(beside.picture, 0.5);
    check_found(score_in(beside, soft, {}));
    const auto pose = find_pose(points_of(find_glyphs(soft, {}, all_glyphs()), beside.wall).points,
                                {KnownIntrinsics::kAll, beside.camera.intrinsic, 640, 480, 2});
    REQUIRE(pose);
    CHECK(pose->rms < 0.1);
  }
}

TEST_CASE("a light that falls off and a highlight that outshines the paper change nothing") {
  const WallPicture seen = wall_picture(8, 640);
  Image<Rgba8> uneven = seen.picture;
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      const double left = 1 - 0.25 * x / 640, right = 0.75 + 0.25 * x / 640;
      Image<Rgba8> one(1, 1, uneven.at(x, y));
      uneven.at(x, y) = with_gains(one, {0.6 * left, 0.6, 0.6 * right}).at(0, 0);
    }
  }
  for (int y = 2; y < 14; ++y) {
    for (int x = 2; x < 90; ++x) uneven.at(x, y) = {255, 255, 255, 255};
  }
  check_found(score_in(seen, uneven, {}));
}

TEST_CASE("what stands before the wall hides glyphs that it touches, and no others") {
  const WallPicture seen = wall_picture(8, 640);
  const OccludedPicture hidden = occluded(seen.picture, 0.15, 3);
  auto clear = visible_glyphs(seen.wall, seen.camera, 640, 480);
  // Keeps the glyphs of which nothing is covered, including the ring of paper that their colours
  // are compared with.
  std::erase_if(clear, [&](const VisibleGlyph& glyph) {
    const double reach = 1.45 * glyph.diameter / 2;
    for (int y = 0; y < 480; ++y) {
      for (int x = 0; x < 640; ++x) {
        if (hidden.covered.at(x, y) != 0 &&
            (Vector2d(x + 0.5, y + 0.5) - glyph.centre).norm() < reach)
          return true;
      }
    }
    return false;
  });
  check_found(
      glyph_score(find_glyphs(hidden.picture, {}, all_glyphs()), seen.wall, seen.camera, clear));
}

TEST_CASE("a panel's discs have their areas, in light") {
  WallLayout layout;
  layout.panels = 1;
  layout.columns = layout.rows = 1;
  layout.first = 23;
  const Wall wall = *make_wall(layout);
  constexpr double kPixels = 1000;  // per metre: the glyph is 90 px across
  const Image<Rgba8> panel = draw_panel(wall, 0, kPixels);
  REQUIRE(panel.width == 120);
  std::array<double, 3> areas{};  // of the discs
  const GlyphCode code = code_of(23);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 120; ++x) {
      const int color = prototype_of(codes_of(light_of(panel.at(x, y))), 0.4f);
      for (std::size_t band = 0; band < 3; ++band) {
        if (color != code[band]) continue;
        for (std::size_t disc = band; disc < 3; ++disc) ++areas[disc];
      }
    }
  }
  for (std::size_t disc = 0; disc < 3; ++disc) {
    const double radius = kDiscRadii[disc] * wall.radius() * kPixels;
    // Some of the 8 r pixels of the border are classified as neither colour.
    INFO("disc " << disc);
    CHECK(areas[disc] <= kPi * radius * radius + 4 * radius);
    CHECK(areas[disc] >= kPi * radius * radius - 8 * radius * double(disc + 1));
  }
  // More exactly: the light that the paper lacks.
  double missing = 0;
  const float dark = light_of({32, 32, 32, 255})[0];
  for (const Rgba8& pixel : panel.pixels)
    missing += double((1 - light_of(pixel).minCoeff()) / (1 - dark));
  // 360 border pixels with 16 sample points each: errors of at most 1/32, evenly distributed, and
  // of half a code of 255.
  const double area = kPi * 45 * 45;
  CHECK(std::abs(missing - area) < 5 * std::sqrt(360.0) * (1.0 / 32 + 1.0 / 255));
}

TEST_CASE("walls of too many glyphs, or of glyphs that touch, are refused") {
  CHECK(make_wall({})->glyphs.size() == 120);
  const auto refusal = [](auto change) {
    WallLayout layout;
    change(layout);
    const auto wall = make_wall(layout);
    REQUIRE_FALSE(wall);
    return wall.error().place;
  };
  CHECK(refusal([](WallLayout& layout) { layout.first = 1; }) == "--grid");
  CHECK(refusal([](WallLayout& layout) { layout.first = std::numeric_limits<int>::max(); }) ==
        "--grid");
  CHECK(refusal([](WallLayout& layout) { layout.columns = 121; }) == "--grid");
  CHECK(refusal([](WallLayout& layout) { layout.diameter = 0.1051; }) == "--diameter");
  CHECK(refusal([](WallLayout& layout) { layout.diameter = 0; }) == "--diameter");
  CHECK(refusal([](WallLayout& layout) { layout.panels = 3; }) == "--panels");
  CHECK(refusal([](WallLayout& layout) { layout.pitch = std::nan(""); }) == "--pitch");
  // 0.72 m are 16384 px at 22755.6 px per metre; the other side has 1.2 m and more pixels.
  CHECK(check_panel_picture(*make_wall({}), 4000));
  CHECK_FALSE(check_panel_picture(*make_wall({}), 14000));
  CHECK_FALSE(check_panel_picture(*make_wall({}), 1));
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

}  // namespace glassbox::views
