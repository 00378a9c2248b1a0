// Finds window violations: things in front of the stereo window that the edge of a picture cuts off
// (S0-13). The eyes see such a thing nearer than the frame, but the frame occludes it.
#pragma once

#include <cstdint>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/engine/framebuffer.h>

namespace glassbox {

// An instance of the scene that an edge of the picture cuts off.
struct CutInstance {
  std::uint32_t instance = 0;  // index into Scene::instances
  int rows = 0;                // its pixels in the picture's two outermost columns
  double least_px = 0;         // the smallest disparity of these pixels
};

// A connected region of one eye's picture (pixels that share a side are connected). All its pixels
// are in front of the window, and some touch the picture's left or right edge. The bottom and top
// edges are left out: a cut there does not contradict what the eyes see.
struct WindowViolation {
  Side eye = Side::kLeft;
  bool left_edge = false, right_edge = false;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // its box, x0 <= x < x1, y0 <= y < y1
  std::uint64_t pixels = 0;
  int rows = 0;                        // its pixels in the picture's two outermost columns
  double least_px = 0;                 // the smallest disparity of these pixels
  double nearest = 0;                  // distance of that point along the gaze, world units
  std::vector<CutInstance> instances;  // instances cut, most rows first; no lines or points
};

struct WindowViolations {
  std::vector<WindowViolation> found;  // the violations, most rows first
  Image<std::uint8_t> left, right;     // by pixel: 1 if it belongs to a violation, otherwise 0
};

struct EyeBuffers {
  const Framebuffer& buffers;     // must include distance and id
  const Image<float>& disparity;  // px, of the same picture
};

// Finds the violations in both eyes' pictures. Pixels that are less than `limit_px` in front of the
// window are ignored: half a pixel is within the sampling error.
WindowViolations window_violations(const Scene& scene, const EyeBuffers& left,
                                   const EyeBuffers& right, double limit_px = 0.5);

}  // namespace glassbox
