#include <glassbox/base/random.h>

#include "study/extremes/common/extreme_case.h"
#include "study/extremes/common/layers.h"
#include "study/naive/layers.h"

namespace glassbox::study {
namespace c82 {

constexpr int kSide = 33, kMiddle = 16;  // in px
constexpr double kFocal = 32, kNear = 1e-3;

// How the second eye moves: `ahead` units along the gaze (backwards if negative), in the direction
// in which the first eye sees pixel (x, y), counted from the middle pixel. If `ahead` is 0, it
// moves sideways, so that samples of closeness n shift by -n x and -n y pixels.
struct Move {
  double ahead;
  int x, y;
};

std::vector<Move> moves() {
  std::vector<Move> all;
  for (const double ahead : {1.0, -1.0, 0.0}) {
    for (const int x : {-30, 0, 5, 30}) {
      for (const int y : {-30, 0, -7, 30}) {
        const auto sign = [](int v) { return (v > 0) - (v < 0); };
        all.push_back(ahead != 0 ? Move{ahead, x, y} : Move{0, sign(x), sign(y)});
      }
    }
  }
  return all;
}

// A layered image whose samples are drawn exactly at pixel centres of the second picture; all
// samples that are drawn in the same pixel are exactly on one line through the second eye.
struct Lattice {
  views::LayeredImage image;
  views::LayerCamera to;
  Image<Rgba8> right;
};

// The place along one axis at which the second eye sees the sample of pixel k (counted from the
// middle) with closeness n, where e is the epipole on this axis; nothing if the place is not a
// pixel centre. If the eye moves ahead, the distance from the epipole is multiplied by n + 1; if it
// moves back, divided by n + 1; if it moves sideways, the place shifts by -n e.
std::optional<int> moved(const Move& move, int k, int e, int n) {
  if (move.ahead > 0) return (n + 1) * k - e * n;
  if (move.ahead == 0) return k - n * e;
  if ((k - e) % (n + 1) != 0) return std::nullopt;
  return (k - e) / (n + 1) + e;
}
double distance_of(const Move& move, int n) {
  if (move.ahead > 0) return (n + 1.0) / n;
  return move.ahead < 0 ? 1.0 / n : kFocal / n;
}

Lattice lattice_of(const Move& move) {
  const LayerEye first{.width = kSide, .height = kSide, .focal = kFocal, .near = kNear};
  LayerEye second = first;
  // Screen y points down and world y up, so y changes its sign.
  second.at = move.ahead == 0 ? std::array<double, 3>{double(move.x), double(-move.y), 0}
                              : std::array<double, 3>{move.ahead * move.x / kFocal,
                                                      -move.ahead * move.y / kFocal, -move.ahead};
  views::LayerBuilder builder(layer_camera_of(first), 0);
  Image<Rgba8> right(kSide, kSide, color_of_number(0));
  Image<double> nearest(kSide, kSide, HUGE_VAL);
  Random random(82);
  std::uint32_t number = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      for (int n = 1; n <= 5; ++n) {
        if (random.integer(0, 2) != 0) continue;
        const auto u = moved(move, x - kMiddle, move.x, n), v = moved(move, y - kMiddle, move.y, n);
        if (!u || !v) continue;
        const double distance = distance_of(move, n);
        const Rgba8 color = color_of_number(++number);
        builder.add(x, y, float(kNear / distance), color);
        const int column = *u + kMiddle, row = *v + kMiddle;
        if (column < 0 || column >= kSide || row < 0 || row >= kSide) continue;
        if (distance >= nearest.at(column, row)) continue;
        nearest.at(column, row) = distance;
        right.at(column, row) = color;
      }
    }
  }
  return {builder.pack(), layer_camera_of(second), std::move(right)};
}

using Draw = std::function<Image<Rgba8>(const Lattice&)>;

