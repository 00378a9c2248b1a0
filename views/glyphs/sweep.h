// How well glyphs are found as pictures get worse: a number of pictures of a wall for each level of one thing (SPEC S1-26, S1-28).
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/renderer.h>

#include "views/glyphs/evaluate.h"
#include "views/glyphs/find.h"
#include "views/glyphs/pose.h"

namespace glassbox::views {

enum class SweepOf {
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
std::string_view name_of(SweepOf what);

struct SweepRow {
  std::string level;  // "20 px"
  GlyphScore score;   // all pictures together
  double degrees = 0,
         millimetres =
             0;  // the largest pose error, the lens being known; nan where no pose was found
};

// Two pictures a level from 2 m, of tilt of a plane wall, else of the default one; glyphs some 40 px large, but of size. Of rules the decoys
// (decoys.h), a row for each rule that is not asked.
std::vector<SweepRow> sweep_glyphs(SweepOf what, const FindSettings& settings,
                                   const std::function<void(const std::string&)>& tell);

// A camera `distance` metres before the middle of the wall, turned around it by these degrees, with a vertical angle of 40 degrees.
PinholeCamera camera_before(double distance, double azimuth_degrees, double elevation_degrees,
                            int width, int height);

// Photographs of a wall, which is drawn once: unlit, four samples a pixel, on grey.
class Studio {
public:
  explicit Studio(const Wall& wall);
  Studio(const Studio&) = delete;  // what draws keeps a reference to the scene
  Studio& operator=(const Studio&) = delete;
  Image<Rgba8> photograph(const PinholeCamera& camera, int width, int height);

private:
  Scene scene_;
  RenderSettings settings_;
  Renderer renderer_;
};

}  // namespace glassbox::views
