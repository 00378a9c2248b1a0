// Texture wrapping, filtering, mip chains and levels of detail.
#include <algorithm>
#include <cmath>
#include <limits>

#include <glassbox/base/random.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/texture.h>

#include "tests/raster/exact.h"
#include "tests/raster/levels.h"
#include "tests/support/catch.h"

namespace {

using namespace glassbox;
using namespace glassbox::test;

constexpr double kU = 0x1p-24;
constexpr Wrap kWraps[] = {Wrap::kRepeat, Wrap::kMirroredRepeat, Wrap::kClampToEdge};

Image<Rgba8> random_image(Random& random, int width, int height) {
  Image<Rgba8> image(width, height);
  for (Rgba8& texel : image.pixels) {
    const std::uint64_t bits = random.bits();
    texel = {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16),
             std::uint8_t(bits >> 24)};
  }
  return image;
}

MipChain single_level(const Image<Rgba8>& image) {
  return make_mip_chain(image, Transfer::kNone, true);
}

Sampler sampler_of(Wrap wrap, Filter filter, MipFilter mip = MipFilter::kNone) {
  return {wrap, wrap, filter, filter, mip};
}

Rgba sample_at(const MipChain& texture, const Sampler& sampler, float u, float v,
               float detail = 0) {
  return sample_mip_chain(texture, sampler, {u, v}, detail);
}

// The index of the texel at place `i` of an endless row.
std::int64_t wrapped(Wrap wrap, std::int64_t i, int size) {
  const auto modulo = [](std::int64_t n, std::int64_t d) { return (n % d + d) % d; };
  switch (wrap) {
    case Wrap::kRepeat:
      return modulo(i, size);
    case Wrap::kMirroredRepeat: {
      const std::int64_t j = modulo(i, 2 * size);
      return std::min(j, 2 * size - 1 - j);
    }
    case Wrap::kClampToEdge:
      return std::clamp<std::int64_t>(i, 0, size - 1);
  }
  return 0;
}

const Rgba8& texel_at(const Image<Rgba8>& image, Wrap wrap, std::int64_t x, std::int64_t y) {
  return image.at(int(wrapped(wrap, x, image.width)), int(wrapped(wrap, y, image.height)));
}

// The texel of a colour that is stored linearly.
Texel texel_of(const Rgba8& c) {
  const auto whole = [](int byte) { return std::int16_t(128 * byte); };
  return {whole(c.r), whole(c.g), whole(c.b), whole(c.a)};
}
Rgba decoded(const Rgba8& c) {
  return light_of(texel_of(c));
}

// The red channel by bilinear filtering in double, at exactly these coordinates.
double bilinear_red(const Image<Rgba8>& image, Wrap wrap, double u, double v) {
  const double x = u * image.width - 0.5, y = v * image.height - 0.5;
  const double x0 = std::floor(x), y0 = std::floor(y), s = x - x0, t = y - y0;
  const auto red = [&](int dx, int dy) {
    return texel_at(image, wrap, std::int64_t(x0) + dx, std::int64_t(y0) + dy).r / 255.0;
  };
  return (1 - t) * ((1 - s) * red(0, 0) + s * red(1, 0)) +
         t * ((1 - s) * red(0, 1) + s * red(1, 1));
}

}  // namespace

TEST_CASE(
    "nearest sampling takes the texel of the endless pattern, negatives and exactly 1 included "
    "(C-68)") {
  Random random(68);
  for (const auto& [width, height] : {std::array{4, 2}, {16, 1}, {1, 8}, {1, 1}}) {
    const Image<Rgba8> image = random_image(random, width, height);
    const MipChain texture = single_level(image);
    for (const Wrap wrap : kWraps) {
      for (int i = -70; i <= 70; ++i) {
        // Sixteenths are exact; some are edges of texels, among them -1, 0 and 1.
        const float u = float(i) / 16, v = float(i * 3) / 16;
        const auto x = std::int64_t(std::floor(double(u) * width)),
                   y = std::int64_t(std::floor(double(v) * height));
        CAPTURE(width, height, int(wrap), u, v);
        REQUIRE(sample_at(texture, sampler_of(wrap, Filter::kNearest), u, v) ==
                decoded(texel_at(image, wrap, x, y)));
      }
    }
  }
}

