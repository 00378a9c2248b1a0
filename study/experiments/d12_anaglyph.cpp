// Compares ways to make an anaglyph: their loss of colour, and how much less they disturb the eyes
// in return (D-12).
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <glassbox/images/colour/ciede2000.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stereo/recolour.h>
#include <glassbox/images/stereo/rivalry.h>
#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/room.h>
#include <glassbox/render/staged/staged.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d12_glasses.h"
#include "study/experiments/d12_leaves.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/rounding_model.h"

namespace glassbox::study {

namespace d12 {

using Picture = Image<Rgba8>;

constexpr const char* kGhosts = "ghosts";

// ---- scenes ----

struct Scenery {
  std::string name;
  std::vector<Linear> colours;
};

// The colours white, grey, red, green, blue, yellow, cyan and magenta (B.6).
Scenery eight_colours() {
  return {"eight colours",
          {{1, 1, 1},
           {0.5f, 0.5f, 0.5f},
           {1, 0, 0},
           {0, 1, 0},
           {0, 0, 1},
           {1, 1, 0},
           {0, 1, 1},
           {1, 0, 1}}};
}

Picture room_picture(int width, int height) {
  const Scene room = make_room();
  return render_staged(room, make_view(room.cameras.front(), width, height).value(), {})
      .buffers.color;
}

Scenery room(Effort effort) {
  Scenery scenery{"room", {}};
  const Picture picture = effort == Effort::kQuick ? room_picture(32, 24) : room_picture(96, 72);
  for (const Rgba8& pixel : picture.pixels) scenery.colours.push_back(linear_of(pixel));
  return scenery;
}

Scenery random_colours(Effort effort) {
  Scenery scenery{"random colours", {}};
  for (std::uint64_t i = 0; i < (effort == Effort::kQuick ? 512u : 4096u); ++i) {
    const auto channel = [i](std::uint64_t k) { return float(random_unit(12, 3 * i + k)); };
    scenery.colours.push_back({channel(0), channel(1), channel(2)});
  }
  return scenery;
}

// `across` x `across` pixels of a picture, evenly spread.
template <class Pixel, class ToLinear>
Scenery sampled(std::string name, const Image<Pixel>& picture, int across,
                const ToLinear& to_linear) {
  Scenery scenery{std::move(name), {}};
  for (int y = 0; y < across; ++y) {
    for (int x = 0; x < across; ++x)
      scenery.colours.push_back(to_linear(picture.at((2 * x + 1) * picture.width / (2 * across),
                                                     (2 * y + 1) * picture.height / (2 * across))));
  }
  return scenery;
}

int samples_across(Effort effort) {
  return effort == Effort::kQuick ? 24 : 64;
}

Scenery leaves(Effort effort) {
  return sampled("dead leaves", make_leaves(256, 192, 12), samples_across(effort),
                 [](const Linear& colour) { return colour; });
}

// Photographs are used if they are beside the repository. They are never required, because the
// leaves picture has the same statistics.
void add_photographs(Effort effort, std::vector<Scenery>& all) {
  for (const char* name : {"cones", "teddy"}) {
    const std::string path = fmt::format("../shared/assets/stereo/{}/im2.ppm", name);
    if (!std::filesystem::exists(path)) continue;
    if (const auto picture = read_image(path))
      all.push_back(sampled(fmt::format("{}, a photograph", name), *picture, samples_across(effort),
                            linear_of));
  }
}

// ---- measures ----

double relative_luminance(const LightMatrix& lens, const Colour3& shown) {
  return times(lens, shown)[1] / times(lens, {1, 1, 1})[1];
}

// The mean rivalry (the difference of the brightness that the two eyes see), computed for any
// method in the same way as Rivalry in rivalry.h.
double mean_rivalry(const ShownColour& show, const Scenery& scenery) {
  const Colour3 white = show({1, 1, 1});
  const double left = relative_luminance(kRedLensLight, white),
               right = relative_luminance(kCyanLensLight, white);
  double sum = 0;
  for (const Linear& colour : scenery.colours) {
    const Colour3 shown = show(colour);
    sum += std::abs(relative_luminance(kRedLensLight, shown) / left -
                    relative_luminance(kCyanLensLight, shown) / right);
  }
  const double mean = sum / double(scenery.colours.size());
  return mean < 0x1p-24 ? 0 : mean;  // colours are floats, so this is only their rounding error
}

double mean_difference(const ShownColour& show, const Scenery& scenery) {
  static const ColourThroughLens both(both_lenses());
  double sum = 0;
  for (const Linear& colour : scenery.colours) {
    sum += ciede2000(both(show(colour)),
                     lab_of_linear(double(colour[0]), double(colour[1]), double(colour[2])));
  }
  return sum / double(scenery.colours.size());
}

// ---- theory ----

// The difference of relative luminance between the eyes, Y_L/Y_Lw - Y_R/Y_Rw: Y is the luminance
// through the left or right lens, w stands for white. It is linear in the colour unless values are
// clamped.
double signed_rivalry(const ShownColour& show, const Linear& colour) {
  const auto share = [&](const LightMatrix& lens) {
    return relative_luminance(lens, show(colour)) / relative_luminance(lens, show({1, 1, 1}));
  };
  return share(kRedLensLight) - share(kCyanLensLight);
}

// The mean of |x| for a normally distributed x = a . c, the rivalry of a colour c. Its mean and its
// standard deviation are those over the scenery; a has the rivalries of full red, green and blue.
double predicted_rivalry(const ShownColour& show, const Scenery& scenery) {
  const Colour3 a{signed_rivalry(show, {1, 0, 0}), signed_rivalry(show, {0, 1, 0}),
                  signed_rivalry(show, {0, 0, 1})};
  double mean = 0, squares = 0;
  for (const Linear& c : scenery.colours) {
    const double x = a[0] * double(c[0]) + a[1] * double(c[1]) + a[2] * double(c[2]);
    mean += x / double(scenery.colours.size());
    squares += x * x / double(scenery.colours.size());
  }
  const double deviation = std::sqrt(std::max(0.0, squares - mean * mean));
  if (squares < 0x1p-48) return 0;  // the rounding error of floats, as in mean_rivalry
  if (deviation == 0) return std::abs(mean);
  const double z = mean / deviation;
  return deviation * kMeanOfNormal * std::exp(-z * z / 2) + mean * std::erf(z / std::sqrt(2.0));
}

// ---- configurations ----

struct Method {
  std::string series;
  AnaglyphMethod method;
  Recolour recolour;
  double rivalry = 0;  // rivalry of the eight colours (B.6)
};

std::vector<Method> methods(Effort effort) {
  using enum AnaglyphMethod;
  std::vector<Method> all{{"true", kTrue, {}, 0},
                          {"grey", kGrey, {}, 0},
                          {"colour", kMask, {}, 0.411},
                          {"half-colour", kHalf, {}, 0.123},
                          {"optimised", kOptimised, {}, 0.036},
                          {"Dubois 2009", kDubois, {}, 0.075},
                          {"Dubois 2001", kDubois2001, {}, 0.062}};
  const int steps = effort == Effort::kQuick ? 4 : 10;
  for (int i = 1; i <= steps; ++i) {
    const double k = double(i) / steps;
    all.push_back({"colour, desaturated", kMask, {k, 0}, 0.411 * (1 - k)});
  }
  for (const double b : {0.1, 0.25})
    all.push_back(
        {"colour, half desaturated and brightened", kMask, {0.5, b}, 0.411 * 0.5 * (1 - b)});
  return all;
}

struct Timed {
  Picture left, right;
};

Timed timed_pictures() {
  return {make_noise(128, {120, 130, 90, 255}, 80, 1), make_noise(128, {120, 130, 90, 255}, 80, 2)};
}

std::function<void(int)> work_of(const Method& method, const std::shared_ptr<const Timed>& eyes) {
  if (method.recolour.desaturate == 0)
    return [=](int) { do_not_optimize(make_anaglyph(eyes->left, eyes->right, method.method)); };
  return [=](int) {
    make_anaglyph(recoloured(eyes->left, method.recolour).value(),
                  recoloured(eyes->right, method.recolour).value(), method.method)
        .value();
  };
}

// Predicts ghosts: the luminance of the other eye's channels through a lens, divided by that of the
// eye's own channels. For red and cyan this is .0136/.0876 (left) and .0176/.3865 (right). The true
// anaglyph shows the right eye only blue: .0018/.0876 and .0176/.0777.
void add_ghosts(const Method& method, double parameter, const AnaglyphViewing& viewing,
                std::vector<Configuration>& all) {
  if (method.recolour.desaturate != 0) return;
  const bool without_green = method.method == AnaglyphMethod::kTrue;
  const auto add = [&](const char* scene, double predicted, std::function<double()> error) {
    all.push_back({.series = method.series,
                   .parameter = parameter,
                   .scene = scene,
                   .measure = kGhosts,
                   .error = std::move(error),
                   .predicted_error = predicted});
  };
  add("left eye", without_green ? .0018 / .0876 : .0136 / .0876,
      [=] { return white_leak(viewing).left; });
  add("right eye", without_green ? .0176 / .0777 : .0176 / .3865,
      [=] { return white_leak(viewing).right; });
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Scenery> sceneries{eight_colours(), random_colours(effort), room(effort),
                                 leaves(effort)};
  add_photographs(effort, sceneries);
  const auto eyes = std::make_shared<const Timed>(timed_pictures());
  std::vector<Configuration> all;
  for (const Method& method : methods(effort)) {
    const AnaglyphViewing seen = anaglyph_viewing(method.method).value();
    const ShownColour show = by_matrix(seen.matrix, method.recolour);
    for (const Scenery& scenery : sceneries) {
      double predicted = predicted_rivalry(show, scenery);
      if (&scenery == &sceneries.front()) {
        predicted = method.rivalry;
      } else if (method.recolour.desaturate != 0) {
        // Rivalry is linear in the colour, and greys have no rivalry (S0-15).
        const double plain = mean_rivalry(by_matrix(seen.matrix, {}), scenery);
        predicted = plain * (1 - method.recolour.desaturate) * (1 - method.recolour.brighten);
      }
      all.push_back({.series = method.series,
                     .parameter = mean_difference(show, scenery),
                     .scene = scenery.name,
                     .error = [=] { return mean_rivalry(show, scenery); },
                     .predicted_error = predicted,
                     .work = work_of(method, eyes),
                     .items = double(eyes->left.pixels.size())});
    }
    add_ghosts(method, mean_difference(show, sceneries.front()), seen, all);
  }
  // The optimum minimizes the sum of two squared distances, from the colours that the left eye and
  // the right eye should see. The least sum is at the midpoint of the two, so half of the colour
  // method's rivalry is predicted.
  const ShownColour optimum = LabOptimum();
  const ShownColour colour = by_matrix(anaglyph_viewing(AnaglyphMethod::kMask).value().matrix, {});
  for (const Scenery& scenery : sceneries) {
    all.push_back({.series = "CIELAB optimum, pixel by pixel",
                   .parameter = mean_difference(optimum, scenery),
                   .scene = scenery.name,
                   .error = [=] { return mean_rivalry(optimum, scenery); },
                   .predicted_error = mean_rivalry(colour, scenery) / 2,
                   .work =
                       [=](int) {
                         for (std::size_t i = 0; i < 64; ++i)
                           do_not_optimize(optimum(scenery.colours[i % scenery.colours.size()]));
                       },
                   .items = 64});
  }
  return all;
}

}  // namespace d12

Experiment d12_anaglyph() {
  using namespace d12;
  return {
      .id = "D-12",
      .name = "Anaglyph: methods for red and cyan glasses",
      .question =
          "How much colour does each method lose, and how much does it reduce the rivalry between "
          "the eyes?",
      .axis = "mean colour difference to the picture without glasses (CIEDE2000)",
      .logarithmic_axis = false,
      .error = "mean rivalry |Y_L/Y_Lw - Y_R/Y_Rw|",
      .error_unit = "of white",
      .reference = "equal relative luminance in both eyes; no light of the other eye",
      .theory =
          "The formulas are in B.6 of docs/references.md. The mean rivalry of eight colours "
          "follows from the luminances of screen and lenses: colour has .411, half-colour .123, "
          "Dubois 2009 .075 and 2001 .062, optimised .036, grey 0. Desaturating by k and "
          "brightening by b multiplies it by exactly (1 - k)(1 - b). The ghosts are .0136/.0876 on "
          "the left and .0176/.3865 on the right. For other pictures, the rivalry of a colour c is "
          "a . c, and its mean is that of a normal distribution with the mean and standard "
          "deviation of the picture's colours; the search between the goals of both eyes has half "
          "the rivalry of the colour method. The colours of photographs are more concentrated than "
          "a normal distribution, so their mean is lower.",
      .item = "pixel",
      .measures = {{kGhosts,
                    "light that reaches an eye where its own picture is black and the other eye's "
                    "is white, divided by the light of its own white",
                    "of white"}},
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
