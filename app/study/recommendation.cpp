#include "app/study/recommendation.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/report/shell_line.h"
#include "study/bench/machine.h"
#include "study/recommend/pictures.h"
#include "study/recommend/vertices.h"

#include <glassbox/base/counted.h>
#include <glassbox/render/engine/names.h>
#include <glassbox/render/renderer.h>

namespace glassbox::app {

namespace {

using study::Candidate;
using study::Comparison;
using study::Quantity;
using study::SceneVertices;
using study::Shot;

Result<Shot> shot_of(const Scene& scene, PictureOptions picture, const RenderSettings& settings) {
  picture.settings = settings;
  return choose_view(scene, picture).map([&](const ChosenView& chosen) {
    return Shot{chosen.view, settings};
  });
}

// Of the candidates that fit: what fails is not recommended, whatever it costs.
void add_times(const Scene& scene, const std::vector<Shot>& shots, double limit,
               Comparison& comparison, Progress& progress) {
  comparison.item = "frame";
  std::vector<Shot> timed;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    if (!(comparison.candidates[i].error < limit)) continue;
    timed.push_back(shots[i]);
    which.push_back(i);
  }
  if (timed.empty()) return;
  progress.phase(fmt::format("measuring {}: timing what fits, {} of {} candidates",
                             name_of(comparison.quantity), timed.size(), shots.size()));
  const auto times = study::frame_times(scene, timed);
  for (std::size_t i = 0; i < times.size(); ++i) comparison.candidates[which[i]].ns = times[i];
}

Result<Comparison> compare_positions(const Scene& scene, const PictureOptions& picture) {
  const auto shot = shot_of(scene, picture, picture.settings);
  if (!shot) return tl::unexpected(shot.error());
  return SceneVertices::of(scene, shot->view).map([](const SceneVertices& vertices) {
    return vertices.positions();
  });
}

Result<Comparison> compare_depths(const Scene& scene, const PictureOptions& picture, double limit,
                                  Progress& progress) {
  Comparison result;
  result.quantity = Quantity::kDepth;
  result.reference = "50 digits";
  std::vector<Shot> shots;
  for (const DepthFormat format : {DepthFormat::kUnorm16, DepthFormat::kUnorm24,
                                   DepthFormat::kFloat32, DepthFormat::kFloat32Reversed}) {
    const std::string name(name_of(format));
    RenderSettings settings = picture.settings;
    settings.depth = format;
    const auto shot = shot_of(scene, picture, settings);
    if (!shot) return tl::unexpected(shot.error());
    const auto vertices = SceneVertices::of(scene, shot->view);
    if (!vertices) return tl::unexpected(vertices.error());
    result.error =
        fmt::format("largest error of the stored distance, as a share of {}, of {} vertices",
                    shot->view.perspective ? "it" : "the depth of the view", vertices->count());
    result.candidates.push_back({name, {"--depth", name}, true, vertices->depth_error(format), {}});
    shots.push_back(*shot);
  }
  add_times(scene, shots, limit, result, progress);
  return result;
}

// How many times as wide and high the reference is drawn.
int reference_factor(const Size& size) {
  constexpr int kMost = 4;
  return std::clamp(kMaxImageSide / std::max(size.width, size.height), 1, kMost);
}

Result<Image<Rgba8>> reference_picture(const Scene& scene, PictureOptions picture, int factor) {
  RenderSettings settings = picture.settings;
  settings.samples = 16;
  picture.size = {picture.size.width * factor, picture.size.height * factor};
  const auto shot = shot_of(scene, picture, settings);
  if (!shot) return tl::unexpected(shot.error());
  Renderer renderer(scene, settings.transfer);
  return study::shrunk(renderer.render(shot->view, settings).buffers.color, factor,
                       settings.transfer);
}

Result<Comparison> compare_colours(const Scene& scene, const PictureOptions& picture, double limit,
                                   Progress& progress) {
  progress.phase("measuring colour: drawing the reference");
  const int factor = reference_factor(picture.size);
  const auto reference = reference_picture(scene, picture, factor);
  if (!reference) return tl::unexpected(reference.error());
  Comparison result;
  result.quantity = Quantity::kColour;
  result.error = "root mean square difference of red, green and blue, 1 for 255 steps";
  result.reference = fmt::format(
      "the picture {0} x {0} times as large with 16 samples, averaged in light", factor);
  std::vector<Shot> shots;
  for (const Shading shading : {Shading::kGouraud, Shading::kPhong}) {
    const std::string name(name_of(shading));
    for (const int samples : {1, 2, 4, 8, 16}) {
      RenderSettings settings = picture.settings;
      settings.shading = shading;
      settings.samples = samples;
      const auto shot = shot_of(scene, picture, settings);
      if (!shot) return tl::unexpected(shot.error());
      const std::string count = fmt::to_string(samples);
      progress.phase(fmt::format("measuring colour: drawing with {}, {} samples", name, count));
      Renderer renderer(scene, settings.transfer);
      const Rendering drawn = renderer.render(shot->view, settings);
      result.candidates.push_back({fmt::format("{}, {}", name, counted(samples, "sample")),
                                   {"--shade", name, "--samples", count},
                                   true,
                                   study::color_error(drawn.buffers.color, *reference),
                                   {}});
      shots.push_back(*shot);
      // More samples are all of this work and more.
      if (result.candidates.back().error < limit) break;
    }
  }
  add_times(scene, shots, limit, result, progress);
  return result;
}

Result<Comparison> compare(const Scene& scene, const PictureOptions& picture,
                           const study::Budget& budget, Progress& progress) {
  switch (budget.quantity) {
    case Quantity::kPosition:
      return compare_positions(scene, picture);
    case Quantity::kDepth:
      return compare_depths(scene, picture, budget.limit, progress);
    case Quantity::kColour:
      break;
  }
  return compare_colours(scene, picture, budget.limit, progress);
}

// The most accurate candidate where none fits.
std::string command_of(const std::vector<Judged>& judged, std::vector<std::string> words) {
  words.insert(words.begin(), "render");
  for (const Judged& each : judged) {
    const auto& candidates = each.comparison.candidates;
    const auto best = std::ranges::min_element(candidates, {}, &Candidate::error);
    const auto& options = each.chosen ? candidates[*each.chosen].options : best->options;
    words.insert(words.end(), options.begin(), options.end());
  }
  words.insert(words.end(), {"-o", "recommended.png"});
  return shell_line({words});
}

}  // namespace

bool Recommendation::meets_all() const {
  return std::ranges::all_of(judged, [](const Judged& each) {
    return each.chosen && each.comparison.candidates[*each.chosen].in_render;
  });
}

Result<Recommendation> recommend(const Scene& scene, const PictureOptions& picture,
                                 const std::vector<study::Budget>& budgets,
                                 const std::vector<std::string>& words, Progress& progress) {
  Recommendation result;
  result.scene = words.front();
  result.machine = study::machine_name();
  result.compiler = study::compiler_name();
  result.size = picture.size;
  for (const study::Budget& budget : budgets) {
    progress.phase(fmt::format("measuring {}", name_of(budget.quantity)));
    auto comparison = compare(scene, picture, budget, progress);
    if (!comparison) return tl::unexpected(comparison.error());
    const auto chosen = study::cheapest(comparison->candidates, budget.limit);
    result.judged.push_back({budget, std::move(*comparison), chosen});
  }
  result.command = command_of(result.judged, words);
  return result;
}

}  // namespace glassbox::app