TEST_CASE(
    "a coordinate just below 0 wraps to the last texel, though it rounds to the whole period "
    "(C-68)") {
  Image<Rgba8> image(3, 1);
  image.at(2, 0) = {255, 255, 255, 255};
  const MipChain texture = single_level(image);
  const Sampler repeat = sampler_of(Wrap::kRepeat, Filter::kNearest);
  for (const float u : {-1e-3f, -1e-10f, -1e-30f, -0x1p-149f}) {
    CAPTURE(u);
    CHECK(u - std::floor(u) <= 1.0f);
    CHECK(sample_at(texture, repeat, u, 0).r == 1.0f);
    CHECK(sample_at(texture, sampler_of(Wrap::kMirroredRepeat, Filter::kNearest), u, 0).r == 0.0f);
  }
  CHECK(sample_at(texture, repeat, 0.0f, 0).r == 0.0f);
  CHECK(sample_at(texture, repeat, 1.0f, 0).r == 0.0f);
  CHECK(sample_at(texture, repeat, std::nextafter(1.0f, 0.0f), 0).r == 1.0f);
}

TEST_CASE("far from the origin a texture looks as it does near it: u = 1e6 (C-67)") {
  Random random(67);
  const Image<Rgba8> image = random_image(random, 1024, 4);
  const MipChain texture = single_level(image);
  for (const Wrap wrap : {Wrap::kRepeat, Wrap::kMirroredRepeat}) {
    for (const Filter filter : {Filter::kNearest, Filter::kLinear}) {
      for (int i = 0; i < 16; ++i) {
        const float near = float(i) / 16;
        const float far = 1e6f + near;  // 1e6 is even, and floats near it are multiples of 1/16
        const Sampler sampler = sampler_of(wrap, filter);
        CHECK(sample_at(texture, sampler, far, 0.3f) == sample_at(texture, sampler, near, 0.3f));
        CHECK(sample_at(texture, sampler, -1e6f + near, 0.3f) ==
              sample_at(texture, sampler, near, 0.3f));
      }
    }
  }
}

TEST_CASE("coordinates that are not finite, or enormous, are legal") {
  Random random(1);
  const Image<Rgba8> image = random_image(random, 5, 3);
  const MipChain texture = make_mip_chain(image, Transfer::kNone, false);
  for (const Wrap wrap : kWraps) {
    for (const Filter filter : {Filter::kNearest, Filter::kLinear}) {
      const Sampler sampler = sampler_of(wrap, filter, MipFilter::kLinear);
      for (const float t : {NAN, INFINITY, -INFINITY}) {
        CHECK(sample_at(texture, sampler, t, t) == sample_at(texture, sampler, 0, 0));
      }
      const float most = std::numeric_limits<float>::max();
      for (const float t :
           {most, -most, 1e30f, -1e30f, 16777216.0f, 0x1p-149f, -0x1p-149f, -0.0f}) {
        for (const float detail : {NAN, INFINITY, -INFINITY, most, 1.5f}) {
          const Rgba c = sample_at(texture, sampler, t, -t, detail);
          CAPTURE(int(wrap), t, detail);
          CHECK((c.r >= 0 && c.r <= 1));
        }
      }
    }
  }
}

TEST_CASE(
    "bilinear filtering gives a texel exactly at its centre, for sides that are powers of two") {
  Random random(2);
  for (const auto& [width, height] : {std::array{8, 4}, {1, 16}, {256, 1}}) {
    const Image<Rgba8> image = random_image(random, width, height);
    const MipChain texture = single_level(image);
    for (const Wrap wrap : kWraps) {
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const float u = (float(x) + 0.5f) / float(width), v = (float(y) + 0.5f) / float(height);
          REQUIRE(sample_at(texture, sampler_of(wrap, Filter::kLinear), u, v) ==
                  decoded(image.at(x, y)));
        }
      }
    }
  }
}

TEST_CASE("bilinear filtering of any size agrees with double arithmetic") {
  Random random(3);
  for (int i = 0; i < 4000; ++i) {
    const int width = int(random.integer(1, 40)), height = int(random.integer(1, 40));
    const Image<Rgba8> image = random_image(random, width, height);
    const Wrap wrap = kWraps[i % 3];
    const float u = float(random.between(-3, 3)), v = float(random.between(-3, 3));
    const double found =
        double(sample_at(single_level(image), sampler_of(wrap, Filter::kLinear), u, v).r);
    CAPTURE(width, height, int(wrap), u, v);
    // Wrapping a negative coordinate, scaling it and subtracting half a texel round the position
    // three times, by u of at most `side` (of twice that if mirrored); the colour changes by at
    // most 1 per texel. Two linear interpolations, one after the other, err by 1.5 units of a texel
    // each; the conversion of the result to float errs by 2 u.
    REQUIRE(std::abs(found - bilinear_red(image, wrap, double(u), double(v))) <=
            3.0 / kFullTexel + (6.0 * (width + height) + 2) * kU);
  }
}

