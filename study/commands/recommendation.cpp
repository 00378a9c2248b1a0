#include "study/commands/recommendation.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cli/report/shell_line.h"
#include "study/bench/machine.h"
#include "study/curve/drawers.h"
#include "study/curve/ways.h"
#include "study/experiment/runner.h"
#include "study/recommend/pictures.h"
#include "study/recommend/vertices.h"

#include <glassbox/base/counted.h>
#include <glassbox/render/engine/names.h>
#include <glassbox/render/renderer.h>

namespace glassbox::study {

namespace {

// Candidates, and the way of drawing that belongs to each.
struct Compared {
  Comparison comparison;
  std::vector<Way> ways;
};

// Measures candidates on one scene. The drawers and the reference picture are shared by all of
// them.
class SceneMeasurement {
public:
  SceneMeasurement(const Scene& scene, const PictureOptions& picture, Progress& progress)
      : scene_(scene),
        picture_(picture),
        view_([this](const RenderSettings& settings, int factor) {
          return choose_view(scene_, picture_, settings, factor);
        }),
        drawers_(scene, view_),
        progress_(progress) {
    joint_.settings = picture.settings;
    joint_.tile.threads = 1;
  }

  Result<Judged> judge(const study::Budget& budget) {
    progress_.phase(fmt::format("measuring {}", name_of(budget.quantity)));
    auto compared = compare(budget);
    if (!compared) return tl::unexpected(compared.error());
    const auto& candidates = compared->comparison.candidates;
    const auto chosen = budget.quantity == Quantity::kPosition
                            ? study::nearest_to_render(candidates, budget.limit)
                            : study::cheapest(candidates, budget.limit);
    take(*compared, chosen);
    return Judged{budget, std::move(compared->comparison), chosen};
  }

  // Measures all recommended options together, in one picture.
  Together together() {
    progress_.phase("measuring all recommended options together");
    Together found;
    found.options = joint_.options;
    found.ns = study::frame_times(drawers_, {joint_}, study::kLeastRepetitions).front().ns;
    if (reference_) {
      found.color_error = study::color_error(drawers_.draw(joint_), reference_->image);
    }
    return found;
  }

private:
  Result<Compared> compare(const study::Budget& budget) {
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

  Result<Compared> compare_positions() {
    const auto view = view_(picture_.settings, 1);
    if (!view) return tl::unexpected(view.error());
    return SceneVertices::of(scene_, *view).map([&](const SceneVertices& vertices) {
      Comparison comparison = vertices.positions();
      std::vector<Way> ways(comparison.candidates.size(), base());
      return Compared{std::move(comparison), std::move(ways)};
    });
  }

  Result<Compared> compare_depths(double limit) {
    Compared all;
    all.comparison.quantity = Quantity::kDepth;
    all.comparison.reference = "50 digits";
    for (const DepthFormat format : {DepthFormat::kUnorm16, DepthFormat::kUnorm24,
                                     DepthFormat::kFloat32, DepthFormat::kFloat32Reversed}) {
      const std::string name(name_of(format));
      Way way = base();
      way.knob = Knob::kDepth;
      way.settings.depth = format;
      way.options = {"--depth", name};
      const auto view = drawers_.view_of(way);
      if (!view) return tl::unexpected(view.error());
      const auto vertices = SceneVertices::of(scene_, *view);
      if (!vertices) return tl::unexpected(vertices.error());
      all.comparison.error = fmt::format(
          "largest error of the distance that is stored as depth, as a share of {}, over {} "
          "vertices",
          view->perspective ? "the distance" : "the depth of the view", vertices->count());
      all.comparison.candidates.push_back(
          {name, way.options, true, vertices->depth_error(format), {}});
      all.ways.push_back(std::move(way));
    }
    add_times(all, limit);
    return all;
  }

  Result<Compared> compare_colours(double limit) {
    progress_.phase("measuring colour: drawing the reference");
    auto reference = study::reference_picture(scene_, view_, picture_.settings);
    if (!reference) return tl::unexpected(reference.error());
    reference_ = std::move(*reference);
    Compared all;
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
    for (const Way& way : study::single_turns(scene_, {}).all) {
      if (way.knob == Knob::kFilter) all.push_back(way.filter);
    }
    return all;
  }

  void add_samples(Shading shading, const std::optional<TextureFilter>& filter, double limit,
                   Compared& all) {
    Way way = base();
    way.knob = Knob::kSeveral;
    way.settings.shading = shading;
    way.filter = filter;
    std::string name(name_of(shading));
    way.options = {"--shade", name};
    if (filter) {
      way.options.insert(way.options.end(), {"--filter", std::string(name_of(*filter))});
      name += fmt::format(", {}", name_of(*filter));
    }
    const std::vector<std::string> shared = way.options;
    for (const int samples : {1, 2, 4, 8, 16}) {
      way.settings.samples = samples;
      way.options = shared;
      way.options.insert(way.options.end(), {"--samples", fmt::to_string(samples)});
      const std::string title = fmt::format("{}, {}", name, counted(samples, "sample"));
      progress_.phase("measuring colour: drawing with " + title);
      const double error = study::color_error(drawers_.draw(way), reference_->image);
      all.comparison.candidates.push_back({title, way.options, true, error, {}});
      all.ways.push_back(way);
      if (error < limit) return;  // more samples would only cost more time
    }
  }

  // Times the candidates whose error is within the limit. The others cannot be recommended,
  // so their times are not needed.
  void add_times(Compared& compared, double limit) {
    Comparison& comparison = compared.comparison;
    comparison.item = "frame";
    std::vector<Way> timed;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < compared.ways.size(); ++i) {
      if (!(comparison.candidates[i].error < limit)) continue;
      timed.push_back(compared.ways[i]);
      which.push_back(i);
    }
    if (timed.empty()) return;
    progress_.phase(
        fmt::format("measuring {}: timing the {} of {} candidates that are accurate enough",
                    name_of(comparison.quantity), timed.size(), compared.ways.size()));
    const auto times = study::frame_times(drawers_, timed, study::kLeastRepetitions);
    for (std::size_t i = 0; i < times.size(); ++i) comparison.candidates[which[i]].ns = times[i].ns;
  }

