// A surface as one HTML page that needs no other file. The reader can turn it; if there are
// pictures, it is coloured by the pictures nearest to the eye's direction.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "views/texture/textured_surface.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::views {

struct SurfacePage {
  std::string verb;  // the subcommand of `glassbox views`, such as "polygons"
  std::string title, summary, text, command;
  const Scene* scene = nullptr;
  std::vector<std::uint8_t> views;  // for each triangle: how many pictures see it
  const views::CalibratedPicture* left_out = nullptr;
  const Image<Rgba8>* drawn = nullptr;  // drawn for the left-out picture's camera
  // Colours that depend on the eye's position, blended by barycentric weights.
  const views::TexturedSurface* textured = nullptr;
  const views::PictureSet* pictures = nullptr;
};

// An error if there are too many triangles or pixels for a browser.
Result<std::string> make_surface_page(const SurfacePage& page);

}  // namespace glassbox::views
