#include "app/views/layers_page.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include <fmt/format.h>
#include <Eigen/LU>
#include <nlohmann/json.hpp>

#include "viewslayers_page.h"  // made by html/embed.cmake

#include <glassbox/base/little_endian.h>
#include <glassbox/html/blob.h>
#include <glassbox/html/page.h>
#include <glassbox/images/recipe.h>

namespace glassbox::app {

namespace {

constexpr std::size_t kMostSamples = std::size_t(1) << 22;  // 32 MB of them

nlohmann::ordered_json rows_of(const Eigen::Matrix4d& matrix) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (int i = 0; i < 16; ++i) rows.push_back(matrix(i / 4, i % 4));
  return rows;
}

// Browsers' typed arrays are little-endian wherever they run today, and so is this program's memory
// (base/little_endian.h).
template <class Value>
std::vector<std::uint8_t> bytes_of(const std::vector<Value>& values) {
  std::vector<std::uint8_t> bytes(values.size() * sizeof(Value));
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

// How far along the gaze what is in the middle of the picture lies: the middle one of the distances there.
double pivot_of(const views::LayeredImage& image, const Eigen::Matrix4d& eye_from_screen) {
  std::vector<double> distances;
  const int width = image.camera.width, height = image.camera.height;
  for (int y = height / 3; y <= height * 2 / 3 && y < height; ++y) {
    for (int x = width / 3; x <= width * 2 / 3 && x < width; ++x) {
      const std::size_t place = image.place(x, y);
      if (image.first[place] == image.first[place + 1]) continue;
      const double depth = double(image.depth[image.first[place + 1] - 1]);
      const Eigen::Vector4d at = eye_from_screen * Eigen::Vector4d(x + 0.5, y + 0.5, depth, 1);
      distances.push_back(-at.z() / at.w());
    }
  }
  if (distances.empty()) return 1;
  std::ranges::nth_element(distances, distances.begin() + std::ptrdiff_t(distances.size() / 2));
  return distances[distances.size() / 2];
}

}  // namespace

Result<std::string> make_layers_page(const views::StoredLayers& layers, const std::string& file) {
  const views::LayeredImage& image = layers.image;
  if (image.samples() > kMostSamples)
    return fail("--html",
                fmt::format("{} samples would be too many for a browser", image.samples()),
                fmt::format("build layers of at most {}: a smaller --size", kMostSamples));
  const views::LayerCounts counts = views::count_layers(image);
  std::vector<std::uint16_t> per_pixel;
  for (std::size_t i = 0; i + 1 < image.first.size(); ++i) {
    constexpr std::uint32_t kMost = 65535;
    const std::uint32_t here = image.first[i + 1] - image.first[i];
    if (here > kMost)
      return fail("--html",
                  fmt::format("a pixel has {} samples, and a page counts to {}", here, kMost),
                  "build them with a larger --epsilon, or fewer --layers");
    per_pixel.push_back(std::uint16_t(here));
  }
  const Eigen::Matrix4d world_from_eye = views::matrix_of(layers.camera.world_from_eye);
  const Eigen::Matrix4d screen_from_eye = image.camera.screen_from_world * world_from_eye;
  const Rgba8& back = layers.background;
  const nlohmann::ordered_json manifest{
      {"file", file},
      {"file_as_word", shell_quoted(file).value_or("FILE.ldi")},
      {"program", fmt::format("glassbox {}, views layers draw --html", GLASSBOX_VERSION)},
      {"width", image.camera.width},
      {"height", image.camera.height},
      {"samples", counts.samples},
      {"most_samples_of_a_pixel", counts.most},
      {"depth_complexity", counts.complexity()},
      {"background", std::uint32_t(back.r) | std::uint32_t(back.g) << 8 |
                         std::uint32_t(back.b) << 16 | 0xff000000u},
      {"screen_from_eye", rows_of(screen_from_eye)},
      {"world_from_eye", rows_of(world_from_eye)},
      {"pivot", pivot_of(image, screen_from_eye.inverse())}};
  std::string blocks = json_block("manifest", manifest);
  for (const auto& [id, bytes] :
       {std::pair("counts", bytes_of(per_pixel)), std::pair("depths", bytes_of(image.depth)),
        std::pair("colours", bytes_of(image.color)),
        std::pair("normals", bytes_of(image.normal))}) {
    const auto packed = packed_text(bytes);
    if (!packed) return tl::unexpected(packed.error());
    blocks += data_block(id, *packed);
  }
  return assemble_page(kViewsLayersPage, "glassbox views layers", blocks);
}

}  // namespace glassbox::app
