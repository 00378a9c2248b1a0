#include "study/commands/recommendation.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cli/report/shell_line.h"
#include "study/bench/machine.h"
#include "study/curve/render_variants.h"
#include "study/curve/renderer_cache.h"
#include "study/experiment/runner.h"
#include "study/recommend/pictures.h"
#include "study/recommend/vertices.h"

#include <glassbox/base/counted.h>
#include <glassbox/render/engine/setting_names.h>
#include <glassbox/render/renderer.h>

namespace glassbox::study {

namespace {

// Candidates for one budget, with the settings that draw each of them.
struct ComparedCandidates {
  Comparison comparison;
  std::vector<RenderVariant> variants;
};

// Measures candidates on one scene. All of them share the renderers and the reference picture.
class SceneMeasurement {
public:
  SceneMeasurement(const Scene& scene, const PictureOptions& picture, Progress& progress)
      : scene_(scene),
        picture_(picture),
        view_([this](const RenderSettings& settings, int factor) {
          return choose_view(scene_, picture_, settings, factor);
        }),
        renderer_cache_(scene, view_),
        progress_(progress) {
    combined_.settings = picture.settings;
    combined_.tile.threads = 1;
  }

  Result<BudgetResult> measure_budget(const study::Budget& budget) {
    progress_.phase(fmt::format("measuring {}", name_of(budget.quantity)));
    auto compared = compare(budget);
    if (!compared) return tl::unexpected(compared.error());
    const auto& candidates = compared->comparison.candidates;
    const auto chosen = budget.quantity == Quantity::kPosition
                            ? study::first_render_candidate(candidates, budget.limit)
                            : study::fastest_candidate(candidates, budget.limit);
    add_to_combined(*compared, chosen);
    return BudgetResult{budget, std::move(compared->comparison), chosen};
  }

  // Measures all recommended options together, in one picture.
  CombinedOptions measure_combined() {
    progress_.phase("measuring all recommended options together");
    CombinedOptions found;
    found.options = combined_.options;
    found.ns = study::frame_times(renderer_cache_, {combined_}, study::kMinRepetitions).front().ns;
    if (reference_) {
      found.color_error = study::color_error(renderer_cache_.draw(combined_), reference_->image);
    }
    return found;
  }

private:
  Result<ComparedCandidates> compare(const study::Budget& budget) {
    switch (budget.quantity) {
      case Quantity::kPosition:
        return compare_positions();
      case Quantity::kDepth:
        return compare_depths(budget.limit);
      case Quantity::kColour:
        break;
    }
    return compare_colours(budget.limit);
  }

  Result<ComparedCandidates> compare_positions() {
    const auto view = view_(picture_.settings, 1);
    if (!view) return tl::unexpected(view.error());
    return SceneVertices::sample(scene_, *view).map([&](const SceneVertices& vertices) {
      Comparison comparison = vertices.positions();
      std::vector<RenderVariant> variants(comparison.candidates.size(), base_variant());
      return ComparedCandidates{std::move(comparison), std::move(variants)};
    });
  }

  Result<ComparedCandidates> compare_depths(double limit) {
    ComparedCandidates all;
    all.comparison.quantity = Quantity::kDepth;
    all.comparison.reference = "50 digits";
    for (const DepthFormat format : {DepthFormat::kUnorm16, DepthFormat::kUnorm24,
                                     DepthFormat::kFloat32, DepthFormat::kFloat32Reversed}) {
      const std::string name(name_of(format));
      RenderVariant variant = base_variant();
      variant.knob = Knob::kDepth;
      variant.settings.depth = format;
      variant.options = {"--depth", name};
      const auto view = renderer_cache_.view_of(variant);
      if (!view) return tl::unexpected(view.error());
      const auto vertices = SceneVertices::sample(scene_, *view);
      if (!vertices) return tl::unexpected(vertices.error());
      all.comparison.error = fmt::format(
          "largest error of the distance that is stored as depth, as a fraction of {}, over {} "
          "vertices",
          view->perspective ? "the distance" : "the depth of the view", vertices->count());
      all.comparison.candidates.push_back(
          {name, variant.options, true, vertices->depth_error(format), {}});
      all.variants.push_back(std::move(variant));
    }
    add_times(all, limit);
    return all;
  }

  Result<ComparedCandidates> compare_colours(double limit) {
    progress_.phase("measuring colour: drawing the reference");
    auto reference = study::reference_picture(scene_, view_, picture_.settings);
    if (!reference) return tl::unexpected(reference.error());
    reference_ = std::move(*reference);
    ComparedCandidates all;
    all.comparison.quantity = Quantity::kColour;
    all.comparison.error =
        "root mean square difference of red, green and blue, where 1 is 255 steps";
    all.comparison.reference = fmt::format(
        "the picture {0} x {0} times as large with 16 samples, averaged in linear light",
        reference_->factor);
    for (const Shading shading : {Shading::kGouraud, Shading::kPhong}) {
      for (const auto& filter : filters()) add_samples(shading, filter, limit, all);
    }
    add_times(all, limit);
    return all;
  }

