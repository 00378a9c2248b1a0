#include "app/info/info_sections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/exit_codes.h"
#include "views/layers/layer_file.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/images/read.h>

namespace glassbox::app {

namespace {

const char* lens_word(const Lens& lens) {
  if (std::holds_alternative<OrthographicLens>(lens)) return "orthographic";
  return std::holds_alternative<FrustumLens>(lens) ? "frustum" : "perspective";
}

// The number of pixels with 1, with 2, with 3 ... samples.
std::vector<std::size_t> pixels_by_samples(const views::LayeredImage& image) {
  std::vector<std::size_t> counts;
  for (std::size_t pixel = 0; pixel + 1 < image.first.size(); ++pixel) {
    const std::size_t here = image.first[pixel + 1] - image.first[pixel];
    if (here == 0) continue;
    if (counts.size() < here) counts.resize(here);
    ++counts[here - 1];
  }
  return counts;
}

std::string depth_text(const std::vector<std::size_t>& by_samples) {
  constexpr std::size_t kMaxShown = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(by_samples.size(), kMaxShown); ++i)
    text += fmt::format("{}{} with {}", i == 0 ? "" : ", ", by_samples[i], i + 1);
  if (by_samples.size() > kMaxShown) text += ", ...";
  return text;
}

}  // namespace

bool is_layer_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, 32> start{};
  in.read(start.data(), std::streamsize(start.size()));
  return views::is_layers(std::as_bytes(std::span(start.data(), std::size_t(in.gcount()))));
}

Result<LayersInfo> layers_info(const std::string& file) {
  const auto bytes = read_file(file);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto layers = views::decode_layers(*bytes, file);
  if (!layers) return tl::unexpected(layers.error());
  const views::LayeredImage& image = layers->image;
  const views::LayerCounts counts = views::count_layers(image);
  const std::vector<std::size_t> by_samples = pixels_by_samples(image);
  const Lens& lens = layers->camera.lens;
  // value() cannot fail: the decoder has checked the camera
  const View view = make_view(layers->camera, image.camera.width, image.camera.height).value();
  const auto& pose = layers->camera.world_from_eye;
  const std::array<double, 3> eye{pose.at(0, 3), pose.at(1, 3), pose.at(2, 3)};
  const Rgba8& background = layers->background;

  LayersInfo info;
  info.text = fmt::format("{}: a layered depth image of {} x {} pixels, {}, {} bytes\n",
                          printable(file, kLongestMessage), image.camera.width, image.camera.height,
                          counted(image.samples(), "sample"), bytes->size());
  info.text += fmt::format("  depth complexity {:.2f} over {}, at most {}\n", counts.complexity(),
                           counted(counts.covered, "covered pixel"), counts.most);
  info.json = {{"layers", file},
               {"width", image.camera.width},
               {"height", image.camera.height},
               {"bytes", bytes->size()},
               {"samples", counts.samples},
               {"covered_pixels", counts.covered},
               {"most_samples_of_a_pixel", counts.most},
               {"depth_complexity", counts.complexity()},
               {"pixels_by_samples", by_samples},
               {"lens", lens_word(lens)},
               {"near", view.near},
               {"far", std::isinf(view.far) ? nlohmann::ordered_json("inf")
                                            : nlohmann::ordered_json(view.far)},
               {"eye", eye},
               {"normals", !image.normal.empty()},
               {"triangles", !image.triangle.empty()},
               {"background", {background.r, background.g, background.b, background.a}}};
  if (counts.samples > 0) {
    const auto [least, greatest] = std::ranges::minmax(image.depth);
    const double nearest = views::distance_of(view, double(greatest)),
                 farthest = views::distance_of(view, double(least));
    info.text += "  pixels: " + depth_text(by_samples) + "\n";
    info.text +=
        fmt::format("  distances from {:.6g} to {:.6g} along the gaze\n", nearest, farthest);
    info.json["nearest"] = nearest;
    info.json["farthest"] = farthest;
  }
  if (!image.normal.empty()) info.text += "  normals of the surfaces are stored\n";
  if (!image.triangle.empty()) info.text += "  numbers of the triangles are stored\n";
  info.text += fmt::format(
      "  camera: {}, at ({:.6g}, {:.6g}, {:.6g}), near plane {:.6g}, far plane {:.6g}\n",
      lens_word(lens), eye[0], eye[1], eye[2], view.near, view.far);
  return info;
}

}  // namespace glassbox::app
