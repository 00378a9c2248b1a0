// Draws a layered depth image as seen from another place: its samples are warped and splatted
// (S1-07 to S1-11).
#pragma once

#include <cstdint>
#include <memory>

#include <glassbox/raster/lanes/target.h>

#include "views/layers/layered_image.h"

namespace glassbox::views {

enum class LayerOrder {
  kDepth,  // depths are compared: at each pixel of the picture, the nearest sample stays
  // The samples are drawn in an order in which, at each pixel of the picture, a later one is
  // nearer, so that no depths are compared (McMillan 1997; S1-11).
  kOcclusion,
};

// The size of the splat of a sample, in pixels of the picture.
enum class Splat {
  kPoint,  // only the pixel that the sample is in
  kThree,  // the pixel that the sample is in and the eight around it
  // The box around the projection of the pixel that the sample comes from. It is (F2 / F1) (d1 /
  // d2) pixels wide, with the focal length F and the distance d in the old (1) and the new picture
  // (2), and also depends on how the surface is tilted (S1-10).
  kProjected,
  // 1, 3, 5 or 7 pixels wide, chosen by the projected size, with partly transparent rims. It needs
  // kOcclusion, because the result of blending depends on the order.
  kSoft,
};
// px; larger splats are drawn at this size, and counted (C-86).
inline constexpr float kLargestSplat = 64;

struct LayerDrawing {
  LayerOrder order = LayerOrder::kDepth;
  Splat splat = Splat::kProjected;
  Rgba8 background{};
  // The picture depends neither on the number of threads nor on the instruction set (target).
  int threads = 1;  // used by kDepth only
  Target target = best_target();
};

struct WarpCounts {
  std::size_t drawn = 0;   // samples that were drawn, including those that nearer ones hide
  std::size_t behind = 0;  // samples that are not in front of the eye (C-83)
  // Samples outside the picture, nearer than the near plane, or beyond a parallel view's far plane.
  std::size_t outside = 0;
  // Samples in front of the eye whose splat is larger than kLargestSplat.
  std::size_t oversized = 0;
  friend bool operator==(const WarpCounts&, const WarpCounts&) = default;
};

struct LayerPicture {
  Image<Rgba8> color;
  Image<float> depth;  // as in layer_camera.h: greater in front; 0 for a hole
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

// threads_that_draw() returns how many threads draw: as many as are requested, but fewer if there
// is less work, or if their canvases, of 8 bytes for each pixel, would together be larger than
// kMaxCanvasBytes. (A single thread always gets its canvas.) kOcclusion uses one thread.
inline constexpr std::size_t kMaxCanvasBytes = std::size_t(1) << 30;
int threads_that_draw(const LayerCamera& from, const LayerCamera& to, const LayerDrawing& drawing);

// Draws a single picture; to draw several pictures of one image, keep a LayerDrawer.
LayerPicture draw_layers(const LayeredImage& image, const LayerCamera& to,
                         const LayerDrawing& drawing);

// Columns (or rows) 0 .. count - 1 in the order of kOcclusion. The epipole is the point of the
// picture where the other eye appears. The order is towards the epipole if the other eye is in
// front of the camera, and away from it if it is behind (S1-11). The epipole's coordinate along the
// axis is `epipole` / w, in pixels.
std::vector<int> visiting_order(double epipole, double w, int count);

}  // namespace glassbox::views
