#include "views/layers/second_eye_error.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>

namespace glassbox::views {

namespace {

// The medians of what runs take, run in turns, so that what disturbs the machine disturbs all of them.
template <std::size_t N>
std::array<double, N> medians_ms(const std::array<std::function<void()>, N>& runs) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t kTimes = 7;
  std::array<std::array<double, kTimes>, N> times;
  for (std::size_t i = 0; i < kTimes; ++i) {
    for (std::size_t k = 0; k < N; ++k) {
      const Clock::time_point start = Clock::now();
      runs[k]();
      times[k][i] = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    }
  }
  std::array<double, N> medians;
  for (std::size_t k = 0; k < N; ++k) {
    std::ranges::sort(times[k]);
    medians[k] = times[k][kTimes / 2];
  }
  return medians;
}

}  // namespace

EyeError eye_error(const Image<Rgba8>& picture, const Image<Rgba8>& truth) {
  constexpr int kSeen = 8;
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
    error.wrong += most > kSeen;
  }
  error.rms = std::sqrt(squares / (3 * double(truth.pixels.size())));
  return error;
}

SecondEyeError second_eye_error(Renderer& renderer, const Scene& scene, const View& centre,
                                const StereoPair& pair, const RenderSettings& settings,
                                const SecondEyeSettings& by) {
  const View left = eye_view(centre, pair, Side::kLeft),
             right = eye_view(centre, pair, Side::kRight);
  const Image<Rgba8> truth = renderer.render(right, settings).buffers.color;
  SecondEye second;
  PairByWarp warped;
  const auto by_warp = [&] {
    render_pair_by_warp(renderer, scene, centre, pair, settings, by, second, warped);
  };
  by_warp();
  const StereoRendering& both = warped.rendering;
  SecondEyeError error;
  error.layers = by.layers;
  error.pixels = truth.pixels.size();
  error.holes = warped.holes;
  error.warped = eye_error(both.right.color, truth);
  error.left = eye_error(both.left.color, truth);
  const std::function<void()> draw_one = [&] { renderer.render(left, settings); };
  const std::function<void()> draw_both = [&] { renderer.render_pair(centre, pair, {settings}); };
  if (by.layers == 1) {
    const auto ms = medians_ms<3>({draw_one, draw_both, [&] { by_warp(); }});
    error.one_eye_ms = ms[0];
    error.both_drawn_ms = ms[1];
    error.both_warped_ms = ms[2];
  } else {
    const auto ms = medians_ms<2>({draw_one, draw_both});
    error.one_eye_ms = ms[0];
    error.both_drawn_ms = ms[1];
    error.both_warped_ms = warped.left_ms + warped.layers_ms + warped.warp_ms;
  }
  return error;
}

}  // namespace glassbox::views
