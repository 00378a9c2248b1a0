#include "views/layers/second_eye.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <glassbox/base/elapsed.h>
#include <glassbox/base/little_endian.h>
#include <glassbox/base/printable.h>
#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/render/engine/threads.h>

#include "views/layers/depth_peeling.h"
#include "views/layers/disocclusion.h"
#include "views/layers/eye_kernels.h"

namespace glassbox::views {

namespace {

using Clock = std::chrono::steady_clock;
constexpr int kRowsOfTask = 16;

// The parallax p(z) of parallax.h as a linear function of the nearness, from its values at the
// nearnesses 0 and 1.
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
    // The depth at distance z is f/(f - n) (1 - n/z) for the near plane n and the far plane f, or
    // with reversed depth n/(f - n) (f/z - 1).
    const double rest = std::isinf(far) ? 1 : (far - near) / far;
    shift.offset = float(reversed ? 1 - rest : 1);
    shift.slope = float(reversed ? rest : -rest);
  }
  const double farthest = parallax_at(centre, pair, at_nothing).px;
  shift.at_infinity = float(farthest);
  shift.by_nearness = float(farthest - parallax_at(centre, pair, near).px);
  return shift;
}

// A row of the other eye's picture, with room for one pixel beyond its end.
struct Row {
  // Empties the row. `beside` is the colour that it gets if nothing is warped to it.
  EyeTarget cleared(int width, const Rgba8& beside) {
    nearness.assign(std::size_t(width) + 1, 0);
    color.resize(std::size_t(width) + 1);
    color[0] = std::bit_cast<std::uint32_t>(beside);
    return target();
  }
  EyeTarget target() { return {color.data(), nearness.data()}; }

  std::vector<std::uint32_t> color, nearness;
};

void take_nearer(const EyeTarget& behind, int width, const EyeTarget& to) {
  for (int x = 0; x < width; ++x) {
    if (behind.nearness[x] <= to.nearness[x]) continue;
    to.nearness[x] = behind.nearness[x];
    to.color[x] = behind.color[x];
  }
}

// The view with its picture extended to the right, up to this width.
View widened(const View& view, int width) {
  View wide = view;
  const double by = double(view.viewport.width()) / width;
  for (int i = 0; i < 4; ++i) {
    wide.clip_from_eye.at(0, i) =
        by * view.clip_from_eye.at(0, i) + (by - 1) * view.clip_from_eye.at(3, i);
  }
  wide.viewport.right = wide.viewport.left + float(width);
  return wide;
}

}  // namespace

struct SecondEye::State {
  struct RowBuffers {
    std::vector<float> scratch;
    Row row;
    DisocclusionBuffers behind;
  };

  void begin(const Image<Rgba8>& first, const View& centre, const StereoPair& pair,
             const SecondEyeSettings& settings) {
    width = first.width;
    height = first.height;
    shift = eye_shift_of(centre, pair, settings.format);
    kernels = &eye_kernels(settings.target);
    const int wanted = std::clamp(settings.threads, 1, height);
    if (threads == wanted) return;
    allow_threads(wanted);
    arena = std::make_unique<tbb::task_arena>(wanted);
    threads = wanted;
    of_thread.resize(std::size_t(threads));
  }

  // Calls work(y, buffers) for all rows; returns the sum of the results.
  template <class Work>
  std::size_t for_each_row(const Work& work) {
    std::vector<int> counts(std::size_t(height), 0);
    if (threads == 1) {
      for (int y = 0; y < height; ++y) counts[std::size_t(y)] = work(y, of_thread[0]);
    } else {
      arena->execute([&] {
        tbb::parallel_for(tbb::blocked_range<int>(0, height, kRowsOfTask),
                          [&](const tbb::blocked_range<int>& some) {
                            const auto mine =
                                std::size_t(tbb::this_task_arena::current_thread_index());
                            for (int y = some.begin(); y < some.end(); ++y)
                              counts[std::size_t(y)] = work(y, of_thread[mine]);
                          });
      });
    }
    return std::accumulate(counts.begin(), counts.end(), std::size_t(0));
  }

