// What is seen through a point of the screen, worked out along the line of sight in extended precision: no matrix, no
// clipping, no divide, no snap and no interpolation, so that it shares nothing with what draws.
//
// Vertices are drawn where they are snapped to and screen coordinates are floats, so the right answer belongs to a picture
// whose edges may be moved by some 2^-7 px (C-40 has the sum). A pixel is judged where its centre and eight points 2^-7 px
// around it see the same.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "study/extremes/kit/drawer.h"
#include "study/extremes/kit/outcome.h"
#include "study/extremes/kit/vista.h"

namespace glassbox::study {

// Through a point, in pixels.
struct Sight {
  int layers = 0;   // surfaces that are hit, those that are culled apart
  int nearest = 0;  // 1 + the number of the first; 0: none
  std::array<int, 2> texel{};
  int stripes = 0;         // of the three kinds, how many the level has lost
  bool told_apart = true;  // the nearest from the next
  friend bool operator==(const Sight&, const Sight&) = default;
};
// `candidates`: numbers of the triangles that may be hit, ascending.
Sight sight_at(const Vista& vista, std::span<const std::size_t> candidates, double x, double y);

// A vista and what is seen of it, worked out once for all drawers.
class SightDrawn {
public:
  explicit SightDrawn(Vista vista);
  // Pixels that show another triangle or texel, with and without numbers of triangles, and those that are covered by another number of layers. Infinite where fewer
  // than half of the pixels can be judged.
  Outcome judge(const Drawer& drawer) const;

  const Vista& vista() const { return vista_; }
  // Of a pixel, by rows; none where it is not to be judged.
  std::optional<Sight> sight(std::size_t pixel) const;

private:
  bool shows_face(const Sight& sight, const Rgba8& color) const;

  Vista vista_;
  Scene numbered_;  // where no texels tell triangles apart: with a colour for each face of a mesh
  std::vector<std::uint32_t> faces_;  // by triangle
  // Of a pixel; none: not to be judged.
  struct Pixel {
    std::optional<Sight> sight;
    std::optional<int> layers;  // known beside an edge that two triangles share, too
  };
  std::vector<Pixel> pixels_;  // by rows
};

// The worst of several pictures.
Outcome worst_of(const std::vector<SightDrawn>& pictures, const Drawer& drawer);

}  // namespace glassbox::study
