// The shaders of the OpenGL peer: what Glassbox computes for the same scene, and nothing else.
#pragma once

#include <string>

namespace glassbox::study {

// Where the attributes of a vertex arrive.
inline constexpr unsigned kPositionAt = 0, kNormalAt = 1, kTexcoordAt = 2, kColorAt = 3;

// What a draw's colours are made of.
struct Ingredients {
  bool lit = false;
  bool textured = false;
  bool colored = false;  // per vertex
};

std::string vertex_shader(const Ingredients& ingredients);
std::string fragment_shader(const Ingredients& ingredients);

}  // namespace glassbox::study
