// Classes that say what happens to the fragments that pass the depth test: the tile keeps them all
// (Opaque), or only some by their alpha (Masked) or depth (Behind), or they are blended over the
// picture (Blended). Masked and Blended compute alpha in functions that are not inlined. Otherwise
// the shading code would be compiled many times: the loop over triangles is compiled for each of
// these classes, for each depth format, and for tiles within the screen or not.

#if defined(GLASSBOX_ALPHA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_ALPHA_INL_H_
#undef GLASSBOX_ALPHA_INL_H_
#else
#define GLASSBOX_ALPHA_INL_H_
#endif

#include <cstring>
#include <type_traits>

#include <glassbox/raster/lanes/shade-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Returns one lane's number, in all lanes.
HWY_INLINE Floats broadcast_lane(Floats x, std::size_t lane) {
  HWY_ALIGN float lanes[kLanes];
  store(x, lanes);
  return lanes[lane];
}

// The tile keeps all fragments.
struct Opaque {
  static constexpr bool kKeepsAll = true, kIsBehind = false;
};

// The counter of the fragments that are discarded, or blended, instead of being written to the
// tile.
using CountOf = std::uint64_t FragmentCounts::*;

// Keeps the fragments whose alpha reaches the material's cutoff. Alpha is computed at the point of
// the pixel where the fragment is shaded.
class Masked {
public:
  static constexpr bool kKeepsAll = false, kIsBehind = false;
  static constexpr CountOf kOthers = &FragmentCounts::discarded;

  HWY_INLINE explicit Masked(const AlphaTest& test) : test_(test) {}

  // Returns which of `lanes` are kept; at least one lane is set. The lanes are pixels k .. k +
  // kLanes - 1 of the quad at (x, y), covered by the small triangle of this reference.
  HWY_NOINLINE IntMask kept(IntMask lanes, Reference reference, int x, int y, std::size_t k) const {
    const Ints of_draw = std::int32_t(reference - test_.draw->first_reference);
    return kept(lanes, SmallSource(*test_.draw, of_draw, quad_columns(k) + x, quad_rows(k) + y,
                                   AtSamples{test_.points, lanes}));
  }
  // Returns which of `lanes` are kept if a large triangle covers them.
  HWY_NOINLINE IntMask kept(IntMask lanes, const LargeShape& shape, int x, int y,
                            std::size_t k) const {
    return kept(lanes, LargeSource(shape, x, y, k, AtSamples{test_.points, lanes}));
  }

private:
  template <class Source>
  HWY_INLINE IntMask kept(IntMask lanes, const Source& source) const {
    const ShadeDraw& draw = *test_.draw;
    DrawTextures textures;
    if (draw.texture != nullptr) textures.color = &draw.texture->get();
    const AllChannels channels{};
    using Texels = TexelsOfSource<AllChannels, Source>;
    const Texels texels{channels, draw, textures, source};
    using Fragment = FragmentInLanes<AllChannels, Source, Texels>;
    const Fragment at{{}, channels, draw, textures, nullptr, source, texels};
    return lanes && int_mask(reaches_cutoff(surface_color(at).alpha, *draw.material));
  }

  const AlphaTest& test_;
};

// Keeps the fragments that are behind given depths and, if the draw has an alpha test, that Masked
// keeps as well.
class Behind {
public:
  static constexpr bool kKeepsAll = false, kIsBehind = true;
  static constexpr CountOf kOthers = Masked::kOthers;

  HWY_INLINE explicit Behind(const BehindTest& test) : codes_(*test.codes), alpha_(test.alpha) {}

  // Returns which of pixels k .. k + kLanes - 1 of the quad at (x, y) are behind the given depths.
  // (At kEmptyDepth, the largest code, nothing is behind; outside the picture nothing is drawn
  // anyway.)
  HWY_INLINE IntMask behind(Ints code, int x, int y, std::size_t k) const {
    HWY_ALIGN std::uint32_t given[kLanes];
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const int px = x + int(k + lane) % kQuadSide, py = y + int(k + lane) / kQuadSide;
      const bool is_there = px < codes_.width && py < codes_.height;
      given[lane] = is_there ? codes_.pixels[codes_.index(px, py)] : kEmptyDepth;
    }
    const Ints there = load(reinterpret_cast<const std::int32_t*>(given));
    return code > there && there >= 0;
  }

  template <class Triangle>
  HWY_INLINE IntMask kept(IntMask lanes, const Triangle& triangle, int x, int y,
                          std::size_t k) const {
    if (alpha_.draw == nullptr) return lanes;
    return Masked(alpha_).kept(lanes, triangle, x, y, k);
  }

