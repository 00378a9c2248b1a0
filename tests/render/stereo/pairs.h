// Scenes with a pair of eyes.
#pragma once

#include <string>
#include <vector>

#include <glassbox/mesh/bounding_box.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>

#include "tests/support/catch.h"

namespace glassbox {

struct PairCase {
  std::string name;
  Scene scene;
  View centre;
  StereoPair pair;
  int width = 96, height = 64;
};

// A built-in scene seen by its own camera, or framed. The window is at the distance of the scene's
// centre or, if that is not between near and far, at ten times the near distance; half the
// separation is `share` of it.
inline PairCase pair_case(const std::string& name, double share, int width = 96, int height = 64) {
  PairCase c{name, {}, {}, {}, width, height};
  const auto scene = make_builtin(name);
  REQUIRE(scene);
  c.scene = *scene;
  const auto framed = framing_camera(c.scene, double(width) / height);
  REQUIRE(framed);
  const auto view =
      make_view(c.scene.cameras.empty() ? *framed : c.scene.cameras.front(), width, height);
  REQUIRE(view);
  c.centre = *view;
  const double z = -(c.centre.eye_from_world * bounds(c.scene).center()).z;
  c.pair.window = z > c.centre.near && z < c.centre.far ? z : 10 * c.centre.near;
  c.pair.half_separation = share * c.pair.window;
  REQUIRE(check_pair(c.centre, c.pair));
  return c;
}

inline std::vector<PairCase> pair_cases() {
  std::vector<PairCase> all;
  for (const BuiltinScene& builtin : builtin_scenes()) {
    all.push_back(pair_case(std::string(builtin.name), 0.03));
  }
  return all;
}

}  // namespace glassbox
