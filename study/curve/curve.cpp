#include "study/curve/curve.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "study/curve/renderer_cache.h"
#include "study/recommend/vertices.h"

#include <glassbox/images/write.h>
#include <glassbox/render/engine/setting_names.h>

namespace glassbox::study {

namespace {

class Measurement {
public:
  explicit Measurement(const CurveRequest& request)
      : request_(request), renderer_cache_(*request.scene, request.view, &request.at_levels) {}

  Result<Curve> run() && {
    RenderVariants variants = single_knob_variants(*request_.scene, request_.variants);
    if (const auto fits = check_memory(variants.all); request_.keep_pictures && !fits) {
      return tl::unexpected(fits.error());
    }
    if (const auto drawn = draw_reference(); !drawn) return tl::unexpected(drawn.error());
    curve_.skipped = std::move(variants.skipped);
    for (const RenderVariant& variant : variants.all) {
      if (const auto drawn = draw(variant); !drawn) return tl::unexpected(drawn.error());
    }
    if (request_.combine) {
      for (const RenderVariant& variant : combined_variants(visible_variants())) {
        if (const auto drawn = draw(variant); !drawn) return tl::unexpected(drawn.error());
      }
    }
    find_faults();
    if (const auto found = measure_geometry(); !found) return tl::unexpected(found.error());
    add_times();
    add_standings();
    return std::move(curve_);
  }

private:
  void report_phase(const std::string& what) const {
    if (request_.phase) request_.phase(what);
  }

  // Fails if the pictures would need too much memory in the case that every variant gives a
  // different one.
  Result<void> check_memory(const std::vector<RenderVariant>& variants) {
    const auto view = renderer_cache_.view_of(variants.front());
    if (!view) return tl::unexpected(view.error());
    const std::size_t most =
        variants.size() + (request_.combine ? combined_variants(variants).size() : 0);
    const Viewport& v = view->viewport;
    const double pixels = std::abs(v.right - v.left) * std::abs(v.bottom - v.top);
    const double bytes = double(most) * pixels * sizeof(Rgba8);
    if (bytes <= request_.most_bytes) return {};
    return fail(fmt::format("{} pictures", most),
                fmt::format("they may take {:.0f} MB, but only {:.0f} MB are available",
                            1e-6 * bytes, 1e-6 * request_.most_bytes),
                request_.combine
                    ? "leave --html out, or ask for fewer pixels (--size) or fewer ways (--quick)"
                    : "leave --html out, or ask for fewer pixels (--size)");
  }

  // The reference is drawn at the finest level of the scene; it is shaded per pixel unless the
  // caller asked for another shading.
  Result<void> draw_reference() {
    RenderSettings settings = request_.variants.settings;
    if (!request_.variants.fixed_knobs.contains(Knob::kShading)) settings.shading = Shading::kPhong;
    RenderVariant finest;
    finest.filter = request_.variants.filter;
    if (!request_.at_levels.empty() && request_.at_levels.rbegin()->first > request_.level)
      finest.level = request_.at_levels.rbegin()->first;
    const Scene& scene = renderer_cache_.scene_of(finest);
    report_phase("drawing the reference");
    auto drawn = reference_picture(scene, request_.view, settings);
    if (!drawn) return tl::unexpected(drawn.error());
    curve_.reference = std::move(drawn->image);
    curve_.reference_is = fmt::format(
        "{0} x {0} times as large with 16 samples a pixel, averaged in linear light; {1}, {2}{3}",
        drawn->factor, name_of(settings.shading), name_of(drawn->depth),
        finest.level ? fmt::format(", level {}", *finest.level) : "");
    return {};
  }

  Result<void> draw(const RenderVariant& variant) {
    const auto view = renderer_cache_.view_of(variant);
    if (!view && variant.knob == Knob::kNone) return tl::unexpected(view.error());
    if (!view) {
      curve_.skipped.push_back({variant.knob, name_of(variant) + ": " + view.error().cause});
      return {};
    }
    report_phase(fmt::format("drawing {} ({} drawn)", name_of(variant), curve_.points.size()));
    CurvePoint point;
    point.variant = variant;
    Image<Rgba8> picture = renderer_cache_.draw(variant);
    const auto number = number_of(picture);
    if (!number) return tl::unexpected(number.error());
    point.picture = *number;
    if (*number == errors_.size()) {
      errors_.push_back(picture_error(picture, curve_.reference));
      if (request_.keep_pictures) curve_.pictures.push_back(std::move(picture));
    }
    curve_.different = errors_.size();
    point.error = errors_[point.picture];
    curve_.points.push_back(std::move(point));
    return {};
  }

