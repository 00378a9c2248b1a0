#include <algorithm>
#include <bit>

#include <glassbox/raster/blend.h>
#include <glassbox/raster/line.h>
#include <glassbox/raster/point.h>
#include <glassbox/raster/samples.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/staged/prepare_lines.h>
#include <glassbox/render/staged/reference.h>
#include <glassbox/render/staged/watch.h>
#include <glassbox/render/tile/draw_round.h>

namespace glassbox {

namespace {

PixelRect tiles_between(TilePlace first, TilePlace last) {
  return {int(first & 0xffff), int(first >> 16), int(last & 0xffff) + 1, int(last >> 16) + 1};
}

// Finds runs: consecutive entries (primitives) that touch the same tiles. Neighbours in a mesh are
// often neighbours on the screen, so most runs are longer than one.
void find_runs(const UnsortedEntries& from, std::vector<BinRun>& runs) {
  runs.clear();
  for (std::size_t end = 0; end < from.count;) {
    const std::size_t begin = end;
    const TilePlace first = from.first[begin], last = from.last[begin];
    while (end < from.count && from.first[end] == first && from.last[end] == last) ++end;
    runs.push_back({begin, end});
  }
}

// Sorts entries (primitives) into the chunk's bins, one for each tile, by counting sort; within a
// bin they keep their order.
void sort_into_bins(const UnsortedEntries& from, Chunk& chunk) {
  chunk.tiles = {};
  chunk.starts.assign(1, 0);
  if (from.count == 0) return chunk.entries.clear();
  find_runs(from, chunk.runs);
  const auto tiles_of = [&](const BinRun& run) {
    return tiles_between(from.first[run.begin], from.last[run.begin]);
  };
  PixelRect tiles = tiles_of(chunk.runs.front());
  for (const BinRun& run : chunk.runs) {
    const PixelRect own = tiles_of(run);
    tiles = {std::min(tiles.x0, own.x0), std::min(tiles.y0, own.y0), std::max(tiles.x1, own.x1),
             std::max(tiles.y1, own.y1)};
  }
  const auto width = std::size_t(tiles.x1 - tiles.x0);
  const auto for_each_bin = [&](const BinRun& run, auto&& visit) {
    const PixelRect own = tiles_of(run);
    for (int y = own.y0; y < own.y1; ++y) {
      for (int x = own.x0; x < own.x1; ++x) {
        visit(std::size_t(y - tiles.y0) * width + std::size_t(x - tiles.x0));
      }
    }
  };
  // The number of entries of bin i is stored in starts[i + 2], so that after summing starts[i + 1]
  // is where bin i begins.
  chunk.tiles = tiles;
  chunk.starts.assign(width * std::size_t(tiles.y1 - tiles.y0) + 2, 0);
  for (const BinRun& run : chunk.runs) {
    const auto size = std::uint32_t(run.end - run.begin);
    for_each_bin(run, [&](std::size_t bin) { chunk.starts[bin + 2] += size; });
  }
  for (std::size_t i = 2; i < chunk.starts.size(); ++i) chunk.starts[i] += chunk.starts[i - 1];
  chunk.entries.resize(chunk.starts.back());
  // Filling bin i moves starts[i + 1] to the end of bin i, which is where bin i + 1 begins.
  for (const BinRun& run : chunk.runs) {
    for_each_bin(run, [&](std::size_t bin) {
      std::uint32_t& at = chunk.starts[bin + 1];
      std::copy(from.entries.data() + run.begin, from.entries.data() + run.end,
                chunk.entries.data() + at);
      at += std::uint32_t(run.end - run.begin);
    });
  }
}

// Adds an entry for a primitive with this box to the bins of the tiles that the box touches, if any
// of it is on the screen.
void add_entry(const TileRun& run, std::uint32_t entry, const PixelRect& box, Chunk& chunk) {
  const PixelRect seen{std::max(box.x0, run.window.x0), std::max(box.y0, run.window.y0),
                       std::min(box.x1, run.window.x1), std::min(box.y1, run.window.y1)};
  if (seen.empty()) return;
  const auto tile = [&](int pixel) { return TilePlace(pixel / run.tile_side); };
  chunk.unsorted.add(entry, tile(seen.x0) | tile(seen.y0) << 16,
                     tile(seen.x1 - 1) | tile(seen.y1 - 1) << 16);
}

// Returns the pixels that the triangle may cover, at least at one sample.
PixelRect covered_bounds(const TileRun& run, const ReadyTriangle& triangle) {
  const PixelRect& bounds = triangle.setup.bounds;
  return samples_drawn(run.settings) > 1 ? sampled_bounds(bounds) : bounds;
}

PixelRect pixels_near(const SnappedVertex& a, const SnappedVertex& b) {
  const auto [left, right] = std::minmax(a.x, b.x);
  const auto [top, bottom] = std::minmax(a.y, b.y);
  return {(left >> kSubpixelBits) - 1, (top >> kSubpixelBits) - 1, (right >> kSubpixelBits) + 2,
          (bottom >> kSubpixelBits) + 2};
}

PrimitiveStage primitive_stage(const TileRun& run, const DrawSlot& slot) {
  const Draw& draw = run.list.draws[slot.draw];
  return {.draw = draw,
          .clip = nullptr,
          .eye_space = slot.eye_space,
          .view = run.view,
          .settings = run.settings,
          .lighting = run.list.lighting,
          .planes = run.planes,
          .object_cull = object_culling(draw, run.view, run.settings).test};
}

// ---- triangles in SIMD lanes ----

// Whether all pixels of the triangle have the same colour: an attribute that is equal at the
// vertices has exactly that value everywhere (interpolate.h), and the colour depends neither on
// textures nor on the position on the surface.
bool has_one_color(const DrawMethod& method, const std::array<Varyings, 3>& vertices) {
  const auto equal = [&](auto member) {
    return vertices[0].*member == vertices[1].*member && vertices[0].*member == vertices[2].*member;
  };
  if (method.texture || method.emission_texture || !equal(&Varyings::color)) return false;
  switch (method.light) {
    case LightAt::kNowhere:
      return true;
    case LightAt::kVertices:
      return equal(&Varyings::normal) && equal(&Varyings::diffuse) && equal(&Varyings::specular);
    case LightAt::kFragments:
      return equal(&Varyings::normal) && !method.eye_positions;
  }
  return false;
}

// `shade` is the index of the draw's slot in the round, and of the data for shading it.
LargeTriangle large_triangle(const DrawMethod& method, std::uint32_t shade,
                             const ReadyTriangle& ready) {
  LargeTriangle large{ready.setup, ready.vertices, {},
                      shade,       ready.number,   has_one_color(method, ready.vertices)};
  if (method.texture || method.emission_texture) {
    large.texture = texture_planes(
        ready.setup,
        {ready.vertices[0].texcoord, ready.vertices[1].texcoord, ready.vertices[2].texcoord});
  }
  return large;
}

// Returns for each of `count` triangles whether it is kept: 0 if it is certainly turned away,
// otherwise 1. Triangles that will be set up one by one, because they may need clipping, are kept
// here and tested then. Returns null if nothing is culled before clipping.
const std::int32_t* cull_early(const PrimitiveStage& stage, const DrawSlot& slot,
                               std::uint32_t first, std::uint32_t count, Chunk& chunk) {
  if (!stage.object_cull) return nullptr;
  const Draw& draw = stage.draw;
  const std::uint32_t* indices = draw.prepared->indices.positions.data() + std::size_t(first) * 3;
  std::int32_t* keep = grow_to(chunk.keep, count + kMaxLanes);
  for (std::uint32_t i = 0; i < count; ++i, indices += 3) {
    const auto needs_clipping = [&](int k) { return slot.screen[indices[k]].x == kNeedsClipping; };
    const auto position = [&](int k) { return draw.mesh->positions[indices[k]]; };
    const bool uncut = !needs_clipping(0) && !needs_clipping(1) && !needs_clipping(2);
    keep[i] = uncut && stage.object_cull->removes({position(0), position(1), position(2)}) ? 0 : 1;
    chunk.statistics.culled_early += keep[i] == 0;
  }
  return keep;
}

// Calls visit for the chunk's triangles in clusters that are drawn, or for all of them if the draw
// has no clusters.
template <class Visit>
void for_each_drawn(const DrawSlot& slot, const Chunk& chunk, const Visit& visit) {
  const auto is_drawn = [&](std::size_t cluster) {
    return slot.verdicts[cluster] == ClusterVerdict::kDrawn;
  };
  if (slot.verdicts.empty()) return visit(chunk.first, chunk.count);
  for_each_run(chunk.first, chunk.count, kClusterTriangles, is_drawn, visit);
}

// Returns the entries for the bins: the small triangles, and in place of each large triangle the
// triangles that the stages of the reference make of it.
const UnsortedEntries& fill_from_lanes(const TileRun& run, const Kernels& kernels,
                                       const DrawSlot& slot, Chunk& chunk) {
  const Draw& draw = run.list.draws[slot.draw];
  const DrawMethod& method = run.methods[slot.draw];
  SelectJob job;
  job.positions = slot.indices->positions.data();
  job.screen = slot.screen;
  job.mirrored = draw.mirrored;
  job.keep_front = method.keep_front;
  job.keep_back = method.keep_back;
  job.all_large = method.large_because != nullptr;
  job.window = run.window;
  job.margin = samples_drawn(run.settings) > 1 ? 1 : 0;
  job.tile_shift = std::countr_zero(unsigned(run.tile_side));

  // The stage for large triangles, which refers to one draw: to the first draw of the slot, until a
  // large triangle of another draw comes.
  std::optional<PrimitiveStage> stage(primitive_stage(run, slot));
  SelectCounts counts;
  UnsortedEntries& found = chunk.selected;
  const BinColumns selected = found.columns(chunk.count + kMaxLanes);
  found.count = 0;
  for_each_drawn(slot, chunk, [&](std::size_t first, std::size_t count) {
    job.first = std::uint32_t(first);
    job.count = std::uint32_t(count);
    if (!job.all_large) job.keep = cull_early(*stage, slot, job.first, job.count, chunk);
    found.count += kernels.select_triangles(job, selected.starting_at(found.count), counts);
  });
  Statistics& s = chunk.statistics;
  s.after_clipping += counts.small;
  s.zero_area += counts.zero_area;
  s.culled += counts.culled;
  s.set_up += counts.small - counts.zero_area - counts.culled;

  const auto is_large = [](std::uint32_t entry) { return (entry & kLarge) != 0; };
  if (std::none_of(selected.entries, selected.entries + found.count, is_large)) return found;

  const CountingWatch watch(s);
  std::vector<ReadyTriangle> ready;
  std::vector<ReadyLine> no_lines;
  const std::vector<Triangle>& triangles = draw.triangulation->triangles;
  std::size_t draw_of_stage = 0;
  for (std::size_t i = 0; i < found.count; ++i) {
    const std::uint32_t entry = found.entries[i];
    if (!is_large(entry)) {
      chunk.unsorted.add(entry, found.first[i], found.last[i]);
      continue;
    }
    const std::size_t triangle = entry & ~kLarge, of_draw = triangle / triangles.size();
    if (of_draw != draw_of_stage) stage.emplace(primitive_stage(run, slot_of_draw(slot, of_draw)));
    draw_of_stage = of_draw;
    ready.clear();
    prepare_triangle(*stage, watch, triangles[triangle % triangles.size()], ready, no_lines);
    for (const ReadyTriangle& triangle : ready) {
      add_entry(run, kChunkEntryBit | std::uint32_t(chunk.large.size()),
                covered_bounds(run, triangle), chunk);
      chunk.large.push_back(large_triangle(method, chunk.slot, triangle));
    }
  }
  return chunk.unsorted;
}

// ---- primitives that the stages of the reference prepare ----

const UnsortedEntries& fill_staged(const TileRun& run, const DrawSlot& slot, Chunk& chunk) {
  const Draw& draw = run.list.draws[slot.draw];
  const PrimitiveStage stage = primitive_stage(run, slot);
  const CountingWatch watch(chunk.statistics);
  if (chunk.kind == Chunk::Kind::kLinesAndPoints) {
    for (std::uint32_t i = 0; i < draw.mesh->lines.size(); ++i) {
      prepare_line(stage, watch, i, chunk.lines);
    }
    for (std::uint32_t i = 0; i < draw.mesh->points.size(); ++i) {
      prepare_point(stage, watch, i, chunk.points);
    }
  }
  for (std::uint32_t i = 0; i < chunk.count; ++i) {
    prepare_triangle(stage, watch, draw.triangulation->triangles[chunk.first + i], chunk.triangles,
                     chunk.lines);
  }
  std::uint32_t entry = kChunkEntryBit;
  for (const ReadyTriangle& triangle : chunk.triangles) {
    add_entry(run, entry++, covered_bounds(run, triangle), chunk);
  }
  for (const ReadyLine& line : chunk.lines) {
    add_entry(run, entry++, pixels_near(snap(line.ends[0]), snap(line.ends[1])), chunk);
  }
  for (const ReadyPoint& point : chunk.points) {
    const SnappedVertex at = snap(point.position);
    add_entry(run, entry++, pixels_near(at, at), chunk);
  }
  return chunk.unsorted;
}

}  // namespace

void fill_chunk(const TileRun& run, const Kernels& kernels, const DrawRound& round, Chunk& chunk) {
  const DrawSlot& slot = round.slots[chunk.slot];
  chunk.large.clear();
  chunk.triangles.clear();
  chunk.lines.clear();
  chunk.points.clear();
  chunk.statistics = {};
  chunk.unsorted.count = 0;
  sort_into_bins(chunk.kind == Chunk::Kind::kLanes ? fill_from_lanes(run, kernels, slot, chunk)
                                                   : fill_staged(run, slot, chunk),
                 chunk);
}

}  // namespace glassbox
