#include "views/layers/draw_layers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <glassbox/base/little_endian.h>
#include <glassbox/render/engine/threads.h>

#include "views/layers/footprints.h"
#include "views/layers/warp_kernels.h"

namespace glassbox::views {

namespace {

// Along a row, the warped position is start + (column in pixels) * right, in float. The start is
// computed anew in double every 64 pixels, so that the rounding error of any pixel is that of at
// most 64 steps (C-80).
constexpr int kAnchorPixels = 64;
// Two samples of neighbouring pixels belong to one surface if their relative difference in depth is
// at most this.
constexpr float kSteepest = 1.0f / 16;
constexpr int kRowsOfTask = 8;
// Vector instructions read and write several numbers at once, and may go this many numbers beyond
// the last one of an array.
constexpr std::size_t kPadding = 64;

WarpedPoint rounded(const Eigen::Vector4d& v) {
  return {float(v.x()), float(v.y()), float(v.z()), float(v.w())};
}

// The samples of a layered depth image in the layout that the kernels read.
struct Samples {
  explicit Samples(const LayeredImage& of)
      : image(of),
        depth(of.samples() + kPadding),
        color(of.samples() + kPadding),
        column(of.samples() + kPadding),
        slope_x(of.samples() + kPadding),
        slope_y(of.samples() + kPadding) {
    std::ranges::copy(of.depth, depth.begin());
    for (std::size_t i = 0; i < of.samples(); ++i)
      color[i] = std::bit_cast<std::uint32_t>(of.color[i]);
    const auto width = std::size_t(of.camera.width);
    for (std::size_t place = 0; place + 1 < of.first.size(); ++place) {
      std::fill(column.begin() + of.first[place], column.begin() + of.first[place + 1],
                std::uint16_t(place % width));
    }
    find_slopes();
  }

  const LayeredImage& image;
  std::vector<float> depth;
  std::vector<std::uint32_t> color;
  std::vector<std::uint16_t> column;
  std::vector<float> slope_x, slope_y;

private:
  // The range of samples of pixel (x, y); empty outside of the picture.
  std::pair<std::uint32_t, std::uint32_t> samples_at(int x, int y) const {
    if (x < 0 || y < 0 || x >= image.camera.width || y >= image.camera.height) return {0, 0};
    const std::size_t place = image.pixel_index(x, y);
    return {image.first[place], image.first[place + 1]};
  }

  // The difference from the depth `from` to the closest depth of pixel (x, y), if both may belong
  // to the same surface.
  std::optional<float> gain(float from, int x, int y) const {
    const auto [begin, end] = samples_at(x, y);
    std::optional<float> least;
    for (std::uint32_t i = begin; i < end; ++i) {
      const float step = image.depth[i] - from;
      if (std::abs(step) > from * kSteepest) continue;
      if (!least || std::abs(step) < std::abs(*least)) least = step;
    }
    return least;
  }

  // The slope of the depth, from its differences to the neighbours on both sides. On a plane, both
  // give the same slope. Otherwise the smaller one is used, because the larger one may belong to
  // the edge of the surface.
  static float slope(const std::optional<float>& before, const std::optional<float>& after) {
    if (!before || !after) return after.value_or(-before.value_or(0));
    return std::abs(*before) < std::abs(*after) ? -*before : *after;
  }

  // A plane in the world is also a plane in screen space: for p x + q y + r z + s = 0, where z is
  // the depth, the slopes of the depth along x and y are -p / r and -q / r. They are limited to the
  // steepest slope that samples without normals may have; a sample that is seen edge on is drawn as
  // a line.
  std::pair<float, float> slopes_of(const SampleNormal& n, const Eigen::Matrix4d& world_from_screen,
                                    const Eigen::Vector4d& at) const {
    const Eigen::Vector3d normal(n.x, n.y, n.z);
    const Eigen::Vector3d place = (world_from_screen * at).hnormalized();
    Eigen::RowVector4d plane;
    plane << normal.transpose(), -normal.dot(place);
    const Eigen::RowVector4d seen = plane * world_from_screen;
    const double steepest = double(kSteepest) * at.z();
    const auto slope = [&](double along) {
      const double exact = -along / seen.z();
      return std::isfinite(exact) ? float(std::clamp(exact, -steepest, steepest)) : 0.0f;
    };
    return {slope(seen.x()), slope(seen.y())};
  }

