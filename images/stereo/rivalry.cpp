#include <glassbox/images/stereo/rivalry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glassbox/images/colour/fixed_sum.h>
#include <glassbox/images/out_of_memory.h>

namespace glassbox {
namespace {

constexpr Linear kBlack{0, 0, 0};
constexpr Linear kWhite{1, 1, 1};

// Computes the ghosts that pairs of colours (one in each eye's picture) produce.
class Leak {
public:
  explicit Leak(const AnaglyphViewing& viewing)
      : viewing_(viewing),
        left_white_(luminance(viewing.lenses.left, mix_eyes(viewing.matrix, kWhite, kBlack))),
        right_white_(luminance(viewing.lenses.right, mix_eyes(viewing.matrix, kBlack, kWhite))) {}

  Ghosts operator()(const Linear& left, const Linear& right) const {
    const auto& [matrix, lenses] = viewing_;
    const Linear both = mix_eyes(matrix, left, right);
    const double left_alone = luminance(lenses.left, mix_eyes(matrix, left, kBlack));
    const double right_alone = luminance(lenses.right, mix_eyes(matrix, kBlack, right));
    return {std::abs(luminance(lenses.left, both) - left_alone) / left_white_,
            std::abs(luminance(lenses.right, both) - right_alone) / right_white_};
  }

private:
  AnaglyphViewing viewing_;
  double left_white_, right_white_;
};

}  // namespace

double content_measure(const Linear& colour, Glasses glasses) {
  const EyeChannels left = eye_masks(glasses).left;
  const bool is_left[3] = {left.r, left.g, left.b};
  float left_most = 0, right_most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    float& most = is_left[i] ? left_most : right_most;
    most = std::max(most, colour[i]);
  }
  const float most = std::max(left_most, right_most);
  return most > 0 ? double(std::min(left_most, right_most)) / double(most) : 1;
}

Result<AnaglyphViewing> anaglyph_viewing(AnaglyphMethod method, Glasses glasses) {
  const Result<AnaglyphMatrix> matrix = anaglyph_matrix(method, glasses);
  if (!matrix) return tl::unexpected(matrix.error());
  return AnaglyphViewing{*matrix, lenses_of(glasses)};
}

Rivalry::Rivalry(const AnaglyphViewing& viewing) : viewing_(viewing) {
  const Linear white = mix_eyes(viewing_.matrix, kWhite, kWhite);
  left_white_ = luminance(viewing_.lenses.left, white);
  right_white_ = luminance(viewing_.lenses.right, white);
}

double Rivalry::operator()(const Linear& colour) const {
  const Linear shown = mix_eyes(viewing_.matrix, colour, colour);
  return std::abs(luminance(viewing_.lenses.left, shown) / left_white_ -
                  luminance(viewing_.lenses.right, shown) / right_white_);
}

Image<float> rivalry_map(const Image<Rgba8>& picture, const AnaglyphViewing& viewing) {
  const Rivalry rivalry(viewing);
  Image<float> map(picture.width, picture.height);
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    map.pixels[i] = float(rivalry(linear_of(picture.pixels[i])));
  }
  return map;
}

Ghosts white_leak(const AnaglyphViewing& viewing) {
  const Leak leak(viewing);
  return {leak(kBlack, kWhite).left, leak(kWhite, kBlack).right};
}

Result<GhostMaps> ghost_maps(const Image<Rgba8>& left, const Image<Rgba8>& right,
                             const AnaglyphViewing& viewing) {
  const Result<void> same_size = check_eyes("ghosts", left, right);
  if (!same_size) return tl::unexpected(same_size.error());
  return unless_out_of_memory([&]() -> Result<GhostMaps> {
    const Leak leak(viewing);
    GhostMaps maps{{left.width, left.height}, {left.width, left.height}};
    for (std::size_t i = 0; i < left.pixels.size(); ++i) {
      const Ghosts ghosts = leak(linear_of(left.pixels[i]), linear_of(right.pixels[i]));
      maps.left.pixels[i] = float(ghosts.left);
      maps.right.pixels[i] = float(ghosts.right);
    }
    return maps;
  });
}

double mean_of(const Image<float>& map) {
  FixedSum sum;
  for (const float value : map.pixels) sum.add(double(value));
  return sum.count() > 0 ? sum.mean() : 0;
}

}  // namespace glassbox
