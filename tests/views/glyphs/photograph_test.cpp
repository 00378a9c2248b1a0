// The changes made to pictures before glyphs are looked for in them, and the list of the glyphs
// that are visible.
#include <tests/support/catch.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <stb_image_write.h>

#include <glassbox/base/trig.h>
#include <glassbox/images/decode.h>
#include <glassbox/images/srgb.h>

#include "views/glyphs/colors.h"
#include "views/glyphs/glyph_score.h"
#include "views/glyphs/picture_effects.h"
#include "views/glyphs/sensor.h"
#include "views/glyphs/sweep.h"

namespace glassbox::views {
namespace {

// The picture after being stored by another program: stb_image_write's JPEG, 4:2:0 up to quality
// 90.
Image<Rgba8> through_file(const Image<Rgba8>& picture, int quality) {
  std::vector<std::byte> bytes;
  const auto append = [](void* target, void* data, int size) {
    const auto* first = static_cast<const std::byte*>(data);
    auto& all = *static_cast<std::vector<std::byte>*>(target);
    all.insert(all.end(), first, first + size);
  };
  REQUIRE(::stbi_write_jpg_to_func(append, &bytes, picture.width, picture.height, 4,
                                   picture.pixels.data(), quality) != 0);
  return *decode_image(bytes);
}

// The diameter of a circle that has the area of the glyph's picture.
double diameter_of(const PinholeCamera& camera, const Wall& wall, const WallGlyph& glyph) {
  const WallPanel& panel = wall.panels[std::size_t(glyph.panel)];
  constexpr int kCorners = 2000;
  double twice = 0;
  Vector2d before = Vector2d::Zero();
  for (int i = 0; i <= kCorners; ++i) {
    const SinCos turn = sin_cos_degrees(360.0 * i / kCorners);
    const Vector2d corner = project(camera, glyph.centre + wall.radius() * (turn.cos * panel.right +
                                                                            turn.sin * panel.down))
                                .head<2>();
    if (i > 0) twice += before.x() * corner.y() - before.y() * corner.x();
    before = corner;
  }
  return 2 * std::sqrt(std::abs(twice) / 2 / kPi);
}

}  // namespace

TEST_CASE("JPEG's rounding is that of a file") {
  // Greys of all frequencies added to one colour, so that the way in which a decoder enlarges
  // chrominance, which varies, has no effect.
  for (const Rgba8& color : {Rgba8{128, 128, 128, 255}, Rgba8{190, 90, 60, 255},
                             Rgba8{60, 110, 190, 255}, Rgba8{80, 170, 70, 255}}) {
    Image<Rgba8> picture(48, 32);
    std::uint32_t state = 1;
    for (Rgba8& pixel : picture.pixels) {
      state = state * 1664525 + 1013904223;
      const int by = int(state >> 24) % 80 - 40;
      pixel = {std::uint8_t(color.r + by), std::uint8_t(color.g + by), std::uint8_t(color.b + by),
               255};
    }
    for (const int quality : {10, 30, 50, 75, 90}) {
      const Image<Rgba8> ours = apply_jpeg(picture, quality), file = through_file(picture, quality);
      int other = 0;
      for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
        const Rgba8 &a = ours.pixels[i], &b = file.pixels[i];
        other += std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > 3;
      }
      INFO("quality " << quality << ", " << int(color.r) << " " << int(color.g));
      // The other program uses floats and integers of twelve bits instead of doubles: a coefficient
      // within a thousandth of the middle between two steps may be rounded differently, which
      // changes one block of the 24.
      CHECK(other <= 2 * 64);
    }
  }
}

TEST_CASE("JPEG's chrominance is the mean of two by two pixels") {
  const Rgba8 left{200, 60, 60, 255}, right{60, 60, 200, 255};
  Image<Rgba8> columns(16, 16, left);
  for (int y = 0; y < 16; ++y) {
    for (int x = 1; x < 16; x += 2) columns.at(x, y) = right;
  }
  const Image<Rgba8> again = apply_jpeg(columns, 100);
  const auto luma = [](const Rgba8& p) { return 0.299 * p.r + 0.587 * p.g + 0.114 * p.b; };
  const double red = (left.r + right.r) / 2.0 - (luma(left) + luma(right)) / 2;
  // Rounding in steps of 1, times 1.402, and rounding to codes: little compared with the 98 codes
  // between the two columns.
  for (const int x : {6, 7}) CHECK(std::abs(again.at(x, 7).r - luma(again.at(x, 7)) - red) < 4);
}

