#include <glassbox/render/trace/picture_bounds.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include <glassbox/base/elementary.h>
#include <glassbox/raster/color_bounds.h>
#include <glassbox/render/staged/vertex_stage.h>
#include <glassbox/render/trace/vertex_bounds.h>

namespace glassbox {
namespace {

using bounded::Bounded;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRoundUp = 1 + 0x1p-40;
constexpr double kPixel = kSubpixels;

// Converts a bound to float, rounded up.
float as_float(double bound) {
  const float nearest = float(bound);
  return double(nearest) < bound ? std::nextafter(nearest, std::numeric_limits<float>::max())
                                 : nearest;
}

// Returns which corner of the triangle the vertex is; nothing if clipping made the vertex.
std::optional<std::uint32_t> corner_of(const TracedVertex& vertex) {
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (vertex.clip.weights[k] == 1) return k;
  }
  return {};
}

double largest_of(const std::array<double, 2>& bounds) {
  return std::isnan(bounds[0]) || std::isnan(bounds[1]) ? kInfinity
                                                        : std::max(bounds[0], bounds[1]);
}

BoundPlace place_of(const TracedFragment& fragment) {
  const FragmentSource& source = fragment.source;
  BoundPlace place{source.number, {}, fragment.fragment.x, fragment.fragment.y};
  if (!source.is_triangle) place.line = source.line;
  return place;
}

// Returns the error that storing a depth in the buffer's format adds.
double rounding_of_format(DepthFormat format, float depth, std::uint32_t code) {
  switch (format) {
    case DepthFormat::kFloat32:
    case DepthFormat::kFloat32Reversed:
      return std::abs(double(depth) - std::clamp(double(depth), 0.0, 1.0));
    case DepthFormat::kUnorm24:
    case DepthFormat::kUnorm16:
      break;
  }
  return std::abs(double(depth) - double(code) / unorm_depth_steps(format)) * kRoundUp;
}

double largest_bound(std::span<const Bounded> numbers) {
  double largest = 0;
  for (const Bounded& number : numbers) largest = std::max(largest, number.bound);
  return largest;
}

// Whether there is a normal. Lines and points may have none, and are then not lit.
bool is_there(const std::array<Bounded, 3>& normal) {
  return std::ranges::any_of(normal, [](const Bounded& n) { return n.value != 0 || n.bound != 0; });
}

// Returns a bound of |error| / |normal|. Higher orders are not neglected: the divisor is the length
// of the normal minus its error.
double share_of_length(const std::array<Bounded, 3>& normal) {
  double squared = 0, error = 0;
  for (const Bounded& n : normal) {
    squared += double(n.value) * double(n.value);
    error += n.bound * n.bound;
  }
  const double length = std::sqrt(squared), off = std::sqrt(error);
  return length > off ? off / (length - off) * kRoundUp : kInfinity;
}

}  // namespace

// ---- summaries ----

void BoundSummary::add(double bound, const BoundPlace& place) {
  ++count_;
  if (!std::isfinite(bound)) {
    ++unbounded_;
    return;
  }
  ++bins_[std::bit_cast<std::uint32_t>(as_float(bound)) >> kShift];
  if (bound < largest_ || (bound == largest_ && count_ - unbounded_ > 1)) return;
  largest_ = bound;
  place_ = place;
}

double BoundSummary::typical() const {
  std::uint64_t below = 0;
  for (std::size_t bin = 0; bin < bins_.size(); ++bin) {
    below += bins_[bin];
    if (bins_[bin] == 0 || 2 * below < count_) continue;
    // Bin 0 contains only 0 and subnormal bounds.
    const std::uint32_t last = std::uint32_t((bin + 1) << kShift) - 1;
    return bin == 0 ? 0 : std::min(largest_, double(std::bit_cast<float>(last)));
  }
  return count_ == 0 ? 0 : kInfinity;
}

// ---- a run ----

