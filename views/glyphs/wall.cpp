#include "views/glyphs/wall.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <glassbox/base/elementary.h>
#include <glassbox/images/srgb.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox::views {

namespace {

constexpr double kRootHalf = 0.70710678118654752440;

std::vector<WallPanel> panels_of(const WallLayout& layout) {
  const double width = layout.columns * layout.pitch, height = layout.rows * layout.pitch;
  const Vector3d down = -Vector3d::UnitY(), top(0, height / 2, 0);
  if (layout.panels == 1)
    return {{top - Vector3d(width / 2, 0, 0), Vector3d::UnitX(), down, width, height}};
  const Vector3d left(kRootHalf, 0, -kRootHalf), right(kRootHalf, 0, kRootHalf);
  return {{top - width * left, left, down, width, height}, {top, right, down, width, height}};
}

// The light at a point of a panel; x and y in metres from its corner.
Eigen::Vector3f light_at(const Wall& wall, int panel, double x, double y) {
  const WallLayout& layout = wall.layout;
  const int column = int(std::floor(x / layout.pitch)), row = int(std::floor(y / layout.pitch));
  const Eigen::Vector3f paper(1, 1, 1);
  if (column < 0 || column >= layout.columns || row < 0 || row >= layout.rows) return paper;
  const int at = (panel * layout.rows + row) * layout.columns + column;
  if (at >= int(wall.glyphs.size())) return paper;
  const double radius =
      hypotenuse(x - (column + 0.5) * layout.pitch, y - (row + 0.5) * layout.pitch);
  const GlyphCode code = code_of(wall.glyphs[std::size_t(at)].identity);
  for (std::size_t band = 0; band < 3; ++band) {
    if (radius >= kDiscRadii[band] * wall.radius()) continue;
    const Rgba8& color = kPrototypeColors[std::size_t(code[band])];
    return {decode_srgb(color.r), decode_srgb(color.g), decode_srgb(color.b)};
  }
  return paper;
}

// Whether no border of a disc is within `reach` of a point. Only the disc of the point's own cell
// is tested, because there is paper between the discs of different cells.
bool is_plain(const Wall& wall, double x, double y, double reach) {
  const double pitch = wall.layout.pitch;
  const double radius = hypotenuse(x - (std::floor(x / pitch) + 0.5) * pitch,
                                   y - (std::floor(y / pitch) + 0.5) * pitch);
  for (const double share : kDiscRadii) {
    if (std::abs(radius - share * wall.radius()) <= reach) return false;
  }
  return true;
}

int side_px(double metres, double pixels_per_metre) {
  return int(std::lround(metres * pixels_per_metre));
}

}  // namespace

const WallGlyph* Wall::find(int identity) const {
  const int at = identity - layout.first;
  return at >= 0 && at < int(glyphs.size()) ? &glyphs[std::size_t(at)] : nullptr;
}

std::array<bool, kGlyphs> Wall::identities() const {
  std::array<bool, kGlyphs> all{};
  for (const WallGlyph& glyph : glyphs) all[std::size_t(glyph.identity)] = true;
  return all;
}

Result<Wall> make_wall(const WallLayout& layout) {
  if (layout.panels != 1 && layout.panels != 2)
    return fail("--panels", "a wall has 1 or 2 panels", "give 1 or 2");
  if (layout.columns < 1 || layout.rows < 1 || layout.columns > kGlyphs || layout.rows > kGlyphs)
    return fail("--grid", fmt::format("a panel has 1 to {} columns and rows", kGlyphs),
                "give 6x10");
  const int glyphs = layout.panels * layout.columns * layout.rows;
  if (layout.first < 0 || layout.first > kGlyphs - glyphs) {
    return fail(
        "--grid",
        fmt::format("the wall needs {} glyphs from number {} on, but there are only {} codes",
                    glyphs, layout.first, kGlyphs),
        "ask for fewer glyphs, or a smaller --first");
  }
  for (const auto& [option, size] :
       {std::pair{"--pitch", layout.pitch}, {"--diameter", layout.diameter}}) {
    if (!(size > 0 && size <= 100))
      return fail(option, "a size must be more than 0 and at most 100 m",
                  "give the size in millimetres");
  }
  if (!(layout.diameter <= 0.875 * layout.pitch)) {
    return fail("--diameter", "the gap between glyphs must be at least an eighth of the pitch",
                fmt::format("give at most {:.6g} mm", 875 * layout.pitch));
  }
  Wall wall{layout, panels_of(layout), {}};
  for (int panel = 0; panel < layout.panels; ++panel) {
    const WallPanel& rectangle = wall.panels[std::size_t(panel)];
    for (int row = 0; row < layout.rows; ++row) {
      for (int column = 0; column < layout.columns; ++column) {
        const Vector3d centre = rectangle.corner + (column + 0.5) * layout.pitch * rectangle.right +
                                (row + 0.5) * layout.pitch * rectangle.down;
        wall.glyphs.push_back({layout.first + int(wall.glyphs.size()), panel, centre});
      }
    }
  }
  return wall;
}

