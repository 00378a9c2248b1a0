// A round: some of a picture's draws, which go through the stages together. It has the tables of
// their vertices, and the triangles of each draw sorted into tiles.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/base/cache_aligned_vector.h>
#include <glassbox/raster/lanes/kernels.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/plan/cluster_cull.h>
#include <glassbox/render/plan/draw_method.h>
#include <glassbox/render/staged/primitives.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {

// The inputs of the tile engine for one eye's picture.
struct TileRun {
  const View& view;
  const RenderSettings& settings;
  const DrawList& list;
  const std::vector<DrawMethod>& methods;        // one for each draw
  std::array<ClipPlane, kMaxClipPlanes> planes;  // render_planes(view)
  PixelRect window;
  int tile_side = 64;

  int tiles_across() const { return (window.x1 + tile_side - 1) / tile_side; }
  int tiles_down() const { return (window.y1 + tile_side - 1) / tile_side; }
  std::size_t tile_count() const { return tile_index(0, tiles_down()); }
  std::size_t tile_index(int x, int y) const {
    return std::size_t(y) * std::size_t(tiles_across()) + std::size_t(x);
  }
};

// Grows the memory if needed and never shrinks it: the next picture probably needs as much.
template <class Memory>
auto* grow_to(Memory& memory, std::size_t size) {
  if (memory.size() < size) memory.resize(size);
  return memory.data();
}

// Visits those of the `count` entries of a table from `first` on whose group g is included,
// is_in(g): calls visit(first, count) for each longest run of consecutive ones. Group g has entries
// g * size .. g * size + size - 1.
template <class IsIn, class Visit>
void for_each_run(std::size_t first, std::size_t count, std::size_t size, const IsIn& is_in,
                  const Visit& visit) {
  const std::size_t end = first + count;
  std::size_t begin = first;  // the beginning of the run that is not yet visited
  for (std::size_t at = first; at < end;) {
    const std::size_t group = at / size, next = std::min(end, (group + 1) * size);
    if (!is_in(group)) {
      if (at > begin) visit(begin, at - begin);
      begin = next;
    }
    at = next;
  }
  if (end > begin) visit(begin, end - begin);
}

// The transformed vertices of the draws of a round.
struct VertexTables {
  CacheAlignedVector<SnappedEntry> screen;
  // The normals of a draw's vertices, then those of its faces; one draw after the other.
  CacheAlignedVector<Normal<Eye>> normals;
  CacheAlignedVector<Point<Eye>> eye_positions;
};

// A slot: the part of the round's tables that belongs to a draw, or to several draws of one mesh
// that go through the stages together; their entries are stored one draw after the other.
struct DrawSlot {
  std::uint32_t draw = 0;                  // the first of the slot's draws
  std::span<const std::uint32_t> draws;    // the slot's draws, in the order of drawing
  const CornerIndices* indices = nullptr;  // of the triangles of all these draws, into the tables
  std::size_t first_position = 0, first_normal = 0, first_eye_position = 0;
  std::size_t positions = 0, normals = 0, eye_positions = 0;  // number of entries of each draw
  Reference first_reference = kReferenceStep;
  SnappedEntry* screen = nullptr;
  EyeSpace eye_space;  // of the first of the slot's draws

  std::span<ClusterVerdict> verdicts;  // for the mesh's clusters; empty: all are drawn
  // For each block of the mesh's tables, 0 if no eye needs any of it. Empty: all blocks are needed.
  std::span<const std::uint8_t> needed_positions, needed_normals;
};

// Returns a slot for draw `k` of the slot's draws alone.
DrawSlot slot_of_draw(const DrawSlot& slot, std::size_t k);

// A task of testing some clusters of one draw.
struct ClusterTask {
  std::uint32_t slot = 0, cull = 0;  // indices into the round's slots and cluster_culls
  std::size_t first = 0, count = 0;
};

// ---- bins ----

// An entry of a bin is the index of a small triangle in its slot. With this bit set, it is the
// index of a primitive that the chunk itself stores. (In the results of select_triangles the same
// bit is kLarge: a large triangle.)
inline constexpr std::uint32_t kChunkEntryBit = kLarge;

// Entries, each with the first and the last of the tiles that it touches, in the order of the draw.
struct UnsortedEntries {
  std::vector<std::uint32_t> entries;
  std::vector<TilePlace> first, last;
  std::size_t count = 0;

  // Returns columns (arrays) with room for `size` entries.
  BinColumns columns(std::size_t size) {
    return {grow_to(entries, size), grow_to(first, size), grow_to(last, size)};
  }
  void add(std::uint32_t entry, TilePlace first_tile, TilePlace last_tile) {
    const BinColumns at = columns(count + 1).starting_at(count);
    *at.entries = entry;
    *at.first = first_tile;
    *at.last = last_tile;
    ++count;
  }
};

