#include "app/views/surface_page.h"

#include <algorithm>
#include <bit>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report/picture_uri.h"
#include "viewssurface_page.h"  // made by html/embed.cmake

#include <glassbox/html/blob.h>

namespace glassbox::app {

namespace {

using SurfaceJson = nlohmann::ordered_json;

void add_float(std::vector<std::uint8_t>& bytes, float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int k = 0; k < 4; ++k) bytes.push_back(std::uint8_t(bits >> (8 * k) & 255));
}

// Nine floats for each triangle, and a byte for each channel of its colour: the mean of its corners'. All 0 for numbers that no triangle has.
struct SurfaceBytes {
  std::vector<std::uint8_t> places, colors;
};

Result<SurfaceBytes> surface_bytes(const Scene& scene) {
  SurfaceBytes bytes;
  const auto fill_up_to = [&](std::size_t number) {
    bytes.places.resize(36 * number, 0);
    bytes.colors.resize(3 * number, 0);
  };
  for (const views::PlacedTriangle& triangle : views::placed_triangles(scene)) {
    fill_up_to(triangle.number);
    for (const views::Vector3d& corner : triangle.corners) {
      for (int axis = 0; axis < 3; ++axis) add_float(bytes.places, float(corner[axis]));
    }
    for (const std::uint8_t channel : triangle.color) bytes.colors.push_back(channel);
  }
  fill_up_to(views::numbers_of(scene));
  constexpr std::size_t kMostTriangles = 400000;
  if (bytes.colors.size() / 3 > kMostTriangles) {
    return fail("--html",
                fmt::format("a page of {} triangles would be too large for a browser",
                            bytes.colors.size() / 3),
                fmt::format("take a surface of at most {}", kMostTriangles));
  }
  return bytes;
}

SurfaceJson numbers_of(const views::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

// K [R | -R c]: the pixel of a point of the world.
SurfaceJson projection_json(const views::PinholeCamera& camera) {
  const views::Matrix3d left = camera.intrinsic * camera.camera_from_world;
  const views::Vector3d right = -left * camera.centre;
  SurfaceJson rows = SurfaceJson::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) rows.push_back(left(row, column));
    rows.push_back(right[row]);
  }
  return rows;
}

// Pictures with what is background transparent, and the triangles of their directions.
Result<SurfaceJson> textures_json(const SurfacePage& page) {
  SurfaceJson json{{"views", SurfaceJson::array()},
                   {"triangles", SurfaceJson::array()},
                   {"border", SurfaceJson::array()}};
  std::size_t pixels = 0;
  for (const views::CalibratedPicture& picture : page.pictures->pictures)
    pixels += picture.color.pixels.size();
  constexpr std::size_t kMostPixels = std::size_t(1) << 24;
  if (pixels > kMostPixels)
    return fail("--html",
                fmt::format("a page of {} pixels would be too large for a browser", pixels),
                "take fewer or smaller pictures");
  for (const views::CalibratedPicture& picture : page.pictures->pictures) {
    Image<Rgba8> shown = picture.color;
    for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
      const bool is_object = picture.matte.pixels.empty() || picture.matte.pixels[i] != 0;
      shown.pixels[i].a = is_object ? 255 : 0;
    }
    const auto uri = picture_uri(shown);
    if (!uri) return tl::unexpected(uri.error());
    const views::Vector3d direction =
        (picture.camera.centre - page.textured->middle()).normalized();
    json["views"].push_back({{"name", picture.name},
                             {"uri", *uri},
                             {"direction", numbers_of(direction)},
                             {"pixel_from_world", projection_json(picture.camera)}});
  }
  for (const auto& triangle : page.textured->blend().sphere().triangles())
    json["triangles"].push_back(triangle);
  for (const auto& edge : page.textured->blend().sphere().border()) json["border"].push_back(edge);
  json["middle"] = numbers_of(page.textured->middle());
  return json;
}

// A bit for each view and triangle: it sees it.
std::vector<std::uint8_t> seen_bytes(const SurfacePage& page, std::size_t triangles) {
  const std::size_t views = page.pictures->pictures.size();
  std::vector<std::uint8_t> bytes((views * triangles + 7) / 8, 0);
  for (std::size_t view = 0; view < views; ++view) {
    for (std::size_t i = 0; i < triangles; ++i) {
      const std::size_t bit = view * triangles + i;
      if (page.textured->seen().sees(view, std::uint32_t(i)))
        bytes[bit / 8] = std::uint8_t(bytes[bit / 8] | 1u << (bit % 8));
    }
  }
  return bytes;
}

}  // namespace

Result<std::string> make_surface_page(const SurfacePage& page) {
  const auto surface = surface_bytes(*page.scene);
  if (!surface) return tl::unexpected(surface.error());
  SurfaceJson manifest{{"verb", page.verb},
                       {"title", page.title},
                       {"summary", page.summary},
                       {"text", page.text},
                       {"program", "glassbox " GLASSBOX_VERSION},
                       {"command", page.command}};
  if (page.left_out != nullptr) {
    const auto picture = picture_uri(page.left_out->color), drawn = picture_uri(*page.drawn);
    if (!picture) return tl::unexpected(picture.error());
    if (!drawn) return tl::unexpected(drawn.error());
    manifest["flicker"] = {{"name", page.left_out->name}, {"picture", *picture}, {"drawn", *drawn}};
  }
  std::string blocks;
  std::vector<std::uint8_t> seen;
  if (page.textured != nullptr) {
    const auto textures = textures_json(page);
    if (!textures) return tl::unexpected(textures.error());
    manifest["textures"] = *textures;
    seen = seen_bytes(page, surface->colors.size() / 3);
  }
  const std::pair<const char*, const std::vector<std::uint8_t>*> all[] = {
      {"places", &surface->places},
      {"colors", &surface->colors},
      {"views", &page.views},
      {"seen", &seen}};
  for (const auto& [id, bytes] : all) {
    const auto text = packed_text(*bytes);
    if (!text) return tl::unexpected(text.error());
    blocks += data_block(id, *text);
  }
  return assemble_page(kViewsSurfacePage, "glassbox views " + page.verb,
                       json_block("manifest", manifest) + blocks);
}

}  // namespace glassbox::app