  void find_slopes() {
    const Eigen::Matrix4d world_from_screen = image.camera.screen_from_world.inverse();
    for (int y = 0; y < image.camera.height; ++y) {
      for (int x = 0; x < image.camera.width; ++x) {
        const auto [begin, end] = samples_at(x, y);
        for (std::uint32_t i = begin; i < end; ++i) {
          const float z = image.depth[i];
          if (!image.normal.empty() && image.normal[i].is_known()) {
            std::tie(slope_x[i], slope_y[i]) =
                slopes_of(image.normal[i], world_from_screen, {x + 0.5, y + 0.5, double(z), 1});
            continue;
          }
          slope_x[i] = slope(gain(z, x - 1, y), gain(z, x + 1, y));
          slope_y[i] = slope(gain(z, x, y - 1), gain(z, x, y + 1));
        }
      }
    }
  }
};

// Warps the samples of one view to another, block by block.
class Warp {
public:
  Warp(const Samples& samples, const LayerCamera& to)
      : samples_(samples),
        matrix_(warp_matrix(to, samples.image.camera)),
        right_(rounded(matrix_.col(0))),
        depth_step_(rounded(matrix_.col(2))) {}

  WarpedPoint down() const { return rounded(matrix_.col(1)); }

  // Calls `visit` for the blocks of row y, from left to right; blocks without samples are left out.
  template <class Visit>
  void for_each_block(int y, const Visit& visit) const {
    const LayeredImage& image = samples_.image;
    const int width = image.camera.width;
    const std::size_t row = image.pixel_index(0, y);
    for (int anchor = 0; anchor < width; anchor += kAnchorPixels) {
      const std::uint32_t
          begin = image.first[row + std::size_t(anchor)],
          end = image.first[row + std::size_t(std::min(anchor + kAnchorPixels, width))];
      if (begin == end) continue;
      const Eigen::Vector4d at(anchor + 0.5, y + 0.5, 0, 1);
      visit(begin,
            WarpBlock{&samples_.depth[begin], &samples_.color[begin], &samples_.column[begin],
                      &samples_.slope_x[begin], &samples_.slope_y[begin], int(end - begin), anchor,
                      rounded(matrix_ * at), right_, depth_step_});
    }
  }

private:
  const Samples& samples_;
  Eigen::Matrix4d matrix_;
  WarpedPoint right_, depth_step_;
};

// Memory for the boxes of pixels that the samples of one row cover.
struct RowBoxes {
  // Returns boxes for `count` samples, with padding for whole vectors.
  SampleBoxes of(std::size_t count) {
    const std::size_t size = count + kPadding;
    for (auto* edge : {&left, &top, &right, &bottom}) {
      if (edge->size() < size) edge->resize(size);
    }
    if (depth.size() < size) depth.resize(size);
    if (side.size() < size) side.resize(size);
    return {left.data(), top.data(), right.data(), bottom.data(), depth.data(), side.data()};
  }

  std::vector<std::int32_t> left, top, right, bottom;
  std::vector<std::uint32_t> depth;
  std::vector<std::uint8_t> side;
};

SampleBoxes boxes_from(const SampleBoxes& boxes, std::size_t i) {
  return {boxes.left + i,   boxes.top + i,   boxes.right + i,
          boxes.bottom + i, boxes.depth + i, boxes.side + i};
}

// The memory that one thread draws into.
struct Canvas {
  static std::size_t keys_of(int width, int height) {
    return std::size_t(width + 2) * std::size_t(height + 2) + 1;
  }
  void clear(int width, int height) {
    keys.assign(keys_of(width, height), 0);
    counts = {};
  }

  std::vector<SampleKey> keys;
  RowBoxes boxes;
  BlockCounts counts;
  std::vector<SampleKey> scratch;
};

}  // namespace

struct LayerDrawer::State {
  explicit State(const LayeredImage& image) : samples(image) {}

  Samples samples;
  std::vector<Canvas> canvases;
  int threads = 0;
  std::unique_ptr<tbb::task_arena> arena;  // with `threads` threads
};

namespace {

// Draws the samples as one picture, row by row.
class Picture {
public:
  Picture(const Samples& samples, const LayerCamera& to, const LayerDrawing& drawing)
      : samples_(samples),
        drawing_(drawing),
        to_(to),
        kernels_(warp_kernels(drawing.target)),
        warp_(samples, to),
        sides_(sides_of(drawing.splat, warp_.down())) {}

