// What the graphics interfaces take for granted: which clip coordinates are visible, and where they come out in the window.
// Which way the eye looks is not among them: that is a matter of the view and projection matrices (SPEC 0.2).
#pragma once

#include <array>
#include <span>
#include <string_view>

#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

struct ApiDialect {
  const char* name = "";        // as an option's value: "opengl"
  const char* title = "";       // as a person writes it: "OpenGL"
  bool z_from_minus_w = false;  // visible: -w <= z <= w; otherwise 0 <= z <= w
  DepthRange depth = DepthRange::kStandard;
  bool ndc_y_down = false;   // y = -1 of NDC is the top of the picture
  bool window_y_up = false;  // window coordinates count from the lower left corner
};

// OpenGL, Direct3D, Vulkan, Metal, WebGPU, reversed depth (in Direct3D's window), and Glassbox itself.
std::span<const ApiDialect> api_dialects();
const ApiDialect* find_dialect(std::string_view name);  // nullptr: there is none

// near, far, left, right, bottom, top. With y down, "bottom" and "top" are those of the picture.
std::array<ClipPlane, 6> clip_planes(const ApiDialect& dialect);

// The window's rectangle as the dialect counts it, made ready for to_screen: y grows downwards there, so a dialect whose
// window and NDC agree about y has top and bottom exchanged.
Viewport window_rectangle(const ApiDialect& dialect, float x, float y, float width, float height);

// The depth of NDC as the depth buffer holds it, in [0, 1].
inline double window_depth(const ApiDialect& dialect, double ndc_z) {
  return dialect.z_from_minus_w ? (ndc_z + 1) / 2 : ndc_z;
}

}  // namespace glassbox
