#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "cli/frames/frame_range.h"
#include "cli/frames/path_file.h"
#include "cli/frames/sequence_frames.h"
#include "cli/frames/stop_request.h"
#include "cli/report/output.h"
#include "views/commands/layers_drawing.h"
#include "views/layers/second_eye_error.h"

#include <glassbox/base/elapsed.h>
#include <glassbox/base/elementary.h>
#include <glassbox/images/write.h>
#include <glassbox/render/renderer.h>

namespace glassbox::views {

namespace {

// Calls visit with the world position of each sample.
template <class Visit>
void for_each_sample(const views::LayeredImage& image, const Visit& visit) {
  const Eigen::Matrix4d world_from_screen = image.camera.screen_from_world.inverse();
  for (int y = 0; y < image.camera.height; ++y) {
    for (int x = 0; x < image.camera.width; ++x) {
      const std::size_t place = image.pixel_index(x, y);
      for (std::uint32_t i = image.first[place]; i < image.first[place + 1]; ++i) {
        const Eigen::Vector4d at =
            world_from_screen * Eigen::Vector4d(x + 0.5, y + 0.5, double(image.depth[i]), 1);
        visit(Eigen::Vector3f(at.hnormalized().cast<float>()));
      }
    }
  }
}

bool needs_framing(const CameraOptions& camera) {
  return !camera.eye && (camera.look_at || camera.up || camera.camera == "none");
}

// The samples as a scene of points, with the layers' camera, for functions that need a scene to
// choose a view. It has all samples, or (if not `all`) the two corners of the box around them.
Scene scene_of(const views::StoredLayers& layers, bool all) {
  Mesh mesh;
  const auto add = [&](const Eigen::Vector3f& p) {
    mesh.points.push_back({.position = std::uint32_t(mesh.positions.size())});
    mesh.positions.emplace_back(p.x(), p.y(), p.z());
  };
  if (all) {
    for_each_sample(layers.image, add);
  } else if (layers.image.samples() > 0) {
    Eigen::AlignedBox3f box;
    for_each_sample(layers.image, [&](const Eigen::Vector3f& p) { box.extend(p); });
    add(box.min());
    add(box.max());
  }
  Scene scene;
  scene.cameras = {layers.camera};
  if (mesh.points.empty()) return scene;
  scene.materials.emplace_back();
  scene.nodes.push_back({"", kNone, {}, {}});
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back({0, 0});
  return scene;
}

Result<std::vector<SequenceFrame>> layer_sequence_frames(const LayersFramesRequest& asked,
                                                         const LayersView& layers_view) {
  PictureOptions picture;
  picture.camera = asked.camera;
  picture.size = layers_view.size();
  const FrameRange& range = *asked.frames.range;
  if (asked.frames.turntable) {
    const double aspect = double(picture.size.width) / double(picture.size.height);
    const auto turntable = make_turntable(layers_view.scene(), asked.camera, aspect);
    if (!turntable) return tl::unexpected(turntable.error());
    return make_sequence_frames(layers_view.scene(), picture, {}, *turntable, range, false);
  }
  const auto path = read_camera_path(*asked.frames.path);
  if (!path) return tl::unexpected(path.error());
  if (const auto legal = check_path_options(picture, *path); !legal)
    return tl::unexpected(legal.error());
  return make_sequence_frames(layers_view.scene(), picture, *path, {}, range, false);
}

}  // namespace

LayersView::LayersView(const views::StoredLayers& layers, const CameraOptions& camera,
                       std::optional<Size> size, bool turntable)
    : scene_(scene_of(layers, turntable || needs_framing(camera))),
      camera_(camera),
      size_(size.value_or(Size{layers.image.camera.width, layers.image.camera.height})) {}

Result<View> LayersView::view() const {
  const double aspect = double(size_.width) / double(size_.height);
  return choose_camera(scene_, camera_, aspect).and_then([&](const Camera& camera) {
    return make_view(camera, size_.width, size_.height);
  });
}

Result<std::vector<LayersFrame>> draw_layer_frames(const LayersFramesRequest& asked,
                                                   const views::StoredLayers& layers,
                                                   Progress& progress) {
  const FrameRange& range = *asked.frames.range;
  const auto names = FrameNames::from_output(asked.output, "layers.png", range.count);
  if (!names) return tl::unexpected(names.error());
  if (const auto legal = check_image_path(names->name(1)); !legal)
    return tl::unexpected(legal.error());
  std::vector<std::string> paths;
  for (int number = range.first; number <= range.last; ++number) {
    paths.push_back(names->name(number));
  }
  if (const auto legal = check_outputs(paths); !legal) return tl::unexpected(legal.error());
  const auto shots = layer_sequence_frames(
      asked, LayersView(layers, asked.camera, asked.size, asked.frames.turntable));
  if (!shots) return tl::unexpected(shots.error());

  const StopRequest stop;
  views::LayerDrawer drawer(layers.image);
  views::LayerPicture picture;
  std::vector<LayersFrame> frames;
  for (const SequenceFrame& shot : *shots) {
    if (stop.is_requested()) {
      return fail("stopped",
                  fmt::format("{} of {} frames are written", frames.size(), shots->size()), "");
    }
    progress.phase(fmt::format("drawing frame {} of {}", shot.number, range.count));
    const auto start = std::chrono::steady_clock::now();
    drawer.draw(views::layer_camera(shot.centre), asked.drawing, picture);
    const double took_ms = elapsed_ms(start);
    const std::string name = names->name(shot.number);
    if (const auto written = write_image(name, picture.color, {}); !written)
      return tl::unexpected(written.error());
    frames.push_back(
        {shot.number, name, std::size_t(std::ranges::count(picture.depth.pixels, 0.0f)), took_ms});
  }
  return frames;
}

namespace {

// Whether the layers contain the point: some sample of its pixel or of a neighbouring one has
// nearly the same depth. The samples' depths are those of pixel centres. On a surface at 45 degrees
// to the direction of view, depths within a pixel differ by the width of the pixel on the surface.
// Relative to the distance, this is less than 1/64 in any picture wider than a hundred pixels.
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
      const std::size_t place = image.pixel_index(int(column), int(row));
      for (std::uint32_t i = image.first[place]; i < image.first[place + 1]; ++i) {
        if (std::abs(double(image.depth[i]) - depth) <= kNear * depth) return true;
      }
    }
  }
  return false;
}

}  // namespace