TEST_CASE("a mip chain halves down to one texel, whatever the size") {
  Random random(4);
  for (const auto& [width, height] :
       {std::array{1, 1}, {7, 5}, {16, 1}, {1, 9}, {13, 6}, {640, 3}, {3, 3}, {64, 32}}) {
    const MipChain chain =
        make_mip_chain(random_image(random, width, height), Transfer::kSrgb, false);
    CHECK((chain.width == width && chain.height == height));
    // The levels follow one another without a gap, and the last one has one texel.
    std::int32_t texels = 0;
    for (int k = 0; k <= chain.last_level(); ++k) {
      CHECK(chain.first[std::size_t(k)] == texels);
      texels += std::max(1, width >> k) * std::max(1, height >> k);
    }
    CHECK(chain.texels.size() == std::size_t(texels));
    CHECK(chain.first.back() == texels - 1);
    CHECK(make_mip_chain(random_image(random, width, height), Transfer::kSrgb, true).last_level() ==
          0);
  }
}

TEST_CASE("a texel stands for its byte: the colour comes back, and alpha is the byte's float") {
  for (const Transfer transfer : {Transfer::kSrgb, Transfer::kNone}) {
    for (int byte = 0; byte < 256; ++byte) {
      const auto b = std::uint8_t(byte);
      const Rgba8 color{b, std::uint8_t(255 - byte), 7, b};
      const Texel texel = make_mip_chain(Image<Rgba8>(1, 1, color), transfer, true).texels.front();
      CAPTURE(int(transfer), byte);
      CHECK(stored_texel(texel, transfer) == color);
      CHECK(light_of(texel).a == decode_unorm8(b));
      // Half a unit of a texel, and the two roundings of a float.
      CHECK(std::abs(double(light_of(texel).r) - double(decode(transfer, b))) <=
            0.5 / kFullTexel + 2 * kU);
    }
  }
  const Texel white =
      make_mip_chain(Image<Rgba8>(1, 1, {255, 255, 255, 255}), Transfer::kSrgb, true)
          .texels.front();
  CHECK(light_of(white) == Rgba{1, 1, 1, 1});
}

TEST_CASE("a linear byte is 128 of a texel, rounded halves up, whatever the texel: lanes shift") {
  for (int whole = 0; whole <= kFullTexel; ++whole) {
    const auto t = std::int16_t(whole);
    REQUIRE(stored_texel({t, t, t, t}, Transfer::kNone).r == std::uint8_t((whole + 64) >> 7));
  }
}

TEST_CASE("an image of one colour has that colour at every level, to the byte") {
  for (const Transfer transfer : {Transfer::kSrgb, Transfer::kNone}) {
    for (int byte = 0; byte < 256; ++byte) {
      const Rgba8 color{std::uint8_t(byte), std::uint8_t(255 - byte), 7, std::uint8_t(byte)};
      const MipChain chain = make_mip_chain(Image<Rgba8>(13, 6 + byte % 3, color), transfer, false);
      for (const Texel& texel : chain.texels) {
        REQUIRE(texel == chain.texels.front());
        REQUIRE(stored_texel(texel, transfer) == color);
      }
    }
  }
}

