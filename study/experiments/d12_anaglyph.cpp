// D-12: ways to make an anaglyph: what they cost in colour, and what disturbs the eyes less for it.
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <glassbox/images/colour/ciede2000.h>
#include <glassbox/images/stereo/recolour.h>
#include <glassbox/images/stereo/rivalry.h>
#include <glassbox/mesh/builtin/images.h>
#include <glassbox/mesh/builtin/room.h>
#include <glassbox/render/staged/staged.h>

#include "study/experiment/experiment.h"
#include "study/experiments/consume.h"
#include "study/experiments/d12_seen.h"

namespace glassbox::study {

namespace {

using namespace d12;

using Picture = Image<Rgba8>;

// ---- scenes ----

struct Scenery {
  std::string name;
  std::vector<Linear> colours;
};

// B.6's: white, grey, red, green, blue, yellow, cyan, magenta.
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

// ---- measures ----

double relative_luminance(const LightMatrix& lens, const Colour3& shown) {
  return times(lens, shown)[1] / times(lens, {1, 1, 1})[1];
}

// As Rivalry of rivalry.h has it, of any method.
double mean_rivalry(const Show1& show, const Scenery& scenery) {
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
  return mean < 0x1p-24 ? 0 : mean;  // colours are floats: this is their rounding
}

double mean_difference(const Show1& show, const Scenery& scenery) {
  static const SeenThrough both(both_lenses());
  double sum = 0;
  for (const Linear& colour : scenery.colours) {
    sum += ciede2000(both(show(colour)),
                     lab_of_linear(double(colour[0]), double(colour[1]), double(colour[2])));
  }
  return sum / double(scenery.colours.size());
}

// ---- configurations ----

struct Method {
  std::string series;
  AnaglyphMethod method;
  Recolour recolour;
  double rivalry = 0;  // of the eight colours, SPEC B.6
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
    return [=](int) { consume(make_anaglyph(eyes->left, eyes->right, method.method)); };
  return [=](int) {
    make_anaglyph(recoloured(eyes->left, method.recolour).value(),
                  recoloured(eyes->right, method.recolour).value(), method.method)
        .value();
  };
}

// Luminance of the other eye's channels through the lens over that of its own: red against cyan, .0136/.0876 and .0176/.3865. The
// true anaglyph shows the right eye blue alone: .0018/.0876 and .0176/.0777.
void add_ghosts(const Method& method, double parameter, const Viewing& viewing,
                std::vector<Configuration>& all) {
  if (method.recolour.desaturate != 0) return;
  const bool without_green = method.method == AnaglyphMethod::kTrue;
  const auto add = [&](const char* scene, double predicted, std::function<double()> error) {
    all.push_back({.series = method.series,
                   .parameter = parameter,
                   .scene = scene,
                   .error = std::move(error),
                   .predicted_error = predicted});
  };
  add("ghost in the left eye", without_green ? .0018 / .0876 : .0136 / .0876,
      [=] { return white_leak(viewing).left; });
  add("ghost in the right eye", without_green ? .0176 / .0777 : .0176 / .3865,
      [=] { return white_leak(viewing).right; });
}

std::vector<Configuration> configurations(Effort effort) {
  const std::vector<Scenery> sceneries{eight_colours(), random_colours(effort), room(effort)};
  const auto eyes = std::make_shared<const Timed>(timed_pictures());
  std::vector<Configuration> all;
  for (const Method& method : methods(effort)) {
    const Viewing seen = viewing(method.method).value();
    const Show1 show = by_matrix(seen.matrix, method.recolour);
    for (const Scenery& scenery : sceneries) {
      std::optional<double> predicted;
      if (&scenery == &sceneries.front()) {
        predicted = method.rivalry;
      } else if (method.recolour.desaturate != 0) {
        // Linear in the colour, and greys have none (S0-15).
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
  const Show1 optimum = LabOptimum();
  for (const Scenery& scenery : sceneries) {
    all.push_back({.series = "CIELAB optimum, pixel by pixel",
                   .parameter = mean_difference(optimum, scenery),
                   .scene = scenery.name,
                   .error = [=] { return mean_rivalry(optimum, scenery); },
                   .work =
                       [=](int) {
                         for (std::size_t i = 0; i < 64; ++i)
                           consume(optimum(scenery.colours[i % scenery.colours.size()]));
                       },
                   .items = 64});
  }
  return all;
}

}  // namespace

Experiment d12_anaglyph() {
  return {
      .id = "D-12",
      .name = "Anaglyph: methods for red and cyan glasses",
      .question =
          "How much colour does each method give up for how much less rivalry between the eyes?",
      .axis = "mean colour difference to the picture without glasses (CIEDE2000)",
      .logarithmic_axis = false,
      .error =
          "mean rivalry |Y_L/Y_Lw - Y_R/Y_Rw|; for ghosts: the other eye's white where the own "
          "picture is black",
      .error_unit = "of white",
      .reference = "equal relative luminance in both eyes; no light of the other eye",
      .theory =
          "B.6: the mean over eight colours from the luminances of screen and lenses, colour .411, "
          "half-colour .123, Dubois 2009 .075 and 2001 .062, optimised .036, grey 0; desaturated "
          "by k and brightened by b times (1 - k)(1 - b) exactly; ghosts .0136/.0876 on the left "
          "and .0176/.3865 on the right.",
      .item = "pixel",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