PictureBounds::PictureBounds(const Scene& scene, const View& view, const RenderSettings& settings)
    : view_(view),
      settings_(settings),
      prepared_(prepare_scene(scene, settings.transfer)),
      list_(make_draw_list(scene, prepared_, view)),
      bounds_(view),
      pixels_(int(std::abs(view.viewport.right - view.viewport.left)),
              int(std::abs(view.viewport.bottom - view.viewport.top))) {
  for (const Draw& draw : list_.draws) draws_[draw.instance] = &draw;
}

void PictureBounds::draw(const TracedDraw& draw) {
  bounds_.draw(draw);
}

void PictureBounds::triangle(const TracedTriangle& triangle) {
  const BoundsOfRun::KnownTriangle& known = bounds_.triangle(triangle);
  const bool is_seen = std::ranges::any_of(
      triangle.pieces, [](const TracedPiece& piece) { return piece.setup && !piece.culled; });
  if (!is_seen) return;
  for (std::size_t i = 0; i < triangle.polygon.size(); ++i) {
    const TracedVertex& vertex = triangle.polygon[i];
    const VertexBounds& bounds = known.bounds.polygon[i];
    const BoundPlace place{triangle.number, corner_of(vertex), -1, -1, {}};
    const double snapped = snapped_bound(vertex, bounds);
    if (place.corner) {
      errors_.screen.add(largest_of({bounds.screen.x, bounds.screen.y}), place);
      errors_.snapped.add(snapped, place);
    } else {
      errors_.cut.add(snapped, place);
    }
    errors_.vertices_snapped_elsewhere += !bounds.snap_x.stable || !bounds.snap_y.stable;
  }
}

template <class MayMiss, class Colors>
void PictureBounds::follow(const TracedFragment& fragment, const FragmentBounds& bounds,
                           Pixel& pixel, const MayMiss& may_miss, const Colors& colors_of) {
  const bool as_deep = add_depth(fragment, bounds, pixel);
  if (fragment.result == FragmentResult::kHidden) return;
  const bool near_edge = may_miss();
  errors_.fragments_near_edge += near_edge;
  // A fragment that is certainly in front and certainly covers the pixel ends all earlier doubts
  // about what the pixel shows.
  if (fragment.result == FragmentResult::kWritten) pixel.is_undecided = as_deep;
  pixel.is_undecided |= near_edge;
  if (settings_.show != Show::kColor) return;
  const ColorBounds colors = colors_of();
  add_attributes(fragment, colors);
  const Material& material = *draws_.at(fragment.instance)->material;
  if (material.alpha_mode == AlphaMode::kMask) {
    const Bounded& alpha = colors.surface[3];
    const bool at_cutoff =
        std::abs(double(alpha.value) - double(material.alpha_cutoff)) <= alpha.bound;
    errors_.fragments_at_cutoff += at_cutoff;
    pixel.is_undecided |= at_cutoff;
  }
  if (fragment.result != FragmentResult::kDiscarded) store(fragment, colors, pixel);
}

void PictureBounds::fragment(const TracedFragment& fragment) {
  Pixel& pixel = pixels_.at(fragment.fragment.x, fragment.fragment.y);
  const BoundsOfRun::KnownTriangle* const known = bounds_.of_fragment(fragment);
  if (known == nullptr) return add_line_fragment(fragment, pixel);
  const FragmentBounds bounds = bounds_of(*known, fragment);
  follow(
      fragment, bounds, pixel, [&] { return is_near_edge(fragment, *known); },
      [&] { return piece_of(fragment, *known).at(fragment, bounds); });
}

void PictureBounds::add_line_fragment(const TracedFragment& fragment, Pixel& pixel) {
  ++errors_.fragments_of_lines_and_points;
  const LineBounds& line = line_of(fragment);
  const FragmentBounds bounds = line.of_fragment(fragment.fragment);
  follow(
      fragment, bounds, pixel, [&] { return line.may_miss(fragment.fragment); },
      [&] { return line.colors(fragment, bounds); });
}

