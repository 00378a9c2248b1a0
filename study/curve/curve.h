// Measures error against time for a scene of the user: draws and times it in every variant that
// `glassbox render` offers.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/bench/statistics.h"
#include "study/curve/picture_error.h"
#include "study/curve/render_variants.h"
#include "study/experiment/pareto.h"
#include "study/recommend/pictures.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::study {

struct CurveRequest {
  const Scene* scene = nullptr;    // with the textures' own filters
  int level = 0;                   // the level of `scene`, if it is a built-in scene with levels
  std::map<int, Scene> at_levels;  // the same scene at other levels, for the same view
  ViewOf view;
  VariantRequest variants;
  // True: also combines shading, filter and samples; false: changes only one option (knob) at a
  // time.
  bool combine = true;
  int repetitions = 0;
  // Whether to fill Curve::pictures, which may take up to most_bytes. If not, the pictures are kept
  // as PNG, only to tell them apart.
  bool keep_pictures = true;
  double most_bytes = std::numeric_limits<double>::infinity();
  std::function<void(const std::string&)> phase;  // called with a description of each step
};

struct CurvePoint {
  RenderVariant variant;
  std::size_t picture = 0;  // index of its picture in Curve::pictures
  PictureError error;
  double depth_error = 0;  // see SceneVertices::depth_error
  Quartiles ns;            // per frame
  int disturbed = 0;       // number of disturbed repetitions (see timing.h)
  // How the variant stands in error and time, compared with the other variants that use one thread.
  // None for variants with several threads, whose times are measured by another clock.
  std::optional<Standing> standing;
};

struct Curve {
  Image<Rgba8> reference;
  std::string reference_is;            // how the reference was drawn
  std::size_t different = 0;           // number of different pictures
  std::vector<Image<Rgba8>> pictures;  // every different picture once; empty if not kept
  std::vector<CurvePoint> points;      // the first one is the picture as it was asked for
  std::vector<SkippedKnob> skipped;
  // The largest position error of `vertices` vertices in px, compared with positions computed with
  // 50 digits.
  double position_error = 0;
  std::size_t vertices = 0;
  int repetitions = 0;
  // Names of variants that change only the engine and yet give another picture, which is an error
  // of the program.
  std::vector<std::string> faults;
};

// Returns an error if the view is impossible, if nothing of the scene is visible in it, or if the
// pictures need too much memory.
Result<Curve> measure_curve(const CurveRequest& request);

}  // namespace glassbox::study
