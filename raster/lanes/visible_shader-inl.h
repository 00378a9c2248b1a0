// Shades what is seen: finds the draw and the triangle that each pixel's reference identifies, and
// computes the pixels' colours.

#if defined(GLASSBOX_VISIBLE_SHADER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_VISIBLE_SHADER_INL_H_
#undef GLASSBOX_VISIBLE_SHADER_INL_H_
#else
#define GLASSBOX_VISIBLE_SHADER_INL_H_
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include <glassbox/raster/lanes/shade-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// The references of a quad's pixels k .. k + kLanes - 1.
HWY_INLINE Ints visible_references(const TileBuffer& tile, std::size_t block, int quad,
                                   std::size_t k) {
  const TileBlock& b = tile.block(block);
  if (b.plain) return std::int32_t(b.reference);
  return load(reinterpret_cast<const std::int32_t*>(tile.reference()) + block * kBlockPixels +
              std::size_t(quad) * kQuadPixels + k);
}
HWY_INLINE IntMask is_to_be_shaded(Ints seen) {
  return seen != std::int32_t(kNothing) && seen != std::int32_t(kInPicture);
}

// A block whose first pixel is at (x, y).
struct BlockOfTile {
  HWY_INLINE BlockOfTile(const TileBuffer& tile, std::size_t block, int at_x, int at_y)
      : state(tile.block(block)), list(tile.listed(block)), x(at_x), y(at_y) {}

  // Whether small triangles were drawn into the block, and no more of them than there are lanes.
  bool shows_few_triangles() const {
    return state.listed - 1 < BlockTriangles::kMost && state.listed <= kLanes;
  }

  const TileBlock& state;
  const BlockTriangles& list;
  int x, y;
};

template <class Channels>
class VisibleShader {
public:
  explicit VisibleShader(const ResolveJob& job) : job_(job), mask_(bytes_of(job.mask)) {}

  const LargeShape& shape_of(Reference reference) {
    if (reference != shape_reference_) {
      shape_reference_ = reference;
      shape_ = LargeShape(*job_.large[reference & ~kLargeReference]);
    }
    return shape_;
  }

  const ShadeDraw& draw_of(Reference reference) {
    if (draw_ == nullptr || reference < draw_->first_reference ||
        reference >= draw_->end_reference) {
      const auto after = std::upper_bound(
          job_.by_reference.begin(), job_.by_reference.end(), reference,
          [&](Reference r, std::uint32_t draw) { return r < job_.draws[draw].first_reference; });
      draw_ = &job_.draws[*(after - 1)];
    }
    return *draw_;
  }

  // Returns the draw's textures, or none if no colours are wanted.
  HWY_INLINE DrawTextures textures_of(const ShadeDraw& draw) const {
    return job_.picture != nullptr ? DrawTextures(draw) : DrawTextures();
  }

  // Whether the block shows a texture; then it is better to shade its vectors together, step by
  // step, and otherwise one after the other. Only the first pixel of each quad is examined, and the
  // first of these that shows a triangle decides.
  HWY_INLINE bool shows_texture(const TileBuffer& tile, std::size_t block) {
    const TileBlock& b = tile.block(block);
    for (int quad = 0; quad < kBlockQuads; ++quad) {
      const Reference seen =
          b.plain ? b.reference
                  : tile.reference()[block * kBlockPixels + std::size_t(quad) * kQuadPixels];
      if (seen == kNothing || seen == kInPicture) continue;
      const ShadeDraw& draw = (seen & kLargeReference) != 0
                                  ? job_.draws[job_.large[seen & ~kLargeReference]->draw]
                                  : draw_of(seen);
      return draw.texture != nullptr || draw.emission_texture != nullptr;
    }
    return false;
  }

  // ---- a vector ----

