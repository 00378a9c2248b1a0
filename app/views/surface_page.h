// A surface as one HTML page that needs nothing else: turned, and, where pictures come with it, coloured by those around the eye.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "views/texture/textured_surface.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::app {

struct SurfacePage {
  std::string verb;  // "polygons": of `glassbox views`
  std::string title, summary, text, command;
  const Scene* scene = nullptr;
  std::vector<std::uint8_t> views;  // of each triangle: how many pictures see it
  const views::CalibratedPicture* left_out = nullptr;
  const Image<Rgba8>* drawn = nullptr;  // for its camera
  // Colours that depend on the eye, blended as barycentric weights have it.
  const views::TexturedSurface* textured = nullptr;
  const views::PictureSet* pictures = nullptr;
};

// Refused: more triangles or pixels than a browser likes to open.
Result<std::string> make_surface_page(const SurfacePage& page);

}  // namespace glassbox::app
