// Draws a layered depth image as seen from another place: its samples are warped and splatted
// (S1-07 to S1-11).
#pragma once

#include <cstdint>
#include <memory>

#include <glassbox/raster/lanes/target.h>

#include "views/layers/layered_image.h"

namespace glassbox::views {

enum class LayerOrder {
  kDepth,  // the nearest sample stays: the picture's depths are compared
  // The pixels are visited in an order in which each sample drawn later is nearer, so that no
  // depths are compared (McMillan 1997; S1-11).
  kOcclusion,
};

// The size of the splat of a sample, in pixels of the picture.
enum class Splat {
  kPoint,  // the pixel that it is in
  kThree,  // that pixel and those around it
  // The box around the projection of its own pixel: (F2 / F1) (d1 / d2) wide, and as its surface is
  // tilted (S1-10).
  kProjected,
  // 1, 3, 5 or 7 pixels, chosen by the projected size, with partly transparent rims: with
  // kOcclusion.
  kSoft,
};
// px; larger splats are drawn at this size, and counted (C-86).
inline constexpr float kLargestSplat = 64;

struct LayerDrawing {
  LayerOrder order = LayerOrder::kDepth;
  Splat splat = Splat::kProjected;
  Rgba8 background{};
  // The picture depends on neither the threads nor the target.
  int threads = 1;  // used by kDepth
  Target target = best_target();
};

struct WarpCounts {
  std::size_t drawn = 0;   // samples that were drawn, including those that nearer ones hide
  std::size_t behind = 0;  // not in front of the eye (C-83)
  // Outside the picture, nearer than the near plane, or beyond a parallel view's far plane.
  std::size_t outside = 0;
  std::size_t oversized = 0;  // in front of the eye, and larger than kLargestSplat
  friend bool operator==(const WarpCounts&, const WarpCounts&) = default;
};

struct LayerPicture {
  Image<Rgba8> color;
  Image<float> depth;  // in the unit of layer_camera.h; 0: a hole
  WarpCounts counts;
};

// Draws one layered image many times: prepares once what all pictures of it need, and reuses the
// memory.
class LayerDrawer {
public:
  // The image must outlive the drawer, and must have passed check().
  explicit LayerDrawer(const LayeredImage& image);
  ~LayerDrawer();
  LayerDrawer(const LayerDrawer&) = delete;
  LayerDrawer& operator=(const LayerDrawer&) = delete;

  // Where two samples have the same depth at a pixel, kDepth keeps the one whose colour is the
  // greater number (warp_kernels.h), so that the picture does not depend on the order of the
  // samples.
  void draw(const LayerCamera& to, const LayerDrawing& drawing, LayerPicture& into);

private:
  struct State;
  std::unique_ptr<State> state_;
};

// The number of threads that draw: as many as are requested, unless there is less work to share, or
// their canvases, of 8 bytes for each pixel, would be larger than this together. (One thread always
// gets its own canvas.)
inline constexpr std::size_t kMostCanvasBytes = std::size_t(1) << 30;
int threads_that_draw(const LayerCamera& from, const LayerCamera& to, const LayerDrawing& drawing);

// Draws one picture, without a LayerDrawer that is kept.
LayerPicture draw_layers(const LayeredImage& image, const LayerCamera& to,
                         const LayerDrawing& drawing);

// Columns (or rows) 0 .. count - 1 in the order of kOcclusion. The epipole is where the other eye
// appears in the picture. The order is towards the epipole if the other eye is in front of the
// camera, and away from it if behind (S1-11). `epipole` and w are its homogeneous coordinate along
// the axis, in pixels.
std::vector<int> visiting_order(double epipole, double w, int count);

}  // namespace glassbox::views
