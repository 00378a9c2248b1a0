// Compares orders in which samples of a layered depth image are drawn: by depth, in an
// occlusion-compatible order, and in packed order (D-16).
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <tuple>
#include <vector>

#include "study/experiment/experiment.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/layer_samples.h"
#include "study/experiments/memoize.h"
#include "views/layers/draw_layers.h"

namespace glassbox::study {

namespace d16 {

constexpr int kSide = 128;  // in px
constexpr double kFocal = 128, kNear = 1e-3;

// A movement of the second eye, and samples at random pixels whose places in its picture are known
// without a matrix.
struct Move {
  const char* name;
  Eigen::Vector3d to;  // second eye in world units; the first is at 0 and looks along -z
  // Returns a random distance. Together with the movement it determines how many times farther from
  // the middle an object is in the second picture than in the first.
  double (*distance)(Random&);
  // px: side of the square in the middle of the picture that samples reach from all sides
  int middle;
  // The predicted fraction of wrong pixels among the pixels that show something, with `layers`
  // samples per pixel: in the occlusion-compatible order and in packed order.
  double (*order)(double layers);
  double (*packed)(double layers);
};

// If the number of samples on a pixel has a Poisson distribution with this mean: the fraction of
// pixels with two or more samples among the pixels with any.
double share_with_two(double mean) {
  return 1 - mean * std::exp(-mean) / (1 - std::exp(-mean));
}

// The eye moves one unit to the left. At the distance kFocal / n the parallax is n whole pixels to
// the right. Packed order goes to the right, and a sample that comes from further right to the same
// pixel is farther away. So the farthest one is drawn last and stays.
double at_whole_parallaxes(Random& random) {
  return kFocal / double(random.integer(1, 40));
}
// The eye moves one unit ahead. An object at the distance r/(r - 1) then appears r times as large;
// r is from 1.5 to 2.5.
double magnified(Random& random) {
  const double r = random.between(1.5, 2.5);
  return r / (r - 1);
}
// The eye moves one unit back, and objects appear half as large: r is from 0.5 to 0.501. Within
// this range, the place of a sample 32 px from the middle differs by 1/30 px.
double halved(Random& random) {
  const double r = random.between(0.5, 0.501);
  return r / (1 - r);
}
// Packed order draws rows from bottom to top. The right order goes towards the epipole, in the
// middle of the picture: packed order does so below the epipole, but goes away from it above.
double packed_ahead(double layers) {
  return share_with_two(layers * (1 / 1.5 - 1 / 2.5)) / 2;
}

const Move kMoves[] = {
    {"aside", {-1, 0, 0}, at_whole_parallaxes, 40, [](double) { return 0.0; }, share_with_two},
    {"ahead", {0, 0, -1}, magnified, 90, [](double) { return 0.0; }, packed_ahead},
    // Four pixels are warped to one. Which of the four samples is the nearest is independent of the
    // order of drawing, so the last one is wrong in three of four cases.
    {"back, a thin slab",
     {0, 0, 1},
     halved,
     56,
     [](double) { return 0.75; },
     [](double) { return 0.75; }},
};

struct LayerTestScene {
  const Move* move = nullptr;
  views::LayeredImage image;
  views::LayerCamera to;
  Image<Rgba8> right;
};

LayerTestScene make_test_scene(const Move& move, double layers) {
  const Eigen::Isometry3d first = Eigen::Isometry3d::Identity();
  LayerTestScene test_scene;
  test_scene.move = &move;
  test_scene.to = perspective_camera(kSide, kSide, kFocal, kNear,
                                     Eigen::Isometry3d(Eigen::Translation3d(-move.to)));
  test_scene.right = Image<Rgba8>(kSide, kSide, Rgba8{0, 0, 0, 0});
  Image<double> nearest(kSide, kSide, std::numeric_limits<double>::infinity());
  views::LayerBuilder builder(perspective_camera(kSide, kSide, kFocal, kNear, first), 0);
  Random random(16);
  std::set<std::tuple<int, int, float>> taken;
  const auto add = [&](int x, int y) {
    const double distance = move.distance(random);
    const Rgba8 color = random_color(random);
    const auto depth = float(kNear / distance);
    if (!taken.emplace(x, y, depth).second) return;
    // The place in the other picture: along the ray from the first eye, minus the movement.
    const double z = kNear / double(depth), left = z + move.to.z();
    const double X = (x + 0.5 - kSide / 2.0) * z / kFocal - move.to.x();
    const double Y = (y + 0.5 - kSide / 2.0) * z / kFocal;
    const int u = int(std::floor(X * kFocal / left + kSide / 2.0)),
              v = int(std::floor(Y * kFocal / left + kSide / 2.0));
    const bool is_inside = u >= 0 && v >= 0 && u < kSide && v < kSide;
    // If two samples at a pixel have the same distance, neither is the nearest, so the second one
    // is left out.
    if (is_inside && z == nearest.at(u, v)) return;
    builder.add(x, y, depth, color);
    if (!is_inside || z > nearest.at(u, v)) return;
    nearest.at(u, v) = z;
    test_scene.right.at(u, v) = color;
  };
  const int each = move.to.z() > 0 ? int(layers) : 0;
  for (int i = 0; i < each * kSide * kSide; ++i) add(i % kSide, i / kSide % kSide);
  for (int i = 0; each == 0 && i < int(layers * kSide * kSide); ++i) {
    const int u = int(random.integer(0, kSide - 1));
    add(u, int(random.integer(0, kSide - 1)));
  }
  test_scene.image = builder.pack();
  return test_scene;
}

// ---- the three methods: the same loop ----

enum class Method { kDepth, kOrder, kPacked };

template <Method method>
Image<Rgba8> draw(const LayerTestScene& test_scene) {
  const views::LayeredImage& image = test_scene.image;
  const Eigen::Matrix4d m = views::warp_matrix(test_scene.to, image.camera);
  std::vector<int> rows, columns;
  if constexpr (method == Method::kOrder) {
    const Eigen::Vector4d e = image.camera.screen_from_world * views::eye_of(test_scene.to);
    rows = views::visiting_order(e.y(), e.w(), kSide);
    columns = views::visiting_order(e.x(), e.w(), kSide);
  } else {
    for (int i = 0; i < kSide; ++i) columns.push_back(i), rows.push_back(kSide - 1 - i);
  }
  Image<Rgba8> color(kSide, kSide, Rgba8{0, 0, 0, 0});
  Image<double> nearest(kSide, kSide, 0.0);
  for (const int y : rows) {
    for (const int x : columns) {
      const std::size_t place = image.pixel_index(x, y);
      const Eigen::Vector4d start = m * Eigen::Vector4d(x + 0.5, y + 0.5, 0, 1);
      for (std::uint32_t i = image.first[place]; i < image.first[place + 1]; ++i) {
        const Eigen::Vector4d at = start + double(image.depth[i]) * m.col(2);
        if (!(at.w() > 0)) continue;
        const double inverse = 1 / at.w();
        const double u = at.x() * inverse, v = at.y() * inverse;
        if (!(u >= 0 && v >= 0 && u < kSide && v < kSide)) continue;
        const std::size_t pixel = color.index(int(u), int(v));
        if constexpr (method == Method::kDepth) {
          const double z = at.z() * inverse;
          if (!(z > nearest.pixels[pixel])) continue;
          nearest.pixels[pixel] = z;
        }
        color.pixels[pixel] = image.color[i];
      }
    }
  }
  return color;
}

// The fraction of pixels in the middle square that do not show the nearest sample, among the pixels
// that show something.
double wrong_share(const LayerTestScene& test_scene, const Image<Rgba8>& drawn) {
  const int begin = (kSide - test_scene.move->middle) / 2;
  double wrong = 0, shown = 0;
  for (int y = begin; y < kSide - begin; ++y) {
    for (int x = begin; x < kSide - begin; ++x) {
      const Rgba8 right = test_scene.right.at(x, y);
      shown += right.a != 0;
      wrong += drawn.at(x, y) != right;
    }
  }
  return wrong / shown;
}

template <Method method>
void add_method(const char* name, const std::shared_ptr<const LayerTestScene>& test_scene,
                double layers, double predicted, std::vector<Configuration>& all) {
  all.push_back(
      {.series = name,
       .parameter = layers,
       .scene = test_scene->move->name,
       .error = [test_scene] { return wrong_share(*test_scene, draw<method>(*test_scene)); },
       .predicted_error = predicted,
       .work = [test_scene](int) { do_not_optimize(draw<method>(*test_scene)); },
       .items = double(test_scene->image.samples())});
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<double> counts{1, 2, 4, 8};
  if (effort == Effort::kFull) counts = {1, 2, 4, 8, 16};
  std::vector<Configuration> all;
  for (const Move& move : kMoves) {
    for (const double layers : counts) {
      const auto test_scene = std::make_shared<const LayerTestScene>(make_test_scene(move, layers));
      add_method<Method::kDepth>("the nearest sample, by depth", test_scene, layers, 0, all);
      add_method<Method::kOrder>("the last sample, in McMillan's order for this eye", test_scene,
                                 layers, move.order(layers), all);
      add_method<Method::kPacked>("the last sample, in the order of the file", test_scene, layers,
                                  move.packed(layers), all);
    }
  }
  return all;
}

}  // namespace d16

Experiment d16_layer_order() {
  using namespace d16;
  return {
      .id = "D-16",
      .name = "Visibility: by the drawing order or by a depth buffer",
      .question =
          "Does drawing in an order show the same as a depth buffer, and what does it save?",
      .axis = "samples for each pixel",
      .error = "fraction of the pixels with samples that do not show their nearest sample",
      .reference = "the place of each sample, and the nearest sample of each pixel",
      .theory =
          "McMillan's order is right for points: two points that fall on one pixel and are visited "
          "in the wrong order would have to be less than a pixel apart in the new picture and at "
          "least one pixel apart in the first, which is impossible if objects look as large or "
          "larger. If they look half as large, four pixels fall on one, and the last of them is "
          "the nearest in only one of four cases. In the order of the file the farthest sample "
          "stays wherever two samples fall on one pixel, everywhere in the picture if the eye "
          "moves to the left, and above the epipole if it moves forward; this happens for the "
          "fraction 1 - m e^-m/(1 - e^-m), with m samples on average (Poisson)",
      .item = "sample",
      .configurations = configurations};
}

}  // namespace glassbox::study