TEST_CASE("a texel of a level is the mean of exactly the area it covers in the level before") {
  Random random(6);
  for (int i = 0; i < 60; ++i) {
    const int width = int(random.integer(1, 24)), height = int(random.integer(1, 24));
    const Image<Rgba8> image = random_image(random, width, height);
    const Transfer transfer = i % 2 == 0 ? Transfer::kNone : Transfer::kSrgb;
    const std::vector<Image<Texel>> levels = levels_of(make_mip_chain(image, transfer, false));
    for (std::size_t k = 1; k < levels.size(); ++k) {
      const Image<Texel>& large = levels[k - 1];
      const Image<Texel>& small = levels[k];
      for (int y = 0; y < small.height; ++y) {
        for (int x = 0; x < small.width; ++x) {
          // The overlaps of texels as areas, in units of 1 / (small.width small.height) of a larger
          // texel.
          const auto overlap = [](int n, int texel, int short_side, int long_side) {
            return std::max(0, std::min((n + 1) * long_side, (texel + 1) * short_side) -
                                   std::max(n * long_side, texel * short_side));
          };
          std::int64_t red = 0, alpha = 0, area = 0;
          for (int row = 0; row < large.height; ++row) {
            for (int column = 0; column < large.width; ++column) {
              const std::int64_t part = std::int64_t(overlap(x, column, small.width, large.width)) *
                                        overlap(y, row, small.height, large.height);
              red += part * large.at(column, row).r;
              alpha += part * large.at(column, row).a;
              area += part;
            }
          }
          CAPTURE(image.width, image.height, k, x, y);
          REQUIRE(area == std::int64_t(large.width) * large.height);
          // Rounded to nearest. The sum of nine texels, each weighted with three roundings, errs by
          // 12 u of a full texel.
          constexpr double kBound = 0.5 + 12 * kU * kFullTexel;
          REQUIRE(std::abs(small.at(x, y).r - double(red) / double(area)) <= kBound);
          REQUIRE(std::abs(small.at(x, y).a - double(alpha) / double(area)) <= kBound);
        }
      }
    }
  }
}

TEST_CASE("mip levels are means of light, not of bytes") {
  Image<Rgba8> image(2, 1, {0, 0, 0, 255});
  image.at(1, 0) = {255, 255, 255, 255};
  const auto smallest = [&](Transfer transfer) {
    return stored_texel(make_mip_chain(image, transfer, false).texels.back(), transfer);
  };
  CHECK(smallest(Transfer::kSrgb) == Rgba8{188, 188, 188, 255});
  CHECK(smallest(Transfer::kNone) == Rgba8{128, 128, 128, 255});
}

TEST_CASE("trilinear filtering is continuous in the level of detail and exact at whole levels") {
  Random random(8);
  const MipChain chain = make_mip_chain(random_image(random, 24, 10), Transfer::kNone, false);
  const Sampler trilinear = sampler_of(Wrap::kRepeat, Filter::kLinear, MipFilter::kLinear);
  const std::vector<Image<Texel>> levels = levels_of(chain);
  const float last = float(chain.last_level());
  for (int i = 0; i < 200; ++i) {
    const float u = float(random.between(-2, 2)), v = float(random.between(-2, 2));
    const auto at = [&](float detail) {
      return double(sample_at(chain, trilinear, u, v, detail).r);
    };
    for (float level = 0; level <= last; ++level) {
      const MipChain alone = chain_of({levels[std::size_t(level)]});
      const double exact = double(sample_at(alone, trilinear, u, v, 0).r);
      CHECK(at(level) == exact);
      // One linear interpolation, whose fractions are exact here: half a unit of a texel; and 2 u
      // for the conversion of each texel to float.
      constexpr double kOneMix = 0.5 / kFullTexel + 4 * kU;
      // 2^-10 of a level away, the sample differs by at most 2^-10 of a change of 1.
      CHECK(std::abs(at(level + 0x1p-10f) - exact) <= 0x1p-10 + kOneMix);
      CHECK(std::abs(at(level - 0x1p-10f) - exact) <= 0x1p-10 + kOneMix);
      if (level < last) CHECK(std::abs(at(level + 0.5f) - (exact + at(level + 1)) / 2) <= kOneMix);
    }
    CHECK(at(last + 5) == at(last));
    CHECK(at(-3) == at(0));
  }
}

TEST_CASE("a fraction of a whole number is rounded to nearest, halves up") {
  Random random(11);
  for (int n = 0; n < 100000; ++n) {
    const auto i = std::int32_t(random.integer(-kFullTexel, kFullTexel));
    const auto f = std::int32_t(random.integer(0, 32767));
    REQUIRE(times_fraction(i, f) == int(std::floor(double(i) * f / 32768 + 0.5)));
  }
  CHECK(times_fraction(1, 16384) == 1);
  CHECK(times_fraction(-1, 16384) == 0);
  CHECK(times_fraction(kFullTexel, 32767) == kFullTexel - 1);
}

