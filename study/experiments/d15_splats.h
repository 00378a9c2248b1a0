// The footprints of a sample (D-15) around the place (x, y) to which it is warped, in pixels of the
// picture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <glassbox/images/image.h>

#include "views/layers/layered_image.h"

namespace glassbox::study::d15 {

// How many times larger a pixel of the first picture is in the other one, to the right and
// downwards. The two values are the same for a surface that faces both eyes.
struct Magnification {
  double x = 1, y = 1;
  double focal = 1;  // F2 d1 / (F1 d2) for focal lengths F and distances d, without tilt
};

struct Pixels {
  int left, top, right, bottom;  // right and bottom are one beyond the last pixel
};
// The pixels whose centres are within half a width and half a height of (x, y).
inline Pixels within(double x, double y, double half_width, double half_height) {
  const auto edge = [](double v) { return int(std::floor(v + 0.5)); };
  return {edge(x - half_width), edge(y - half_height), edge(x + half_width), edge(y + half_height)};
}

// ---- footprints that hide what is behind them: put(u, v) for each pixel ----

struct Square {
  double side = 1;
  template <class Put>
  void operator()(double x, double y, Put&& put) const {
    const Pixels p = within(x, y, side / 2, side / 2);
    for (int v = p.top; v < p.bottom; ++v) {
      for (int u = p.left; u < p.right; ++u) put(u, v);
    }
  }
};

// A disc around a square sample as the other eye sees it: the ellipse through the corners of the
// area that the sample's pixel covers there.
struct Ellipse {
  double half_width = 1, half_height = 1;  // in px
  template <class Put>
  void operator()(double x, double y, Put&& put) const {
    const Pixels p = within(x, y, half_width, half_height);
    for (int v = p.top; v < p.bottom; ++v) {
      for (int u = p.left; u < p.right; ++u) {
        const double a = (u + 0.5 - x) / half_width, b = (v + 0.5 - y) / half_height;
        if (a * a + b * b <= 1) put(u, v);
      }
    }
  }
};

// ---- footprints that are blended: put(u, v, weight) ----

// A square of one of four sizes, with weights that are powers of two (Shade et al. 1998, section
// 4.3).
struct FourSizes {
  int side = 1;
  static FourSizes for_size(double wanted) {
    int side = 1;
    while (side < 7 && side < wanted) side += 2;
    return {side};
  }
  // The weight of a pixel at (a, b) from the middle one: a bell curve that falls to 1/e^2 at the
  // rim, rounded to 1, 1/2 or 1/4.
  double weight(int a, int b) const {
    const double rim = side / 2.0, bell = std::exp(-2 * (a * a + b * b) / (rim * rim));
    return bell >= 0.75 ? 1 : bell >= 0.375 ? 0.5 : 0.25;
  }
  template <class Put>
  void operator()(double x, double y, Put&& put) const {
    const int u = int(std::floor(x)), v = int(std::floor(y)), reach = side / 2;
    for (int b = -reach; b <= reach; ++b) {
      for (int a = -reach; a <= reach; ++a) put(u + a, v + b, weight(a, b));
    }
  }
};

// Elliptical weighted average (Heckbert 1989): a bell curve with a standard deviation of half a
// pixel of the first picture, warped to the other picture and convolved with a bell curve of half a
// pixel there.
struct Gaussian {
  static constexpr double kReach = 3;  // in standard deviations
  double deviation_x = 1, deviation_y = 1;
  static Gaussian for_magnification(const Magnification& m) {
    return {std::hypot(0.5 * m.x, 0.5), std::hypot(0.5 * m.y, 0.5)};
  }
  double weight(double dx, double dy) const {
    const double a = dx / deviation_x, b = dy / deviation_y;
    return std::exp(-(a * a + b * b) / 2);
  }
  template <class Put>
  void operator()(double x, double y, Put&& put) const {
    const Pixels p = within(x, y, kReach * deviation_x, kReach * deviation_y);
    for (int v = p.top; v < p.bottom; ++v) {
      for (int u = p.left; u < p.right; ++u) put(u, v, weight(u + 0.5 - x, v + 0.5 - y));
    }
  }
};

// ---- pictures ----

struct Splatted {
  Image<Rgba8> color;
  Image<float> depth;  // 0: a hole
};

// Draws all samples. In each pixel the nearer sample stays, and the first one of equally near
// samples; if the footprint is blended, samples at the same distance are averaged.
template <class Footprint>
Splatted splat(const views::LayeredImage& image, const views::LayerCamera& to,
               const Footprint& footprint) {
  constexpr bool is_blended =
      std::is_same_v<Footprint, FourSizes> || std::is_same_v<Footprint, Gaussian>;
  Splatted picture{Image<Rgba8>(to.width, to.height, Rgba8{0, 0, 0, 255}),
                   Image<float>(to.width, to.height, 0.0f)};
  const Eigen::Matrix4d matrix = views::warp_matrix(to, image.camera);
  struct Sum {
    float r = 0, g = 0, b = 0, weight = 0;
  };
  Image<Sum> sums(is_blended ? to.width : 1, is_blended ? to.height : 1, Sum{});
  const auto is_inside = [&](int u, int v) {
    return u >= 0 && v >= 0 && u < to.width && v < to.height;
  };
  std::size_t place = 0;
  for (int y = image.camera.height; y-- > 0;) {
    for (int x = 0; x < image.camera.width; ++x, ++place) {
      for (std::uint32_t i = image.first[place]; i < image.first[place + 1]; ++i) {
        const Eigen::Vector4d at =
            matrix * Eigen::Vector4d(x + 0.5, y + 0.5, double(image.depth[i]), 1);
        const float z = float(at.z() / at.w());
        const Rgba8 c = image.color[i];
        if constexpr (is_blended) {
          footprint(at.x() / at.w(), at.y() / at.w(), [&](int u, int v, double w) {
            if (!is_inside(u, v)) return;
            float& depth = picture.depth.at(u, v);
            Sum& sum = sums.at(u, v);
            if (z < depth) return;
            if (z > depth) sum = {}, depth = z;
            const auto weight = float(w);
            sum.r += weight * c.r, sum.g += weight * c.g, sum.b += weight * c.b;
            sum.weight += weight;
          });
        } else {
          footprint(at.x() / at.w(), at.y() / at.w(), [&](int u, int v) {
            if (!is_inside(u, v) || !(z > picture.depth.at(u, v))) return;
            picture.depth.at(u, v) = z;
            picture.color.at(u, v) = c;
          });
        }
      }
    }
  }
  if constexpr (is_blended) {
    for (std::size_t i = 0; i < sums.pixels.size(); ++i) {
      const Sum& sum = sums.pixels[i];
      if (!(sum.weight > 0)) continue;
      const auto byte = [&](float channel) { return std::uint8_t(channel / sum.weight + 0.5f); };
      picture.color.pixels[i] = {byte(sum.r), byte(sum.g), byte(sum.b), 255};
    }
  }
  return picture;
}

}  // namespace glassbox::study::d15
