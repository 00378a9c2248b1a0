// Things in front of the stereo window that the edge of a picture cuts off (S0-13): the eyes see them nearer than the
// frame, which hides them all the same.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/engine/framebuffer.h>

namespace glassbox {

// What of the scene is cut.
struct CutInstance {
  std::uint32_t instance = 0;  // index into Scene::instances
  int rows = 0;                // of the picture's two outermost columns
  double least_px = 0;         // its disparity where it stands out most there
};

// A connected piece (by sides of pixels) of one eye's picture whose pixels all stand out of the window and of which
// some touch the picture's left or right edge. Bottom and top are left out: a cut there does not contradict the eyes.
struct WindowViolation {
  Side eye = Side::kLeft;
  bool left_edge = false, right_edge = false;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // its box, x0 <= x < x1
  std::uint64_t pixels = 0;
  int rows = 0;                        // pixels in the picture's two outermost columns
  double least_px = 0;                 // the disparity there that stands out most
  double nearest = 0;                  // and its distance along the gaze, world units
  std::vector<CutInstance> instances;  // most rows first; without lines and points
};

struct WindowViolations {
  std::vector<WindowViolation> found;  // most rows first
  Image<std::uint8_t> left, right;     // 1 for their pixels
};

struct EyeBuffers {
  const Framebuffer& buffers;     // with distance and id
  const Image<float>& disparity;  // px, of the same picture
};

// Less than `limit_px` in front of the window counts as in it: half a pixel is within the sampling.
WindowViolations window_violations(const Scene& scene, const EyeBuffers& left,
                                   const EyeBuffers& right, double limit_px = 0.5);

}  // namespace glassbox
