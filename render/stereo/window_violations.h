// Finds window violations: things in front of the stereo window that the edge of a picture cuts off
// (S0-13). The eyes see them nearer than the frame, but the frame occludes them.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/engine/framebuffer.h>

namespace glassbox {

// An instance of the scene that is cut.
struct CutInstance {
  std::uint32_t instance = 0;  // index into Scene::instances
  int rows = 0;                // pixels in the picture's two outermost columns
  double least_px = 0;         // its smallest disparity there
};

// A connected piece of one eye's picture (neighbours share a side). All its pixels are in front of
// the window, and some touch the picture's left or right edge. The bottom and top edges do not
// count: a cut there does not contradict the eyes.
struct WindowViolation {
  Side eye = Side::kLeft;
  bool left_edge = false, right_edge = false;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // its box, x0 <= x < x1
  std::uint64_t pixels = 0;
  int rows = 0;                        // pixels in the picture's two outermost columns
  double least_px = 0;                 // the smallest disparity there
  double nearest = 0;                  // the distance of that point along the gaze, world units
  std::vector<CutInstance> instances;  // those with most rows first; without lines and points
};

struct WindowViolations {
  std::vector<WindowViolation> found;  // those with most rows first
  Image<std::uint8_t> left, right;     // 1 for their pixels
};

struct EyeBuffers {
  const Framebuffer& buffers;     // must include distance and id
  const Image<float>& disparity;  // px, of the same picture
};

// A disparity of less than `limit_px` in front of the window counts as in the window: half a pixel
// is within the sampling error.
WindowViolations window_violations(const Scene& scene, const EyeBuffers& left,
                                   const EyeBuffers& right, double limit_px = 0.5);

}  // namespace glassbox
