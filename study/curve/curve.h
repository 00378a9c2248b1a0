// Error against time for one's own scene: every way that `glassbox render` has to draw it, each measured.
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
#include "study/curve/ways.h"
#include "study/experiment/pareto.h"
#include "study/recommend/pictures.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::study {

struct CurveRequest {
  const Scene* scene = nullptr;    // its textures as written
  int level = 0;                   // of that, where it is a built-in scene that has levels
  std::map<int, Scene> at_levels;  // the same at others, seen by the same view
  ViewOf view;
  WaysAsked ways;
  bool combine = true;  // shading, filter and samples; else each knob is turned alone
  int repetitions = 0;
  // Curve::pictures are wanted, and may take that much; otherwise pictures are kept packed, to be told apart.
  bool keep_pictures = true;
  double most_bytes = std::numeric_limits<double>::infinity();
  std::function<void(const std::string&)> phase;  // told what is being done
};

struct CurvePoint {
  Way way;
  std::size_t picture = 0;  // which of the different ones: an index into Curve::pictures
  PictureError error;
  double depth_error = 0;  // as SceneVertices::depth_error
  Quartiles ns;            // of a frame
  int disturbed = 0;       // of the repetitions (timing.h)
  // Among those with one thread; none for more, whose times are of another clock.
  std::optional<Standing> standing;
};

struct Curve {
  Image<Rgba8> reference;
  std::string reference_is;            // how it was drawn
  std::size_t different = 0;           // pictures
  std::vector<Image<Rgba8>> pictures;  // each once; none where they are not kept
  std::vector<CurvePoint> points;      // as asked first
  std::vector<NotTurned> left_out;
  double position_error =
      0;  // px: the largest on the screen, of `vertices` vertices, against 50 digits
  std::size_t vertices = 0;
  int repetitions = 0;
  // Ways that only the engine knows of, and whose picture has other bytes: faults of the program.
  std::vector<std::string> faults;
};

// An error where the view cannot be had, nothing of the scene is in it, or the pictures would not fit.
Result<Curve> measure_curve(const CurveRequest& request);

}  // namespace glassbox::study