private:
  const Image<std::uint32_t>& codes_;
  const AlphaTest& alpha_;
};

// A table for a triangle of one colour: the result of blending the colour over each possible byte,
// in all four channels. It is filled after as many vectors have been blended without it as the
// table has vectors; for fewer it would not save time.
struct BlendTable {
  static constexpr std::size_t kBytes = 256;
  std::size_t vectors = 0;  // blended so far
  HWY_ALIGN std::int32_t after[kBytes];

  bool is_filled() const { return vectors >= kBytes / kLanes; }
};

// The tile keeps no fragment: all fragments are blended into the picture, in the order in which
// they are drawn.
class Blended {
public:
  static constexpr bool kKeepsAll = false, kIsBehind = false;
  static constexpr CountOf kOthers = &FragmentCounts::blended;

  // `table`: the table of a triangle of one colour if only colours are wanted, otherwise null.
  HWY_INLINE explicit Blended(const BlendJob& job, BlendTable* table = nullptr)
      : job_(job), table_(table), mask_(bytes_of(job.resolve->mask)) {}

  HWY_NOINLINE IntMask kept(IntMask lanes, Reference reference, int x, int y, std::size_t k) const {
    const Ints of_draw = std::int32_t(reference - job_.draw->first_reference);
    blend(lanes, x, y, k,
          SmallSource(*job_.draw, of_draw, quad_columns(k) + x, quad_rows(k) + y,
                      AtSamples{job_.points, lanes}));
    return lanes && !lanes;
  }
  HWY_NOINLINE IntMask kept(IntMask lanes, const LargeShape& shape, int x, int y,
                            std::size_t k) const {
    if (table_ != nullptr && table_->is_filled()) {
      replace(lanes, x, y, k, [&](Ints before) HWY_ATTR { return blended_from_table(before); });
    } else {
      blend(lanes, x, y, k, LargeSource(shape, x, y, k, AtSamples{job_.points, lanes}));
    }
    return lanes && !lanes;
  }

private:
  template <class Source>
  HWY_INLINE void blend(IntMask lanes, int x, int y, std::size_t k, const Source& source) const {
    if (job_.colors != nullptr) blend_colors(lanes, x, y, k, source);
    const ResolveJob& resolve = *job_.resolve;
    if (resolve.distance != nullptr) {
      HWY_ALIGN float distances[kLanes];
      store(distance_of(resolve, source.depth(), source.at().inverse_w), distances);
      for_each_lane(lanes, x, y, k, [&](std::size_t lane, int px, int py) {
        resolve.distance->at(px, py) = distances[lane];
      });
    }
    if (resolve.id != nullptr) {
      HWY_ALIGN std::int32_t ids[kLanes];
      store(source.id(), ids);
      for_each_lane(lanes, x, y, k, [&](std::size_t lane, int px, int py) {
        resolve.id->at(px, py) = std::uint32_t(ids[lane]);
      });
    }
  }

  template <class Source>
  HWY_INLINE void blend_colors(IntMask lanes, int x, int y, std::size_t k,
                               const Source& source) const {
    const DrawTextures textures(*job_.draw);
    const auto surface = shaded_surface<AllChannels>(*job_.draw, textures, *job_.resolve, source);
    const Floats alpha = clamped(surface.alpha, Floats(0.0f), Floats(1.0f));
    replace(lanes, x, y, k,
            [&](Ints before) HWY_ATTR { return blended_bytes(surface.color, alpha, before); });
    if (table_ == nullptr) return;
    ++table_->vectors;
    if (!table_->is_filled()) return;
    const auto any = std::size_t(hn::FindFirstTrue(kI, lanes.m));
    fill_table({broadcast_lane(surface.color[0], any), broadcast_lane(surface.color[1], any),
                broadcast_lane(surface.color[2], any)},
               broadcast_lane(alpha, any));
  }