  // Shades what is seen in the `pending` lanes.
  template <class To>
  HWY_INLINE void shade_lanes(Ints seen, IntMask pending, int x, int y, std::size_t k,
                              const To& to) {
    while (!none(pending)) {
      HWY_ALIGN std::int32_t references[kLanes];
      store(seen, references);
      const auto first = Reference(references[hn::FindFirstTrue(kI, pending.m)]);
      IntMask same;
      if ((first & kLargeReference) != 0) {
        same = pending && seen == std::int32_t(first);
        const LargeShape& shape = shape_of(first);
        const ShadeDraw& draw = job_.draws[shape.triangle->draw];
        const DrawTextures textures = textures_of(draw);
        to.shade_and_store(draw, textures, LargeSource(shape, x, y, k, to.shading_point(same)),
                           same);
      } else {
        const ShadeDraw& draw = draw_of(first);
        const DrawTextures textures = textures_of(draw);
        const Ints begin = std::int32_t(draw.first_reference);
        same = pending && seen >= begin && seen < std::int32_t(draw.end_reference);
        const Ints reference = select(same, seen, std::int32_t(first)) - begin;
        if (textures.color != nullptr || textures.emission != nullptr) {
          shade_textured(draw, textures, reference, x, y, k, to, same);
        } else {
          to.shade_and_store(draw, DrawTextures(), small_source(draw, reference, x, y, k, to, same),
                             same);
        }
      }
      pending = pending && !same;
    }
  }

  template <class To>
  HWY_INLINE static SmallSource small_source(const ShadeDraw& draw, Ints reference, int x, int y,
                                             std::size_t k, const To& to, IntMask lanes) {
    return {draw, reference, quad_columns(k) + x, quad_rows(k) + y, to.shading_point(lanes)};
  }
  // Not inlined, so that compilers keep what vectors without textures need in registers.
  template <class To>
  HWY_NOINLINE static void shade_textured(const ShadeDraw& draw, const DrawTextures& textures,
                                          Ints reference, int x, int y, std::size_t k, const To& to,
                                          IntMask lanes) {
    to.shade_and_store(draw, textures, small_source(draw, reference, x, y, k, to, lanes), lanes);
  }

  // ---- a block ----

  // The source for vector i of the block at (x, y).
  HWY_INLINE static LargeSource large_source(const LargeShape& shape, int x, int y, std::size_t i) {
    const int quad = int(i / kQuadVectors);
    return {shape, x + (quad % 2) * kQuadSide, y + (quad / 2) * kQuadSide,
            i % kQuadVectors * kLanes, AtCentre()};
  }

  // Shades the block's pending pixels and writes their colours to `colors`; other pixels keep their
  // colours.
  HWY_INLINE void shade_block(const BlockOfTile& block, const Ints* seen, IntMask* pending,
                              Ints* colors) {
    for (std::size_t i = 0; i < kBlockVectors; ++i) {
      while (!none(pending[i])) shade_group(block, seen, pending, i, colors);
    }
  }

private:
  // Pixels of a block that show small triangles of one draw, or one large triangle.
  struct Group {
    std::size_t count = 0;
    std::size_t vector[kBlockVectors];
    IntMask lanes[kBlockVectors];
  };
  // Moves the pending pixels that belong to the group into it, beginning with vector `begin`.
  template <class Belongs>
  HWY_INLINE static void collect_group(const Ints* seen, IntMask* pending, std::size_t begin,
                                       const Belongs& belongs, Group& group) {
    for (std::size_t i = begin; i < kBlockVectors; ++i) {
      const IntMask same = pending[i] && belongs(seen[i]);
      if (none(same)) continue;
      pending[i] = pending[i] && !same;
      group.vector[group.count] = i;
      group.lanes[group.count++] = same;
    }
  }