  // Draws the samples of row y of the layers; at each pixel the nearest one stays.
  void draw_row(int y, Canvas& canvas) const {
    const KeyCanvas view = view_of(canvas);
    if (drawing_.splat == Splat::kPoint || drawing_.splat == Splat::kThree) {
      const int margin = drawing_.splat == Splat::kThree;
      warp_.for_each_block(y, [&](std::uint32_t, const WarpBlock& block) {
        kernels_.points(block, margin, view, canvas.counts);
      });
      return;
    }
    warp_.for_each_block(y, [&](std::uint32_t, const WarpBlock& block) {
      const SampleBoxes boxes = canvas.boxes.of(std::size_t(block.count));
      kernels_.boxes(block, sides_, to_.width, to_.height, boxes, canvas.counts);
      for (int i = 0; i < block.count; ++i) {
        const SampleKey key = SampleKey(boxes.depth[i]) << 32 | block.color[i];
        for (int row = boxes.top[i]; row < boxes.bottom[i]; ++row) {
          SampleKey* const pixels = row_of(view, row);
          for (int x = boxes.left[i]; x < boxes.right[i]; ++x) pixels[x] = std::max(pixels[x], key);
        }
      }
    });
  }

  // Draws all samples in the order of LayerOrder::kOcclusion, from far to near, without comparing
  // depths.
  void draw_ordered(Canvas& canvas) const {
    const KeyCanvas view = view_of(canvas);
    const LayeredImage& image = samples_.image;
    const Eigen::Vector4d epipole = image.camera.screen_from_world * eye_of(to_);
    const auto columns = visiting_order(epipole.x(), epipole.w(), image.camera.width);
    for (const int y : visiting_order(epipole.y(), epipole.w(), image.camera.height)) {
      const std::size_t row = image.pixel_index(0, y);
      const std::uint32_t begin = image.first[row];
      const std::size_t count = image.first[row + std::size_t(image.camera.width)] - begin;
      const SampleBoxes boxes = canvas.boxes.of(count);
      warp_.for_each_block(y, [&](std::uint32_t first, const WarpBlock& block) {
        kernels_.boxes(block, sides_, to_.width, to_.height, boxes_from(boxes, first - begin),
                       canvas.counts);
      });
      for (const int x : columns) {
        const std::size_t place = row + std::size_t(x);
        for (std::uint32_t i = image.first[place]; i < image.first[place + 1]; ++i) {
          paint(boxes, i - begin, samples_.color[i], view);
        }
      }
    }
  }

  // Combines row y of all canvases, and stores it in the picture.
  void finish_row(int y, std::span<Canvas> canvases, std::vector<SampleKey>& scratch,
                  LayerPicture& into) const {
    const bool widened = drawing_.splat == Splat::kThree && drawing_.order == LayerOrder::kDepth;
    std::vector<const SampleKey*> rows;
    for (Canvas& canvas : canvases) {
      const KeyCanvas view = view_of(canvas);
      for (int beside = widened ? -1 : 0; beside <= (widened ? 1 : 0); ++beside) {
        rows.push_back(row_of(view, y + beside) - 1);
      }
    }
    scratch.resize(std::size_t(to_.width) + 2);
    kernels_.finish_row(rows, widened, to_.width, std::bit_cast<std::uint32_t>(drawing_.background),
                        scratch.data(), &into.color.at(0, y), &into.depth.at(0, y));
  }

private:
  static SplatSides sides_of(Splat splat, const WarpedPoint& down) {
    switch (splat) {
      case Splat::kPoint:
        return {0, 1, 1, 1, down};
      case Splat::kThree:
        return {0, 3, 3, 3, down};
      case Splat::kProjected:
        return {1, 1, kLargestSplat, kLargestSplat, down};
      case Splat::kSoft:  // the box has only the pixel in the middle
        break;
    }
    return {1, 1, 1, float(kLargestFootprint), down};
  }

  KeyCanvas view_of(Canvas& canvas) const { return {canvas.keys.data(), to_.width, to_.height}; }
  // Pointer to pixel 0 of row y.
  static SampleKey* row_of(const KeyCanvas& view, int y) {
    return view.keys + std::ptrdiff_t(y + 1) * view.stride() + 1;
  }

  void paint(const SampleBoxes& boxes, std::size_t i, std::uint32_t color,
             const KeyCanvas& view) const {
    const SampleKey key = SampleKey(boxes.depth[i]) << 32 | color;
    if (drawing_.splat == Splat::kSoft) {
      if (boxes.left[i] < boxes.right[i])
        paint_footprint(boxes.left[i], boxes.top[i], boxes.side[i], key, drawing_.background, view);
      return;
    }
    for (int row = boxes.top[i]; row < boxes.bottom[i]; ++row) {
      SampleKey* const pixels = row_of(view, row);
      std::fill(pixels + boxes.left[i], pixels + boxes.right[i], key);
    }
  }

