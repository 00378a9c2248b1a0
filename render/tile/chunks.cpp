#include <algorithm>
#include <bit>

#include <glassbox/raster/blend.h>
#include <glassbox/raster/line.h>
#include <glassbox/raster/point.h>
#include <glassbox/raster/samples.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/staged/ready_lines.h>
#include <glassbox/render/staged/reference.h>
#include <glassbox/render/staged/watch.h>
#include <glassbox/render/tile/round.h>
#include <glassbox/render/tile/runs.h>

namespace glassbox {

namespace {

// Sorts entries into the chunk's bins by counting; within a bin they keep their order.
void sort_into_bins(std::span<const BinEntry> entries, Chunk& chunk) {
  chunk.tiles = {};
  chunk.starts.assign(1, 0);
  chunk.entries.clear();
  if (entries.empty()) return;
  PixelRect tiles{entries[0].x0, entries[0].y0, 0, 0};
  for (const BinEntry& e : entries) {
    tiles = {std::min<int>(tiles.x0, e.x0), std::min<int>(tiles.y0, e.y0),
             std::max<int>(tiles.x1, e.x1 + 1), std::max<int>(tiles.y1, e.y1 + 1)};
  }
  const auto width = std::size_t(tiles.x1 - tiles.x0);
  const auto for_each_bin = [&](const BinEntry& e, auto&& visit) {
    for (int y = e.y0; y <= e.y1; ++y) {
      for (int x = e.x0; x <= e.x1; ++x) {
        visit(std::size_t(y - tiles.y0) * width + std::size_t(x - tiles.x0));
      }
    }
  };
  // Counted one bin further on, so that after the sums starts[i] is where bin i begins ...
  chunk.tiles = tiles;
  chunk.starts.assign(width * std::size_t(tiles.y1 - tiles.y0) + 2, 0);
  for (const BinEntry& e : entries) {
    for_each_bin(e, [&](std::size_t bin) { ++chunk.starts[bin + 2]; });
  }
  for (std::size_t i = 2; i < chunk.starts.size(); ++i) chunk.starts[i] += chunk.starts[i - 1];
  chunk.entries.resize(chunk.starts.back());
  // ... and filling bin i moves starts[i + 1] to its end.
  for (const BinEntry& e : entries) {
    for_each_bin(e, [&](std::size_t bin) { chunk.entries[chunk.starts[bin + 1]++] = e.entry; });
  }
}

// The bins of the pixels of a box; nothing where none is on the screen.
std::optional<BinEntry> bin_entry(const TileRun& run, std::uint32_t entry, const PixelRect& box) {
  const PixelRect seen{std::max(box.x0, run.window.x0), std::max(box.y0, run.window.y0),
                       std::min(box.x1, run.window.x1), std::min(box.y1, run.window.y1)};
  if (seen.empty()) return std::nullopt;
  const auto tile = [&](int pixel) { return std::uint16_t(pixel / run.tile_side); };
  return BinEntry{entry, tile(seen.x0), tile(seen.y0), tile(seen.x1 - 1), tile(seen.y1 - 1)};
}

// Pixels of which the triangle may cover something.
PixelRect reach(const TileRun& run, const ReadyTriangle& triangle) {
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

void add_entry(const TileRun& run, std::uint32_t entry, const PixelRect& box, Chunk& chunk) {
  if (const auto bins = bin_entry(run, entry, box)) chunk.unsorted.push_back(*bins);
}

// ---- triangles over lanes ----

// Nothing on the triangle changes from pixel to pixel: an attribute that is equal at the vertices is exactly that everywhere
// (interpolate.h), and neither textures nor the surface's place have a say.
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

LargeTriangle large_triangle(const TileRun& run, const DrawSlot& slot, const ReadyTriangle& ready) {
  LargeTriangle large{ready.setup,  ready.vertices,
                      {},           slot.draw,
                      ready.number, has_one_color(run.methods[slot.draw], ready.vertices)};
  if (run.methods[slot.draw].texture || run.methods[slot.draw].emission_texture) {
    large.texture = texture_planes(
        ready.setup,
        {ready.vertices[0].texcoord, ready.vertices[1].texcoord, ready.vertices[2].texcoord});
  }
  return large;
}

// Which of `count` triangles go on to be selected: all but those that are turned away for certain. Those that are made ready one by
// one are asked there: all of a draw that says so, and those that clipping has to look at.
const std::int32_t* cull_early(const PrimitiveStage& stage, const DrawSlot& slot,
                               std::uint32_t first, std::uint32_t count, Chunk& chunk) {
  if (!stage.object_cull) return nullptr;
  const Draw& draw = stage.draw;
  const std::uint32_t* indices = draw.prepared->indices.positions.data() + std::size_t(first) * 3;
  std::int32_t* keep = at_least(chunk.keep, count + kMostLanes);
  for (std::uint32_t i = 0; i < count; ++i, indices += 3) {
    const auto needs_clipping = [&](int k) { return slot.screen[indices[k]].x == kNeedsClipping; };
    const auto position = [&](int k) { return draw.mesh->positions[indices[k]]; };
    const bool uncut = !needs_clipping(0) && !needs_clipping(1) && !needs_clipping(2);
    keep[i] = uncut && stage.object_cull->removes({position(0), position(1), position(2)}) ? 0 : 1;
    chunk.statistics.culled_early += keep[i] == 0;
  }
  return keep;
}

// The triangles of the clusters that are drawn, where the draw has any.
template <class Visit>
void for_each_drawn(const DrawSlot& slot, const Chunk& chunk, const Visit& visit) {
  const auto is_drawn = [&](std::size_t cluster) {
    return slot.verdicts[cluster] == ClusterVerdict::kDrawn;
  };
  if (slot.verdicts.empty()) return visit(chunk.first, chunk.count);
  for_each_run(chunk.first, chunk.count, kClusterTriangles, is_drawn, visit);
}

// The entries of the bins: the small triangles, and in their places what came of the large ones.
std::span<const BinEntry> fill_from_lanes(const TileRun& run, const Kernels& kernels,
                                          const DrawSlot& slot, Chunk& chunk) {
  const Draw& draw = run.list.draws[slot.draw];
  const DrawMethod& method = run.methods[slot.draw];
  SelectJob job;
  job.positions = draw.prepared->indices.positions.data();
  job.screen = slot.screen;
  job.mirrored = draw.mirrored;
  job.keep_front = method.keep_front;
  job.keep_back = method.keep_back;
  job.all_large = method.large_because != nullptr;
  job.window = run.window;
  job.margin = samples_drawn(run.settings) > 1 ? 1 : 0;
  job.tile_shift = std::countr_zero(unsigned(run.tile_side));

  const PrimitiveStage stage = primitive_stage(run, slot);
  SelectCounts counts;
  BinEntry* selected = at_least(chunk.selected, chunk.count + kMostLanes);
  std::size_t kept = 0;
  for_each_drawn(slot, chunk, [&](std::size_t first, std::size_t count) {
    job.first = std::uint32_t(first);
    job.count = std::uint32_t(count);
    if (!job.all_large) job.keep = cull_early(stage, slot, job.first, job.count, chunk);
    kept += kernels.select_triangles(job, selected + kept, counts);
  });
  const std::span found(selected, kept);
  Statistics& s = chunk.statistics;
  s.after_clipping += counts.small;
  s.zero_area += counts.zero_area;
  s.culled += counts.culled;
  s.set_up += counts.small - counts.zero_area - counts.culled;

  const auto is_large = [](const BinEntry& one) { return (one.entry & kLarge) != 0; };
  if (std::ranges::none_of(found, is_large)) return found;

  const Counting watch(s);
  std::vector<ReadyTriangle> ready;
  std::vector<ReadyLine> no_lines;
  for (const BinEntry& one : found) {
    if (!is_large(one)) {
      chunk.unsorted.push_back(one);
      continue;
    }
    ready.clear();
    TriangleAttributes attributes;
    ready_triangle(stage, watch, draw.triangulation->triangles[one.entry & ~kLarge], attributes,
                   ready, no_lines);
    for (const ReadyTriangle& triangle : ready) {
      add_entry(run, kOfChunk | std::uint32_t(chunk.large.size()), reach(run, triangle), chunk);
      chunk.large.push_back(large_triangle(run, slot, triangle));
    }
  }
  return chunk.unsorted;
}

// ---- the staged primitives ----

std::span<const BinEntry> fill_staged(const TileRun& run, const DrawSlot& slot, Chunk& chunk) {
  const Draw& draw = run.list.draws[slot.draw];
  const PrimitiveStage stage = primitive_stage(run, slot);
  const Counting watch(chunk.statistics);
  if (chunk.kind == Chunk::Kind::kLinesAndPoints) {
    for (const auto& line : draw.mesh->lines) ready_line(stage, watch, line, chunk.lines);
    for (const Corner& point : draw.mesh->points) ready_point(stage, watch, point, chunk.points);
  }
  for (std::uint32_t i = 0; i < chunk.count; ++i) {
    TriangleAttributes attributes;
    ready_triangle(stage, watch, draw.triangulation->triangles[chunk.first + i], attributes,
                   chunk.triangles, chunk.lines);
  }
  std::uint32_t entry = kOfChunk;
  for (const ReadyTriangle& triangle : chunk.triangles) {
    add_entry(run, entry++, reach(run, triangle), chunk);
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

void fill_chunk(const TileRun& run, const Kernels& kernels, const Round& round, Chunk& chunk) {
  const DrawSlot& slot = round.slots[chunk.slot];
  chunk.large.clear();
  chunk.triangles.clear();
  chunk.lines.clear();
  chunk.points.clear();
  chunk.statistics = {};
  chunk.unsorted.clear();
  sort_into_bins(chunk.kind == Chunk::Kind::kLanes ? fill_from_lanes(run, kernels, slot, chunk)
                                                   : fill_staged(run, slot, chunk),
                 chunk);
}

}  // namespace glassbox
