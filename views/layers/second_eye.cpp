#include "views/layers/second_eye.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <glassbox/base/printable.h>
#include <glassbox/pipeline/stereo/parallax.h>

#include "views/layers/eye_kernels.h"

namespace glassbox::views {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kRowsOfTask = 16;

// p(z) of parallax.h from its values where the nearness is 0 and 1.
EyeShift eye_shift_of(const View& centre, const StereoPair& pair, DepthFormat format) {
  EyeShift shift{};
  shift.format = format;
  const double near = centre.near, far = centre.far;
  const bool reversed = centre.depth_range == DepthRange::kReversed;
  double at_nothing = std::numeric_limits<double>::infinity();
  if (!centre.perspective) {
    at_nothing = far;
    shift.offset = reversed ? 0 : 1;
    shift.slope = reversed ? 1 : -1;
  } else {
    // Depths are f/(f - n) (1 - n/z), or reversed n/(f - n) (f/z - 1).
    const double rest = std::isinf(far) ? 1 : (far - near) / far;
    shift.offset = float(reversed ? 1 - rest : 1);
    shift.slope = float(reversed ? rest : -rest);
  }
  const double farthest = parallax_at(centre, pair, at_nothing).px;
  shift.at_infinity = float(farthest);
  shift.by_nearness = float(farthest - parallax_at(centre, pair, near).px);
  return shift;
}

// A code's depth.
double depth_of_code(DepthFormat format, std::uint32_t code) {
  constexpr std::uint32_t kOne = std::bit_cast<std::uint32_t>(1.0f);
  switch (format) {
    case DepthFormat::kFloat32:
      return double(std::bit_cast<float>(code));
    case DepthFormat::kFloat32Reversed:
      return double(std::bit_cast<float>(kOne - code));
    case DepthFormat::kUnorm24:
    case DepthFormat::kUnorm16:
      break;
  }
  return code / unorm_depth_steps(format);
}

// The codes of what has a pixel of parallax more: what is nearer to the surface in front than that cannot come into view beside it by a
// whole pixel, and would take a layer from what can.
void push_back_by_a_pixel(const EyeShift& shift, Image<std::uint32_t>& codes) {
  for (std::uint32_t& code : codes.pixels) {
    if (code == kEmptyDepth) continue;
    const double nearness =
        double(shift.offset) + double(shift.slope) * depth_of_code(shift.format, code);
    const double behind = nearness - 1 / double(shift.by_nearness);
    code = behind <= 0 ? kEmptyDepth
                       : depth_code(shift.format,
                                    float((behind - double(shift.offset)) / double(shift.slope)));
  }
}

// A row of the other eye's picture and room beyond it.
struct Row {
  EyeTarget cleared(int width) {
    nearness.assign(std::size_t(width) + 1, 0);
    color.resize(std::size_t(width) + 1);
    return {color.data(), nearness.data()};
  }