  void warp_row(const LayerView& layer, bool is_first, int y, RowBuffers& buffers,
                const EyeTarget& to) const {
    const int columns = layer.color.width;
    buffers.scratch.resize(2 * std::size_t(columns) + 256);
    const EyeRow row{&layer.color.at(0, y), &layer.depth.at(0, y), columns, is_first};
    kernels->warp_row(shift, row, buffers.scratch.data(), to);
  }

  int finish_row(const EyeTarget& row, int y, Image<Rgba8>& into) const {
    const int holes = kernels->fill(row, width);
    std::memcpy(static_cast<void*>(&into.at(0, y)), row.color, 4 * std::size_t(width));
    return holes;
  }

  // The width of the hole at the right end of a row: what is seen there is outside of the first
  // eye's picture.
  int hole_at_end(int y) {
    const EyeTarget row = rows[std::size_t(y)].target();
    int end = width;
    while (end > 0 && row.nearness[end - 1] == 0) --end;
    return width - end;
  }

  int width = 0, height = 0;
  int extra_columns = 0;  // columns that a second layer has beyond the first one's right edge
  EyeShift shift{};
  const EyeKernels* kernels = nullptr;
  std::vector<Row> rows;  // of the other eye, if there is more than one layer
  std::vector<RowBuffers> of_thread;
  int threads = 0;
  std::unique_ptr<tbb::task_arena> arena;  // with `threads` threads
};

SecondEye::SecondEye() : state_(std::make_unique<State>()) {}
SecondEye::~SecondEye() = default;

void SecondEye::begin(const LayerView& first, const View& centre, const StereoPair& pair,
                      const SecondEyeSettings& settings) {
  State& s = *state_;
  s.begin(first.color, centre, pair, settings);
  if (s.rows.size() < std::size_t(s.height)) s.rows.resize(std::size_t(s.height));
  s.for_each_row([&](int y, State::RowBuffers& buffers) {
    s.warp_row(first, true, y, buffers,
               s.rows[std::size_t(y)].cleared(s.width, first.color.at(0, y)));
    return 0;
  });
  // The next layers are drawn with further columns at the right, because they must fill the hole at
  // the end of a row. Surfaces that are nearer than those at the edge move farther than the hole is
  // wide, so twice its width is an estimate. (And one column more, because a pixel between two
  // samples is a mixture of both.)
  s.extra_columns = 0;
  for (int y = 0; y < s.height; ++y) {
    if (const int hole = s.hole_at_end(y); hole > 0)
      s.extra_columns = std::max(s.extra_columns, 2 * hole + 1);
  }
  s.extra_columns = std::min(s.extra_columns, kMaxImageSide - s.width);
}

bool SecondEye::find_disoccluded_depths(const Image<std::uint32_t>& last,
                                        Image<std::uint32_t>& behind) {
  State& s = *state_;
  const int columns = s.width + s.extra_columns;
  if (behind.width != columns || behind.height != s.height)
    behind = Image<std::uint32_t>(columns, s.height);
  const bool is_second = last.width == s.width;
  return s.for_each_row([&](int y, State::RowBuffers& buffers) {
    std::uint32_t* const row = &behind.at(0, y);
    const bool found = find_disocclusions(s.shift, &last.at(0, y), s.width,
                                          s.rows[std::size_t(y)].target(), buffers.behind, row);
    const int hole = is_second ? s.hole_at_end(y) : 0;
    const int wanted = hole > 0 ? std::min(2 * hole + 1, s.extra_columns) : 0;
    std::fill_n(row + s.width, wanted, 0u);
    std::fill(row + s.width + wanted, row + columns, kEmptyDepth);
    return int(found || wanted > 0);
  }) > 0;
}

void SecondEye::add(const LayerView& layer) {
  State& s = *state_;
  s.for_each_row([&](int y, State::RowBuffers& buffers) {
    const EyeTarget row = buffers.row.cleared(layer.color.width, layer.color.at(0, y));
    s.warp_row(layer, false, y, buffers, row);
    take_nearer(row, s.width, s.rows[std::size_t(y)].target());
    return 0;
  });
}

