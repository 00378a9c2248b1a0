// The conventions that differ between graphics interfaces: which clip coordinates are visible, and
// where they appear in the window. The direction in which the eye looks is not one of these
// conventions: it depends on the view and projection matrices only.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/pipeline/viewport.h>

namespace glassbox {

struct ApiDialect {
  const char* name = "";        // the value of a command line option: "opengl"
  const char* title = "";       // the name as people write it: "OpenGL"
  bool z_from_minus_w = false;  // visible: -w <= z <= w; if false, 0 <= z <= w
  DepthRange depth = DepthRange::kStandard;
  bool ndc_y_down = false;   // y = -1 of NDC is the top of the picture
  bool window_y_up = false;  // window coordinates count from the lower left corner
};

// All dialects: OpenGL, Direct3D, Vulkan, Metal, WebGPU, reversed depth (with Direct3D's window),
// and Glassbox itself.
std::span<const ApiDialect> api_dialects();
const ApiDialect* find_dialect(std::string_view name);  // nullptr: there is no dialect of that name

// The planes near, far, left, right, bottom, top, in this order. Their names "bottom" and "top"
// mean the bottom and top of the picture, also if y of NDC points down.
std::array<ClipPlane, 6> clip_planes(const ApiDialect& dialect);

// The window's rectangle as to_screen needs it: to_screen maps y = -1 of NDC to `bottom` and y = 1
// to `top`. So top and bottom are exchanged for a dialect whose window and NDC have y in the same
// direction.
Viewport window_rectangle(const ApiDialect& dialect, float x, float y, float width, float height);

// The depth that the depth buffer stores for an NDC depth, in [0, 1].
inline double window_depth(const ApiDialect& dialect, double ndc_z) {
  return dialect.z_from_minus_w ? (ndc_z + 1) / 2 : ndc_z;
}

}  // namespace glassbox
