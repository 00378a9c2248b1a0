// The lanes' functions give the same bits as the scalar stages, for every instruction set.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/images/srgb.h>
#include <glassbox/raster/mean_color.h>
#include <glassbox/raster/snap.h>

#include "tests/raster/lanes/probes.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

using test::lane_probes;
using test::LaneProbes;
using Float3 = std::array<float, 3>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

// Calls check(probes) for every instruction set that this machine has.
template <class Check>
void for_each_target(const Check& check) {
  for (const Target target : available_targets()) {
    INFO("target " << name_of(target));
    check(lane_probes(target));
  }
}

// How many entries differ in their bits; reports the first of them.
template <class T>
std::size_t differing(const std::vector<T>& expected, const std::vector<T>& actual) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (std::bit_cast<std::uint32_t>(expected[i]) == std::bit_cast<std::uint32_t>(actual[i])) {
      continue;
    }
    if (count++ == 0)
      UNSCOPED_INFO("entry " << i << ": " << actual[i] << " instead of " << expected[i]);
  }
  return count;
}

// Zeros, subnormals, ones, the largest floats, infinities and NaN.
std::vector<float> special_values() {
  std::vector<float> values{0.0f,
                            1.0f,
                            kInfinity,
                            kNaN,
                            0.5f,
                            std::numeric_limits<float>::denorm_min(),
                            std::numeric_limits<float>::min(),
                            std::numeric_limits<float>::max(),
                            std::nextafter(1.0f, 2.0f),
                            std::nextafter(1.0f, 0.0f),
                            0x1p-149f * 12345};
  const std::size_t count = values.size();
  for (std::size_t i = 0; i < count; ++i) values.push_back(-values[i]);
  return values;
}

void append_neighbours(float value, std::vector<float>& values) {
  float below = value, above = value;
  values.push_back(value);
  for (int i = 0; i < 2; ++i) {
    below = std::nextafter(below, -kInfinity);
    above = std::nextafter(above, kInfinity);
    values.push_back(below);
    values.push_back(above);
  }
}

// Floats of every magnitude and sign: every `stride`-th bit pattern.
std::vector<float> floats_with_stride(std::uint32_t stride) {
  std::vector<float> values;
  for (std::uint64_t bits = 0; bits < (std::uint64_t{1} << 32); bits += stride) {
    values.push_back(std::bit_cast<float>(std::uint32_t(bits)));
  }
  return values;
}

// ---- colours ----

TEST_CASE("lanes encode colours as the scalar stage does: at every threshold, and all over") {
  std::vector<float> values = special_values();
  for (const float threshold : kSrgbThreshold) append_neighbours(threshold, values);
  for (int k = 0; k <= 255; ++k) {
    append_neighbours(float(k) / 255.0f, values);
    append_neighbours((float(k) + 0.5f) / 255.0f, values);
  }
  // The borders of the table's buckets.
  for (std::uint32_t bucket = srgb_detail::kFirstBucket - 1; bucket <= srgb_detail::kEndBucket;
       ++bucket) {
    append_neighbours(std::bit_cast<float>(bucket << srgb_detail::kBucketShift), values);
  }
  const std::vector<float> spread = floats_with_stride(1009);  // 1009 is prime, so mantissas vary
  values.insert(values.end(), spread.begin(), spread.end());

  for (const Transfer transfer : {Transfer::kSrgb, Transfer::kNone}) {
    std::vector<std::int32_t> expected, actual(values.size());
    for (const float v : values) expected.push_back(encode(transfer, v));
    for_each_target([&](const LaneProbes& lanes) {
      lanes.encode(transfer, values, actual.data());
      CHECK(differing(expected, actual) == 0);
    });
  }
}

TEST_CASE("lanes decode each of the 256 bytes to the float of the scalar stage") {
  for (const Transfer transfer : {Transfer::kSrgb, Transfer::kNone}) {
    std::vector<std::int32_t> bytes;
    std::vector<float> expected, actual(256);
    for (int byte = 0; byte < 256; ++byte) {
      bytes.push_back(byte);
      expected.push_back(decode(transfer, std::uint8_t(byte)));
    }
    for_each_target([&](const LaneProbes& lanes) {
      lanes.decode(transfer, bytes, actual.data());
      CHECK(differing(expected, actual) == 0);
    });
  }
}

