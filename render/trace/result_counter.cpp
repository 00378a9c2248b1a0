#include <glassbox/render/trace/result_counter.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <limits>
#include <utility>

#include <glassbox/raster/blend.h>
#include <glassbox/render/engine/distance.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/trace/coverage_miss.h>

namespace glassbox {

namespace {

std::optional<std::uint32_t> number_or_none(std::uint32_t number) {
  if (number == kNone) return std::nullopt;
  return number;
}

std::vector<Occluder> most_first(const std::unordered_map<std::uint32_t, std::uint32_t>& counts) {
  std::vector<Occluder> occluders;
  for (const auto& [number, pixels] : counts) occluders.push_back({number_or_none(number), pixels});
  std::sort(occluders.begin(), occluders.end(), [](const Occluder& a, const Occluder& b) {
    return a.pixels != b.pixels ? a.pixels > b.pixels : a.number < b.number;
  });
  return occluders;
}

}  // namespace

// ---- results ----

std::optional<std::size_t> first_outside_plane(const TracedTriangle& triangle,
                                               std::span<const ClipPlane> planes) {
  Outcode all = ~Outcode{0};
  for (const TracedCorner& corner : triangle.corners) all &= outcode(corner.clip, planes);
  if (all == 0) return std::nullopt;
  return std::size_t(std::countr_zero(all));
}

TriangleResult result_before_fragments(const TracedTriangle& triangle,
                                       std::span<const ClipPlane> planes,
                                       const RenderSettings& settings, const PixelRect& picture) {
  if (triangle.pieces.empty()) {
    std::array<Outcode, 3> codes;
    bool behind = true;
    for (std::size_t k = 0; k < 3; ++k) {
      codes[k] = outcode(triangle.corners[k].clip, planes);
      behind = behind && triangle.corners[k].clip.w <= 0;
    }
    if (((codes[0] | codes[1] | codes[2]) & kNotFinite) != 0) return TriangleResult::kNotFinite;
    if (behind) return TriangleResult::kBehindEye;
    return (codes[0] & codes[1] & codes[2]) != 0 ? TriangleResult::kOutsidePlane
                                                 : TriangleResult::kClippedAway;
  }
  bool any_area = false, any_kept = false, any_inside = false;
  for (const TracedPiece& piece : triangle.pieces) {
    any_area = any_area || piece.setup.has_value();
    if (!piece.setup || piece.culled) continue;
    any_kept = true;
    any_inside = any_inside || !outside_distances(piece, picture);
  }
  if (!any_area) return TriangleResult::kNoScreenArea;
  if (!any_kept) return TriangleResult::kTurnedAway;
  if (settings.wireframe) return TriangleResult::kLines;
  return any_inside ? TriangleResult::kBetweenCentres : TriangleResult::kOutsidePicture;
}

TriangleResult result_of(const TriangleFragmentCounts& t, TriangleResult before) {
  if (t.covered == 0) return before;
  if (t.visible > 0) {
    if (t.unchanged == t.visible) return TriangleResult::kUnchanged;
    return t.visible == t.covered ? TriangleResult::kVisible : TriangleResult::kPartlyVisible;
  }
  const std::pair<std::uint32_t, TriangleResult> losses[] = {
      {t.hidden, TriangleResult::kHidden},
      {t.discarded, TriangleResult::kDiscarded},
      {t.masked, TriangleResult::kMasked},
      {t.overwritten, TriangleResult::kOverwritten}};
  return std::max_element(std::begin(losses), std::end(losses),
                          [](const auto& a, const auto& b) { return a.first < b.first; })
      ->second;
}

// ---- triangles ----

ResultCounter::ResultCounter(const View& view, const RenderSettings& settings,
                             std::optional<std::uint32_t> subject)
    : view_(view),
      settings_(settings),
      subject_(subject),
      planes_(render_planes(view)),
      width_(int(view.viewport.width())),
      height_(int(view.viewport.height())),
      nearest_(std::size_t(width_) * std::size_t(height_), Nearest{kNone, 0}),
      tops_(nearest_.size(), kNone),
      free_(kNone) {}

void ResultCounter::draw(const Draw& draw) {
  draw_ = &draw;
  const std::size_t end = std::size_t(draw.first_number) + draw.triangulation->numbered;
  if (entries_.size() < end) entries_.resize(end);
}

void ResultCounter::clipped(const PrimitiveStage&, const Triangle&,
                            const std::array<ClipVertex, 3>& corners, ClipPolygon&) {
  for (std::size_t k = 0; k < 3; ++k) current_.corners[k].clip = corners[k].position;
  current_.pieces.clear();
}

void ResultCounter::set_up(std::uint32_t, const std::array<ScreenVertex, 3>& vertices,
                           std::optional<TriangleSetup>& setup) {
  TracedPiece& piece = current_.pieces.emplace_back();
  piece.vertices = vertices;
  piece.setup = setup;
}

void ResultCounter::facing_tested(const TriangleSetup&, bool front, bool& culled) {
  current_.pieces.back().front = front;
  current_.pieces.back().culled = culled;
}

void ResultCounter::triangle_finished(const Triangle& triangle) {
  Entry& entry = entries_[draw_->first_number + triangle.number];
  entry.before = result_before_fragments(current_, planes_, settings_, {0, 0, width_, height_});
  if (entry.before != TriangleResult::kOutsidePlane) return;
  entry.plane = std::uint8_t(first_outside_plane(current_, planes_).value_or(0));
}

// ---- fragments ----

void ResultCounter::compared(const FragmentSource& source, const Fragment&, std::uint32_t code,
                             std::uint32_t stored, bool&) {
  code_ = code;
  stored_ = stored;
  if (source.is_triangle) ++entries_[source.number].fragments.covered;
}

void ResultCounter::textured(const Varyings&, Rgba& surface) {
  alpha_ = surface.a;
}

void ResultCounter::encoded(const Fragment&, const Rgba8& before, Rgba8& after) {
  before_ = before;
  after_ = after;
}

void ResultCounter::fragment_finished(const FragmentSource& source, const Fragment& fragment,
                                      FragmentResult result) {
  switch (result) {
    case FragmentResult::kHidden:
      return count_hidden(source, fragment);
    case FragmentResult::kDiscarded:
      return count_discarded(source, fragment);
    case FragmentResult::kWritten:
    case FragmentResult::kBlended:
      return count_written(source, fragment, result);
  }
}

void ResultCounter::count_hidden(const FragmentSource& source, const Fragment& fragment) {
  if (!source.is_triangle) return;
  ++entries_[source.number].fragments.hidden;
  if (source.number != subject_) return;
  const Nearest& by = nearest_[pixel_of(fragment)];
  ++hidden_by_[by.number];
  auto& closest = details_.closest_hidden;
  if (closest && closest->code - closest->stored <= code_ - stored_) return;
  closest = FragmentDetails::Hidden{
      .x = fragment.x,
      .y = fragment.y,
      .code = code_,
      .stored = stored_,
      .distance = distance_along_gaze(view_, fragment.depth, fragment.inverse_w),
      .stored_distance = by.distance,
      .by = number_or_none(by.number)};
}

void ResultCounter::count_discarded(const FragmentSource& source, const Fragment& fragment) {
  if (!source.is_triangle) return;
  ++entries_[source.number].fragments.discarded;
  highest_discarded_alpha_ = std::max(highest_discarded_alpha_, alpha_);
  if (source.number != subject_) return;
  auto& closest = details_.closest_discarded;
  if (closest && closest->alpha >= alpha_) return;
  closest = FragmentDetails::Discarded{
      .x = fragment.x, .y = fragment.y, .alpha = alpha_, .cutoff = draw_->material->alpha_cutoff};
}

void ResultCounter::count_written(const FragmentSource& source, const Fragment& fragment,
                                  FragmentResult result) {
  const std::size_t pixel = pixel_of(fragment);
  const std::uint32_t number = source.is_triangle ? source.number : kNone;
  if (result == FragmentResult::kWritten) {
    nearest_[pixel] = {number, distance_along_gaze(view_, fragment.depth, fragment.inverse_w)};
  }
  constexpr float kHalfAByte = 0.5f / 255;
  if (number != kNone && result == FragmentResult::kBlended && alpha_ < kHalfAByte) {
    ++entries_[number].fragments.transparent;
  }
  const ColorMask& mask = settings_.mask;
  if (!mask.r && !mask.g && !mask.b && !mask.a) {
    if (number != kNone) ++entries_[number].fragments.masked;
    return;
  }
  const bool hides_what_was_there = result == FragmentResult::kWritten || alpha_ >= 1;
  if (hides_what_was_there) cover_layers(pixel, number);
  Rgba8 stored = before_;
  write_masked(mask, after_, stored);
  add_layer(pixel, number, stored == before_);
  if (number == subject_ && stored == before_ && !details_.unchanged) {
    details_.unchanged = FragmentDetails::Unchanged{.x = fragment.x,
                                                    .y = fragment.y,
                                                    .blended = result == FragmentResult::kBlended,
                                                    .alpha = alpha_,
                                                    .bytes = before_};
  }
}

// ---- layers ----

void ResultCounter::add_layer(std::size_t pixel, std::uint32_t number, bool unchanged) {
  std::uint32_t slot = free_;
  if (slot == kNone) {
    slot = std::uint32_t(layers_.size());
    layers_.emplace_back();
  } else {
    free_ = layers_[slot].next;
  }
  layers_[slot] = {number, tops_[pixel], unchanged};
  tops_[pixel] = slot;
}

void ResultCounter::cover_layers(std::size_t pixel, std::uint32_t by) {
  while (tops_[pixel] != kNone) {
    const std::uint32_t slot = tops_[pixel];
    const std::uint32_t number = layers_[slot].number;
    if (number != kNone) ++entries_[number].fragments.overwritten;
    if (number == subject_) {
      ++overwritten_by_[by];
      details_.overwritten_at = {int(pixel) % width_, int(pixel) / width_};
    }
    tops_[pixel] = layers_[slot].next;
    layers_[slot].next = free_;
    free_ = slot;
  }
}

void ResultCounter::finish() {
  for (std::size_t pixel = 0; pixel < tops_.size(); ++pixel) {
    bool shown = false;
    for (std::uint32_t slot = tops_[pixel]; slot != kNone; slot = layers_[slot].next) {
      const Layer& layer = layers_[slot];
      shown = shown || !layer.unchanged;
      if (layer.number == kNone) continue;
      TriangleFragmentCounts& tally = entries_[layer.number].fragments;
      ++tally.visible;
      tally.unchanged += layer.unchanged ? 1 : 0;
      tally.under_translucent += slot != tops_[pixel] ? 1u : 0u;
    }
    shown_pixels_ += shown ? 1u : 0u;
  }
  details_.hidden_by = most_first(hidden_by_);
  details_.overwritten_by = most_first(overwritten_by_);
  if (subject_) find_visible();
}

bool ResultCounter::shows_subject(int x, int y) const {
  std::uint32_t slot = tops_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
  while (slot != kNone && layers_[slot].number != subject_) slot = layers_[slot].next;
  return slot != kNone;
}

void ResultCounter::find_visible() {
  PixelRect box{width_, height_, 0, 0};
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      if (!shows_subject(x, y)) continue;
      box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x + 1),
             std::max(box.y1, y + 1)};
    }
  }
  if (box.empty()) return;
  details_.visible_box = box;
  int least = std::numeric_limits<int>::max();  // twice |dx| + |dy| from the box's middle
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      const int away =
          std::abs(2 * x + 1 - box.x0 - box.x1) + std::abs(2 * y + 1 - box.y0 - box.y1);
      if (away >= least || !shows_subject(x, y)) continue;
      least = away;
      details_.example = {x, y};
    }
  }
}

}  // namespace glassbox