  const Samples& samples_;
  const LayerDrawing& drawing_;
  const LayerCamera& to_;
  const WarpKernels& kernels_;
  Warp warp_;
  SplatSides sides_;
};

WarpCounts sum_of(std::span<const Canvas> canvases, std::size_t samples) {
  WarpCounts sum;
  for (const Canvas& canvas : canvases) {
    sum.behind += canvas.counts.behind;
    sum.outside += canvas.counts.outside;
    sum.oversized += canvas.counts.oversized;
  }
  sum.drawn = samples - sum.behind - sum.outside;
  return sum;
}

template <class Pixel>
void resize_to(Image<Pixel>& image, const LayerCamera& to) {
  if (image.width != to.width || image.height != to.height)
    image = Image<Pixel>(to.width, to.height);
}

}  // namespace

std::vector<int> visiting_order(double epipole, double w, int count) {
  const auto ascends = [&](int i) { return epipole - (i + 0.5) * w > 0; };
  std::vector<int> order;
  for (int i = 0; i < count; ++i) {
    if (ascends(i)) order.push_back(i);
  }
  for (int i = count; i-- > 0;) {
    if (!ascends(i)) order.push_back(i);
  }
  return order;
}

int threads_that_draw(const LayerCamera& from, const LayerCamera& to, const LayerDrawing& drawing) {
  if (drawing.order == LayerOrder::kOcclusion) return 1;
  const std::size_t canvases =
      kMaxCanvasBytes / (sizeof(SampleKey) * Canvas::keys_of(to.width, to.height));
  const int tasks = (from.height + kRowsOfTask - 1) / kRowsOfTask;
  const int useful = std::min(tasks, int(std::min<std::size_t>(canvases, 1u << 30)));
  return std::clamp(drawing.threads, 1, std::max(useful, 1));
}

LayerDrawer::LayerDrawer(const LayeredImage& image) : state_(std::make_unique<State>(image)) {}
LayerDrawer::~LayerDrawer() = default;

void LayerDrawer::draw(const LayerCamera& to, const LayerDrawing& drawing, LayerPicture& into) {
  State& state = *state_;
  const Picture picture(state.samples, to, drawing);
  const LayerCamera& from = state.samples.image.camera;
  resize_to(into.color, to);
  resize_to(into.depth, to);
  const int threads = threads_that_draw(from, to, drawing);
  state.canvases.resize(std::size_t(threads));
  if (threads == 1) {
    Canvas& canvas = state.canvases[0];
    canvas.clear(to.width, to.height);
    if (drawing.order == LayerOrder::kOcclusion) {
      picture.draw_ordered(canvas);
    } else {
      for (int y = from.height; y-- > 0;) picture.draw_row(y, canvas);
    }
    for (int y = 0; y < to.height; ++y) picture.finish_row(y, state.canvases, canvas.scratch, into);
  } else {
    if (state.threads != threads) {
      allow_threads(threads);
      state.arena = std::make_unique<tbb::task_arena>(threads);
      state.threads = threads;
    }
    const auto rows = [](int height) { return tbb::blocked_range<int>(0, height, kRowsOfTask); };
    const auto mine = [&]() -> Canvas& {
      return state.canvases[std::size_t(tbb::this_task_arena::current_thread_index())];
    };
    state.arena->execute([&] {
      tbb::parallel_for(0, threads,
                        [&](int i) { state.canvases[std::size_t(i)].clear(to.width, to.height); });
      tbb::parallel_for(rows(from.height), [&](const tbb::blocked_range<int>& some) {
        for (int y = some.begin(); y < some.end(); ++y) picture.draw_row(y, mine());
      });
      tbb::parallel_for(rows(to.height), [&](const tbb::blocked_range<int>& some) {
        for (int y = some.begin(); y < some.end(); ++y)
          picture.finish_row(y, state.canvases, mine().scratch, into);
      });
    });
  }
  into.counts = sum_of(state.canvases, state.samples.image.samples());
}

LayerPicture draw_layers(const LayeredImage& image, const LayerCamera& to,
                         const LayerDrawing& drawing) {
  LayerPicture picture;
  LayerDrawer(image).draw(to, drawing, picture);
  return picture;
}

}  // namespace glassbox::views
