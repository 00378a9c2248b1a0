// Compares sizes and shapes in which a sample of a layered depth image is drawn (D-15).
#include <cmath>
#include <memory>
#include <vector>

#include "study/experiment/experiment.h"
#include "study/experiments/d15_filter.h"
#include "study/experiments/d15_splats.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/layer_samples.h"
#include "study/experiments/memoize.h"

namespace glassbox::study {

namespace d15 {

constexpr const char *kRms = "rms", *kPsnr = "PSNR", *kSharpness = "sharpness";

// A wall of n x n samples with independent colours, one behind each pixel of a parallel camera, and
// the same wall magnified m times. So only sampling matters, and the positions of pixels relative
// to the samples repeat.
struct LayerTestScene {
  std::string name;
  Magnification m;
  views::LayeredImage wall;
  views::LayerCamera to;
};

LayerTestScene make_test_scene(int samples, double times, bool tilted) {
  // The first eye sees the wall at 60 degrees, so for the second eye it is 1/cos 60 = 2 times as
  // wide.
  const Magnification m{tilted ? 2 * times : times, times, times};
  LayerTestScene test_scene{tilted ? "wall at 60 degrees" : "wall", m, {}, {}};
  views::LayerCamera from;
  from.width = from.height = samples;
  test_scene.to.width = int(samples * m.x), test_scene.to.height = int(samples * m.y);
  test_scene.to.screen_from_world.diagonal() << m.x, m.y, 1, 1;
  views::LayerBuilder builder(from, 0);
  Random random(15);
  for (int y = 0; y < samples; ++y) {
    for (int x = 0; x < samples; ++x) builder.add(x, y, 0.5f, random_color(random));
  }
  test_scene.wall = builder.pack();
  return test_scene;
}

// ---- the error ----

struct Errors {
  double holes = 0;      // as a fraction of the pixels
  double rms = 0;        // of a channel, in 1/255
  double sharpness = 0;  // mean square of the gradients, divided by that of the true picture
};

double channel(const Rgba8& c, int k) {
  return k == 0 ? c.r : k == 1 ? c.g : c.b;
}

// Uses only pixels for which all samples that could reach them exist.
Errors errors_of(const LayerTestScene& test_scene, const Splatted& drawn) {
  const int margin = int(8 * std::max(test_scene.m.x, test_scene.m.y));
  const int height = test_scene.wall.camera.height;
  const auto truth = [&](int u, int v, int k) {
    double sum = 0;
    for (const auto& [sample, area] : truth_in(u, v, test_scene.m)) {
      const auto place =
          std::size_t(height - 1 - sample.second) * std::size_t(height) + std::size_t(sample.first);
      sum += area * channel(test_scene.wall.color[place], k);
    }
    return sum;
  };
  double holes = 0, squares = 0, gradient = 0, true_gradient = 0, pixels = 0;
  for (int v = margin; v < test_scene.to.height - margin; ++v) {
    std::array<double, 3> before{};
    for (int u = margin; u < test_scene.to.width - margin; ++u) {
      ++pixels;
      holes += drawn.depth.at(u, v) == 0;
      for (int k = 0; k < 3; ++k) {
        const double is = channel(drawn.color.at(u, v), k), should = truth(u, v, k);
        squares += square(is - should) / 3;
        if (u > margin) {
          gradient += square(is - channel(drawn.color.at(u - 1, v), k));
          true_gradient += square(should - before[std::size_t(k)]);
        }
        before[std::size_t(k)] = should;
      }
    }
  }
  return {holes / pixels, std::sqrt(squares / pixels), gradient / true_gradient};
}

double psnr(double rms) {
  return 20 * std::log10(255 / rms);
}

// ---- the table ----

template <class Footprint>
void add_footprint(const char* name, const std::shared_ptr<const LayerTestScene>& test_scene,
                   double times, const Footprint& footprint, std::vector<Configuration>& all) {
  const Expected expected = expect(test_scene->m, footprint);
  const auto errors = memoize(
      [=] { return errors_of(*test_scene, splat(test_scene->wall, test_scene->to, footprint)); });
  const auto add = [&](const char* measure, double predicted, auto error) {
    all.push_back({.series = name,
                   .parameter = times,
                   .scene = test_scene->name,
                   .measure = measure,
                   .error = [=] { return error(errors()); },
                   .predicted_error = predicted});
  };
  add("", expected.holes, [](const Errors& e) { return e.holes; });
  all.back().work = [=](int) {
    do_not_optimize(splat(test_scene->wall, test_scene->to, footprint));
  };
  all.back().items = double(test_scene->wall.samples());
  const double rms = std::sqrt(expected.mean_square);
  add(kRms, rms, [](const Errors& e) { return e.rms; });
  add(kPsnr, psnr(rms), [](const Errors& e) { return psnr(e.rms); });
  add(kSharpness, expected.gradient / expected.true_gradient,
      [](const Errors& e) { return e.sharpness; });
}

void add_test_scene(int samples, double times, bool tilted, std::vector<Configuration>& all) {
  const auto test_scene =
      std::make_shared<const LayerTestScene>(make_test_scene(samples, times, tilted));
  const Magnification& m = test_scene->m;
  const double side = std::max(m.focal, 1.0);
  add_footprint("1 x 1", test_scene, times, Square{1}, all);
  add_footprint("3 x 3", test_scene, times, Square{3}, all);
  add_footprint("square of side l", test_scene, times, Square{side}, all);
  // The factor for the tilt is sqrt(cos 0 / cos 60): the square then has the same area as the
  // sample has for the second eye (S1-10).
  const double with_tilt = std::max(m.focal * std::sqrt(m.x / m.y), 1.0);
  if (tilted)
    add_footprint("square of side l, widened by the tilt", test_scene, times, Square{with_tilt},
                  all);
  add_footprint("four sizes, weights 1, 1/2, 1/4", test_scene, times,
                FourSizes::for_size(with_tilt), all);
  add_footprint("Gaussian (EWA)", test_scene, times, Gaussian::for_magnification(m), all);
  const double corner = std::sqrt(0.5);
  add_footprint("ellipse", test_scene, times,
                Ellipse{std::max(m.x, 1.0) * corner, std::max(m.y, 1.0) * corner}, all);
}

std::vector<Configuration> configurations(Effort effort) {
  const bool quick = effort == Effort::kQuick;
  std::vector<double> magnifications{0.5, 1, 2, 4};
  if (!quick) magnifications = {0.5, 1, 2, 3, 4};
  std::vector<Configuration> all;
  for (const bool tilted : {false, true}) {
    for (const double times : magnifications) add_test_scene(quick ? 40 : 128, times, tilted, all);
  }
  return all;
}

}  // namespace d15

Experiment d15_splats() {
  using namespace d15;
  return {
      .id = "D-15",
      .name = "Splats: one pixel, a square or a Gaussian",
      .question = "Which footprint of a sample leaves no holes, and how much does it blur?",
      .axis = "magnification from one picture to the other",
      .error = "fraction of a wall's pixels that show nothing",
      .reference = "the wall of samples, averaged over each pixel",
      .theory =
          "At the magnification m, one pixel per sample covers 1/m^2 of the wall, so 1 - 1/m^2 are "
          "holes; with 3 x 3 pixels, 1 - 9/m^2 are holes for m above 3; squares of side l = m "
          "leave no holes. A wall at 60 degrees is twice as wide. The colours of the samples are "
          "independent, with the mean 127.5 and the variance s = (256^2 - 1)/12. A footprint is a "
          "filter: if its weights differ by d from the right ones, its error has the mean square s "
          "sum(d^2) + 127.5^2 (sum d)^2, and the differences of neighbours follow the same formula",
      .item = "sample",
      .measures =
          {{kRms, "RMS error of a channel", "1/255"},
           {.name = kPsnr,
            .error = "peak signal-to-noise ratio",
            .error_unit = "dB",
            .more_is_better = true},
           {.name = kSharpness,
            .error =
                "mean square of the differences between neighbours, divided by the reference's",
            .error_unit = "",
            .more_is_better = true}},
      .configurations = configurations};
}

}  // namespace glassbox::study