  // The filters to compare: none (each texture's own), and every filter that changes the picture.
  std::vector<std::optional<TextureFilter>> filters() const {
    std::vector<std::optional<TextureFilter>> all{std::nullopt};
    for (const RenderVariant& variant : study::single_knob_variants(scene_, {}).all) {
      if (variant.knob == Knob::kFilter) all.push_back(variant.filter);
    }
    return all;
  }

  void add_samples(Shading shading, const std::optional<TextureFilter>& filter, double limit,
                   ComparedCandidates& all) {
    RenderVariant variant = base_variant();
    variant.knob = Knob::kSeveral;
    variant.settings.shading = shading;
    variant.filter = filter;
    std::string name(name_of(shading));
    variant.options = {"--shade", name};
    if (filter) {
      variant.options.insert(variant.options.end(), {"--filter", std::string(name_of(*filter))});
      name += fmt::format(", {}", name_of(*filter));
    }
    const std::vector<std::string> shared = variant.options;
    for (const int samples : {1, 2, 4, 8, 16}) {
      variant.settings.samples = samples;
      variant.options = shared;
      variant.options.insert(variant.options.end(), {"--samples", fmt::to_string(samples)});
      const std::string title = fmt::format("{}, {}", name, counted(samples, "sample"));
      progress_.phase("measuring colour: drawing with " + title);
      const double error = study::color_error(renderer_cache_.draw(variant), reference_->image);
      all.comparison.candidates.push_back({title, variant.options, true, error, {}});
      all.variants.push_back(variant);
      if (error < limit) return;  // more samples would only cost more time
    }
  }

  // Times the candidates whose error is within the limit. Other candidates cannot be recommended,
  // so their times are not needed.
  void add_times(ComparedCandidates& compared, double limit) {
    Comparison& comparison = compared.comparison;
    comparison.item = "frame";
    std::vector<RenderVariant> timed;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < compared.variants.size(); ++i) {
      if (!(comparison.candidates[i].error < limit)) continue;
      timed.push_back(compared.variants[i]);
      which.push_back(i);
    }
    if (timed.empty()) return;
    progress_.phase(
        fmt::format("measuring {}: timing the {} of {} candidates that are accurate enough",
                    name_of(comparison.quantity), timed.size(), compared.variants.size()));
    const auto times = study::frame_times(renderer_cache_, timed, study::kMinRepetitions);
    for (std::size_t i = 0; i < times.size(); ++i) comparison.candidates[which[i]].ns = times[i].ns;
  }

  // Adds the chosen candidate to the options that are recommended together; if none was chosen, the
  // most accurate candidate.
  void add_to_combined(const ComparedCandidates& compared, std::optional<std::size_t> chosen) {
    const auto& candidates = compared.comparison.candidates;
    const auto best = std::ranges::min_element(candidates, {}, &Candidate::error);
    const std::size_t at = chosen.value_or(std::size_t(best - candidates.begin()));
    const RenderVariant& variant = compared.variants[at];
    if (variant.knob == Knob::kDepth) combined_.settings.depth = variant.settings.depth;
    if (variant.knob == Knob::kSeveral) {
      combined_.settings.shading = variant.settings.shading;
      combined_.settings.samples = variant.settings.samples;
      combined_.filter = variant.filter;
    }
    combined_.options.insert(combined_.options.end(), variant.options.begin(),
                             variant.options.end());
  }

  RenderVariant base_variant() const {
    RenderVariant variant;
    variant.settings = picture_.settings;
    variant.tile.threads = 1;
    return variant;
  }

  const Scene& scene_;
  const PictureOptions& picture_;
  study::ViewOf view_;
  study::RendererCache renderer_cache_;
  Progress& progress_;
  std::optional<study::ReferencePicture> reference_;  // made when a colour budget needs it
  RenderVariant combined_;                            // all recommended options together
};

}  // namespace

bool Recommendation::meets_all() const {
  return std::ranges::all_of(budget_results, [&](const BudgetResult& each) {
    if (!each.chosen || !each.comparison.candidates[*each.chosen].in_render) return false;
    const bool is_colour = each.budget.quantity == Quantity::kColour;
    return !is_colour || *combined.color_error < each.budget.limit;
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
  SceneMeasurement measurement(scene, picture, progress);
  for (const study::Budget& budget : budgets) {
    auto judged = measurement.measure_budget(budget);
    if (!judged) return tl::unexpected(judged.error());
    result.budget_results.push_back(std::move(*judged));
  }
  result.combined = measurement.measure_combined();
  result.command =
      shell_line({{"render"}, words, result.combined.options, {"-o", "recommended.png"}});
  return result;
}

}  // namespace glassbox::study