// Returns the bounds of the fragment's line. When the line's first fragment comes, the errors of
// its ends are added; those of an edge have been added with its triangle.
const LineBounds& PictureBounds::line_of(const TracedFragment& fragment) {
  const FragmentSource& source = fragment.source;
  const bool is_the_same = line_ && line_instance_ == fragment.instance &&
                           line_source_.number == source.number &&
                           line_source_.line == source.line && line_source_.edge == source.edge;
  if (is_the_same) return *line_;
  const bool is_edge = source.line == LineKind::kEdge;
  const auto& [traced, draw_bounds] = bounds_.of_instance(fragment.instance);
  const CornerStage stage{*draws_.at(fragment.instance), draw_bounds, list_.lighting, settings_};
  line_.emplace(stage, bounds_.trace(), traced, source,
                is_edge ? bounds_.of_triangle(source.number) : nullptr);
  line_source_ = source;
  line_instance_ = fragment.instance;
  if (is_edge) return *line_;
  for (std::uint32_t k = 0; k < line_->ends().size(); ++k) {
    const auto& [vertex, bounds] = line_->ends()[k];
    const bool is_cut = !corner_of(vertex);
    const BoundPlace place{source.number, is_cut ? std::nullopt : std::optional(k), -1, -1,
                           source.line};
    const double snapped = snapped_bound(vertex, bounds);
    if (is_cut) {
      errors_.cut.add(snapped, place);
    } else {
      errors_.screen.add(largest_of({bounds.screen.x, bounds.screen.y}), place);
      errors_.snapped.add(snapped, place);
    }
    errors_.vertices_snapped_elsewhere += !bounds.snap_x.stable || !bounds.snap_y.stable;
  }
  return *line_;
}

bool PictureBounds::add_depth(const TracedFragment& fragment, const FragmentBounds& bounds,
                              Pixel& pixel) {
  const Fragment& place = fragment.fragment;
  const BoundPlace where = place_of(fragment);
  const double stored =
      bounds.depth + rounding_of_format(settings_.depth, place.depth, fragment.code);
  errors_.depth.add(stored, where);
  if (view_.perspective) {
    const double distance = 1 / double(place.inverse_w);
    const double first_order = distance_of_depth(distance, view_.near, view_.far, stored);
    errors_.distance.add(share_of_distance(first_order / distance), where);
  }
  // The depth test compares codes. If the codes are equal, or the bounds of the depths overlap, the
  // exact depths may be in the other order; then, exactly, the other depth may be the one that is
  // stored.
  const double apart = std::abs(double(place.depth) - double(pixel.depth));
  const bool as_deep = apart <= stored + double(pixel.depth_bound);
  errors_.fragments_as_deep += as_deep;
  pixel.is_undecided |= as_deep;
  const double doubt = as_deep ? apart + std::max(stored, double(pixel.depth_bound)) : 0;
  if (fragment.result == FragmentResult::kWritten) {
    pixel.depth = place.depth;
    pixel.depth_bound = as_float(std::max(stored, doubt));
  } else {
    pixel.depth_bound = std::max(pixel.depth_bound, as_float(doubt));
  }
  return as_deep;
}

// Whether the fragment is so near to an edge that the exact triangle may not cover it. The snapped
// vertices are within s (`moved`) pixels of the exact ones along x and along y. So each point of an
// edge is within sqrt 2 s of the exact edge.
bool PictureBounds::is_near_edge(const TracedFragment& fragment,
                                 const BoundsOfRun::KnownTriangle& known) const {
  const TracedPiece& piece = known.triangle->pieces[fragment.source.piece];
  double moved = 0;
  for (const std::size_t i : piece.polygon) {
    moved = std::max(moved, snapped_bound(known.triangle->polygon[i], known.bounds.polygon[i]));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeFunction& edge = piece.setup->edges[k];
    // a and b are in 1/256 pixel, the edge function is in 1/65536 square pixel.
    const double length = hypotenuse(double(edge.a), double(edge.b));
    const double away = double(fragment.coverage.edges[k]) / (length * kPixel);
    if (!(away > std::sqrt(2.0) * moved * kRoundUp)) return true;
  }
  return false;
}