  // Shades the group of the first pending pixel in vector `begin`.
  HWY_INLINE void shade_group(const BlockOfTile& block, const Ints* seen, IntMask* pending,
                              std::size_t begin, Ints* colors) {
    HWY_ALIGN std::int32_t references[kLanes];
    store(seen[begin], references);
    const auto first = Reference(references[hn::FindFirstTrue(kI, pending[begin].m)]);
    Group group;
    Ints shaded[kBlockVectors];
    if ((first & kLargeReference) != 0) {
      collect_group(
          seen, pending, begin, [&](Ints s) HWY_ATTR { return s == std::int32_t(first); }, group);
      const LargeShape& shape = shape_of(first);
      const ShadeDraw& draw = job_.draws[shape.triangle->draw];
      shade_vectors<Channels, LargeSource>(
          draw, DrawTextures(draw), job_, group.count,
          [&](std::size_t i)
              HWY_ATTR { return large_source(shape, block.x, block.y, group.vector[i]); },
          shaded);
    } else {
      const ShadeDraw& draw = draw_of(first);
      const Ints from = std::int32_t(draw.first_reference);
      collect_group(
          seen, pending, begin,
          [&](Ints s) HWY_ATTR { return s >= from && s < std::int32_t(draw.end_reference); },
          group);
      if (block.shows_few_triangles() && SharedTriangles::can_share(draw)) {
        shade_shared(draw, block, seen, group, shaded);
      } else {
        shade_vectors<Channels, SmallSource>(
            draw, DrawTextures(draw), job_, group.count,
            [&](std::size_t i) HWY_ATTR {
              const std::size_t vector = group.vector[i];
              const Ints reference = select(group.lanes[i], seen[vector], std::int32_t(first));
              return SmallSource(draw, reference - from, block_columns(vector) + block.x,
                                 block_rows(vector) + block.y, AtCentre());
            },
            shaded);
      }
    }
    for (std::size_t i = 0; i < group.count; ++i) {
      Ints& color = colors[group.vector[i]];
      color = select(group.lanes[i], (shaded[i] & mask_) | (color & ~mask_), color);
    }
  }

  // ---- small triangles that a block's pixels share ----

  // The draw's triangles in the block's list, and which of them each lane of the group's vectors
  // shows.
  struct Shared {
    HWY_INLINE Shared(const ShadeDraw& draw, const BlockOfTile& block, const Ints* seen,
                      const Group& group) {
      for (std::size_t i = 0; i < group.count; ++i) lanes[i] = 0;
      std::int32_t count = 0;
      for (std::uint32_t k = 1; k <= block.state.listed; ++k) {
        const Reference reference = block.list.references[k];
        if (reference < draw.first_reference || reference >= draw.end_reference) continue;
        for (std::size_t i = 0; i < group.count; ++i) {
          lanes[i] = select(seen[group.vector[i]] == std::int32_t(reference), count, lanes[i]);
        }
        references[count++] = std::int32_t(reference - draw.first_reference);
      }
    }

    // The triangles' references minus the draw's first reference. Unused lanes get 0, the draw's
    // first triangle, which is valid.
    HWY_ALIGN std::int32_t references[kLanes] = {};
    Ints lanes[kBlockVectors];
  };
  HWY_NOINLINE void shade_shared(const ShadeDraw& draw, const BlockOfTile& block, const Ints* seen,
                                 const Group& group, Ints* colors) const {
    const Shared shared(draw, block, seen, group);
    const SharedTriangles triangles(draw, load(shared.references), block.x, block.y);
    const auto source_of = [&](std::size_t i) HWY_ATTR {
      const std::size_t vector = group.vector[i];
      return SharedSource(triangles, shared.lanes[i], block_columns(vector), block_rows(vector),
                          AtCentre());
    };
    const DrawTextures textures(draw);
    // Without textures, steps are used only with the longest vectors: with shorter ones, a block
    // has more vectors than fit in registers from one step to the next.
    if (kLanes == 16 || textures.color != nullptr || textures.emission != nullptr) {
      return shade_in_steps<Channels, SharedSource>(draw, textures, job_, group.count, source_of,
                                                    colors);
    }
    for (std::size_t i = 0; i < group.count; ++i) {
      colors[i] = shade<Channels>(draw, DrawTextures(), job_, source_of(i));
    }
  }

  const ResolveJob& job_;
  std::int32_t mask_;
  // The draw and the shape of the previous pixels: neighbouring pixels often show the same ones.
  const ShadeDraw* draw_ = nullptr;
  Reference shape_reference_ = kNothing;
  LargeShape shape_;
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