TEST_CASE("trilinear filtering is within 4.5 units of exact weights") {
  Random random(10);
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    const int width = int(random.integer(1, 40)), height = int(random.integer(1, 40));
    const MipChain chain =
        make_mip_chain(random_image(random, width, height), Transfer::kSrgb, false);
    const float u = float(random.unit()), v = float(random.unit());
    const float detail = float(random.between(0, chain.last_level()));
    const auto red_at = [](const Image<Texel>& level, double x, double y) {
      const double x0 = std::floor(x), y0 = std::floor(y), s = x - x0, t = y - y0;
      const auto red = [&](int dx, int dy) {
        return double(level
                          .at(std::clamp(int(x0) + dx, 0, level.width - 1),
                              std::clamp(int(y0) + dy, 0, level.height - 1))
                          .r);
      };
      return (1 - t) * ((1 - s) * red(0, 0) + s * red(1, 0)) +
             t * ((1 - s) * red(0, 1) + s * red(1, 1));
    };
    const std::vector<Image<Texel>> levels = levels_of(chain);
    // The positions as they are rounded in float, so that only the errors of the interpolation are
    // compared.
    const auto red_of = [&](std::size_t k) {
      const Image<Texel>& level = levels[std::min(k, levels.size() - 1)];
      return red_at(level, double(u * float(level.width) - 0.5f),
                    double(v * float(level.height) - 0.5f));
    };
    const auto finer = std::size_t(detail);
    const double beyond = double(detail) - double(finer);
    const double exact = (1 - beyond) * red_of(finer) + beyond * red_of(finer + 1);
    const Sampler trilinear = sampler_of(Wrap::kClampToEdge, Filter::kLinear, MipFilter::kLinear);
    const double found = double(sample_at(chain, trilinear, u, v, detail).r) * kFullTexel;
    worst = std::max(worst, std::abs(found - exact));
  }
  CAPTURE(worst);
  CHECK(worst <= 4.5 + 2 * kU * kFullTexel);
  CHECK(worst >= 1);  // otherwise nothing was interpolated
}

TEST_CASE("the level of detail chooses filter and level as the sampler says") {
  // All texels of level k have the byte 10 k.
  std::vector<Image<Texel>> levels;
  for (int k = 0; k < 4; ++k) {
    const auto byte = std::uint8_t(10 * k);
    levels.emplace_back(8 >> k, 8 >> k, texel_of({byte, byte, byte, 255}));
  }
  const MipChain chain = chain_of(levels);
  const auto level = [&](MipFilter mip, float detail) {
    return double(
               sample_at(chain, sampler_of(Wrap::kRepeat, Filter::kLinear, mip), 0.3f, 0.3f, detail)
                   .r) *
           25.5;
  };
  const auto is = [](double found, double expected) { return std::abs(found - expected) <= 1e-5; };
  CHECK(is(level(MipFilter::kNone, 2.7f), 0));
  CHECK(is(level(MipFilter::kNearest, -1), 0));
  CHECK(is(level(MipFilter::kNearest, 0.4f), 0));
  CHECK(is(level(MipFilter::kNearest, 0.6f), 1));
  CHECK(is(level(MipFilter::kNearest, 2.4f), 2));
  CHECK(is(level(MipFilter::kNearest, 99), 3));
  CHECK(is(level(MipFilter::kLinear, 1.25f), 1.25));
  CHECK(is(level(MipFilter::kLinear, 99), 3));

  // Magnified with one filter, minified with the other.
  Image<Rgba8> image(2, 1, {0, 0, 0, 255});
  image.at(1, 0) = {255, 255, 255, 255};
  const Sampler sampler{Wrap::kClampToEdge, Wrap::kClampToEdge, Filter::kNearest, Filter::kLinear,
                        MipFilter::kNone};
  CHECK(sample_at(single_level(image), sampler, 0.5f, 0.5f, -0.1f).r == 1.0f);
  CHECK(sample_at(single_level(image), sampler, 0.5f, 0.5f, 0.1f).r == 0.5f);
}