LayersComparison compare_with_scene(const views::LayerPicture& picture, const View& view,
                                    const Scene& scene, const views::StoredLayers& layers) {
  RenderSettings settings;
  settings.background = layers.background;
  settings.want_distance = true;
  Renderer renderer(scene, settings.transfer);
  renderer.render(view, settings);  // the first run also prepares the scene, so it is not timed
  const auto start = std::chrono::steady_clock::now();
  const Framebuffer truth = renderer.render(view, settings).buffers;
  LayersComparison comparison;
  comparison.render_ms = elapsed_ms(start);
  const Eigen::Matrix4d to_layers =
      views::warp_matrix(layers.image.camera, views::layer_camera(view));
  const views::EyeError error = views::eye_error(picture.color, truth.color);
  comparison.wrong = error.wrong;
  comparison.psnr = 20 * logarithm_10(255 / error.rms);
  for (int y = 0; y < truth.color.height; ++y) {
    for (int x = 0; x < truth.color.width; ++x) {
      const float distance = truth.distance.at(x, y);
      if (picture.depth.at(x, y) != 0 || !std::isfinite(distance)) continue;
      ++comparison.missing;
      const Eigen::Vector4d here(x + 0.5, y + 0.5, views::depth_of(view, double(distance)), 1);
      comparison.interior += is_in_layers(layers.image, to_layers * here);
    }
  }
  return comparison;
}

}  // namespace glassbox::views
