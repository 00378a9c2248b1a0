#include "views/commands/layers_against.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glassbox/base/elapsed.h>
#include <glassbox/base/elementary.h>
#include <glassbox/render/renderer.h>

#include "views/layers/second_eye_error.h"

namespace glassbox::views {

namespace {

// Whether the layers contain the point: some sample of its pixel or of a neighbouring one has
// nearly the same depth. The samples' depths are those of pixel centres. On a surface at 45 degrees
// to the gaze, depths within a pixel differ by a pixel's width relative to the distance, which is
// less than 1/64 in any picture wider than a hundred pixels.
bool is_in_layers(const views::LayeredImage& image, const Eigen::Vector4d& there) {
  constexpr double kNear = 1.0 / 64;
  if (!(there.w() > 0)) return false;
  const double x = std::floor(there.x() / there.w()), y = std::floor(there.y() / there.w());
  const double depth = there.z() / there.w();
  const auto in_picture = [&](double column, double row) {
    return column >= 0 && row >= 0 && column < image.camera.width && row < image.camera.height;
  };
  if (!in_picture(x, y)) return false;
  for (double row = y - 1; row <= y + 1; ++row) {
    for (double column = x - 1; column <= x + 1; ++column) {
      if (!in_picture(column, row)) continue;
      const std::size_t place = image.place(int(column), int(row));
      for (std::uint32_t i = image.first[place]; i < image.first[place + 1]; ++i) {
        if (std::abs(double(image.depth[i]) - depth) <= kNear * depth) return true;
      }
    }
  }
  return false;
}

}  // namespace

LayersAgainst against_scene(const views::LayerPicture& picture, const View& view,
                            const Scene& scene, const views::StoredLayers& layers) {
  RenderSettings settings;
  settings.background = layers.background;
  settings.want_distance = true;
  Renderer renderer(scene, settings.transfer);
  renderer.render(view, settings);  // the first run also prepares the scene, so it is not timed
  const auto start = std::chrono::steady_clock::now();
  const Framebuffer truth = renderer.render(view, settings).buffers;
  LayersAgainst against;
  against.render_ms = elapsed_ms(start);
  const Eigen::Matrix4d to_layers =
      views::warp_matrix(layers.image.camera, views::layer_camera(view));
  const views::EyeError error = views::eye_error(picture.color, truth.color);
  against.wrong = error.wrong;
  against.psnr = 20 * logarithm_10(255 / error.rms);
  for (int y = 0; y < truth.color.height; ++y) {
    for (int x = 0; x < truth.color.width; ++x) {
      const float distance = truth.distance.at(x, y);
      if (picture.depth.at(x, y) != 0 || !std::isfinite(distance)) continue;
      ++against.missing;
      const Eigen::Vector4d here(x + 0.5, y + 0.5, views::depth_of(view, double(distance)), 1);
      against.interior += is_in_layers(layers.image, to_layers * here);
    }
  }
  return against;
}

}  // namespace glassbox::views
