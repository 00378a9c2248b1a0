#include "views/layers/draw_layers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <Eigen/Geometry>

namespace glassbox::views {

namespace {

// Along a row the warp is (column in pixels) * right + start; start is computed anew, in double, every so many pixels, so that a
// float's rounding is that of 64 steps wherever in the row it is (C-80).
constexpr int kAnchorPixels = 64;

struct Warped {
  float x, y, z, w;  // times w
};
Warped operator+(const Warped& a, const Warped& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w};
}
Warped operator*(float s, const Warped& a) {
  return {s * a.x, s * a.y, s * a.z, s * a.w};
}
Warped rounded(const Eigen::Vector4d& v) {
  return {float(v.x()), float(v.y()), float(v.z()), float(v.w())};
}

// Pixels for each unit of length at distance 1; of a parallel camera, at any: the geometric mean of both axes.
double focal_length(const LayerCamera& camera) {
  const auto row = [&](int i) -> Eigen::Vector3d {
    return camera.screen_from_world.row(i).head<3>();
  };
  const Eigen::Vector3d gaze = row(3);  // of length 1, or 0 for a parallel camera
  const auto across = [&](int i) { return (row(i) - row(i).dot(gaze) * gaze).norm(); };
  return std::sqrt(across(0) * across(1));
}

// The picture, or one thread's part of its samples.
class Canvas {
public:
  Canvas(const LayerCamera& camera, const LayerDrawing& drawing, double focal_from)
      : drawing_(drawing),
        magnification_(float(focal_length(camera) / focal_from)),
        color_(camera.width, camera.height, drawing.background),
        depth_(camera.width, camera.height, 0.0f) {}

  void draw(const Warped& at, Rgba8 color) {
    if (!(at.w > 0)) {
      ++counts_.behind;
      return;
    }
    const float inverse = 1 / at.w;
    const float x = at.x * inverse, y = at.y * inverse, z = at.z * inverse;
    const float half = half_side(inverse);
    // As floats, so that no number is too large for an integer.
    const float left = std::max(std::floor(x - half + 0.5f), 0.0f);
    const float top = std::max(std::floor(y - half + 0.5f), 0.0f);
    const float right = std::min(std::floor(x + half + 0.5f), float(color_.width));
    const float bottom = std::min(std::floor(y + half + 0.5f), float(color_.height));
    if (!(left < right) || !(top < bottom) || !(z <= 1)) {
      ++counts_.beside;
      return;
    }
    ++counts_.drawn;
    const bool compared = drawing_.order == LayerOrder::kDepth;
    for (int row = int(top); row < int(bottom); ++row) {
      for (int column = int(left); column < int(right); ++column) {
        const std::size_t i = depth_.index(column, row);
        if (compared && !(z > depth_.pixels[i])) continue;
        depth_.pixels[i] = z;
        color_.pixels[i] = color;
      }
    }
  }

  // `later` was drawn behind this.
  void take(const Canvas& later) {
    for (std::size_t i = 0; i < depth_.pixels.size(); ++i) {
      if (!(later.depth_.pixels[i] > depth_.pixels[i])) continue;
      depth_.pixels[i] = later.depth_.pixels[i];
      color_.pixels[i] = later.color_.pixels[i];
    }
    counts_.drawn += later.counts_.drawn;
    counts_.behind += later.counts_.behind;
    counts_.beside += later.counts_.beside;
    counts_.cut += later.counts_.cut;
  }

  LayerPicture finish() { return {std::move(color_), std::move(depth_), counts_}; }

private:
  float half_side(float inverse_w) {
    if (drawing_.splat == Splat::kPoint) return 0.5f;
    if (drawing_.splat == Splat::kThree) return 1.5f;
    const float side = magnification_ * inverse_w;
    counts_.cut += side > kLargestSplat;
    return std::clamp(side, 1.0f, kLargestSplat) / 2;
  }

  const LayerDrawing& drawing_;
  float magnification_;
  Image<Rgba8> color_;
  Image<float> depth_;
  WarpCounts counts_;
};

// The samples of pixel (x, y), from back to front.
class Warp {
public:
  Warp(const LayeredImage& image, const LayerCamera& to)
      : image_(image),
        matrix_(warp_matrix(to, image.camera)),
        right_(rounded(matrix_.col(0))),
        depth_(rounded(matrix_.col(2))) {}

  // Of a row, from its first pixel or from an anchor.
  Warped start(int x, int y) const {
    const int anchor = x / kAnchorPixels * kAnchorPixels;
    const Eigen::Vector4d at(anchor + 0.5, y + 0.5, 0, 1);
    return rounded(matrix_ * at) + float(x - anchor) * right_;
  }

  void draw_pixel(int x, int y, const Warped& start, Canvas& canvas) const {
    const std::size_t place = image_.place(x, y);
    for (std::uint32_t i = image_.first[place]; i < image_.first[place + 1]; ++i) {
      canvas.draw(start + image_.depth[i] * depth_, image_.color[i]);
    }
  }

  // Rows of the packed order, begin .. end - 1.
  void draw_rows(int begin, int end, Canvas& canvas) const {
    const int width = image_.camera.width;
    for (int row = begin; row < end; ++row) {
      const int y = image_.camera.height - 1 - row;
      for (int anchor = 0; anchor < width; anchor += kAnchorPixels) {
        const Warped begin_at = start(anchor, y);
        for (int x = anchor; x < std::min(anchor + kAnchorPixels, width); ++x) {
          draw_pixel(x, y, begin_at + float(x - anchor) * right_, canvas);
        }
      }
    }
  }

private:
  const LayeredImage& image_;
  Eigen::Matrix4d matrix_;
  Warped right_, depth_;
};

// Rows of the packed order, so that all parts have about as many samples.
std::vector<int> shared_rows(const LayeredImage& image, int parts) {
  std::vector<int> begins{0};
  const auto width = std::size_t(image.camera.width);
  int row = 0;
  for (int part = 1; part < parts; ++part) {
    const std::size_t wanted = image.samples() * std::size_t(part) / std::size_t(parts);
    while (row < image.camera.height && image.first[std::size_t(row) * width] < wanted) ++row;
    begins.push_back(row);
  }
  begins.push_back(image.camera.height);
  return begins;
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

LayerPicture draw_layers(const LayeredImage& image, const LayerCamera& to,
                         const LayerDrawing& drawing) {
  const Warp warp(image, to);
  const double focal_from = focal_length(image.camera);
  if (drawing.order == LayerOrder::kOcclusion) {
    Canvas canvas(to, drawing, focal_from);
    const Eigen::Vector4d epipole = image.camera.screen_from_world * eye_of(to);
    const auto columns = visiting_order(epipole.x(), epipole.w(), image.camera.width);
    for (const int y : visiting_order(epipole.y(), epipole.w(), image.camera.height)) {
      for (const int x : columns) warp.draw_pixel(x, y, warp.start(x, y), canvas);
    }
    return canvas.finish();
  }
  const int parts = std::clamp(drawing.threads, 1, image.camera.height);
  const std::vector<int> begins = shared_rows(image, parts);
  std::vector<Canvas> canvases(std::size_t(parts), Canvas(to, drawing, focal_from));
  tbb::task_arena arena(parts);
  arena.execute([&] {
    tbb::parallel_for(0, parts, [&](int part) {
      const auto k = std::size_t(part);
      warp.draw_rows(begins[k], begins[k + 1], canvases[k]);
    });
  });
  for (int part = 1; part < parts; ++part) canvases[0].take(canvases[std::size_t(part)]);
  return canvases[0].finish();
}

}  // namespace glassbox::views