const PieceColors& PictureBounds::piece_of(const TracedFragment& fragment,
                                           const BoundsOfRun::KnownTriangle& known) {
  const FragmentSource& source = fragment.source;
  if (!piece_ || source.number != piece_triangle_ || source.piece != piece_number_) {
    piece_.emplace(*draws_.at(fragment.instance), bounds_.of_instance(fragment.instance).bounds,
                   list_.lighting, settings_, known, source.piece);
    piece_triangle_ = source.number;
    piece_number_ = source.piece;
  }
  return *piece_;
}

void PictureBounds::add_attributes(const TracedFragment& fragment, const ColorBounds& colors) {
  const Draw& draw = *draws_.at(fragment.instance);
  const BoundPlace where = place_of(fragment);
  if (draw.texture != nullptr) {
    const MipChain& texture = draw.texture->get();
    errors_.texcoord.add(largest_of({colors.at.texcoord[0].bound * texture.width,
                                     colors.at.texcoord[1].bound * texture.height}),
                         where);
    errors_.texture.add(*colors.sample, where);
  }
  if (needs_normals(draw, settings_) && is_there(colors.at.normal)) {
    errors_.normal.add(share_of_length(colors.at.normal), where);
  }
  if (fragment.result != FragmentResult::kDiscarded)
    errors_.light.add(largest_bound(colors.light), where);
}

// Adds the bounds of the bytes that a fragment stores. Blending reads the stored colour, which has
// an error of its own.
void PictureBounds::store(const TracedFragment& fragment, const ColorBounds& colors, Pixel& pixel) {
  const bool blended = fragment.result == FragmentResult::kBlended;
  const Bounded alpha = bounded::clamped(colors.surface[3], Bounded(0.0f), Bounded(1.0f));
  const std::array<std::uint8_t, 4> before{fragment.before.r, fragment.before.g, fragment.before.b,
                                           fragment.before.a};
  const std::array<std::uint8_t, 4> after{fragment.after.r, fragment.after.g, fragment.after.b,
                                          fragment.after.a};
  const ColorMask& mask = settings_.mask;
  const std::array<bool, 4> wanted{mask.r, mask.g, mask.b, mask.a};
  double largest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!wanted[i]) continue;
    const Transfer transfer = i == 3 ? Transfer::kNone : settings_.transfer;
    Bounded light = i == 3 ? Bounded(1.0f) : colors.light[i];
    if (blended) {
      light = bounded::blended_channel(
          light, alpha, light_of_stored(transfer, before[i], double(pixel.bytes_off[i])));
    }
    const double bound = stored_bound(transfer, after[i], light);
    pixel.bytes_off[i] =
        light.is_bounded() ? as_float(bound) : std::numeric_limits<float>::infinity();
    largest = std::max(largest, double(pixel.bytes_off[i]));
  }
  const BoundPlace where = place_of(fragment);
  errors_.stored.add(largest, where);
  pixel.number = where.number;
  pixel.line = where.line;
  pixel.is_drawn = true;
}

PictureErrors PictureBounds::finish() {
  for (int y = 0; y < pixels_.height; ++y) {
    for (int x = 0; x < pixels_.width; ++x) {
      const Pixel& pixel = pixels_.at(x, y);
      errors_.pixels_undecided += pixel.is_undecided;
      if (!pixel.is_drawn) continue;
      const double largest = *std::ranges::max_element(pixel.bytes_off);
      errors_.pixels_unbounded += !std::isfinite(largest);
      errors_.picture.add(largest, {pixel.number, {}, x, y, pixel.line});
    }
  }
  return std::move(errors_);
}

PictureErrors picture_errors(const Scene& scene, const View& view, const RenderSettings& settings) {
  PictureBounds bounds(scene, view, with_one_sample(settings));
  TraceFilter everything;
  everything.max_bytes = std::numeric_limits<std::uint64_t>::max();
  trace(scene, view, settings, everything, bounds);
  return bounds.finish();
}

}  // namespace glassbox
