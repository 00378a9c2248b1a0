// Cards in front of a wall (D-11): a scene in which the holes that a warp leaves are known.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>

namespace glassbox::study::d11 {

// ---- cards before a wall, all at distances whose parallax is a whole number of pixels ----
//
// Everything is made of cells of 4 x 4 px of the left picture, each with its own colour, so that a
// warp moves whole pixels and has errors only in the holes. The width of a hole is the difference
// of two parallaxes, (W/2)(d/h) B (1/z_front - 1/z_back): W is the width of the picture, d/h an
// entry of the projection, B the distance between the eyes, z a distance.

inline constexpr int kWidth = 240, kHeight = 160, kCell = 4;
inline constexpr double kWindow = 8;

struct Card {
  int x, y, columns, rows;  // left picture, px, multiples of kCell
  int parallax;             // px, at most 0; the wall has 0
};

// The hole beside a single card shows the wall, which is in the second layer. Two cards with a
// common right edge, one behind the other, are a stack: in a part of the hole beside it, the wall
// is only in the third layer.
inline std::vector<Card> cards() {
  std::vector<Card> all;
  for (int i = 0; i < 5; ++i) {
    const int x = 20 + 44 * i;
    all.push_back({x, 12, 24, 28, i % 2 == 0 ? -8 : -4});
    all.push_back({x, 56, 28, 40, -4});
    all.push_back({x + 4, 64, 24, 24, -8});
    all.push_back({x, 112, 20, 32, -12});
  }
  return all;
}

// Inverts the formula in parallax.h: 1/z = 1/f - p/(W (d/h) s). z is the distance, f that of the
// window, p the parallax, W the width, s half of the eyes' distance; d/h is the entry (0, 0) of the
// projection.
inline double distance_of(int parallax, const View& centre, const StereoPair& pair) {
  return 1 / (1 / pair.window -
              parallax / (kWidth * centre.clip_from_eye.at(0, 0) * pair.half_separation));
}

inline void add_cells(Mesh& mesh, const Card& card, const View& centre, const StereoPair& pair,
                      std::uint64_t stream) {
  const double z = distance_of(card.parallax, centre, pair);
  const double h = z / centre.clip_from_eye.at(0, 0), v = z / centre.clip_from_eye.at(1, 1);
  const double shift = pair.half_separation * (1 - z / pair.window);
  const auto x_of = [&](int px) { return (2.0 * px / kWidth - 1) * h - shift; };
  const auto y_of = [&](int px) { return (1 - 2.0 * px / kHeight) * v; };
  for (int y = card.y; y < card.y + card.rows; y += kCell) {
    for (int x = card.x; x < card.x + card.columns; x += kCell) {
      const auto channel = [&](std::uint64_t k) {
        return float(scramble(stream + 3 * std::uint64_t(y * kWidth + x) + k) % 256) / 255.0f;
      };
      const std::uint32_t color = add_color(mesh, {channel(0), channel(1), channel(2), 1});
      const std::array<std::uint32_t, 4> corners{
          add_position(mesh, x_of(x), y_of(y + kCell), -z),
          add_position(mesh, x_of(x + kCell), y_of(y + kCell), -z),
          add_position(mesh, x_of(x + kCell), y_of(y), -z),
          add_position(mesh, x_of(x), y_of(y), -z)};
      add_flat_face(mesh, corners, color);
    }
  }
}

// The number of pixels in the right picture that stay empty with `layers` layers of the left one.
// To the right of its right edge, a card uncovers `-parallax` columns of the wall. Beside a stack
// of two cards, 4 of these columns show the rear card, which is in the second layer, and 4 show the
// wall, which is in the third.
inline double hole_pixels(int layers) {
  double pixels = 0;
  const std::vector<Card> all = cards();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Card& card = all[i];
    const bool stacked = i % 4 == 2, behind = i % 4 == 1;
    // Rows of the rear card that the front card also has are counted with the front card.
    const int rows = behind ? card.rows - all[i + 1].rows : card.rows;
    if (layers == 1) pixels += -card.parallax * rows;
    if (layers == 2 && stacked) pixels += 4 * card.rows;
  }
  return pixels;
}

// The number of pixels that show another surface in the right picture than in the left one: the
// pixels that cards cover in either picture. The two cards of a stack together cover what the rear
// card covers.
inline double moved_pixels() {
  double pixels = 0;
  const std::vector<Card> all = cards();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % 4 != 2) pixels += double(all[i].columns - all[i].parallax) * all[i].rows;
  }
  return pixels;
}
inline constexpr double kLargestParallax = 12;

}  // namespace glassbox::study::d11
