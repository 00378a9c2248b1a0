// The condition numbers of a scene in one view (condition_formulas.h): the place where each is
// worst, the error bound that follows from it, and advice.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::study {

// A place in the scene.
struct ScenePlace {
  std::uint32_t instance = 0, triangle = 0;  // triangle: number in the whole scene
  std::optional<std::uint32_t> corner;       // 0 to 2
  std::optional<std::uint32_t> position;     // index of the corner's position in Mesh::positions
  int x = -1, y = -1;                        // the pixel, for fragments
};

struct ConditionNumber {
  std::string key;       // stable, for example "far-over-near"
  std::string name;      // for example "far over near"
  double condition = 0;  // may be infinite
  double bound = 0;      // infinite: no bound exists
  std::string unit;      // unit of the bound: "px", "of distance", "of range", "of 1/w", "texels"
  // The bound in pixels of the picture, if the error moves or separates things in the picture.
  std::optional<double> pixels;
  std::string formula;  // formula of the bound
  std::string source;   // for example "extreme case of slivers (C-47)"
  std::optional<ScenePlace> place;
  // Only for depth: the number of depth tests that exact depths might decide otherwise. If it is 0,
  // the bound does no harm.
  std::optional<std::uint64_t> tests_in_doubt;
  std::string advice;

  // Whether the bound is larger than a pixel of the picture, or than a texel, so that the error may
  // be visible; for depth, false if no depth test is in doubt.
  bool is_above_limit() const {
    if (tests_in_doubt == 0) return false;
    return !(pixels.value_or(unit == "texels" ? bound : 0) <= 1);
  }
};

struct Stiffness {
  std::vector<ConditionNumber> numbers;
  std::vector<std::string> not_computed;  // one sentence each
};

// `up` is the vector with which the view was made; none if the view was given as a pose. Runs the
// staged reference engine without storing anything: it takes some microseconds per triangle and
// half a microsecond per fragment.
Stiffness stiffness_of(const Scene& scene, const View& view, const RenderSettings& settings,
                       const std::optional<Vector<World, double>>& up);

}  // namespace glassbox::study
