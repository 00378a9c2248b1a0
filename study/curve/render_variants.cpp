#include "study/curve/render_variants.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <glassbox/render/engine/setting_names.h>

namespace glassbox::study {

namespace {

// Collects the variants of one scene in which a single knob (an option of drawing) is changed.
class VariantCollector {
public:
  VariantCollector(const Scene& scene, const VariantRequest& asked) : scene_(scene), asked_(asked) {
    base_.settings = asked.settings;
    base_.filter = asked.filter;
    base_.tile = asked.tile;
    base_.tile.threads = 1;
    found_.all.push_back(base_);
  }

  RenderVariants all() && {
    add_shading_variants();
    add_filter_variants();
    add_samples_variants();
    add_depth_variants();
    add_level_variants();
    add_engine_variants();
    return std::move(found_);
  }

private:
  template <class Change>
  void add(Knob knob, std::vector<std::string> options, Change change) {
    RenderVariant variant = base_;
    variant.knob = knob;
    variant.options = std::move(options);
    change(variant);
    found_.all.push_back(std::move(variant));
  }

  bool is_fixed(Knob knob) {
    if (!asked_.fixed_knobs.contains(knob)) return false;
    found_.skipped.push_back({knob, "you gave this option's value"});
    return true;
  }

  void add_shading_variants() {
    if (is_fixed(Knob::kShading)) return;
    for (const Shading shading :
         {Shading::kUnlit, Shading::kFlat, Shading::kGouraud, Shading::kPhong}) {
      if (shading == base_.settings.shading) continue;
      add(Knob::kShading, {"--shade", std::string(name_of(shading))},
          [&](RenderVariant& variant) { variant.settings.shading = shading; });
    }
  }

  // Whether the samplers of all textures already have this filter.
  bool is_written(TextureFilter filter) const {
    return std::ranges::all_of(scene_.textures, [&](const Texture& texture) {
      return with_filter(texture.sampler, filter) == texture.sampler;
    });
  }

  void add_filter_variants() {
    if (scene_.textures.empty()) {
      found_.skipped.push_back({Knob::kFilter, "the scene has no texture"});
      return;
    }
    if (is_fixed(Knob::kFilter)) return;
    for (const TextureFilter filter : {TextureFilter::kNearest, TextureFilter::kBilinear,
                                       TextureFilter::kBilinearLevels, TextureFilter::kTrilinear}) {
      if (is_written(filter)) continue;
      add(Knob::kFilter, {"--filter", std::string(name_of(filter))},
          [&](RenderVariant& variant) { variant.filter = filter; });
    }
  }

  void add_samples_variants() {
    if (is_fixed(Knob::kSamples)) return;
    for (const int samples : {1, 2, 4, 8, 16}) {
      if (samples == base_.settings.samples) continue;
      add(Knob::kSamples, {"--samples", fmt::to_string(samples)},
          [&](RenderVariant& variant) { variant.settings.samples = samples; });
    }
  }

  void add_depth_variants() {
    if (is_fixed(Knob::kDepth)) return;
    for (const DepthFormat format : {DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                                     DepthFormat::kUnorm24, DepthFormat::kUnorm16}) {
      if (format == base_.settings.depth) continue;
      add(Knob::kDepth, {"--depth", std::string(name_of(format))},
          [&](RenderVariant& variant) { variant.settings.depth = format; });
    }
  }

  void add_level_variants() {
    if (asked_.levels.empty()) {
      found_.skipped.push_back({Knob::kLevel, "the scene has only one level of detail"});
      return;
    }
    for (const int level : asked_.levels) {
      add(Knob::kLevel, {}, [&](RenderVariant& variant) { variant.level = level; });
    }
  }

  void add_engine_variants() {
    for (const Target target : available_targets()) {
      if (target == base_.tile.target) continue;
      add(Knob::kEngine, {"--target", std::string(name_of(target))},
          [&](RenderVariant& variant) { variant.tile.target = target; });
    }
    add(Knob::kEngine, {"--no-plan"}, [](RenderVariant& variant) { variant.tile.plan = false; });
    if (!asked_.cull_stage_fixed) {
      add(Knob::kEngine, {"--cull-stage", "object"},
          [](RenderVariant& variant) { variant.settings.cull_stage = CullStage::kObject; });
    }
    add(Knob::kEngine, {"--engine", "staged"},
        [](RenderVariant& variant) { variant.engine = EngineKind::kStaged; });
    for (int threads = 2; threads <= asked_.threads; threads *= 2) {
      add(Knob::kEngine, {"--threads", fmt::to_string(threads)},
          [&](RenderVariant& variant) { variant.tile.threads = threads; });
    }
  }

  const Scene& scene_;
  const VariantRequest& asked_;
  RenderVariant base_;
  RenderVariants found_;
};

// Combines two variants into one that has the changes of both.
RenderVariant combine(RenderVariant a, const RenderVariant& b) {
  if (a.knob == Knob::kNone) return b;
  a.options.insert(a.options.end(), b.options.begin(), b.options.end());
  switch (b.knob) {
    case Knob::kShading:
      a.settings.shading = b.settings.shading;
      break;
    case Knob::kFilter:
      a.filter = b.filter;
      break;
    default:
      a.settings.samples = b.settings.samples;
  }
  a.knob = Knob::kSeveral;
  return a;
}

}  // namespace

std::string_view name_of(Knob knob) {
  constexpr std::string_view kNames[] = {"none",  "shading", "filter", "samples",
                                         "depth", "level",   "engine", "several"};
  return kNames[std::size_t(knob)];
}

std::string name_of(const RenderVariant& variant) {
  if (variant.level) return fmt::format("level {}", *variant.level);
  return variant.options.empty() ? "as asked" : fmt::format("{}", fmt::join(variant.options, " "));
}

RenderVariants single_knob_variants(const Scene& scene, const VariantRequest& asked) {
  return VariantCollector(scene, asked).all();
}

std::vector<RenderVariant> combined_variants(const std::vector<RenderVariant>& turns) {
  std::vector<RenderVariant> all{turns.front()};
  for (const Knob knob : {Knob::kShading, Knob::kFilter, Knob::kSamples}) {
    const std::size_t before = all.size();
    for (const RenderVariant& turn : turns) {
      if (turn.knob != knob) continue;
      for (std::size_t i = 0; i < before; ++i) all.push_back(combine(all[i], turn));
    }
  }
  std::erase_if(all, [](const RenderVariant& variant) { return variant.knob != Knob::kSeveral; });
  return all;
}

}  // namespace glassbox::study