std::size_t SecondEye::finish(Image<Rgba8>& into) {
  State& s = *state_;
  if (into.width != s.width || into.height != s.height) into = Image<Rgba8>(s.width, s.height);
  return s.for_each_row([&](int y, State::RowBuffers&) {
    return s.finish_row(s.rows[std::size_t(y)].target(), y, into);
  });
}

std::size_t SecondEye::warp(const LayerView& layer, const View& centre, const StereoPair& pair,
                            const SecondEyeSettings& settings, Image<Rgba8>& into) {
  State& s = *state_;
  s.begin(layer.color, centre, pair, settings);
  if (into.width != s.width || into.height != s.height) into = Image<Rgba8>(s.width, s.height);
  return s.for_each_row([&](int y, State::RowBuffers& buffers) {
    const EyeTarget row = buffers.row.cleared(s.width, layer.color.at(0, y));
    s.warp_row(layer, true, y, buffers, row);
    return s.finish_row(row, y, into);
  });
}

Result<void> check_second_eye(const Scene& scene, const RenderSettings& settings, int layers) {
  const std::string option = "--second-eye";
  if (settings.show != Show::kColor)
    return fail(option, "warping moves colours from eye to eye, but not the quantities of --show",
                "leave one of the two options out");
  if (layers == 1) return {};
  if (settings.samples > 1)
    return fail(option,
                "several layers cannot be used with --samples, because each pixel of a layer has "
                "only one depth",
                "leave --samples out, or use warp:1");
  if (const Material* glass = transparent_material(scene))
    return fail(option,
                "material \"" + printable(glass->name) +
                    "\" is transparent, which is possible with one layer only",
                "use warp:1, which warps the material together with the surface behind it");
  return {};
}

void render_pair_by_warp(Renderer& renderer, const View& centre, const StereoPair& pair,
                         const RenderSettings& settings, const SecondEyeSettings& warp_settings,
                         SecondEye& second, WarpedPair& into) {
  StereoRendering& both = into.rendering;
  RenderSettings with_depth = settings;
  with_depth.want_depth = true;
  SecondEyeSettings how = warp_settings;
  how.format = settings.depth;
  const View left_view = eye_view(centre, pair, Side::kLeft);
  const Clock::time_point start = Clock::now();
  Rendering& drawn = into.drawn;
  drawn.buffers = std::move(both.left);
  renderer.render(left_view, with_depth, drawn);
  both.left = std::move(drawn.buffers);
  both.left_statistics = drawn.statistics;
  into.left_ms = elapsed_ms(start);
  into.layers_ms = into.warp_ms = 0;
  into.holes = 0;
  both.passes = 1;
  if (pair.half_separation == 0) {
    both.right = both.left;
    return;
  }
  const LayerView first{both.left.color, both.left.depth};
  const auto warping = [&](const auto& work) {
    const Clock::time_point began = Clock::now();
    work();
    into.warp_ms += elapsed_ms(began);
  };
  if (warp_settings.layers == 1) {
    warping([&] { into.holes = second.warp(first, centre, pair, how, both.right.color); });
  } else {
    warping([&] { second.begin(first, centre, pair, how); });
    const Image<std::uint32_t>* last = &both.left.depth;
    with_depth.want_distance = false;
    for (int i = 1; i < warp_settings.layers; ++i) {
      bool any = false;
      warping([&] { any = second.find_disoccluded_depths(*last, into.behind); });
      if (!any) break;
      const Clock::time_point peeling = Clock::now();
      renderer.render(widened(left_view, into.behind.width), with_depth, into.layer, &into.behind);
      into.layers_ms += elapsed_ms(peeling);
      last = &into.layer.buffers.depth;
      warping([&] { second.add({into.layer.buffers.color, *last}); });
    }
    warping([&] { into.holes = second.finish(both.right.color); });
  }
  both.right.distance = settings.want_distance ? both.left.distance : Image<float>();
}

}  // namespace glassbox::views