Outcome measure_error(const Draw& draw) {
  static const std::vector<Lattice> all = [] {
    std::vector<Lattice> made;
    for (const Move& move : moves()) made.push_back(lattice_of(move));
    return made;
  }();
  int wrong = 0, pixels = 0;
  for (const Lattice& lattice : all) {
    const Image<Rgba8> drawn = draw(lattice);
    for (std::size_t i = 0; i < drawn.pixels.size(); ++i) {
      pixels += number_of_color(lattice.right.pixels[i]) != 0;
      wrong += drawn.pixels[i] != lattice.right.pixels[i];
    }
  }
  return wrong_count_outcome(
      wrong, pixels, fmt::format("pixels are wrong, with {} places of the second eye", all.size()));
}

Image<Rgba8> in_order(const Lattice& lattice) {
  return drawn_layers(lattice.image, lattice.to, views::Splat::kPoint,
                      views::LayerOrder::kOcclusion)
      .color;
}

// The homogeneous coordinates of the epipole: its x and y times w, and w.
struct Epipole {
  double x, y, w;
};
Epipole epipole_of(const Lattice& lattice) {
  const Eigen::Vector4d at = lattice.image.camera.screen_from_world * views::eye_of(lattice.to);
  return {at.x(), at.y(), at.w()};
}
Image<Rgba8> by_lists(const Lattice& lattice, std::vector<int> columns, std::vector<int> rows,
                      bool back_to_front = true) {
  naive::SplatLoop loop;
  loop.side = [](double, double) { return 1.0; };
  loop.compares_depth = false;
  loop.columns = std::move(columns);
  loop.rows = std::move(rows);
  loop.back_to_front = back_to_front;
  return naive::splat(lattice.image, lattice.to, loop).color;
}
Image<Rgba8> as_packed(const Lattice& lattice) {
  return by_lists(lattice, {}, {});
}
// Visits the pixels towards the epipole, even if the eye has moved back, where the opposite order
// would be right.
Image<Rgba8> without_sign(const Lattice& lattice) {
  const Epipole e = epipole_of(lattice);
  const double sign = e.w < 0 ? -1 : 1;
  return by_lists(lattice, views::visiting_order(sign * e.x, sign * e.w, kSide),
                  views::visiting_order(sign * e.y, sign * e.w, kSide));
}
Image<Rgba8> rows_alone(const Lattice& lattice) {
  const Epipole e = epipole_of(lattice);
  return by_lists(lattice, {}, views::visiting_order(e.y, e.w, kSide));
}
Image<Rgba8> front_to_back(const Lattice& lattice) {
  const Epipole e = epipole_of(lattice);
  return by_lists(lattice, views::visiting_order(e.x, e.w, kSide),
                  views::visiting_order(e.y, e.w, kSide), false);
}

}  // namespace c82

ExtremeCase c82_layers_order() {
  using namespace c82;
  return {
      .id = "C-82",
      .name = "Epipoles in, beside and behind",
      .construction =
          "33 x 33 pixels with up to 5 samples each, and eyes that moved ahead, back and sideways, "
          "to 48 places: every sample falls on a pixel centre, and samples that fall on the same "
          "pixel are on one line",
      .stage = "layers",
      .right_answer =
          "each pixel shows its nearest sample, although no depths are compared (S1-11)",
      .unit = "pixels",
      .oracle = Oracle::kInteger,
      .ours = {"occlusion-compatible order", [] { return measure_error(in_order); }},
      .naive = {"the packed order", [] { return measure_error(as_packed); }},
      .mutants = {{"samples are visited towards the epipole even if it is behind the camera",
                   [] { return measure_error(without_sign); }},
                  {"rows are ordered by the epipole, but columns always from the left",
                   [] { return measure_error(rows_alone); }},
                  {"samples of one pixel are visited from front to back",
                   [] { return measure_error(front_to_back); }}},
      .not_drawn = "views/layers warps the samples; no engine of glassbox render takes part",
  };
}

}  // namespace glassbox::study
