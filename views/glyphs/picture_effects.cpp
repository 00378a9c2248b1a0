#include "views/glyphs/picture_effects.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include <glassbox/base/elementary.h>
#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/images/srgb.h>

#include "views/glyphs/colors.h"

namespace glassbox::views {

namespace {

// ---- blur ----

using Lights = std::vector<Eigen::Vector3f>;

// A blur along rows or columns: each pixel becomes the weighted mean of the pixels around it;
// outside of the picture its border is repeated.
Lights blurred_along(const Lights& lights, int width, int height, bool is_along_rows,
                     const std::vector<float>& weights) {
  const int reach = int(weights.size()) - 1, most = (is_along_rows ? width : height) - 1;
  Lights result(lights.size());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (int k = -reach; k <= reach; ++k) {
        const int at = std::clamp((is_along_rows ? x : y) + k, 0, most);
        const int i = is_along_rows ? at : x, j = is_along_rows ? y : at;
        sum += weights[std::size_t(std::abs(k))] *
               lights[std::size_t(j) * std::size_t(width) + std::size_t(i)];
      }
      result[std::size_t(y) * std::size_t(width) + std::size_t(x)] = sum;
    }
  }
  return result;
}

// ---- JPEG ----

using Block = Eigen::Matrix<double, 8, 8>;

// Quantization tables of ITU-T T.81, Annex K, tables K.1 and K.2.
constexpr std::array<std::uint8_t, 64> kLuminance{
    16, 11, 10, 16, 24,  40,  51,  61,  12, 12, 14, 19, 26,  58,  60,  55,
    14, 13, 16, 24, 40,  57,  69,  56,  14, 17, 22, 29, 51,  87,  80,  62,
    18, 22, 37, 56, 68,  109, 103, 77,  24, 35, 55, 64, 81,  104, 113, 92,
    49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99};
constexpr std::array<std::uint8_t, 64> kChrominance{
    17, 18, 24, 47, 99, 99, 99, 99, 18, 21, 26, 66, 99, 99, 99, 99, 24, 26, 56, 99, 99, 99,
    99, 99, 47, 66, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
    99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99};

Block steps_of(const std::array<std::uint8_t, 64>& table, int quality) {
  const int scale = quality < 50 ? 5000 / quality : 200 - 2 * quality;
  Block steps;
  for (int i = 0; i < 64; ++i)
    steps(i / 8, i % 8) = std::clamp((table[std::size_t(i)] * scale + 50) / 100, 1, 255);
  return steps;
}

// The matrix of the orthonormal cosine transform.
const Block& cosines() {
  static const Block matrix = [] {
    Block made;
    for (int k = 0; k < 8; ++k) {
      for (int n = 0; n < 8; ++n)
        made(k, n) =
            sin_cos_degrees(180.0 / 16 * (2 * n + 1) * k).cos * (k == 0 ? std::sqrt(1.0 / 8) : 0.5);
    }
    return made;
  }();
  return matrix;
}

void round_blocks(Eigen::MatrixXd& plane, const Block& steps) {
  const Eigen::Index height = plane.rows(), width = plane.cols();
  for (Eigen::Index y = 0; y < height; y += 8) {
    for (Eigen::Index x = 0; x < width; x += 8) {
      Block block;
      for (Eigen::Index j = 0; j < 8; ++j) {
        for (Eigen::Index i = 0; i < 8; ++i)
          block(j, i) = plane(std::min(y + j, height - 1), std::min(x + i, width - 1)) - 128;
      }
      Block coefficients = cosines() * block * cosines().transpose();
      coefficients = (coefficients.array() / steps.array()).round() * steps.array();
      block = cosines().transpose() * coefficients * cosines();
      for (Eigen::Index j = 0; j < std::min<Eigen::Index>(8, height - y); ++j) {
        for (Eigen::Index i = 0; i < std::min<Eigen::Index>(8, width - x); ++i)
          plane(y + j, x + i) = std::clamp(std::round(block(j, i) + 128), 0.0, 255.0);
      }
    }
  }
}

Eigen::MatrixXd halved(const Eigen::MatrixXd& plane) {
  Eigen::MatrixXd small((plane.rows() + 1) / 2, (plane.cols() + 1) / 2);
  for (Eigen::Index y = 0; y < small.rows(); ++y) {
    for (Eigen::Index x = 0; x < small.cols(); ++x) {
      const Eigen::Index right = std::min(2 * x + 1, plane.cols() - 1),
                         below = std::min(2 * y + 1, plane.rows() - 1);
      small(y, x) =
          (plane(2 * y, 2 * x) + plane(2 * y, right) + plane(below, 2 * x) + plane(below, right)) /
          4;
    }
  }
  return small;
}

}  // namespace