// ---- geometry ----

TEST_CASE("lanes snap as the scalar stage does: halves, their neighbours, the guard band's ends") {
  std::vector<float> pixels;
  for (const int k : {0, 1, 2, 255, 256, 32767, 65535, 65536, 8388607, 16777215}) {
    for (const float sign : {1.0f, -1.0f}) {
      append_neighbours(sign * float(k) / 256, pixels);
      append_neighbours(sign * (float(k) + 0.5f) / 256, pixels);
    }
  }
  append_neighbours(0.0f, pixels);
  Random random(3);
  for (int i = 0; i < 100000; ++i) {
    const double share = random.between(-1, 1);
    pixels.push_back(float(share * std::exp2(random.between(-12, 16))));
  }
  // Only values in the range of snap().
  std::erase_if(pixels, [](float p) { return !(std::abs(p) <= 65536); });
  std::vector<std::int32_t> expected, actual(pixels.size());
  for (const float p : pixels) expected.push_back(snap(p));
  for_each_target([&](const LaneProbes& lanes) {
    lanes.snap(pixels, actual.data());
    CHECK(differing(expected, actual) == 0);
  });
}

TEST_CASE("lanes make the depth codes of the scalar stage in every format") {
  std::vector<float> depths = special_values();
  for (const int bits : {16, 24}) {
    const double steps = std::exp2(bits) - 1;
    for (int i = 0; i < 2000; ++i) {
      const double step = i < 1000 ? i : steps - (i - 1000);
      append_neighbours(float((step + 0.5) / steps), depths);
      append_neighbours(float(step / steps), depths);
    }
  }
  for (std::uint32_t bits = 0; bits <= std::bit_cast<std::uint32_t>(1.5f); bits += 4099) {
    depths.push_back(std::bit_cast<float>(bits));
  }
  for (const DepthFormat format : {DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                                   DepthFormat::kUnorm24, DepthFormat::kUnorm16}) {
    INFO("format " << int(format));
    std::vector<std::int32_t> expected, actual(depths.size());
    for (const float z : depths) expected.push_back(std::int32_t(depth_code(format, z)));
    for_each_target([&](const LaneProbes& lanes) {
      lanes.depth_code(format, depths, actual.data());
      CHECK(differing(expected, actual) == 0);
    });
  }
}

// ---- textures ----

std::vector<float> flattened(const std::vector<Rgba>& colors) {
  std::vector<float> all;
  for (const Rgba& c : colors) all.insert(all.end(), {c.r, c.g, c.b, c.a});
  return all;
}

// A level of detail for each coordinate. The vectors are of all kinds: magnified in every lane, all
// at one whole level, or mixed.
std::vector<float> levels_of_detail(Random& random, std::size_t count) {
  const std::vector<float> special{kNaN,      -kInfinity, kInfinity,     -0.0f, 0.0f,
                                   0x1p-149f, -1e-6f,     0.5f,          1.0f,  1.5f,
                                   0x1p30f,   6.0f,       0x1.7ffffep+1f};
  std::vector<float> levels;
  while (levels.size() < count) {
    const std::int64_t kind = random.integer(0, 3);
    const float whole = float(random.integer(0, 7));
    for (int i = 0; i < 48; ++i) {
      const float choices[] = {
          float(random.between(-9, 0)), whole, float(random.between(-1, 8)),
          special[std::size_t(random.integer(0, std::int64_t(special.size()) - 1))]};
      levels.push_back(choices[kind]);
    }
  }
  levels.resize(count);
  return levels;
}

std::vector<Sampler> all_filters(Wrap wrap_u, Wrap wrap_v) {
  std::vector<Sampler> samplers;
  for (const Filter magnify : {Filter::kNearest, Filter::kLinear}) {
    for (const Filter minify : {Filter::kNearest, Filter::kLinear}) {
      for (const MipFilter mip : {MipFilter::kNone, MipFilter::kNearest, MipFilter::kLinear}) {
        samplers.push_back({wrap_u, wrap_v, magnify, minify, mip});
      }
    }
  }
  return samplers;
}

