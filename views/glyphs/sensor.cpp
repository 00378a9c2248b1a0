#include "views/glyphs/sensor.h"

#include <algorithm>
#include <cmath>

#include <glassbox/base/random.h>
#include <glassbox/images/srgb.h>

#include "views/glyphs/colors.h"

namespace glassbox::views {

namespace {

using Lights = Image<Rgb32f>;

float& channel_of(Rgb32f& light, int channel) {
  return channel == 0 ? light.r : channel == 1 ? light.g : light.b;
}
float channel_of(const Rgb32f& light, int channel) {
  return channel == 0 ? light.r : channel == 1 ? light.g : light.b;
}

// Interpolates between four pixels; outside of the picture the border is repeated.
Rgb32f light_between(const Image<Rgba8>& picture, double x, double y) {
  const double left = std::clamp(x - 0.5, 0.0, picture.width - 1.0),
               top = std::clamp(y - 0.5, 0.0, picture.height - 1.0);
  const int i = int(left), j = int(top);
  const auto across = float(left - i), down = float(top - j);
  Light sum = Light::Zero();
  for (int k = 0; k < 4; ++k) {
    const int at_x = std::min(i + k % 2, picture.width - 1),
              at_y = std::min(j + k / 2, picture.height - 1);
    const float weight = (k % 2 == 0 ? 1 - across : across) * (k / 2 == 0 ? 1 - down : down);
    sum += weight * light_of(picture.at(at_x, at_y));
  }
  return {sum[0], sum[1], sum[2]};
}

Lights through_lens(const Image<Rgba8>& picture, const Sensor& sensor) {
  Lights lights(picture.width, picture.height);
  const double half_x = picture.width / 2.0, half_y = picture.height / 2.0;
  const double corner = (half_x * half_x + half_y * half_y) / (half_y * half_y);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const double off_x = x + 0.5 - half_x, off_y = y + 0.5 - half_y;
      const double squared = (off_x * off_x + off_y * off_y) / (half_y * half_y);
      const double bent = 1 + sensor.distortion * squared;
      Rgb32f& light = lights.at(x, y);
      light = light_between(picture, half_x + bent * off_x, half_y + bent * off_y);
      const auto share = float(1 - sensor.falloff * squared / corner);
      light = {light.r * share, light.g * share, light.b * share};
    }
  }
  return lights;
}

// A random number with the mean 0 and the variance 1 that is normally distributed except in its
// tails: the sum of twelve uniform numbers in [0, 1), minus 6.
double normal(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.unit();
  return sum;
}

void add_noise(Lights& lights, double electrons, std::uint64_t seed) {
  Random random(seed);
  for (Rgb32f& light : lights.pixels) {
    for (int channel = 0; channel < 3; ++channel) {
      float& value = channel_of(light, channel);
      value += float(normal(random) * std::sqrt(double(value) / electrons));
    }
  }
}

int filter_at(int x, int y) {
  return (x & 1) + (y & 1);
}

// Keeps only the channel that a pixel's filter lets through, and interpolates the other channels
// from its neighbours.
Lights without_mosaic(const Lights& lights) {
  Lights whole = lights;
  for (int y = 0; y < lights.height; ++y) {
    for (int x = 0; x < lights.width; ++x) {
      for (int channel = 0; channel < 3; ++channel) {
        if (filter_at(x, y) == channel) continue;
        float sum = 0;
        int count = 0;
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, lights.height - 1); ++j) {
          for (int i = std::max(x - 1, 0); i <= std::min(x + 1, lights.width - 1); ++i) {
            if (filter_at(i, j) != channel) continue;
            sum += channel_of(lights.at(i, j), channel);
            ++count;
          }
        }
        if (count > 0) channel_of(whole.at(x, y), channel) = sum / float(count);
      }
    }
  }
  return whole;
}

}  // namespace

Image<Rgba8> apply_sensor(const Image<Rgba8>& picture, const Sensor& sensor, std::uint64_t seed) {
  Lights lights = through_lens(picture, sensor);
  if (sensor.electrons > 0) add_noise(lights, sensor.electrons, seed);
  if (sensor.has_mosaic) lights = without_mosaic(lights);
  Image<Rgba8> result(picture.width, picture.height);
  for (std::size_t i = 0; i < lights.pixels.size(); ++i) {
    const Rgb32f& light = lights.pixels[i];
    result.pixels[i] = {encode_srgb(light.r), encode_srgb(light.g), encode_srgb(light.b), 255};
  }
  return result;
}

}  // namespace glassbox::views