Image<Rgba8> blurred(const Image<Rgba8>& picture, double deviation) {
  if (!(deviation > 0)) return picture;
  std::vector<float> weights;
  const int reach = int(std::ceil(3 * deviation));
  double all = 0;
  for (int k = 0; k <= reach; ++k)
    all += (k == 0 ? 1 : 2) * exponential(-k * k / (2 * deviation * deviation));
  for (int k = 0; k <= reach; ++k)
    weights.push_back(float(exponential(-k * k / (2 * deviation * deviation)) / all));
  Lights lights;
  for (const Rgba8& pixel : picture.pixels) lights.emplace_back(light_of(pixel));
  lights = blurred_along(lights, picture.width, picture.height, true, weights);
  lights = blurred_along(lights, picture.width, picture.height, false, weights);
  Image<Rgba8> result = picture;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const Eigen::Vector3f& light = lights[i];
    result.pixels[i] = {encode_srgb(light.x()), encode_srgb(light.y()), encode_srgb(light.z()),
                        255};
  }
  return result;
}

Image<Rgba8> with_gains(const Image<Rgba8>& picture, const std::array<double, 3>& gains) {
  Image<Rgba8> result = picture;
  const auto scaled = [](std::uint8_t code, double gain) {
    return encode_srgb(float(double(decode_srgb(code)) * gain));
  };
  for (Rgba8& pixel : result.pixels) {
    pixel = {scaled(pixel.r, gains[0]), scaled(pixel.g, gains[1]), scaled(pixel.b, gains[2]),
             pixel.a};
  }
  return result;
}

Image<Rgba8> apply_jpeg(const Image<Rgba8>& picture, int quality) {
  const int width = picture.width, height = picture.height;
  std::array<Eigen::MatrixXd, 3> planes;
  for (auto& plane : planes) plane.resize(height, width);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Rgba8& p = picture.at(x, y);
      planes[0](y, x) = 0.299 * p.r + 0.587 * p.g + 0.114 * p.b;
      planes[1](y, x) = 128 - 0.168736 * p.r - 0.331264 * p.g + 0.5 * p.b;
      planes[2](y, x) = 128 + 0.5 * p.r - 0.418688 * p.g - 0.081312 * p.b;
    }
  }
  round_blocks(planes[0], steps_of(kLuminance, quality));
  for (std::size_t c : {1u, 2u}) {
    planes[c] = halved(planes[c]);
    round_blocks(planes[c], steps_of(kChrominance, quality));
  }
  Image<Rgba8> result(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double luma = planes[0](y, x), cb = planes[1](y / 2, x / 2) - 128,
                   cr = planes[2](y / 2, x / 2) - 128;
      const auto code = [](double value) {
        return std::uint8_t(std::clamp(value + 0.5, 0.0, 255.0));
      };
      result.at(x, y) = {code(luma + 1.402 * cr), code(luma - 0.344136 * cb - 0.714136 * cr),
                         code(luma + 1.772 * cb), 255};
    }
  }
  return result;
}

OccludedPicture occluded(const Image<Rgba8>& picture, double share, std::uint64_t seed) {
  OccludedPicture result{picture, Image<std::uint8_t>(picture.width, picture.height, 0)};
  Random random(seed);
  const double half = picture.height / 32.0, size = hypotenuse(picture.width, picture.height);
  const double wanted = std::min(share, 1.0) * double(picture.pixels.size());
  double covered = 0;
  while (covered < wanted) {
    const SinCos turn = sin_cos_degrees(random.between(0, 180));
    const double x0 = random.between(0, picture.width), y0 = random.between(0, picture.height);
    const double length = random.between(0.1, 0.5) * size;
    const auto shade = std::uint8_t(random.integer(40, 90));
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const double along = (x + 0.5 - x0) * turn.cos + (y + 0.5 - y0) * turn.sin,
                     across = (y + 0.5 - y0) * turn.cos - (x + 0.5 - x0) * turn.sin;
        if (std::abs(across) > half || std::abs(along) > length / 2) continue;
        result.picture.at(x, y) = {shade, std::uint8_t(shade - 10), std::uint8_t(shade - 20), 255};
        covered += result.covered.at(x, y) == 0;
        result.covered.at(x, y) = 255;
      }
    }
  }
  return result;
}

}  // namespace glassbox::views