TEST_CASE(
    "lanes sample textures as the scalar stage does: every wrap, filter, level and coordinate") {
  Random random(5);
  const int sides[] = {1, 2, 3, 5, 7, 8, 64, 97};
  std::vector<float> coordinates{0.0f,       -0.0f, 1.0f,           -1.0f,      2.0f,     -2.0f,
                                 0.5f,       -0.5f, 1e-30f,         -1e-30f,    0x1p23f,  -0x1p23f,
                                 0x1p24f,    1e30f, -1e30f,         3.4e38f,    -3.4e38f, kInfinity,
                                 -kInfinity, kNaN,  0x1.fffffep-1f, -0x1p-149f, 0x1p-149f};
  for (const int side : sides) {
    for (int texel = -side; texel <= 2 * side; ++texel) {
      append_neighbours(float(texel) / float(side), coordinates);
      append_neighbours((float(texel) + 0.5f) / float(side), coordinates);
    }
  }
  std::vector<TexCoord> at;
  for (const float u : coordinates) {
    const auto other = std::size_t(random.integer(0, std::int64_t(coordinates.size()) - 1));
    at.push_back({u, coordinates[other]});
  }

  const Wrap wraps[] = {Wrap::kRepeat, Wrap::kMirroredRepeat, Wrap::kClampToEdge};
  for (const int width : sides) {
    const int height = sides[std::size_t(random.integer(0, 7))];
    Image<Rgba8> image(width, height);
    for (Rgba8& texel : image.pixels) {
      const std::uint64_t bits = random.bits();
      texel = {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16),
               std::uint8_t(bits >> 24)};
    }
    for (const Wrap wrap : wraps) {
      for (const Sampler& sampler : all_filters(wrap, wraps[random.integer(0, 2)])) {
        const Transfer transfer = random.integer(0, 1) == 0 ? Transfer::kSrgb : Transfer::kNone;
        const MipChain texture = make_mip_chain(image, transfer, sampler.mip == MipFilter::kNone);
        INFO(width << " x " << height << ", wraps " << int(wrap) << " " << int(sampler.wrap_v)
                   << ", filters " << int(sampler.magnify) << " " << int(sampler.minify) << " "
                   << int(sampler.mip));
        const std::vector<float> levels = levels_of_detail(random, at.size());
        std::vector<Rgba> expected, actual(at.size());
        for (std::size_t i = 0; i < at.size(); ++i) {
          expected.push_back(sample_mip_chain(texture, sampler, {at[i].u, at[i].v}, levels[i]));
        }
        for_each_target([&](const LaneProbes& lanes) {
          lanes.sample(texture, sampler, at, levels, actual.data());
          CHECK(differing(flattened(expected), flattened(actual)) == 0);
        });
      }
    }
  }
}

// ---- samples ----

TEST_CASE("lanes take the mean of a pixel's samples as the scalar stage does") {
  Random random(77);
  for (const std::size_t count :
       {std::size_t{2}, std::size_t{4}, std::size_t{8}, std::size_t{16}}) {
    for (const Transfer transfer : {Transfer::kSrgb, Transfer::kNone}) {
      INFO(count << " samples, transfer " << int(transfer));
      std::vector<Rgba8> samples(4099 * count), means(4099);
      for (Rgba8& sample : samples) {
        const std::uint64_t bits = random.bits();
        sample = {std::uint8_t(bits), std::uint8_t(bits >> 8), std::uint8_t(bits >> 16),
                  std::uint8_t(bits >> 24)};
      }
      std::fill_n(samples.begin(), count * 40, Rgba8{1, 128, 254, 255});  // equal samples
      std::vector<Rgba8> expected;
      for (std::size_t i = 0; i < means.size(); ++i) {
        expected.push_back(mean_color(transfer, std::span(samples).subspan(i * count, count)));
      }
      for_each_target([&](const LaneProbes& lanes) {
        lanes.mean_color(transfer, samples, count, means.data());
        CHECK(means == expected);
      });
    }
  }
}

// ---- light ----

