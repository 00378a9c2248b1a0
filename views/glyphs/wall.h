// Walls covered with glyphs, and which glyph is where (the slides' wallpaper table, S1-25, S1-27).
#pragma once

#include <array>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>

#include "views/glyphs/glyph_code.h"
#include "views/two_view/camera.h"

namespace glassbox::views {

struct WallLayout {
  // 2: a corner of 90 degrees that opens towards +z, with its edge along y; 1: a wall in the plane
  // z = 0.
  int panels = 2;
  int columns = 6, rows = 10;  // of each panel
  // The identity of the first glyph; the following identities are arranged by rows from the top
  // left, panel after panel.
  int first = 0;
  double pitch = 0.12;     // metres from one glyph's centre to the next
  double diameter = 0.09;  // metres
};

// A rectangle: its top left corner, and the unit directions to the right and down. Its front is
// visible; the cross product of `right` and `down` points to its back.
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
  const WallGlyph* find(int identity) const;     // nullptr if it is not on the wall
  std::array<bool, kGlyphs> identities() const;  // which of all glyphs are on the wall
};

// Refused: more glyphs than there are codes, glyphs with less paper between them than an eighth of
// the pitch, numbers that are not finite or out of range.
Result<Wall> make_wall(const WallLayout& layout);

// Refused: pictures without a pixel, with a side longer than 16384 px, or with more than
// kMaxSheetPixels.
inline constexpr double kMaxSheetPixels = 1 << 26;
Result<void> check_panel_picture(const Wall& wall, double pixels_per_metre);

// The picture of a panel on white paper, to be printed: each pixel is the mean of the light at 4 x
// 4 points in it.
Image<Rgba8> draw_panel(const Wall& wall, int panel, double pixels_per_metre);

// The wall as a scene: an unlit rectangle for each panel, with its picture as a texture.
Scene wall_scene(const Wall& wall, double pixels_per_metre);

inline constexpr double kMetresOfInch = 0.0254;

}  // namespace glassbox::views
