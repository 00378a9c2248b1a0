// Compares methods to compute where the samples of a layered depth image are warped: by products or
// by additions, in float, fixed point and double (D-14).
#include <cmath>
#include <memory>
#include <vector>

#include "study/experiment/experiment.h"
#include "study/experiments/d14_methods.h"
#include "study/experiments/d14_model.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/layer_samples.h"
#include "study/experiments/memoize.h"

namespace glassbox::study {

namespace d14 {

constexpr const char* kMoved = "moved";

// The scene has about 111,600 samples in 90,000 pixels, 1.24 per pixel as on the slides (S1-12).
// There is one image for each picture width; it is warped to several places.
struct LayerTestScene {
  views::LayeredImage image;
  std::vector<Eigen::Matrix4d> warps;
};

Eigen::Isometry3d nearby_eye(Random& random) {
  const auto some = [&](double most) { return random.between(-most, most); };
  const Eigen::Vector3d axis = Eigen::Vector3d{some(1), some(1), some(1)}.normalized();
  Eigen::Isometry3d eye = Eigen::Isometry3d::Identity();
  eye.linear() = Eigen::AngleAxisd(some(0.1), axis).toRotationMatrix();
  eye.translation() = Eigen::Vector3d{some(0.3), some(0.3), some(0.3)};
  return eye;
}

LayerTestScene make_test_scene(int width, int eyes) {
  const int height = 90000 / width;
  const double focal = width, near = 0.5;
  LayerTestScene test_scene;
  const auto from = perspective_camera(width, height, focal, near, Eigen::Isometry3d::Identity());
  Random random(14);
  views::LayerBuilder builder(from, 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto add = [&, x, y](double nearest, double furthest) {
        const auto depth = float(near / random.between(nearest, furthest));
        builder.add(x, y, depth, random_color(random));
      };
      add(2, 20);
      if (random.integer(0, 99) < 24) add(20, 40);
    }
  }
  test_scene.image = builder.pack();
  for (int i = 0; i < eyes; ++i) {
    const auto to = perspective_camera(width, height, focal, near, nearby_eye(random));
    test_scene.warps.push_back(views::warp_matrix(to, from));
  }
  return test_scene;
}

// ---- errors ----

// `value` minus the product of a row with (x, y, z, 1), with twice the digits of double: the
// rounding error of each product and each sum is computed and added, too.
double beyond(double value, const Eigen::RowVector4d& row, double x, double y, double z) {
  double sum = value, rest = 0;
  const auto take_away = [&](double a, double b) {
    const double product = a * b;
    rest -= std::fma(a, b, -product);
    const double next = sum - product, shown = next - sum;
    rest += (sum - (next - shown)) - (product + shown);
    sum = next;
  };
  take_away(row[0], x);
  take_away(row[1], y);
  take_away(row[2], z);
  take_away(row[3], 1);
  return sum + rest;
}

struct Errors {
  double rms = 0;    // in px, x and y together, without the rounding errors of the division
  double moved = 0;  // fraction of the samples that reach another pixel
};

template <class Method>
Errors errors_of(const LayerTestScene& test_scene) {
  double squares = 0, samples = 0, moved = 0;
  for (const Eigen::Matrix4d& m : test_scene.warps) {
    warp_all<Method>(test_scene.image, m, [&](int x, int y, std::uint32_t i, const auto& at) {
      const double u = x + 0.5, v = y + 0.5, z = double(test_scene.image.depth[i]);
      const Eigen::Vector4d right = m * Eigen::Vector4d(u, v, z, 1);
      const double column = right.x() / right.w(), row = right.y() / right.w();
      const double of_w = beyond(double(at.w), m.row(3), u, v, z);
      const double dx = (beyond(double(at.x), m.row(0), u, v, z) - column * of_w) / right.w();
      const double dy = (beyond(double(at.y), m.row(1), u, v, z) - row * of_w) / right.w();
      squares += square(dx) + square(dy);
      const auto inverse = 1 / at.w;
      moved += std::floor(double(at.x * inverse)) != std::floor(column);
      moved += std::floor(double(at.y * inverse)) != std::floor(row);
      ++samples;
    });
  }
  return {std::sqrt(squares / samples), moved / samples};
}

// ---- work: draws one picture, in which each sample fills one pixel and the nearest stays ----

template <class Method>
void draw(const LayerTestScene& test_scene) {
  const int width = test_scene.image.camera.width, height = test_scene.image.camera.height;
  Image<float> depth(width, height, 0.0f);
  Image<Rgba8> color(width, height, Rgba8{0, 0, 0, 255});
  warp_all<Method>(test_scene.image, test_scene.warps.front(),
                   [&](int, int, std::uint32_t i, const auto& at) {
                     if (!(at.w > 0)) return;
                     const auto inverse = 1 / at.w;
                     const auto x = at.x * inverse, y = at.y * inverse;
                     if (!(x >= 0 && y >= 0 && x < decltype(x)(width) && y < decltype(y)(height)))
                       return;
                     const auto z = float(at.z * inverse);
                     const std::size_t pixel = depth.index(int(x), int(y));
                     if (!(z > depth.pixels[pixel])) return;
                     depth.pixels[pixel] = z;
                     color.pixels[pixel] = test_scene.image.color[i];
                   });
  do_not_optimize(color);
}

// ---- the table ----

template <class Method>
void add_method(const char* name, const std::shared_ptr<const LayerTestScene>& test_scene,
                std::vector<Configuration>& all) {
  const int width = test_scene->image.camera.width, height = test_scene->image.camera.height;
  const auto eyes = double(test_scene->warps.size());
  Predicted mean;
  for (const Eigen::Matrix4d& m : test_scene->warps) {
    const Predicted one = predict<Method>(test_scene->image, m, std::max(height / 5, 1));
    mean.mean_square += one.mean_square / eyes;
    mean.moved += one.moved / eyes;
  }
  const double samples = double(test_scene->image.samples()) * eyes;
  // If not even a hundredth of a sample is expected to move, a fraction of 0 is predicted.
  if (mean.moved * samples < 0.01) mean.moved = 0;
  const auto errors = memoize([test_scene] { return errors_of<Method>(*test_scene); });
  all.push_back({.series = name,
                 .parameter = double(width),
                 .error = [errors] { return errors().rms; },
                 .predicted_error = std::sqrt(mean.mean_square),
                 .work = [test_scene](int) { draw<Method>(*test_scene); },
                 .items = double(test_scene->image.samples())});
  all.push_back({.series = name,
                 .parameter = double(width),
                 .measure = kMoved,
                 .error = [errors] { return errors().moved; },
                 .predicted_error = mean.moved});
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<int> widths{300, 942, 8192};
  if (effort == Effort::kFull) widths = {300, 942, 2048, 4096, 8192, 16384};
  std::vector<Configuration> all;
  for (const int width : widths) {
    const auto test_scene = std::make_shared<const LayerTestScene>(
        make_test_scene(width, effort == Effort::kQuick ? 8 : 16));
    add_method<FullProduct<float>>("float, 16 products", test_scene, all);
    add_method<Additions<float, kNever>>("float, added up, never restarted", test_scene, all);
    add_method<Additions<float, kLine>>("float, added up, restarted each row", test_scene, all);
    add_method<Additions<float, 64>>("float, added up, restarted every 64 px", test_scene, all);
    add_method<Additions<float, 16>>("float, added up, restarted every 16 px", test_scene, all);
    add_method<Multiples>("float, multiples of the step, restarted every 64 px", test_scene, all);
    add_method<FixedPoint>("fixed point, added up, restarted each row", test_scene, all);
    add_method<FullProduct<double>>("double, 16 products", test_scene, all);
    add_method<Additions<double, kLine>>("double, added up, restarted each row", test_scene, all);
  }
  return all;
}

}  // namespace d14

Experiment d14_layer_warp() {
  using namespace d14;
  return {.id = "D-14",
          .name = "Warping the samples of a layered image",
          .question =
              "How much time do additions in place of products save, and how large does their "
              "error become?",
          .axis = "width of a row",
          .axis_unit = "px",
          .error = "RMS distance of a sample from its place, before the division",
          .error_unit = "px",
          .reference = "the product with the matrix, to twice the digits of double",
          .theory =
              "A rounding error is uniform within half a unit in the last place, so its standard "
              "deviation is ulp/sqrt 12. If the same step is added again to a sum with the same "
              "power of two, it is rounded by the same amount again, so n additions have an error "
              "of n ulp/sqrt 12; the error of w is multiplied by x. This is at most W u W px, and "
              "the sum over the powers of two is smaller. A coordinate with the error e falls into "
              "another pixel with the probability E min(1, |e|)",
          .item = "sample",
          .measures = {{kMoved,
                        "fraction of the samples that fall into the row or column of another pixel",
                        ""}},
          .configurations = configurations};
}

}  // namespace glassbox::study
