#include "app/views/voxels_page.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report/picture_uri.h"
#include "views/voxels/layers_of.h"
#include "viewsvoxels_page.h"  // made by html/embed.cmake

#include <glassbox/html/blob.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

Result<void> check_size(const VoxelsInput& input, const VoxelsReport& report) {
  constexpr std::size_t kMostVoxels = std::size_t(1) << 23, kMostColored = 1000000;
  constexpr std::size_t kMostPixels = std::size_t(1) << 24;
  const std::size_t voxels = report.verdicts.size(), colored = report.coloring.voxels.size();
  if (voxels > kMostVoxels || colored > kMostColored) {
    return fail(
        "--html",
        fmt::format("a page of {} voxels, {} of them coloured, would be too large for a "
                    "browser",
                    voxels, colored),
        fmt::format("ask for at most {} and {}, with --resolution", kMostVoxels, kMostColored));
  }
  std::size_t pixels = 0;
  for (const auto& picture : input.set.pictures) pixels += picture.color.pixels.size();
  if (pixels > kMostPixels) {
    return fail("--html",
                fmt::format("a page of {} pixels would be too large for a browser", pixels),
                "choose fewer pictures with --pictures");
  }
  return {};
}

void add_short(std::vector<std::uint8_t>& bytes, int value) {
  bytes.push_back(std::uint8_t(value & 255));
  bytes.push_back(std::uint8_t(value >> 8 & 255));
}

// x, y, z as two bytes each, the colour, and how many pictures see it (255: or more).
std::vector<std::uint8_t> voxel_bytes(const std::vector<views::ColoredVoxel>& voxels) {
  std::vector<std::uint8_t> bytes;
  for (const views::ColoredVoxel& voxel : voxels) {
    for (const int coordinate : {voxel.at.x, voxel.at.y, voxel.at.z}) add_short(bytes, coordinate);
    for (const std::uint8_t channel : {voxel.color.r, voxel.color.g, voxel.color.b})
      bytes.push_back(channel);
    bytes.push_back(std::uint8_t(std::min<int>(voxel.views, 255)));
  }
  return bytes;
}

// Of each pixel the first layer that hides what is behind it, and 65535 where none does: what a voxel of layer k was shown is what
// had no number below k.
std::vector<std::uint8_t> hidden_bytes(const views::CalibratedPicture& picture,
                                       const views::ColoringRequest& request,
                                       const views::Coloring& coloring) {
  const int width = picture.color.width;
  const views::GridPicture lens = views::grid_picture(
      coloring.grid, views::projection_of(picture.camera), width, picture.color.height);
  constexpr int kNever = 65535;
  std::vector<int> first(picture.color.pixels.size(), kNever);
  const views::PlaneLayers planes(coloring.grid, coloring.direction);
  for (const views::ColoredVoxel& voxel : coloring.voxels) {
    const int layer = planes.layer_of(voxel.at);
    const auto hide = [&](int x, int y) {
      int& here = first[std::size_t(y) * std::size_t(width) + std::size_t(x)];
      here = std::min(here, layer);
    };
    views::for_each_pixel(lens, views::centre_of(lens, voxel.at), request.settings.hidden, hide);
  }
  std::vector<std::uint8_t> bytes;
  for (const int layer : first) add_short(bytes, layer);
  return bytes;
}

Result<Json> picture_json(const views::CalibratedPicture& picture, const views::VoxelGrid& grid) {
  Image<Rgba8> shown = picture.color;
  for (std::size_t i = 0; i < shown.pixels.size(); ++i) {
    const bool is_object = picture.matte.pixels.empty() || picture.matte.pixels[i] != 0;
    shown.pixels[i].a = is_object ? 255 : 0;
  }
  const auto uri = picture_uri(shown);
  if (!uri) return tl::unexpected(uri.error());
  const views::GridPicture lens = views::grid_picture(grid, views::projection_of(picture.camera),
                                                      picture.color.width, picture.color.height);
  Json matrix = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) matrix.push_back(lens.pixel_from_grid(row, column));
  }
  return Json{{"name", picture.name},
              {"width", picture.color.width},
              {"height", picture.color.height},
              {"pixel_from_grid", matrix},
              {"uri", *uri}};
}