TEST_CASE("a blurred edge is the integral of a Gaussian, in light, along both axes") {
  constexpr double kDeviation = 1.5;
  for (const bool is_upright : {true, false}) {
    Image<Rgba8> edge(40, 40, {0, 0, 0, 255});
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) {
        if ((is_upright ? x : y) >= 20) edge.at(x, y) = {255, 255, 255, 255};
      }
    }
    const Image<Rgba8> soft = blurred(edge, kDeviation);
    for (int i = 0; i < 40; ++i) {
      const Rgba8& pixel = is_upright ? soft.at(i, 7) : soft.at(7, i);
      const double share = (1 + std::erf((i - 19.5) / (kDeviation * std::sqrt(2.0)))) / 2;
      INFO(i);
      // Cut off at three deviations (0.0027), summed in steps of a pixel, and rounded to a code of
      // 255, at most 0.009 of light.
      CHECK(std::abs(double(decode_srgb(pixel.r)) - share) < 0.012);
    }
  }
  CHECK(blurred(Image<Rgba8>(9, 9, {200, 100, 50, 255}), 2) ==
        Image<Rgba8>(9, 9, {200, 100, 50, 255}));
}

TEST_CASE("gains are of light, channel by channel") {
  const Image<Rgba8> tinted = with_gains(Image<Rgba8>(1, 1, {255, 255, 200, 255}), {0.5, 1, 2});
  CHECK(tinted.at(0, 0) == Rgba8{188, 255, 255, 255});  // 0.5 of light is code 187.5 of sRGB
}

TEST_CASE(
    "a sensor of which nothing is asked changes nothing, nor does a mosaic what is even or "
    "slopes") {
  Image<Rgba8> slope(40, 30);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      const auto light = [&](double from) {
        return encode_srgb(float(from + 0.01 * x + 0.005 * y));
      };
      slope.at(x, y) = {light(0.1), light(0.2), light(0.3), 255};
    }
  }
  CHECK(apply_sensor(slope, {}, 1) == slope);
  const Image<Rgba8> mosaic = apply_sensor(slope, {.has_mosaic = true}, 1);
  for (int y = 1; y < 29; ++y) {
    for (int x = 1; x < 39; ++x) {
      // In a linear slope the mean of the neighbours is the value between them, up to the rounding
      // to codes.
      CHECK(std::abs(int(mosaic.at(x, y).r) - int(slope.at(x, y).r)) <= 1);
      CHECK(std::abs(int(mosaic.at(x, y).g) - int(slope.at(x, y).g)) <= 1);
      CHECK(std::abs(int(mosaic.at(x, y).b) - int(slope.at(x, y).b)) <= 1);
    }
  }
  // Each pixel of a white line a pixel wide measures one colour of the mosaic, which spreads to its
  // neighbours.
  Image<Rgba8> line(20, 20, {0, 0, 0, 255});
  for (int y = 0; y < 20; ++y) line.at(8, y) = {255, 255, 255, 255};
  const Image<Rgba8> fringed = apply_sensor(line, {.has_mosaic = true}, 1);
  // Red is measured here; two of the four green neighbours are on the line, and no blue one is.
  CHECK(fringed.at(8, 8) == Rgba8{255, 188, 0, 255});
  CHECK(fringed.at(9, 8).r == 188);
}

TEST_CASE("noise has the variance of the electrons that are counted") {
  const std::uint8_t code = 137;
  const double light = double(decode_srgb(code)), electrons = 1000;  // light: 0.25
  const Image<Rgba8> noisy =
      apply_sensor(Image<Rgba8>(200, 200, {code, code, code, 255}), {.electrons = electrons}, 5);
  double sum = 0, squares = 0;
  for (const Rgba8& pixel : noisy.pixels) {
    const double off = double(decode_srgb(pixel.g)) - light;
    sum += off / 40000;
    squares += off * off / 40000;
  }
  // The deviation of the mean is 0.0158 / 200, that of the variance 1 / sqrt(20000) of its value;
  // codes add 0.5 %.
  CHECK(std::abs(sum) < 3 * 0.0158 / 200);
  CHECK(squares == Approx(light / electrons).epsilon(3 * 0.0071 + 0.005));
}

