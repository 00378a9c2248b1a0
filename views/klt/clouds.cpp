#include "views/klt/clouds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/images.h>

namespace glassbox::views {

namespace {

struct Direction {
  double x, y, z;
};

double smooth(double t) {
  return t * t * (3 - 2 * t);
}

// Value noise: random numbers at points with whole coordinates, interpolated smoothly between them.
double value_noise(std::uint64_t seed, const Direction& p) {
  const double x = std::floor(p.x), y = std::floor(p.y), z = std::floor(p.z);
  const double s = smooth(p.x - x), t = smooth(p.y - y), r = smooth(p.z - z);
  const auto at = [&](int i, int j, int k) {
    const auto whole = [](double v) { return std::uint64_t(std::int64_t(v) + 4096); };
    const std::uint64_t index = (whole(x + i) << 32) + (whole(y + j) << 16) + whole(z + k);
    return random_unit(seed, index);
  };
  const auto mix = [](double a, double b, double share) { return a + (b - a) * share; };
  const auto row = [&](int j, int k) { return mix(at(0, j, k), at(1, j, k), s); };
  return mix(mix(row(0, 0), row(1, 0), t), mix(row(0, 1), row(1, 1), t), r);
}

// The sum of several noises (octaves): each has details of half the size and half the weight of
// those of the noise before. The result is in 0 .. 1.
double fractal(std::uint64_t seed, const Direction& p, double frequency, int octaves) {
  double sum = 0, weight = 0.5, all = 0;
  for (int i = 0; i < octaves; ++i, frequency *= 2, weight /= 2) {
    sum += weight * value_noise(seed + std::uint64_t(i),
                                {p.x * frequency, p.y * frequency, p.z * frequency});
    all += weight;
  }
  return sum / all;
}

double fraction_between(double low, double high, double value) {
  return std::clamp((value - low) / (high - low), 0.0, 1.0);
}

struct Sky {
  double opacity, height, moisture, land, desert, warmth;
};

Sky sky_at(const Direction& p) {
  Sky sky{};
  sky.land = smooth(fraction_between(0.5, 0.53, fractal(100, p, 1.6, 6)));
  sky.desert = smooth(fraction_between(0.4, 0.65, fractal(150, p, 2.5, 5)));
  // Winds stretch clouds along circles of latitude.
  const Direction pulled{p.x, 2.2 * p.y, p.z};
  const double thickness = 14 * fraction_between(0.5, 0.9, fractal(200, pulled, 2.4, 7));
  sky.opacity = thickness / (1 + thickness);
  sky.height = fractal(300, p, 2, 3);
  sky.moisture = fractal(400, p, 1.4, 4);
  sky.warmth = 1 - p.y * p.y;
  return sky;
}

// The light in per cent (the visible band), and temperatures in kelvins (the infrared bands).
std::array<double, kCloudBands> measured(const Sky& sky) {
  const double bare = 6 + sky.land * (9 + 36 * sky.desert);
  const double ground = 262 + 35 * sky.warmth + 5 * sky.land;
  const double top = ground - 25 - 70 * sky.height;
  const double seen = sky.opacity;
  const double short_wave = std::min(1.0, 1.1 * seen);
  return {bare + (82 - bare) * seen, ground + (top + 6 - ground) * short_wave,
          252 - 22 * sky.moisture - 14 * sky.height * seen, ground + (top - ground) * seen,
          ground + (top - ground) * seen - 6 * sky.moisture * (1 - seen)};
}

struct Channel {
  const char* name;
  double low, high, noise;  // measured values for the counts 0 and 1023; noise in counts
};
constexpr std::array<Channel, kCloudBands> kChannels{{{"visible 0.65 um", 0, 100, 1},
                                                      {"infrared 3.9 um", 180, 320, 3},
                                                      {"water vapour 6.7 um", 180, 320, 1.5},
                                                      {"infrared 10.7 um", 180, 320, 0.5},
                                                      {"infrared 12 um", 180, 320, 0.5}}};

Rgba8 ground_color(const Sky& sky, double grain) {
  const double cold = fraction_between(0.35, 0.1, sky.warmth);
  const auto channel = [&](double sea, double land) {
    const double bare = sea + (land * (0.75 + 0.5 * grain) - sea) * sky.land;
    return std::uint8_t(bare + (235 - bare) * cold + 0.5);
  };
  const double dry = sky.desert;
  return {channel(18, 62 + 118 * dry), channel(52, 88 + 62 * dry), channel(104, 46 + 50 * dry),
          255};
}

}  // namespace

CloudScene make_clouds(int width) {
  CloudScene scene;
  const int height = width / 2;
  scene.bands = {width, height, {}};
  for (const Channel& channel : kChannels)
    scene.bands.bands.push_back({channel.name, std::vector<double>(scene.bands.pixels())});
  scene.ground = Image<Rgba8>(width, height);
  scene.opacity.resize(scene.bands.pixels());
  std::vector<SinCos> turns;
  for (int x = 0; x < width; ++x) turns.push_back(sin_cos_degrees(360 * (x + 0.5) / width));
  for (int y = 0; y < height; ++y) {
    const SinCos polar = sin_cos_degrees(180 * (y + 0.5) / height);
    for (int x = 0; x < width; ++x) {
      // The same layout as that of the built-in sphere's texture: the left column is at -z, columns
      // to the right turn towards -x, and the top row is at the north pole, +y.
      const SinCos& turn = turns[std::size_t(x)];
      const Direction p{polar.sin * -turn.sin, polar.cos, polar.sin * -turn.cos};
      const Sky sky = sky_at(p);
      const std::size_t i = scene.ground.index(x, y);
      scene.opacity[i] = sky.opacity;
      scene.ground.pixels[i] = ground_color(sky, fractal(500, p, 12, 3));
      const std::array<double, kCloudBands> values = measured(sky);
      for (std::size_t b = 0; b < kChannels.size(); ++b) {
        const Channel& channel = kChannels[b];
        const double noise = channel.noise * (2 * random_unit(600 + b, i) - 1);
        const double count =
            1023 * (values[b] - channel.low) / (channel.high - channel.low) + noise;
        scene.bands.bands[b].samples[i] = std::clamp(std::floor(count + 0.5), 0.0, 1023.0);
      }
    }
  }
  return scene;
}

}  // namespace glassbox::views
