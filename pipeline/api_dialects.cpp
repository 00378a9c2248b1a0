#include <glassbox/pipeline/api_dialects.h>

#include <utility>

namespace glassbox {

std::span<const ApiDialect> api_dialects() {
  constexpr DepthRange kStandard = DepthRange::kStandard, kReversed = DepthRange::kReversed;
  static constexpr ApiDialect kDialects[] = {
      {"opengl", "OpenGL", true, kStandard, false, true},
      {"d3d", "Direct3D", false, kStandard, false, false},
      {"vulkan", "Vulkan", false, kStandard, true, false},
      {"metal", "Metal", false, kStandard, false, false},
      {"webgpu", "WebGPU", false, kStandard, false, false},
      {"reversed", "reversed depth", false, kReversed, false, false},
      {"glassbox", "Glassbox", false, kStandard, false, false},
  };
  return kDialects;
}

const ApiDialect* find_dialect(std::string_view name) {
  for (const ApiDialect& dialect : api_dialects()) {
    if (name == dialect.name) return &dialect;
  }
  return nullptr;
}

std::array<ClipPlane, 6> clip_planes(const ApiDialect& dialect) {
  std::array<ClipPlane, 6> planes = frustum_planes(dialect.depth);
  if (dialect.z_from_minus_w) {
    ClipPlane& low = dialect.depth == DepthRange::kStandard ? planes[0] : planes[1];
    const char* name = low.name;
    low = opengl_near_plane();
    low.name = name;
  }
  if (dialect.ndc_y_down) std::swap(planes[4].name, planes[5].name);
  return planes;
}

Viewport window_rectangle(const ApiDialect& dialect, float x, float y, float width, float height) {
  const bool agree = dialect.ndc_y_down != dialect.window_y_up;
  if (agree) return {x, y + height, x + width, y};
  return {x, y, x + width, y + height};
}

}  // namespace glassbox