  std::vector<std::uint32_t> color, nearness;
};

// Pixels of parallax that what is seen in a hole may lie behind the farther of its sides: surfaces recede, and others begin. A guess, of
// which less fills the forest's holes worse and more shows the sky through the room's walls.
constexpr float kRecedes = 8;

// For each hole that the first layer leaves, the least nearness (bits + 1) of what may be seen in it: the farther of its two sides', less so
// much parallax. Deeper layers have what lies behind that side, too, which it would hide if it went on
// in the hole, as a wall does behind a lamp.
void find_limits(const EyeTarget& front, int width, const EyeShift& shift,
                 std::vector<std::uint32_t>& limits) {
  limits.assign(std::size_t(width), 0);
  for (int x = 0; x < width; ++x) {
    if (front.nearness[x] != 0) continue;
    int end = x;
    while (end < width && front.nearness[end] == 0) ++end;
    const std::uint32_t left = x > 0 ? front.nearness[x - 1] : 0,
                        right = end < width ? front.nearness[end] : 0;
    const std::uint32_t farther = left == 0 ? right : right == 0 ? left : std::min(left, right);
    if (farther != 0) {
      const float limit = std::bit_cast<float>(farther - 1) - kRecedes / shift.by_nearness;
      std::fill(limits.begin() + x, limits.begin() + end,
                limit > 0 ? std::bit_cast<std::uint32_t>(limit) + 1 : 0);
    }
    x = end;
  }
}

void take_behind(const EyeTarget& behind, const std::vector<std::uint32_t>& limits,
                 const EyeTarget& to) {
  for (std::size_t x = 0; x < limits.size(); ++x) {
    if (behind.nearness[x] <= to.nearness[x] || behind.nearness[x] < limits[x]) continue;
    to.nearness[x] = behind.nearness[x];
    to.color[x] = behind.color[x];
  }
}

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

struct SecondEye::State {
  struct Memory {
    std::vector<float> scratch;
    Row front, behind;
    std::vector<std::uint32_t> limits;
  };
  std::vector<Memory> of_thread;
  int threads = 0;
  std::unique_ptr<tbb::task_arena> arena;  // of that many
};

SecondEye::SecondEye() : state_(std::make_unique<State>()) {}
SecondEye::~SecondEye() = default;

std::size_t SecondEye::warp(std::span<const LayerView> layers, const View& centre,
                            const StereoPair& pair, const SecondEyeSettings& settings,
                            Image<Rgba8>& into) {
  const int width = layers[0].color.width, height = layers[0].color.height;
  const EyeShift shift = eye_shift_of(centre, pair, settings.format);
  const EyeKernels& kernels = eye_kernels(settings.target);
  if (into.width != width || into.height != height) into = Image<Rgba8>(width, height);
  State& state = *state_;
  const int threads = std::clamp(settings.threads, 1, height);
  if (state.threads != threads) {
    state.arena = std::make_unique<tbb::task_arena>(threads);
    state.threads = threads;
    state.of_thread.resize(std::size_t(threads));
  }
  std::vector<int> holes(std::size_t(height), 0);
  const auto warp_row = [&](int y, State::Memory& memory) {
    memory.scratch.resize(2 * std::size_t(width) + 256);
    EyeTarget to = memory.front.cleared(width);
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const LayerView& layer = layers[i];
      const EyeRow row{&layer.color.at(0, y), &layer.depth.at(0, y), width, i == 0};
      const EyeTarget layer_to = i == 0 ? to : memory.behind.cleared(width);
      kernels.carry(shift, row, memory.scratch.data(), layer_to);
      if (i == 0 && layers.size() > 1) find_limits(to, width, shift, memory.limits);
      if (i > 0) take_behind(layer_to, memory.limits, to);
    }
    holes[std::size_t(y)] = kernels.fill(to, width);
    std::memcpy(static_cast<void*>(&into.at(0, y)), to.color, 4 * std::size_t(width));
  };
  if (threads == 1) {
    for (int y = 0; y < height; ++y) warp_row(y, state.of_thread[0]);
  } else {
    state.arena->execute([&] {
      tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsOfTask),
                        [&](const tbb::blocked_range<int>& rows) {
                          const auto mine =
                              std::size_t(tbb::this_task_arena::current_thread_index());
                          for (int y = rows.begin(); y < rows.end(); ++y)
                            warp_row(y, state.of_thread[mine]);
                        });
    });
  }
  std::size_t all = 0;
  for (const int here : holes) all += std::size_t(here);
  return all;
}

Result<void> check_second_eye(const Scene& scene, const RenderSettings& settings, int layers) {
  const std::string option = "--second-eye";
  if (settings.show != Show::kColor)
    return fail(option, "it carries colours from eye to eye, not what --show shows",
                "leave one of them out");
  if (layers == 1) return {};
  if (settings.samples > 1)
    return fail(option, "a sample of a layer has one depth", "leave out --samples, or take warp:1");
  for (const Material& material : scene.materials) {
    if (material.alpha_mode == AlphaMode::kBlend)
      return fail(option, "material \"" + printable(material.name) + "\" is seen through",
                  "take warp:1, which carries it with what is behind it");
  }
  return {};
}

void render_pair_by_warp(Renderer& renderer, const Scene& scene, const View& centre,
                         const StereoPair& pair, const RenderSettings& settings,
                         const SecondEyeSettings& by, SecondEye& second, PairByWarp& into) {
  StereoRendering& both = into.rendering;
  RenderSettings with_depth = settings;
  with_depth.want_depth = true;
  SecondEyeSettings how = by;
  how.format = settings.depth;
  const View left_view = eye_view(centre, pair, Side::kLeft);
  const Clock::time_point start = Clock::now();
  Rendering left = renderer.render(left_view, with_depth);
  into.left_ms = ms_since(start);
  into.holes = 0;
  both.left = std::move(left.buffers);
  both.left_statistics = left.statistics;
  both.passes = 1;
  if (pair.half_separation == 0) {
    both.right = both.left;
    return;
  }
  const Clock::time_point peeling = Clock::now();
  std::vector<Layer> behind;
  if (by.layers > 1)
    behind = peel_behind(scene, left_view, with_depth, both.left.depth, by.layers - 1,
                         [&, shift = eye_shift_of(centre, pair, settings.depth)](
                             Image<std::uint32_t>& codes) { push_back_by_a_pixel(shift, codes); });
  into.layers_ms = ms_since(peeling);
  std::vector<LayerView> layers{{both.left.color, both.left.depth}};
  for (const Layer& layer : behind) layers.push_back({layer.color, layer.depth});
  const Clock::time_point warping = Clock::now();
  into.holes = second.warp(layers, centre, pair, how, both.right.color);
  into.warp_ms = ms_since(warping);
  both.right.distance = settings.want_distance ? both.left.distance : Image<float>();
}

}  // namespace glassbox::views