  // The index of an earlier picture with the same bytes; the next free index if there is none.
  Result<std::size_t> number_of(const Image<Rgba8>& picture) {
    if (request_.keep_pictures) {
      return std::size_t(std::ranges::find(curve_.pictures, picture) - curve_.pictures.begin());
    }
    // PNG is lossless, so two pictures of one size are the same if their packed bytes are the same.
    auto packed = encode_png(picture);
    if (!packed) return tl::unexpected(packed.error());
    const auto same = std::size_t(std::ranges::find(packed_, *packed) - packed_.begin());
    if (same == packed_.size()) packed_.push_back(std::move(*packed));
    return same;
  }

  // Returns the variants whose picture differs from that of the first variant: only these are worth
  // combining. A knob that never changes a byte is listed as skipped.
  std::vector<RenderVariant> visible_variants() {
    std::vector<RenderVariant> turns;
    std::set<Knob> shown;
    for (const CurvePoint& point : curve_.points) {
      if (point.picture == 0 && point.variant.knob != Knob::kNone) continue;
      turns.push_back(point.variant);
      shown.insert(point.variant.knob);
    }
    for (const Knob knob : {Knob::kShading, Knob::kFilter, Knob::kSamples}) {
      const bool tried = std::ranges::any_of(
          curve_.points, [&](const CurvePoint& point) { return point.variant.knob == knob; });
      if (tried && !shown.contains(knob)) {
        curve_.skipped.push_back(
            {knob,
             "this option changes no byte of the picture, so it is not combined with others"});
      }
    }
    return turns;
  }

  void find_faults() {
    for (const CurvePoint& point : curve_.points) {
      if (point.variant.knob == Knob::kEngine && point.picture != 0)
        curve_.faults.push_back(name_of(point.variant));
    }
  }

  Result<void> measure_geometry() {
    report_phase("computing vertices with 50 digits");
    std::map<std::pair<int, DepthFormat>, double> errors;  // keys: level and format
    for (CurvePoint& point : curve_.points) {
      const DepthFormat format = point.variant.settings.depth;
      const auto key = std::pair(point.variant.level.value_or(0), format);
      if (!errors.contains(key)) {
        const Scene& scene =
            point.variant.level ? renderer_cache_.scene_of(point.variant) : *request_.scene;
        const auto vertices = SceneVertices::sample(scene, *renderer_cache_.view_of(point.variant));
        if (!vertices) return tl::unexpected(vertices.error());
        errors[key] = vertices->depth_error(format);
        if (point.variant.knob == Knob::kNone) {
          curve_.position_error = vertices->position_error();
          curve_.vertices = vertices->count();
        }
      }
      point.depth_error = errors[key];
    }
    return {};
  }

  void add_times() {
    report_phase(fmt::format("timing {} ways", curve_.points.size()));
    std::vector<RenderVariant> variants;
    for (const CurvePoint& point : curve_.points) variants.push_back(point.variant);
    const std::vector<Timed> times = frame_times(renderer_cache_, variants, request_.repetitions);
    for (std::size_t i = 0; i < times.size(); ++i) {
      curve_.points[i].ns = times[i].ns;
      curve_.points[i].disturbed = times[i].disturbed;
    }
    curve_.repetitions = request_.repetitions;
  }

  void add_standings() {
    std::vector<CurvePoint*> rivals;
    std::vector<ErrorAndTime> errors_and_times;
    for (CurvePoint& point : curve_.points) {
      if (point.variant.threads() > 1) continue;
      rivals.push_back(&point);
      errors_and_times.push_back({point.error.rms, point.ns});
    }
    const std::vector<Standing> found = standings(errors_and_times);
    for (std::size_t i = 0; i < found.size(); ++i) rivals[i]->standing = found[i];
  }

  const CurveRequest& request_;
  RendererCache renderer_cache_;
  Curve curve_;
  std::vector<PictureError> errors_;  // one for each different picture
  // The different pictures as PNG, if they are not kept uncompressed.
  std::vector<std::vector<std::byte>> packed_;
};

}  // namespace

Result<Curve> measure_curve(const CurveRequest& request) {
  return Measurement(request).run();
}

}  // namespace glassbox::study