Result<std::string> block_of(const std::string& id, const std::vector<std::uint8_t>& bytes) {
  return packed_text(bytes).map([&](const std::string& text) { return data_block(id, text); });
}

}  // namespace

Result<std::string> make_voxels_page(const VoxelsInput& input,
                                     const views::ColoringRequest& request,
                                     const VoxelsReport& report, const Json& json,
                                     const VoxelsPageOrigin& origin) {
  if (const auto legal = check_size(input, report); !legal) return tl::unexpected(legal.error());
  const views::Coloring& coloring = report.coloring;
  const views::ColoringSettings& settings = request.settings;
  Json manifest = json;
  manifest["text"] = voxels_text(input, request, report);
  manifest["program"] = origin.program;
  manifest["command"] = origin.command;
  manifest["direction"] = {coloring.direction[0], coloring.direction[1]};
  // Only planes leave a number at each pixel from which any voxel's verdict can be worked out again, and the page looks at one pixel of
  // each picture, the centre's.
  const bool has_layers = coloring.order == views::Order::kSweep && !coloring.in_shells &&
                          settings.update == views::Update::kLayer &&
                          settings.sampled == views::Footprint::kCentre;
  manifest["has_layers"] = has_layers;
  // JSON has no infinity: null is one.
  const Json threshold =
      std::isfinite(settings.threshold) ? Json(settings.threshold) : Json(nullptr);
  manifest["settings"] = {{"threshold", threshold},
                          {"edge", settings.edge},
                          {"k1", settings.k1},
                          {"k2", settings.k2},
                          {"noise", settings.noise},
                          {"significance", settings.significance},
                          {"lightness", settings.lightness}};
  Json axes = Json::array();
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) axes.push_back(coloring.grid.axes(row, column));
  }
  manifest["axes"] = axes;
  manifest["shown"] = Json::array();
  std::string blocks;
  const auto add_block = [&](const std::string& id,
                             const std::vector<std::uint8_t>& bytes) -> Result<void> {
    const auto block = block_of(id, bytes);
    if (!block) return tl::unexpected(block.error());
    blocks += *block;
    return {};
  };
  for (std::size_t i = 0; i < input.set.pictures.size(); ++i) {
    const auto one = picture_json(input.set.pictures[i], coloring.grid);
    if (!one) return tl::unexpected(one.error());
    manifest["shown"].push_back(*one);
    if (!has_layers) continue;
    const auto added = add_block(fmt::format("hidden{}", i),
                                 hidden_bytes(input.set.pictures[i], request, coloring));
    if (!added) return tl::unexpected(added.error());
  }
  if (input.left_out) {
    const auto picture = picture_uri(input.left_out->color),
               drawn = picture_uri(report.drawn->color);
    if (!picture) return tl::unexpected(picture.error());
    if (!drawn) return tl::unexpected(drawn.error());
    manifest["flicker"] = {
        {"name", input.left_out->name}, {"picture", *picture}, {"drawn", *drawn}};
  }
  if (const auto added = add_block("voxels", voxel_bytes(coloring.voxels)); !added)
    return tl::unexpected(added.error());
  std::vector<std::uint8_t> verdicts;
  if (coloring.order == views::Order::kSweep) {
    for (const views::Verdict verdict : report.verdicts) verdicts.push_back(std::uint8_t(verdict));
  }
  if (const auto added = add_block("verdicts", verdicts); !added)
    return tl::unexpected(added.error());
  return assemble_page(kViewsVoxelsPage, "glassbox views voxels",
                       json_block("manifest", manifest) + blocks);
}

}  // namespace glassbox::app
