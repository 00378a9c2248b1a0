#include "views/layers/second_eye_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <glassbox/base/processor_time.h>

namespace glassbox::views {

namespace {

// Measures each of `runs` fifteen times, or as often as two seconds allow but at least three times,
// and returns the lower quartiles of the times. The runs take turns, so that other work on the
// machine disturbs all of them alike.
template <std::size_t N>
std::array<double, N> quartiles_ms(const std::array<std::function<void()>, N>& runs) {
  constexpr std::size_t kMaxTimes = 15, kMinTimes = 3;
  constexpr double kMaxMs = 2000;
  std::array<std::vector<double>, N> times;
  const double begin = processor_ms();
  while (times[0].size() < kMinTimes ||
         (times[0].size() < kMaxTimes && processor_ms() - begin < kMaxMs)) {
    for (std::size_t k = 0; k < N; ++k) {
      const double start = processor_ms();
      runs[k]();
      times[k].push_back(processor_ms() - start);
    }
  }
  std::array<double, N> quartiles{};
  for (std::size_t k = 0; k < N; ++k) {
    std::ranges::sort(times[k]);
    quartiles[k] = times[k][times[k].size() / 4];
  }
  return quartiles;
}

}  // namespace

EyeError eye_error(const Image<Rgba8>& picture, const Image<Rgba8>& truth) {
  EyeError error;
  double squares = 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    const Rgba8 &a = picture.pixels[i], &b = truth.pixels[i];
    int most = 0;
    for (const int off : {a.r - b.r, a.g - b.g, a.b - b.b}) {
      most = std::max(most, std::abs(off));
      squares += double(off * off);
    }
    error.largest = std::max(error.largest, most);
    error.wrong += most > kVisibleDifference;
  }
  error.rms = std::sqrt(squares / (3 * double(truth.pixels.size())));
  return error;
}

SecondEyeError second_eye_error(Renderer& renderer, const View& centre, const StereoPair& pair,
                                const RenderSettings& settings,
                                const SecondEyeSettings& warp_settings) {
  const View left = eye_view(centre, pair, Side::kLeft),
             right = eye_view(centre, pair, Side::kRight);
  const Image<Rgba8> truth = renderer.render(right, settings).buffers.color;
  SecondEye second;
  WarpedPair warped;
  const auto by_warp = [&] {
    render_pair_by_warp(renderer, centre, pair, settings, warp_settings, second, warped);
  };
  by_warp();
  const StereoRendering& both = warped.rendering;
  SecondEyeError error;
  error.layers = warp_settings.layers;
  error.pixels = truth.pixels.size();
  error.holes = warped.holes;
  error.warped = eye_error(both.right.color, truth);
  error.left = eye_error(both.left.color, truth);
  error.drawn = truth;
  error.picture = both.right.color;
  error.left_picture = both.left.color;
  Rendering one;
  StereoRendering two;
  const auto ms =
      quartiles_ms<3>({[&] { renderer.render(left, settings, one); },
                       [&] { renderer.render_pair(centre, pair, {settings}, two); }, by_warp});
  error.one_eye_ms = ms[0];
  error.both_drawn_ms = ms[1];
  error.both_warped_ms = ms[2];
  return error;
}

}  // namespace glassbox::views