TEST_CASE("the level of detail is log2 of the longer side of the footprint") {
  Random random(9);
  for (int i = 0; i < 20000; ++i) {
    const auto change = [&] { return float(random.scaled(-1, 1, -25, 10)); };
    const TextureGradient g{{change(), change()}, {change(), change()}};
    const double x = std::hypot(double(g.along_x[0]) * 640, double(g.along_x[1]) * 480);
    const double y = std::hypot(double(g.along_y[0]) * 640, double(g.along_y[1]) * 480);
    const double exact = std::log2(std::max(x, y));
    const double found = double(level_of_detail(g, 640, 480));
    CAPTURE(g.along_x, g.along_y, exact, found);
    // Half the error of the logarithm of the square: 4 u / ln 2 from the square, 5e-8 from the
    // series, 8 u from its roundings, and u of the sum, which is twice the result.
    REQUIRE(std::abs(found - exact) <= 10 * kU + kU * std::abs(exact));
  }
  for (int k = -20; k <= 20; ++k) {
    const TextureGradient g{{std::ldexp(1.0f, k), 0}, {0, 0}};
    CHECK(level_of_detail(g, 4, 64) == float(k + 2));  // exact for powers of two
  }
  // Squares below the smallest normal float, which are still powers of two.
  for (int k = -74; k <= -63; ++k) {
    CHECK(level_of_detail({{std::ldexp(1.0f, k), 0}, {0, 0}}, 1, 1) == float(k));
  }
  const float most = std::numeric_limits<float>::max();
  CHECK(level_of_detail({}, 8, 8) == -INFINITY);
  CHECK(level_of_detail({{1e30f, 0}, {0, 0}}, 8, 8) == most);
  CHECK(level_of_detail({{INFINITY, 0}, {0, 0}}, 8, 8) == most);
}

TEST_CASE("texture gradients are the exact derivatives, at the silhouette as inside (C-69)") {
  Random random(69);
  double worst = 0;
  int pixels = 0;
  while (pixels < 1500) {
    std::array<ScreenVertex, 3> t;
    std::array<std::array<float, 2>, 3> texcoords;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t x = random.integer(-3000, 9000), y = random.integer(-3000, 9000);
      t[k] = screen_vertex(x, y, 0.5f, float(random.between(0.01, 10)));
      texcoords[k] = {float(random.between(-4, 4)), float(random.between(-4, 4))};
    }
    const auto setup = setup_triangle(t);
    if (!setup) continue;
    if (random.integer(0, 9) == 0) texcoords[1] = texcoords[2] = texcoords[0];
    const TexturePlanes planes = texture_planes(*setup, texcoords);
    int wanted = 3;
    for_each_covered(*setup, {0, 0, 16, 16}, [&](const Coverage& pixel) {
      if (wanted-- <= 0) return;
      ++pixels;
      const Fragment fragment = interpolate(*setup, pixel);
      const auto found_at = interpolate(texcoords[0], texcoords[1], texcoords[2], fragment.weights);
      const TextureGradient gradient = texture_gradient(planes, found_at, fragment.inverse_w);
      // u = N / D with N = sum E_k u_k / w_k and D = sum E_k / w_k, so u' = (N' - u D') / D.
      for (std::size_t axis = 0; axis < 2; ++axis) {
        for (std::size_t i = 0; i < 2; ++i) {
          Rational n = 0, d = 0, dn = 0, dd = 0, size = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            const Rational iw(setup->inverse_w[k]), u(texcoords[k][i]);
            const Rational slope = 256 * (axis == 0 ? setup->edges[k].a : setup->edges[k].b) * iw;
            n += pixel.edges[k] * iw * u;
            d += pixel.edges[k] * iw;
            dn += slope * u;
            dd += slope;
          }
          const Rational u = n / d;
          const Rational exact = (dn - u * dd) / d;
          // The magnitudes of the terms that are added and may cancel.
          for (std::size_t k = 0; k < 3; ++k) {
            const Rational slope =
                abs_of(Rational(256 * (axis == 0 ? setup->edges[k].a : setup->edges[k].b))) *
                Rational(setup->inverse_w[k]);
            const Rational u0(texcoords[0][i]);
            size += slope * (abs_of(Rational(texcoords[k][i]) - u0) + abs_of(u - u0) + abs_of(u));
            size += slope * (abs_of(Rational(texcoords[1][i]) - u0) +
                             abs_of(Rational(texcoords[2][i]) - u0));
          }
          size /= d;
          const float found = axis == 0 ? gradient.along_x[i] : gradient.along_y[i];
          if (size == 0) {
            REQUIRE(found == 0.0f);
            continue;
          }
          worst = std::max(worst, double(Rational(abs_of(Rational(found) - exact) / size)) / kU);
        }
      }
    });
  }
  CAPTURE(worst);
  // A slope has 5 roundings (step, area, reciprocal, two products). Then follow a difference, a
  // product, a sum, the product with u - u0, a difference, 8 u of w, and a product. The coordinate
  // u itself errs by 13 unit roundoffs of its spread.
  CHECK(worst <= 19);
}