std::vector<float> flattened(const std::vector<Reflection>& light, bool highlights) {
  std::vector<float> all;
  for (const Reflection& r : light) {
    all.insert(all.end(), r.diffuse.begin(), r.diffuse.end());
    if (highlights) all.insert(all.end(), r.specular.begin(), r.specular.end());
  }
  return all;
}

TEST_CASE("lanes find the level of detail of the scalar stage, whatever the gradient") {
  Random random(13);
  std::vector<TextureGradient> gradients;
  const std::vector<float> special = special_values();
  for (const float a : special) {
    for (const float b : special) gradients.push_back({{a, 0.0f}, {b, 1.0f}});
  }
  // Gradients whose squares range from below the smallest float to infinity.
  for (int i = 0; i < 20000; ++i) {
    const auto change = [&] { return float(random.scaled(-1, 1, -90, 70)); };
    gradients.push_back({{change(), change()}, {change(), change()}});
  }
  std::vector<float> expected, actual(gradients.size());
  for (const TextureGradient& g : gradients) expected.push_back(level_of_detail(g, 640, 480));
  for_each_target([&](const LaneProbes& lanes) {
    lanes.level_of_detail(640, 480, gradients, actual.data());
    CHECK(differing(expected, actual) == 0);
  });
}

TEST_CASE("lanes light as the scalar stage does: every kind of light, near, far and where it is") {
  Random random(11);
  const auto anywhere = [&](double most) {
    return Float3{float(random.between(-most, most)), float(random.between(-most, most)),
                  float(random.between(-most, most))};
  };
  for (int scene_number = 0; scene_number < 60; ++scene_number) {
    Scene scene;
    for (std::int64_t i = random.integer(0, 3); i > 0; --i) {
      Light light;
      light.kind = LightKind(random.integer(0, 2));
      light.intensity = std::exp2(random.between(-10, 40));
      light.color = {1.0f, float(random.unit()), 0.0f};
      if (random.integer(0, 1) == 0) light.range = std::exp2(random.between(-4, 10));
      light.outer_cone_radians = random.between(0.01, 1.57);
      light.inner_cone_radians = light.outer_cone_radians * random.unit();
      const Float3 p = anywhere(5);
      light.position = {p[0], p[1], p[2]};
      const double z = random.between(-1, 1), angle = random.between(0, 2 * kPi);
      const double r = std::sqrt(1 - z * z);
      light.direction = {r * std::cos(angle), r * std::sin(angle), z};
      scene.lights.push_back(light);
    }
    View view;
    view.perspective = random.integer(0, 1) == 0;
    const Lighting lighting = light_scene(scene, view);

    std::vector<Float3> positions, normals;
    for (int i = 0; i < 500; ++i) {
      positions.push_back(anywhere(std::exp2(random.between(-3, 10))));
      normals.push_back(anywhere(1));
      if (random.integer(0, 9) == 0) normals.back() = {0, 0, 0};
      if (random.integer(0, 9) == 0) positions.back() = {0, 0, 0};
      if (!lighting.lights.empty() && random.integer(0, 9) == 0) {  // at the position of the light
        const Point<Eye>& p = lighting.lights[0].position;
        positions.back() = {p.x, p.y, p.z};
      }
      // The squares of the first overflow, those of the second underflow.
      if (random.integer(0, 19) == 0) positions.back() = anywhere(3e38);
      if (random.integer(0, 19) == 0) normals.back() = anywhere(1e-30);
    }
    for (const int shininess : {1, 2, 16, 127, 1024}) {
      for (const bool highlights : {true, false}) {
        INFO("scene " << scene_number << ", shininess " << shininess);
        std::vector<Reflection> expected, actual(positions.size());
        for (std::size_t i = 0; i < positions.size(); ++i) {
          expected.push_back(illuminate(lighting, positions[i], normals[i], shininess));
        }
        for_each_target([&](const LaneProbes& lanes) {
          lanes.illuminate(lighting, shininess, highlights, positions, normals, actual.data());
          CHECK(differing(flattened(expected, highlights), flattened(actual, highlights)) == 0);
        });
      }
    }
  }
}

}  // namespace
}  // namespace glassbox
