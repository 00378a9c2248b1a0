// Walls covered with glyphs: which one is where (the slides' wallpaper table, S1-25, S1-27).
#pragma once

#include <array>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>

#include "views/glyphs/code.h"
#include "views/two_view/camera.h"

namespace glassbox::views {

struct WallLayout {
  int panels =
      2;  // 2: a corner of 90 degrees that opens towards +z, its edge along y; 1: a wall in the plane z = 0
  int columns = 6, rows = 10;  // of each panel
  int first =
      0;  // the identity of the first glyph; then by rows from the top left, panel after panel
  double pitch = 0.12;     // metres from glyph to glyph
  double diameter = 0.09;  // metres
};

// A rectangle: its top left corner, and the directions to the right and down. Seen from its front, which right x down points away from.
struct WallPanel {
  Vector3d corner, right, down;
  double width = 0, height = 0;  // metres
};

struct WallGlyph {
  int identity = 0, panel = 0;
  Vector3d centre;  // metres
};

struct Wall {
  WallLayout layout;
  std::vector<WallPanel> panels;
  std::vector<WallGlyph> glyphs;

  double radius() const { return layout.diameter / 2; }
  const WallGlyph* find(int identity) const;     // nullptr where it is not on the wall
  std::array<bool, kGlyphs> identities() const;  // which of all are on it
};

// Refused: more glyphs than there are codes, glyphs that touch each other (there must be paper of an eighth of the pitch between
// them), numbers that are none.
Result<Wall> make_wall(const WallLayout& layout);

// Refused: pictures without a pixel, of a side that is longer than 16384 px, or of more than kMostSheetPixels.
inline constexpr double kMostSheetPixels = 1 << 26;
Result<void> check_panel_picture(const Wall& wall, double pixels_per_metre);

// A panel on white paper, as it is printed: each pixel the mean light of 4 x 4 points of it.
Image<Rgba8> draw_panel(const Wall& wall, int panel, double pixels_per_metre);

// The wall as a scene: a rectangle for each panel, with its picture as texture, unlit.
Scene wall_scene(const Wall& wall, double pixels_per_metre);

inline constexpr double kMetresOfInch = 0.0254;

}  // namespace glassbox::views