  HWY_INLINE void fill_table(const Rgb& color, Floats alpha) const {
    for (std::size_t first = 0; first < BlendTable::kBytes; first += kLanes) {
      const Ints byte = hn::Iota(kI, std::int32_t(first));
      const Ints two = byte | shifted_left<8>(byte);
      store(blended_bytes(color, alpha, two | shifted_left<16>(two)), table_->after + first);
    }
  }

  HWY_INLINE Ints blended_from_table(Ints before) const {
    const auto after = [&](Ints byte) HWY_ATTR { return gather(table_->after, byte & 255); };
    const Ints color = (after(before) & 0xff) | (after(shifted_right<8>(before)) & 0xff00) |
                       (after(shifted_right<16>(before)) & 0xff0000);
    if (!job_.resolve->mask.a) return color;
    return color | (after(shifted_right<24>(before)) & std::int32_t(0xff000000u));
  }

  // Replaces the stored colours of these lanes by after(stored colours), in the channels of the
  // mask.
  template <class After>
  HWY_INLINE void replace(IntMask lanes, int x, int y, std::size_t k, const After& after) const {
    HWY_ALIGN std::int32_t colors[kLanes] = {};
    for_each_run(lanes, x, y, k, [&](std::size_t lane, Rgba8* stored, auto count) {
      std::memcpy(colors + lane, stored, count * sizeof(Rgba8));
    });
    const Ints before = load(colors);
    store((after(before) & mask_) | (before & ~mask_), colors);
    for_each_run(lanes, x, y, k, [&](std::size_t lane, Rgba8* stored, auto count) {
      std::memcpy(static_cast<void*>(stored), colors + lane, count * sizeof(Rgba8));
    });
  }

  // Calls visit(lane, colours, count) for runs of stored colours of these lanes that are next to
  // each other: the rows of a quad, if all its pixels are blended and each has one sample;
  // otherwise single colours.
  template <class Visit>
  HWY_INLINE void for_each_run(IntMask lanes, int x, int y, std::size_t k,
                               const Visit& visit) const {
    if (kLanes % kQuadSide == 0 && job_.rows.count == 1 && none(!lanes)) {
      for (std::size_t lane = 0; lane < kLanes; lane += kQuadSide) {
        visit(lane, job_.colors + job_.at(x, y + int(k + lane) / kQuadSide),
              std::integral_constant<std::size_t, kQuadSide>());
      }
      return;
    }
    for_each_lane(lanes, x, y, k, [&](std::size_t lane, int px, int py) {
      visit(lane, job_.colors + job_.at(px, py), std::integral_constant<std::size_t, 1>());
    });
  }

  // Vectorised blend_over(); channels that are not wanted are 0.
  HWY_INLINE Ints blended_bytes(const Rgb& color, Floats alpha, Ints before) const {
    const ResolveJob& resolve = *job_.resolve;
    const Transfer transfer = resolve.transfer;
    const Rgb stored = decoded(transfer, before);
    const auto byte = [&](bool wanted, std::size_t i) HWY_ATTR {
      return wanted ? encode(transfer, blended_channel(color[i], alpha, stored[i])) : Ints(0);
    };
    Ints after = byte(resolve.channels.r, 0) | shifted_left<8>(byte(resolve.channels.g, 1)) |
                 shifted_left<16>(byte(resolve.channels.b, 2));
    if (resolve.mask.a) {
      const Floats a = blended_channel(Floats(1.0f), alpha, decoded_alpha(before));
      after = after | shifted_left<24>(encode_unorm8(a));
    }
    return after;
  }

  // Calls visit(lane, x, y) with the pixels of these lanes.
  template <class Visit>
  HWY_INLINE static void for_each_lane(IntMask lanes, int x, int y, std::size_t k,
                                       const Visit& visit) {
    HWY_ALIGN std::int32_t is_in[kLanes];
    store(one_where(lanes), is_in);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const int pixel = int(k + lane);
      if (is_in[lane] != 0) visit(lane, x + pixel % kQuadSide, y + pixel / kQuadSide);
    }
  }

  const BlendJob& job_;
  BlendTable* table_;
  std::int32_t mask_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