  // Adds the chosen candidate to the options that are recommended together; the most accurate one
  // if none was chosen.
  void take(const Compared& compared, std::optional<std::size_t> chosen) {
    const auto& candidates = compared.comparison.candidates;
    const auto best = std::ranges::min_element(candidates, {}, &Candidate::error);
    const std::size_t at = chosen.value_or(std::size_t(best - candidates.begin()));
    const Way& way = compared.ways[at];
    if (way.knob == Knob::kDepth) joint_.settings.depth = way.settings.depth;
    if (way.knob == Knob::kSeveral) {
      joint_.settings.shading = way.settings.shading;
      joint_.settings.samples = way.settings.samples;
      joint_.filter = way.filter;
    }
    joint_.options.insert(joint_.options.end(), way.options.begin(), way.options.end());
  }

  Way base() const {
    Way way;
    way.settings = picture_.settings;
    way.tile.threads = 1;
    return way;
  }

  const Scene& scene_;
  const PictureOptions& picture_;
  study::ViewOf view_;
  study::Drawers drawers_;
  Progress& progress_;
  std::optional<study::ReferencePicture> reference_;  // made when a colour budget needs it
  Way joint_;                                         // all recommended options together
};

}  // namespace

bool Recommendation::meets_all() const {
  return std::ranges::all_of(judged, [&](const Judged& each) {
    if (!each.chosen || !each.comparison.candidates[*each.chosen].in_render) return false;
    const bool is_colour = each.budget.quantity == Quantity::kColour;
    return !is_colour || *together.color_error < each.budget.limit;
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
    auto judged = measurement.judge(budget);
    if (!judged) return tl::unexpected(judged.error());
    result.judged.push_back(std::move(*judged));
  }
  result.together = measurement.together();
  result.command =
      shell_line({{"render"}, words, result.together.options, {"-o", "recommended.png"}});
  return result;
}

}  // namespace glassbox::study
