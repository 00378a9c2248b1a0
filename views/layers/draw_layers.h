// A layered depth image looked at from another place: its samples warped and splatted (S1-07 to S1-11).
#pragma once

#include <cstdint>
#include <memory>

#include <glassbox/raster/lanes/target.h>

#include "views/layers/layered_image.h"

namespace glassbox::views {

enum class LayerOrder {
  kDepth,      // what is nearer stays: the depths of the picture are compared
  kOcclusion,  // pixels in an order in which what is drawn later is nearer, and nothing is compared (McMillan 1997; S1-11)
};

// How large a sample is drawn, in pixels of the picture.
enum class Splat {
  kPoint,      // the pixel that it is in
  kThree,      // and those around it
  kProjected,  // the box around what its own pixel is from there: (F2 / F1) (d1 / d2) wide, and as its surface is tilted (S1-10)
  kSoft,  // 1, 3, 5 or 7 pixels, which of them l says, the outer ones seen through: with kOcclusion
};
inline constexpr float kLargestSplat =
    64;  // px; larger ones are drawn so large, and counted (C-86)

struct LayerDrawing {
  LayerOrder order = LayerOrder::kDepth;
  Splat splat = Splat::kProjected;
  Rgba8 background{};
  // The picture depends on neither.
  int threads = 1;  // of kDepth
  Target target = best_target();
};

struct WarpCounts {
  std::size_t drawn = 0;   // samples of which a pixel was asked
  std::size_t behind = 0;  // not before the eye (C-83)
  std::size_t beside =
      0;  // outside the picture, nearer than the near plane or beyond a parallel view's far plane
  std::size_t cut = 0;  // before the eye, and larger than kLargestSplat
  friend bool operator==(const WarpCounts&, const WarpCounts&) = default;
};

struct LayerPicture {
  Image<Rgba8> color;
  Image<float> depth;  // of layer_camera.h; 0: a hole
  WarpCounts counts;
};

// Draws one layered image again and again: what all pictures of it need is made once, and memory is used again.
class LayerDrawer {
public:
  explicit LayerDrawer(const LayeredImage& image);  // which must outlive it, and counts as checked
  ~LayerDrawer();
  LayerDrawer(const LayerDrawer&) = delete;
  LayerDrawer& operator=(const LayerDrawer&) = delete;

  // Where two samples have one depth at a pixel, kDepth keeps the one whose colour is the greater number (warp_kernels.h), so
  // that nothing depends on the order of the samples.
  void draw(const LayerCamera& to, const LayerDrawing& drawing, LayerPicture& into);

private:
  struct State;
  std::unique_ptr<State> state_;
};

// As many as are asked for, unless there is less to share out, or their canvases, of 8 bytes for each pixel, would be larger than this
// together. (One thread always gets its own.)
inline constexpr std::size_t kMostCanvasBytes = std::size_t(1) << 30;
int threads_that_draw(const LayerCamera& from, const LayerCamera& to, const LayerDrawing& drawing);

// One picture, with everything made for it alone.
LayerPicture draw_layers(const LayeredImage& image, const LayerCamera& to,
                         const LayerDrawing& drawing);

// Columns (or rows) 0 .. count - 1 in the order of kOcclusion: towards the epipole, where the other eye is seen in the picture, if it lies
// before the camera, and away from it if behind (S1-11). `epipole` and w: its homogeneous coordinate along the axis, in pixels.
std::vector<int> visiting_order(double epipole, double w, int count);

}  // namespace glassbox::views