// A run of consecutive entries that touch the same tiles.
struct BinRun {
  std::size_t begin = 0, end = 0;
};

// A chunk: some primitives of one slot, sorted into tiles in the order of the draw.
struct Chunk {
  enum class Kind { kLanes, kStagedTriangles, kLinesAndPoints };
  Kind kind = Kind::kLanes;
  std::uint32_t slot = 0;              // index into the round's slots
  std::uint32_t first = 0, count = 0;  // which triangles of the slot

  std::vector<std::int32_t> keep;  // for kLanes: 0 if the triangle was culled in object space
  UnsortedEntries selected;        // for kLanes: triangles that are not culled
  std::vector<LargeTriangle> large;
  std::vector<ReadyTriangle> triangles;  // triangles, lines and points: for the other kinds
  std::vector<ReadyLine> lines;
  std::vector<ReadyPoint> points;
  std::uint32_t first_large = 0;  // in the round, index of the first triangle of `large`

  UnsortedEntries unsorted;
  std::vector<BinRun> runs;

  // The tiles x0 <= x < x1, y0 <= y < y1 have bins, row by row. The entries of bin
  // i are entries[starts[i]] to entries[starts[i + 1] - 1].
  PixelRect tiles;
  std::vector<std::uint32_t> starts, entries;

  Statistics statistics;

  std::span<const std::uint32_t> bin(int tile_x, int tile_y) const {
    if (tile_x < tiles.x0 || tile_x >= tiles.x1 || tile_y < tiles.y0 || tile_y >= tiles.y1)
      return {};
    const auto i = std::size_t(tile_y - tiles.y0) * std::size_t(tiles.x1 - tiles.x0) +
                   std::size_t(tile_x - tiles.x0);
    return std::span(entries).subspan(starts[i], starts[i + 1] - starts[i]);
  }
};

struct DrawRound {
  VertexTables tables;
  std::vector<DrawSlot> slots;
  std::vector<ClusterCull> cluster_culls;  // for the slots whose clusters are tested
  std::vector<ClusterTask> cluster_tasks;
  std::vector<ClusterVerdict> verdicts;
  std::vector<std::uint8_t> needed;
  std::vector<Chunk> chunks;
  std::size_t chunk_count = 0;  // how many of the chunks are in use
  // The large triangles of all chunks, one after the other.
  std::vector<const LargeTriangle*> large;
  // Indexed by TileRun::tile_index: the chunks that have something in the tile, in order.
  std::vector<std::vector<std::uint32_t>> chunks_of_tile;
};

// ---- the work, in the order in which it is done ----

// Makes the slots of the draws beginning with order[first], as many as a round takes: up to
// `round_size` vertices or triangles, or one draw. Returns the index after the last draw. The
// tables have no memory yet; set_eye_space() is called after they have got it.
std::size_t make_slots(const TileRun& run, std::span<const std::uint32_t> order, std::size_t first,
                       std::size_t round_size, std::vector<DrawSlot>& slots);
void set_eye_space(const TileRun& run, VertexTables& tables, DrawSlot& slot);

// Lists the clusters of the round's draws that have to be tested, for one eye.
void begin_clusters(const TileRun& run, DrawRound& round);
void test_clusters(const TileRun& run, const DrawRound& round, const ClusterTask& task);
void count_clusters(const TileRun& run, const DrawRound& round, Statistics& statistics);
// Finds the vertices that are needed for at least one eye and marks them in the first eye's slots.
void find_needed_vertices(const TileRun& run, std::span<DrawRound> rounds);

// The inputs for the second eye of a pair.
struct SecondEyeInputs {
  const TileRun& run;
  const DrawSlot& slot;
};

// Fills the tables for positions first .. first + count - 1 of one draw (transform_normals: for its
// normals), where they are needed. `other` is null for one eye. For the second eye of a pair, only
// x is computed anew.
void transform_positions(const TileRun& run, const Kernels& kernels, const DrawSlot& slot,
                         const SecondEyeInputs* other, VertexTables& tables, std::size_t first,
                         std::size_t count);
void transform_normals(const TileRun& run, const Kernels& kernels, const DrawSlot& slot,
                       VertexTables& tables, std::size_t first, std::size_t count);
void transform_face_normals(const TileRun& run, const DrawSlot& slot, VertexTables& tables);

// Selects the chunk's primitives (some of those of a slot), prepares them and sorts them into
// tiles.
void fill_chunk(const TileRun& run, const Kernels& kernels, const DrawRound& round, Chunk& chunk);

}  // namespace glassbox
