// The description of a scene that the OpenGL peer gets: one draw for each instance, in the same
// order as in the engines.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <glassbox/render/engine/draw_list.h>

#include "study/bench/mesa/shaders.h"
#include "study/scenes/scenes.h"

namespace glassbox::study {

enum class CulledFaces { kNone, kBack, kFront, kAll };

struct PeerDraw {
  const Material* material = nullptr;
  std::uint32_t mesh = 0;  // index into Scene::meshes
  // Indices into Scene::textures; kNone: no texture.
  std::uint32_t texture = kNone, emission_texture = kNone;
  std::array<float, 3> emission{};
  CulledFaces culled_faces = CulledFaces::kNone;  // the faces that are culled
  bool mirrored = false;
  glm::mat4 clip_from_object{1};  // upside down, depth from -1 to 1
  glm::mat4 eye_from_object{1};
  glm::mat3 eye_normal_from_object{1};
};

// Lists the draws of a view. Positions are relative to the mesh's anchor (a point near its
// vertices), as in the engines.
std::vector<PeerDraw> peer_draws(const BenchScene& bench, const DrawList& list, const View& view);

Ingredients ingredients_of(const BenchScene& bench, const PeerDraw& draw, const Lighting& lighting);

}  // namespace glassbox::study