TEST_CASE("corners are darker, and a bent lens draws together") {
  const Image<Rgba8> white(81, 61, {255, 255, 255, 255});
  const Image<Rgba8> dark = apply_sensor(white, {.falloff = 0.5}, 1);
  CHECK(dark.at(40, 30).r == 255);
  // The centre of the corner's pixel is a hundredth nearer to the middle than the corner itself:
  // 0.5 of light is code 188, 0.51 is 190.
  CHECK(dark.at(0, 0).r == 190);
  // An edge 30.5 px from the middle of a picture whose half height is 50.
  Image<Rgba8> edge(101, 100, {0, 0, 0, 255});
  for (int y = 0; y < 100; ++y) {
    for (int x = 81; x < 101; ++x) edge.at(x, y) = {255, 255, 255, 255};
  }
  const Image<Rgba8> bent = apply_sensor(edge, {.distortion = 0.2}, 1);
  double right = 0;
  for (int x = 60; x < 101; ++x) right += double(decode_srgb(bent.at(x, 50).r));
  // 101 minus the position of the edge, 50.5 + 50 r with r = 0.5634, where r + 0.2 r^3 = 0.61.
  double r = 0.61;
  for (int i = 0; i < 50; ++i) r = 0.61 - 0.2 * r * r * r;
  CHECK(std::abs(101 - right - (50.5 + 50 * r)) < 0.1);
}

TEST_CASE("bars cover the share that is asked for, and little more") {
  const Image<Rgba8> white(320, 240, {255, 255, 255, 255});
  for (const double share : {0.0, 0.1, 0.4}) {
    const OccludedPicture hidden = occluded(white, share, 5);
    int covered = 0;
    for (std::size_t i = 0; i < white.pixels.size(); ++i) {
      const bool is_covered = hidden.covered.pixels[i] != 0;
      covered += is_covered;
      CHECK(is_covered == (hidden.picture.pixels[i].r < 128));
    }
    const double all = 320 * 240,
                 bar = 240 / 16.0 * 200;  // a bar is at most half the diagonal long
    CHECK(covered >= share * all);
    CHECK(covered <= share * all + (share > 0 ? bar : 0));
  }
}

TEST_CASE("a glyph is visible from the front, whole, and where at most a tenth of it is covered") {
  const Wall wall = *make_wall({});
  const PinholeCamera camera = camera_in_front(3, 0, 0, 640, 480);
  const auto all = visible_glyphs(wall, camera, 640, 480);
  CHECK(all.size() == 120);
  CHECK(visible_glyphs(wall, camera_in_front(3, 180, 0, 640, 480), 640, 480).empty());
  for (const VisibleGlyph& glyph : all) {
    const WallGlyph& there = *wall.find(glyph.identity);
    CHECK((glyph.centre - project(camera, there.centre).head<2>()).norm() < 1e-9);
    // Foreshortened by up to about 45 degrees; its size is that of its picture, approximated by a
    // polygon of 2000 corners.
    CHECK(glyph.diameter == Approx(diameter_of(camera, wall, there)).epsilon(1e-3));
    CHECK(glyph.shorter < glyph.diameter);
  }
  // Bars cover its upper part down to a share of the diameter: circle segments of 5 % and of 25 %
  // of the area.
  for (const auto& [depth, is_seen] : {std::pair(0.1, true), std::pair(0.3, false)}) {
    const VisibleGlyph& glyph = all[33];
    Image<std::uint8_t> covered(640, 480, 0);
    const int top = int(glyph.centre.y() - glyph.diameter / 2),
              bottom = int(glyph.centre.y() + glyph.diameter * (depth - 0.5));
    for (int y = top - 2; y < bottom; ++y) {
      for (int x = 0; x < 640; ++x) covered.at(x, y) = 255;
    }
    const auto seen = visible_glyphs(wall, camera, 640, 480, covered);
    CHECK(is_seen == std::ranges::any_of(seen, [&](const VisibleGlyph& one) {
            return one.identity == glyph.identity;
          }));
  }
}

TEST_CASE("a glyph is right where it is, wrong elsewhere, and partly right where it is cut off") {
  const Wall wall = *make_wall({});
  const PinholeCamera camera = camera_in_front(2, 0, 0, 640, 480);
  auto visible = visible_glyphs(wall, camera, 640, 480);
  const auto score_at = [&](int identity, const Vector2d& centre) {
    GlyphRegion region;
    region.identity = identity;
    region.ellipse = {centre, 25 * Eigen::Matrix2d::Identity(), 314};  // 20 px across
    return glyph_score({{region}}, wall, camera, visible);
  };
  const VisibleGlyph glyph = visible[40];
  CHECK(score_at(glyph.identity, glyph.centre + Vector2d(9, 0)).right == 1);
  CHECK(score_at(glyph.identity, glyph.centre + Vector2d(11, 0)).wrong == 1);
  CHECK(score_at(glyph.identity + 1, glyph.centre).wrong == 1);
  visible.erase(visible.begin() + 40);
  const GlyphScore partly = score_at(glyph.identity, glyph.centre);
  CHECK(partly.partly == 1);
  CHECK(partly.right + partly.wrong == 0);
  CHECK(partly.precision() == 1);
  CHECK(score_at(glyph.identity, {0, 0}).precision() == 0);
}

}  // namespace glassbox::views
