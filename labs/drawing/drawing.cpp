#include "labs/drawing/drawing.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/show_plane.h>

namespace glassbox::labs {

#define ENTRY(number) LabDrawing drawing_##number();
#include <drawings.inc>  // ENTRY(01) and so on, for each lab that draws (CMakeLists.txt)
#undef ENTRY

namespace {

struct Entry {
  int lab;
  LabDrawing (*make)();
};

constexpr int lab_number(const char* digits) {
  return (digits[0] - '0') * 10 + (digits[1] - '0');
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
#define ENTRY(number) {lab_number(#number), drawing_##number},
#include <drawings.inc>
#undef ENTRY
  };
  return all;
}

}  // namespace

std::optional<LabDrawing> drawing_of(int lab) {
  for (const Entry& entry : entries()) {
    if (entry.lab == lab) return entry.make();
  }
  return std::nullopt;
}

Rendering PictureSetup::render() const {
  Rendering rendering = render_staged(scene, view, settings, stages.get());
  if (finish) finish(rendering.buffers);
  return rendering;
}

void observe_run(const PictureSetup& run, Observer& observer) {
  render_staged(run.scene, run.view, run.settings, &observer);
}

std::function<void(Framebuffer&)> show_distances(std::vector<std::size_t> pixels,
                                                 Numbers distances) {
  return [pixels = std::move(pixels), distances = std::move(distances)](Framebuffer& picture) {
    for (std::size_t i = 0; i < pixels.size() && i < distances.size(); ++i)
      picture.distance.pixels[pixels[i]] = float(distances[i]);
    show_plane(Show::kDepth, picture);
  };
}

Result<void> check_opaque(const Scene& scene, const std::string& lab) {
  for (const Instance& instance : scene.instances) {
    const Material& material = scene.materials[scene.meshes[instance.mesh].material];
    if (material.alpha_mode != AlphaMode::kOpaque)
      return fail(
          "the scene",
          "some surfaces of the scene are transparent, or parts of them are cut out by their alpha",
          lab + " draws opaque surfaces only: name a scene that has no others");
  }
  return {};
}

std::optional<WrongNumber> first_wrong(std::span<const double> yours,
                                       std::span<const double> reference,
                                       const std::function<double(std::size_t)>& bound,
                                       const std::string& unit,
                                       const std::function<std::string(std::size_t)>& name) {
  const std::size_t count = std::max(yours.size(), reference.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (i >= yours.size()) return WrongNumber{name(i), 0, reference[i], 0, unit, "missing"};
    if (i >= reference.size()) return WrongNumber{name(i), yours[i], 0, 0, unit, "too many"};
    const bool same = yours[i] == reference[i] || std::abs(yours[i] - reference[i]) <= bound(i);
    if (!same) return WrongNumber{name(i), yours[i], reference[i], bound(i), unit, ""};
  }
  return std::nullopt;
}

std::optional<WrongNumber> first_wrong_entry(std::span<const double> yours,
                                             std::span<const double> reference, double bound,
                                             const std::string& unit) {
  return first_wrong(
      yours, reference, [bound](std::size_t) { return bound; }, unit,
      [](std::size_t i) { return fmt::format("row {}, column {}", i / 4, i % 4); });
}

float to_finite_float(double value, float most) {
  return std::isfinite(value) ? float(std::clamp(value, -double(most), double(most))) : 0.0f;
}

}  // namespace glassbox::labs
