// Measures how well glyphs are found as pictures get worse: each sweep varies one property of the
// pictures in levels, with several pictures of a wall for each level (S1-26, S1-28).
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/renderer.h>

#include "views/glyphs/find_glyphs.h"
#include "views/glyphs/glyph_score.h"
#include "views/glyphs/pose.h"

namespace glassbox::views {

enum class SweepVariable {
  kSize,
  kBlur,
  kOcclusion,
  kTilt,
  kJpeg,
  kBalance,
  kCamera,
  kThreshold,
  kRules
};
std::string_view name_of(SweepVariable what);

struct SweepRow {
  std::string level;  // "20 px"
  GlyphScore score;   // all pictures of the level together
  // The largest pose error with a known lens; nan if a pose was not found.
  double degrees = 0, millimetres = 0;
};

// Two pictures for each level, from a distance of 2 m. The tilt sweep uses a plane wall, the other
// sweeps use the default wall, a corner. Glyphs are about 40 px large, except in the size sweep.
// The rules sweep uses the decoys (decoys.h), with a row for each rule that is switched off.
std::vector<SweepRow> sweep_glyphs(SweepVariable what, const FindSettings& settings,
                                   const std::function<void(const std::string&)>& report_progress);

// A camera `distance` metres in front of the middle of the wall, turned around it by these angles,
// with a vertical angle of view of 40 degrees.
PinholeCamera camera_in_front(double distance, double azimuth_degrees, double elevation_degrees,
                              int width, int height);

// Takes photographs of a wall: unlit, with four samples per pixel, on a grey background. The wall's
// textures are made only once.
class WallPhotographer {
public:
  explicit WallPhotographer(const Wall& wall);
  WallPhotographer(const WallPhotographer&) =
      delete;  // the renderer keeps a reference to the scene
  WallPhotographer& operator=(const WallPhotographer&) = delete;
  Image<Rgba8> photograph(const PinholeCamera& camera, int width, int height);

private:
  Scene scene_;
  RenderSettings settings_;
  Renderer renderer_;
};

}  // namespace glassbox::views
