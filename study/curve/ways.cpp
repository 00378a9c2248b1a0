#include "study/curve/ways.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <glassbox/render/engine/names.h>

namespace glassbox::study {

namespace {

// Collects the ways of one scene in which a single knob is turned.
class Turns {
public:
  Turns(const Scene& scene, const WaysAsked& asked) : scene_(scene), asked_(asked) {
    base_.settings = asked.settings;
    base_.filter = asked.filter;
    base_.tile = asked.tile;
    base_.tile.threads = 1;
    found_.all.push_back(base_);
  }

  Ways all() && {
    turn_shading();
    turn_filter();
    turn_samples();
    turn_depth();
    turn_level();
    turn_engine();
    return std::move(found_);
  }

private:
  template <class Change>
  void add(Knob knob, std::vector<std::string> options, Change change) {
    Way way = base_;
    way.knob = knob;
    way.options = std::move(options);
    change(way);
    found_.all.push_back(std::move(way));
  }

  bool is_held(Knob knob) {
    if (!asked_.held.contains(knob)) return false;
    found_.left_out.push_back({knob, "you gave its value"});
    return true;
  }

  void turn_shading() {
    if (is_held(Knob::kShading)) return;
    for (const Shading shading :
         {Shading::kUnlit, Shading::kFlat, Shading::kGouraud, Shading::kPhong}) {
      if (shading == base_.settings.shading) continue;
      add(Knob::kShading, {"--shade", std::string(name_of(shading))},
          [&](Way& way) { way.settings.shading = shading; });
    }
  }

  // Whether the samplers of all textures already have this filter.
  bool is_written(TextureFilter filter) const {
    return std::ranges::all_of(scene_.textures, [&](const Texture& texture) {
      return with_filter(texture.sampler, filter) == texture.sampler;
    });
  }

  void turn_filter() {
    if (scene_.textures.empty()) {
      found_.left_out.push_back({Knob::kFilter, "the scene has no texture"});
      return;
    }
    if (is_held(Knob::kFilter)) return;
    for (const TextureFilter filter : {TextureFilter::kNearest, TextureFilter::kBilinear,
                                       TextureFilter::kBilinearLevels, TextureFilter::kTrilinear}) {
      if (is_written(filter)) continue;
      add(Knob::kFilter, {"--filter", std::string(name_of(filter))},
          [&](Way& way) { way.filter = filter; });
    }
  }

  void turn_samples() {
    if (is_held(Knob::kSamples)) return;
    for (const int samples : {1, 2, 4, 8, 16}) {
      if (samples == base_.settings.samples) continue;
      add(Knob::kSamples, {"--samples", fmt::to_string(samples)},
          [&](Way& way) { way.settings.samples = samples; });
    }
  }

  void turn_depth() {
    if (is_held(Knob::kDepth)) return;
    for (const DepthFormat format : {DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                                     DepthFormat::kUnorm24, DepthFormat::kUnorm16}) {
      if (format == base_.settings.depth) continue;
      add(Knob::kDepth, {"--depth", std::string(name_of(format))},
          [&](Way& way) { way.settings.depth = format; });
    }
  }

  void turn_level() {
    if (asked_.levels.empty()) {
      found_.left_out.push_back({Knob::kLevel, "the scene has only one level of detail"});
      return;
    }
    for (const int level : asked_.levels) {
      add(Knob::kLevel, {}, [&](Way& way) { way.level = level; });
    }
  }

  void turn_engine() {
    for (const Target target : available_targets()) {
      if (target == base_.tile.target) continue;
      add(Knob::kEngine, {"--target", std::string(name_of(target))},
          [&](Way& way) { way.tile.target = target; });
    }
    add(Knob::kEngine, {"--no-plan"}, [](Way& way) { way.tile.plan = false; });
    if (!asked_.cull_stage_held) {
      add(Knob::kEngine, {"--cull-stage", "object"},
          [](Way& way) { way.settings.cull_stage = CullStage::kObject; });
    }
    add(Knob::kEngine, {"--engine", "staged"}, [](Way& way) { way.engine = EngineKind::kStaged; });
    for (int threads = 2; threads <= asked_.threads; threads *= 2) {
      add(Knob::kEngine, {"--threads", fmt::to_string(threads)},
          [&](Way& way) { way.tile.threads = threads; });
    }
  }

  const Scene& scene_;
  const WaysAsked& asked_;
  Way base_;
  Ways found_;
};

// Combines two ways into one that turns the knobs of both.
Way both(Way a, const Way& b) {
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

std::string name_of(const Way& way) {
  if (way.level) return fmt::format("level {}", *way.level);
  return way.options.empty() ? "as asked" : fmt::format("{}", fmt::join(way.options, " "));
}

Ways single_turns(const Scene& scene, const WaysAsked& asked) {
  return Turns(scene, asked).all();
}

std::vector<Way> combined_turns(const std::vector<Way>& turns) {
  std::vector<Way> all{turns.front()};
  for (const Knob knob : {Knob::kShading, Knob::kFilter, Knob::kSamples}) {
    const std::size_t before = all.size();
    for (const Way& turn : turns) {
      if (turn.knob != knob) continue;
      for (std::size_t i = 0; i < before; ++i) all.push_back(both(all[i], turn));
    }
  }
  std::erase_if(all, [](const Way& way) { return way.knob != Knob::kSeveral; });
  return all;
}

}  // namespace glassbox::study