Result<void> check_panel_picture(const Wall& wall, double pixels_per_metre) {
  const WallPanel& panel = wall.panels.front();
  const double width = panel.width * pixels_per_metre, height = panel.height * pixels_per_metre;
  constexpr double kMaxSide = 16384;
  if (!(width >= 1 && height >= 1))
    return fail("--dpi", "the picture of a panel would have no pixel", "ask for more pixels");
  if (width <= kMaxSide && height <= kMaxSide && width * height <= kMaxSheetPixels) return {};
  return fail("--dpi",
              fmt::format("the picture of a panel would have {:.0f} x {:.0f} px", width, height),
              "ask for fewer pixels per inch, or smaller glyphs (--pitch, --diameter)");
}

Image<Rgba8> draw_panel(const Wall& wall, int panel, double pixels_per_metre) {
  const WallPanel& rectangle = wall.panels[std::size_t(panel)];
  Image<Rgba8> image(side_px(rectangle.width, pixels_per_metre),
                     side_px(rectangle.height, pixels_per_metre));
  constexpr int kPoints = 4;
  const double step_x = rectangle.width / image.width, step_y = rectangle.height / image.height;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double middle_x = (x + 0.5) * step_x, middle_y = (y + 0.5) * step_y;
      if (is_plain(wall, middle_x, middle_y, step_x + step_y)) {
        const Eigen::Vector3f light = light_at(wall, panel, middle_x, middle_y);
        image.at(x, y) = {encode_srgb(light.x()), encode_srgb(light.y()), encode_srgb(light.z()),
                          255};
        continue;
      }
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (int i = 0; i < kPoints * kPoints; ++i) {
        const double across = x + (i % kPoints + 0.5) / kPoints,
                     down = y + (i / kPoints + 0.5) / kPoints;
        sum += light_at(wall, panel, across * step_x, down * step_y);
      }
      const Eigen::Vector3f mean = sum / float(kPoints * kPoints);
      image.at(x, y) = {encode_srgb(mean.x()), encode_srgb(mean.y()), encode_srgb(mean.z()), 255};
    }
  }
  return image;
}

Scene wall_scene(const Wall& wall, double pixels_per_metre) {
  Scene scene;
  scene.name = "glyph wall";
  for (int p = 0; p < wall.layout.panels; ++p) {
    const WallPanel& panel = wall.panels[std::size_t(p)];
    const std::uint32_t material =
        add_material(scene, fmt::format("paper {}", p + 1), {1, 1, 1, 1});
    scene.materials[material].unlit = true;
    const std::uint32_t texture = add_texture(scene, draw_panel(wall, p, pixels_per_metre));
    scene.textures[texture].sampler.wrap_u = scene.textures[texture].sampler.wrap_v =
        Wrap::kClampToEdge;
    scene.materials[material].texture = texture;
    Mesh mesh;
    mesh.name = fmt::format("panel {}", p + 1);
    mesh.material = material;
    const auto numbers = [](const Vector3d& v) { return std::array{v.x(), v.y(), v.z()}; };
    add_rectangle(mesh, numbers(panel.corner + panel.height * panel.down),
                  numbers(panel.width * panel.right), numbers(-panel.height * panel.down));
    add_object(scene, std::move(mesh));
  }
  const double height = wall.panels.front().height;
  add_perspective(scene, "before the wall", 40, 0.01,
                  look_at_pose({0.2 * height, 0.1 * height, 1.9 * height}, {0, 0, 0}));
  return scene;
}

}  // namespace glassbox::views
