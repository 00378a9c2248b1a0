#include "views/layers/layer_builder.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace glassbox::views {

LayerBuilder::LayerBuilder(const LayerCamera& camera, double epsilon,
                           const WantedAttributes& wanted)
    : camera_(camera),
      epsilon_(epsilon),
      wanted_(wanted),
      last_added_(std::size_t(camera.width) * std::size_t(camera.height), kNone) {}

void LayerBuilder::add(int x, int y, float depth, Rgba8 color, std::uint32_t rank,
                       const SampleAttributes& source) {
  if (!(depth > 0) || !std::isfinite(depth)) return;
  const std::size_t place =
      std::size_t(camera_.height - 1 - y) * std::size_t(camera_.width) + std::size_t(x);
  samples_.push_back({depth, color, rank, last_added_[place], source});
  last_added_[place] = std::uint32_t(samples_.size() - 1);
}

template <class SourceOf>
std::size_t LayerBuilder::add_pixels(const View& from, const Image<Rgba8>& color,
                                     const Image<float>& distance, std::uint32_t rank,
                                     const SourceOf& source_of) {
  const Eigen::Matrix4d warp = warp_matrix(camera_, layer_camera(from));
  std::size_t beside = 0;
  for (int y = 0; y < distance.height; ++y) {
    for (int x = 0; x < distance.width; ++x) {
      const float z = distance.at(x, y);
      if (!std::isfinite(z)) continue;
      const Eigen::Vector4d here(x + 0.5, y + 0.5, depth_of(from, double(z)), 1);
      const Eigen::Vector4d there = warp * here;
      const double column = std::floor(there.x() / there.w());
      const double row = std::floor(there.y() / there.w());
      if (!(there.w() > 0) || !(column >= 0 && column < camera_.width) ||
          !(row >= 0 && row < camera_.height)) {
        ++beside;
        continue;
      }
      add(int(column), int(row), float(there.z() / there.w()), color.at(x, y), rank,
          source_of(x, y));
    }
  }
  return beside;
}

std::size_t LayerBuilder::add_picture(const View& from, const Image<Rgba8>& color,
                                      const Image<float>& distance, std::uint32_t rank) {
  return add_pixels(from, color, distance, rank, [](int, int) { return SampleAttributes(); });
}

std::size_t LayerBuilder::add_layer(const View& from, const Layer& layer,
                                    std::span<const SampleNormal> normals, std::uint32_t rank) {
  if (layer.id.pixels.empty()) return add_picture(from, layer.color, layer.distance, rank);
  return add_pixels(from, layer.color, layer.distance, rank, [&](int x, int y) {
    const std::uint32_t triangle = layer.id.at(x, y);
    return SampleAttributes{triangle < normals.size() ? normals[triangle] : SampleNormal(),
                            triangle};
  });
}

// A total order of the samples' contents, so that only identical samples are equal.
bool LayerBuilder::is_behind(const Sample& a, const Sample& b) {
  const auto key = [](const Sample& s) {
    return std::tuple(s.depth, ~s.rank, s.color.r, s.color.g, s.color.b, s.color.a, s.source.normal,
                      s.source.triangle);
  };
  return key(a) < key(b);
}

LayeredImage LayerBuilder::pack() const {
  LayeredImage image;
  image.camera = camera_;
  image.first.reserve(last_added_.size() + 1);
  image.first.push_back(0);
  std::vector<Sample> here;
  for (const std::uint32_t last : last_added_) {
    here.clear();
    for (std::uint32_t i = last; i != kNone; i = samples_[i].next) here.push_back(samples_[i]);
    std::ranges::sort(here, [](const Sample& a, const Sample& b) { return is_behind(b, a); });
    std::size_t kept = 0;  // number of samples kept so far, counted from the front
    double front = 0;      // depth of the nearest sample of the group that is being merged
    for (const Sample& sample : here) {
      const bool is_new = kept == 0 || front - double(sample.depth) > epsilon_ * front;
      if (is_new) {
        front = double(sample.depth);
        here[kept++] = sample;
      } else if (sample.rank < here[kept - 1].rank) {
        here[kept - 1] = sample;
      }
    }
    for (std::size_t i = kept; i-- > 0;) {
      image.depth.push_back(here[i].depth);
      image.color.push_back(here[i].color);
      if (wanted_.normals) image.normal.push_back(here[i].source.normal);
      if (wanted_.triangles) image.triangle.push_back(here[i].source.triangle);
    }
    image.first.push_back(std::uint32_t(image.depth.size()));
  }
  return image;
}

LayeredImage nearest_and_farthest(const LayeredImage& image) {
  LayeredImage ends;
  ends.camera = image.camera;
  ends.first.push_back(0);
  for (std::size_t place = 0; place + 1 < image.first.size(); ++place) {
    const std::uint32_t farthest = image.first[place], end = image.first[place + 1];
    for (std::uint32_t i = farthest; i < end; ++i) {
      if (i != farthest && i + 1 != end) continue;
      ends.depth.push_back(image.depth[i]);
      ends.color.push_back(image.color[i]);
      if (!image.normal.empty()) ends.normal.push_back(image.normal[i]);
      if (!image.triangle.empty()) ends.triangle.push_back(image.triangle[i]);
    }
    ends.first.push_back(std::uint32_t(ends.depth.size()));
  }
  return ends;
}

LayeredImage build_layers(const Scene& scene, const View& view, const RenderSettings& settings,
                          int layers) {
  RenderSettings with_distance = settings;
  with_distance.want_distance = true;
  LayerBuilder builder(layer_camera(view), 0);
  for (const Layer& layer : peel(scene, view, with_distance, layers)) {
    builder.add_picture(view, layer.color, layer.distance);
  }
  return builder.pack();
}

}  // namespace glassbox::views
