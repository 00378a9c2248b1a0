// How stiff a scene is in one view: the condition numbers that decide (numbers.h), each where it is worst, with the bound that
// follows and what to do about it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox::study {

// Where in the scene.
struct StiffPlace {
  std::uint32_t instance = 0, triangle = 0;  // number in the whole scene
  std::optional<std::uint32_t> corner;       // 0 to 2
  std::optional<std::uint32_t> position;     // of the corner: index into Mesh::positions
  int x = -1, y = -1;                        // of fragments: the pixel
};

struct StiffNumber {
  std::string key;       // "far-over-near": stable
  std::string name;      // "far over near"
  double condition = 0;  // may be infinite
  double bound = 0;      // infinite: nothing can be said
  std::string unit;      // of the bound: "px", "of distance", "of range", "of 1/w", "texels"
  std::optional<double>
      pixels;  // the bound as pixels of the picture, where it moves or parts something there
  std::string formula;  // of the bound
  std::string source;   // "SPEC C, generic bound 8; C-10"
  std::optional<StiffPlace> place;
  // Of depth: tests of the picture that exact depths might decide otherwise. A bound that no test depends on does no harm.
  std::optional<std::uint64_t> tests_in_doubt;
  std::string advice;

  // More than a pixel of the picture, or a texel, where it can do harm: an error of that size can be seen.
  bool passes() const {
    if (tests_in_doubt == 0) return false;
    return !(pixels.value_or(unit == "texels" ? bound : 0) <= 1);
  }
};

struct Stiffness {
  std::vector<StiffNumber> numbers;
  std::vector<std::string> left_out;  // one sentence each
};

// `up`: what the view was made with; none where a pose was given. A run of the staged reference, of which nothing is kept: some
// microseconds for each triangle, and half a microsecond for each fragment.
Stiffness stiffness_of(const Scene& scene, const View& view, const RenderSettings& settings,
                       const std::optional<Vector<World, double>>& up);

}  // namespace glassbox::study
