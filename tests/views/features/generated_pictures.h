// Generated pictures of one pattern, turned, scaled and lit in known ways: for each point of one
// picture it is known where it is in the other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Core>

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/images/image.h>

namespace glassbox::test {

using Eigen::Vector2d;

// A pattern of grey squares of several sizes and directions, different everywhere: about as much
// detail as a photograph of a town. The values are from 0 to 1.
class GreySquares {
public:
  explicit GreySquares(std::uint64_t seed) {
    Random random(seed);
    for (std::size_t i = 0; i < kSizes.size(); ++i) {
      lattices_[i].turn = sin_cos_degrees(random.between(0, 90));
      lattices_[i].seed = random.bits();
    }
  }

  double at(const Vector2d& place) const {
    double sum = 0;
    for (std::size_t i = 0; i < kSizes.size(); ++i) sum += value(i, place) * kWeights[i];
    return sum;
  }

private:
  static constexpr std::array kSizes{47.0, 23.0, 11.0};  // px
  static constexpr std::array kWeights{0.4, 0.35, 0.25};

  struct Lattice {
    SinCos turn;
    std::uint64_t seed = 0;
  };

  double value(std::size_t i, const Vector2d& place) const {
    const auto& [turn, seed] = lattices_[i];
    const double u = (turn.cos * place.x() - turn.sin * place.y()) / kSizes[i];
    const double v = (turn.sin * place.x() + turn.cos * place.y()) / kSizes[i];
    const auto column = std::uint64_t(std::int64_t(std::floor(u)));
    const auto row = std::uint64_t(std::int64_t(std::floor(v)));
    return Random(seed ^ column * 0x9e3779b97f4a7c15u ^ row * 0xc2b2ae3d27d4eb4fu).unit();
  }

  std::array<Lattice, 3> lattices_;
};

// How the right picture shows the left one's points: turned about the middle, then scaled. Then its
// grey is changed, and each pixel gets noise.
struct PictureChange {
  double degrees = 0;  // clockwise, as y is down
  double scale = 1;
  Vector2d shift{0, 0};         // px of the right picture
  double gain = 1, offset = 0;  // grey levels
  double noise = 0;             // standard deviation, grey levels
};

struct KnownPair {
  Image<Rgba8> left, right;
  PictureChange change;

  Vector2d centre() const { return {left.width / 2.0, left.height / 2.0}; }
  // Where the right picture shows a point of the left one, px.
  Vector2d in_right(const Vector2d& point) const {
    const SinCos turn = sin_cos_degrees(change.degrees);
    const Vector2d from = point - centre();
    return centre() + change.shift +
           change.scale * Vector2d(turn.cos * from.x() - turn.sin * from.y(),
                                   turn.sin * from.x() + turn.cos * from.y());
  }
  Vector2d in_left(const Vector2d& point) const {
    const SinCos turn = sin_cos_degrees(change.degrees);
    const Vector2d from = (point - centre() - change.shift) / change.scale;
    return centre() + Vector2d(turn.cos * from.x() + turn.sin * from.y(),
                               turn.cos * from.y() - turn.sin * from.x());
  }
  bool is_inside(const Vector2d& point, double margin) const {
    return point.x() >= margin && point.y() >= margin && point.x() <= left.width - margin &&
           point.y() <= left.height - margin;
  }
};

// The picture whose pixel at a place shows the mean of grey(place) over the pixel's square, from
// kSamples x kSamples samples: `grey` is a function of a Vector2d, 0 to 1.
template <int kSamples = 4, class Grey>
Image<Rgba8> drawn_picture(int width, int height, const PictureChange& light, std::uint64_t seed,
                           const Grey& grey) {
  Random random(seed);
  Image<Rgba8> picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int i = 0; i < kSamples * kSamples; ++i) {
        const double dx = (i % kSamples + 0.5) / kSamples, dy = (i / kSamples + 0.5) / kSamples;
        sum += grey(Vector2d(x + dx, y + dy));
      }
      double normal = -6;
      for (int i = 0; i < 12; ++i) normal += random.unit();
      const double level = light.gain * 255 * sum / (kSamples * kSamples) + light.offset;
      const auto code = std::uint8_t(std::clamp(level + light.noise * normal + 0.5, 0.0, 255.0));
      picture.at(x, y) = {code, code, code, 255};
    }
  }
  return picture;
}

// The left picture is lit and has noise like the right one's, but with a gain of 1.
inline KnownPair known_pair(std::uint64_t seed, int width, int height,
                            const PictureChange& change) {
  const GreySquares pattern(seed);
  KnownPair pair;
  pair.change = change;
  PictureChange plain;
  plain.noise = change.noise;
  pair.left = drawn_picture(width, height, plain, 2 * seed,
                            [&](const Vector2d& at) { return pattern.at(at); });
  pair.right = Image<Rgba8>(width, height);
  pair.right = drawn_picture(width, height, change, 2 * seed + 1,
                             [&](const Vector2d& at) { return pattern.at(pair.in_left(at)); });
  return pair;
}

}  // namespace glassbox::test
