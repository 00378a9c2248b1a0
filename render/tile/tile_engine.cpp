#include <glassbox/render/tile/tile_engine.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <deque>

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <glassbox/render/engine/stopwatch.h>
#include <glassbox/render/plan/plan.h>
#include <glassbox/render/tile/draw_round.h>
#include <glassbox/render/tile/tile_pass.h>
#include <glassbox/render/tile/tile_picture.h>

namespace glassbox {

namespace {

// The number of vertices in one task of the vertex stage, and of triangles in one chunk (a task of
// the stages up to the sorting into tiles).
constexpr std::size_t kVertexBatch = 4096;
constexpr std::uint32_t kChunkTriangles = 8192;

void add(const Statistics& part, Statistics& sum) {
  sum.culled_early += part.culled_early;
  sum.rejected += part.rejected;
  sum.clipped_away += part.clipped_away;
  sum.clipped += part.clipped;
  sum.after_clipping += part.after_clipping;
  sum.zero_area += part.zero_area;
  sum.culled += part.culled;
  sum.set_up += part.set_up;
  sum.covered += part.covered;
  sum.depth_failed += part.depth_failed;
  sum.discarded += part.discarded;
  sum.written += part.written;
  sum.blended += part.blended;
}

// A task of the vertex stage: some entries of one draw, or all entries of some draws of one slot.
struct VertexTask {
  enum class Kind { kPositions, kNormals, kFaceNormals };
  Kind kind = Kind::kPositions;
  std::uint32_t slot = 0;
  std::size_t first_draw = 0, draws = 1;
  std::size_t first = 0, count = 0;  // which entries of each draw
};

constexpr std::size_t kMaxEyes = 2;

}  // namespace

struct TileEngine::State {
  // The pictures of one eye or two. (A deque, because a picture cannot be moved.)
  using Pictures = std::deque<TilePicture>;

  explicit State(const TileOptions& o)
      : options(o),
        kernels(glassbox::kernels(o.target)),
        threads(o.threads > 0 ? o.threads : default_threads()),
        arena(threads),
        memories([side = o.tile_side] { return TileMemory(side); }) {
    allow_threads(threads);
  }

  using StageTime = double TileReport::Thread::*;

  template <class Work>
  void for_each(StageTime stage, std::size_t count, const Work& work) {
    const auto timed = [&](std::size_t i) {
      if (report == nullptr) return work(i);
      const Stopwatch watch(at_work.local().*stage);
      work(i);
    };
    // If there are thousands of small items of work, a task takes several of them.
    const std::size_t together = 1 + count / 4096;
    const auto some = [&](const tbb::blocked_range<std::size_t>& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) timed(i);
    };
    const tbb::blocked_range<std::size_t> all(0, count, together);
    arena.execute([&] { tbb::parallel_for(all, some, tbb::simple_partitioner()); });
  }

  // ---- a round: some of the draws ----

  // Makes slots for the draws from `first` on, as many as a round takes (the draws that go through
  // the stages together); returns the index after the last draw.
  std::size_t begin_round(const Pictures& pictures, std::size_t first);
  void cull_clusters(const Pictures& pictures);
  void transform_vertices(const Pictures& pictures);
  void fill_chunks(const Pictures& pictures);
  void draw_tiles(const Pictures& pictures, std::span<const TilePass> passes);

  TileOptions options;
  const Kernels& kernels;
  int threads;
  // The threads of this engine, which may be more than the machine has (allow_threads).
  tbb::task_arena arena;
  tbb::enumerable_thread_specific<TileMemory> memories;
  PlannedPicture planned;
  std::array<DrawRound, kMaxEyes> rounds;  // by eye; data that both eyes share is in the first
  std::vector<VertexTask> vertex_tasks;
  TileReport* report = nullptr;  // of the picture being drawn; null if none is wanted
  tbb::enumerable_thread_specific<TileReport::Thread> at_work;
};

std::size_t TileEngine::State::begin_round(const Pictures& pictures, std::size_t first) {
  const TileRun& run = pictures.front().run();
  std::vector<DrawSlot>& slots = rounds.front().slots;
  const std::size_t end =
      make_slots(run, pictures.front().plan().order, first, options.round_size, slots);
  VertexTables& tables = rounds.front().tables;
  using CountOf = std::size_t DrawSlot::*;
  const auto entries = [&](CountOf begin, CountOf of_draw) {
    if (slots.empty()) return std::size_t{0};
    const DrawSlot& last = slots.back();
    return last.*begin + last.draws.size() * last.*of_draw;
  };
  grow_to(tables.normals, entries(&DrawSlot::first_normal, &DrawSlot::normals));
  grow_to(tables.eye_positions, entries(&DrawSlot::first_eye_position, &DrawSlot::eye_positions));
  for (DrawSlot& slot : slots) set_eye_space(run, tables, slot);
  const std::size_t positions = entries(&DrawSlot::first_position, &DrawSlot::positions);
  for (std::size_t eye = 0; eye < pictures.size(); ++eye) {
    DrawRound& round = rounds[eye];
    if (eye > 0) round.slots = slots;
    SnappedEntry* screen = grow_to(round.tables.screen, positions);
    for (DrawSlot& slot : round.slots) slot.screen = screen + slot.first_position;
  }
  return end;
}

void TileEngine::State::cull_clusters(const Pictures& pictures) {
  for (std::size_t eye = 0; eye < pictures.size(); ++eye) {
    const TileRun& run = pictures[eye].run();
    DrawRound& round = rounds[eye];
    begin_clusters(run, round);
    for_each(&TileReport::Thread::vertex_ms, round.cluster_tasks.size(),
             [&](std::size_t i) { test_clusters(run, round, round.cluster_tasks[i]); });
    count_clusters(run, round, pictures[eye].statistics());
  }
  find_needed_vertices(pictures.front().run(), std::span(rounds).first(pictures.size()));
}

namespace {

// Returns how many entries of a table are transformed: all, or those of the needed blocks.
std::size_t count_needed(std::span<const std::uint8_t> needed, std::size_t table_size) {
  if (needed.empty()) return table_size;
  const auto blocks = std::size_t(std::ranges::count(needed, std::uint8_t(1)));
  // Entries of the last block that are beyond the table's end.
  const std::size_t beyond = needed.size() * kTableBlock - table_size;
  return blocks * kTableBlock - (needed.back() != 0 ? beyond : 0);
}

}  // namespace

void TileEngine::State::transform_vertices(const Pictures& pictures) {
  const TileRun& run = pictures.front().run();
  DrawRound& round = rounds.front();
  vertex_tasks.clear();
  const auto add_tasks = [&](VertexTask::Kind kind, std::uint32_t slot, std::size_t size) {
    if (size == 0) return;
    const std::size_t draws = round.slots[slot].draws.size();
    const std::size_t together = std::max<std::size_t>(kVertexBatch / size, 1);
    for (std::size_t draw = 0; draw < draws; draw += together) {
      for (std::size_t at = 0; at < size; at += kVertexBatch) {
        vertex_tasks.push_back({kind, slot, draw, std::min(together, draws - draw), at,
                                std::min(kVertexBatch, size - at)});
      }
    }
  };
  for (std::uint32_t i = 0; i < round.slots.size(); ++i) {
    const DrawSlot& slot = round.slots[i];
    const std::size_t draws = slot.draws.size(), normals = slot.eye_space.normals.size();
    const std::size_t positions = count_needed(slot.needed_positions, slot.positions);
    Statistics& statistics = pictures.front().statistics();
    statistics.vertices += draws * positions;
    if (normals > 0) statistics.normals += draws * count_needed(slot.needed_normals, normals);
    statistics.normals += draws * slot.eye_space.face_normals.size();
    if (!slot.eye_space.positions.empty()) statistics.eye_positions += draws * positions;
    if (pictures.size() > 1) pictures.back().statistics().moved_in_x += draws * positions;
    for (const TilePicture& picture : pictures) {
      for (const std::uint32_t draw : slot.draws) {
        if (picture.run().methods[draw].test_planes) picture.statistics().plane_tests += positions;
      }
    }
    add_tasks(VertexTask::Kind::kPositions, i, slot.positions);
    add_tasks(VertexTask::Kind::kNormals, i, normals);
    add_tasks(VertexTask::Kind::kFaceNormals, i, slot.eye_space.face_normals.empty() ? 0 : 1);
  }
  for_each(&TileReport::Thread::vertex_ms, vertex_tasks.size(), [&](std::size_t i) {
    const VertexTask& task = vertex_tasks[i];
    for (std::size_t k = task.first_draw; k < task.first_draw + task.draws; ++k) {
      const DrawSlot slot = slot_of_draw(round.slots[task.slot], k);
      switch (task.kind) {
        case VertexTask::Kind::kPositions:
          if (pictures.size() == 1) {
            transform_positions(run, kernels, slot, nullptr, round.tables, task.first, task.count);
          } else {
            const DrawSlot of_other = slot_of_draw(rounds.back().slots[task.slot], k);
            const SecondEyeInputs other{pictures.back().run(), of_other};
            transform_positions(run, kernels, slot, &other, round.tables, task.first, task.count);
          }
          break;
        case VertexTask::Kind::kNormals:
          transform_normals(run, kernels, slot, round.tables, task.first, task.count);
          break;
        case VertexTask::Kind::kFaceNormals:
          transform_face_normals(run, slot, round.tables);
          break;
      }
    }
  });
}

namespace {

// Makes the chunks of a round, not yet filled: each is some triangles of one slot, or its lines and
// points.
void begin_chunks(const TileRun& run, DrawRound& round) {
  round.chunk_count = 0;
  const auto add_chunk = [&](Chunk::Kind kind, std::uint32_t slot, std::uint32_t first,
                             std::uint32_t count) {
    if (round.chunks.size() == round.chunk_count) round.chunks.emplace_back();
    Chunk& chunk = round.chunks[round.chunk_count++];
    chunk.kind = kind;
    chunk.slot = slot;
    chunk.first = first;
    chunk.count = count;
  };
  for (std::uint32_t i = 0; i < round.slots.size(); ++i) {
    const DrawSlot& slot = round.slots[i];
    const Draw& draw = run.list.draws[slot.draw];
    const auto triangles = std::uint32_t(slot.draws.size() * draw.triangulation->triangles.size());
    const bool staged = run.methods[slot.draw].staged_because != nullptr;
    for (std::uint32_t at = 0; at < triangles; at += kChunkTriangles) {
      add_chunk(staged ? Chunk::Kind::kStagedTriangles : Chunk::Kind::kLanes, i, at,
                std::min(kChunkTriangles, triangles - at));
    }
    if (!draw.mesh->lines.empty() || !draw.mesh->points.empty()) {
      add_chunk(Chunk::Kind::kLinesAndPoints, i, 0, 0);
    }
  }
}

void list_large_triangles(DrawRound& round) {
  round.large.clear();
  for (std::size_t i = 0; i < round.chunk_count; ++i) {
    Chunk& chunk = round.chunks[i];
    chunk.first_large = std::uint32_t(round.large.size());
    for (const LargeTriangle& large : chunk.large) round.large.push_back(&large);
  }
}

// Lists for each tile the chunks (each has some primitives of one slot) that have something in it:
// in a scene of many draws these are only a few.
void list_chunks_of_tiles(const TileRun& run, DrawRound& round) {
  for (std::vector<std::uint32_t>& chunks : round.chunks_of_tile) chunks.clear();
  round.chunks_of_tile.resize(run.tile_count());
  for (std::uint32_t i = 0; i < round.chunk_count; ++i) {
    const Chunk& chunk = round.chunks[i];
    for (int y = chunk.tiles.y0; y < chunk.tiles.y1; ++y) {
      for (int x = chunk.tiles.x0; x < chunk.tiles.x1; ++x) {
        if (!chunk.bin(x, y).empty()) round.chunks_of_tile[run.tile_index(x, y)].push_back(i);
      }
    }
  }
}

}  // namespace

// Fills the chunks (tasks of some triangles) of a pair's two eyes in turn: the data that the first
// eye's chunk has read is then in the cache for the same chunk of the second eye.
void TileEngine::State::fill_chunks(const Pictures& pictures) {
  const std::size_t eyes = pictures.size();
  for (std::size_t eye = 0; eye < eyes; ++eye) begin_chunks(pictures[eye].run(), rounds[eye]);
  for_each(&TileReport::Thread::triangle_ms, rounds.front().chunk_count * eyes, [&](std::size_t i) {
    DrawRound& round = rounds[i % eyes];
    fill_chunk(pictures[i % eyes].run(), kernels, round, round.chunks[i / eyes]);
  });
  for (std::size_t eye = 0; eye < eyes; ++eye) {
    list_large_triangles(rounds[eye]);
    list_chunks_of_tiles(pictures[eye].run(), rounds[eye]);
    for (std::size_t i = 0; i < rounds[eye].chunk_count; ++i) {
      add(rounds[eye].chunks[i].statistics, pictures[eye].statistics());
    }
  }
}

namespace {

// Whether a tile's colours can stay in memory until the second eye has been drawn: the second eye
// draws over the first eye's colours, and colours are read and written only at the end, when the
// tile is resolved.
bool share_colors(std::span<const TilePass> passes) {
  return passes.size() > 1 && passes.front().resolve.drawn_over &&
         !passes.front().resolve.keep_picture && passes.back().resolve.picture != nullptr &&
         samples_drawn(passes.front().run.settings) == 1;
}

}  // namespace

// Draws a tile of the first eye, then the same tile of the second eye, which may draw into the same
// picture.
void TileEngine::State::draw_tiles(const Pictures& pictures, std::span<const TilePass> passes) {
  const TileRun& run = pictures.front().run();
  const int across = run.tiles_across();
  const bool shared = share_colors(passes);
  const auto tile_pixels = std::size_t(run.tile_side) * std::size_t(run.tile_side);
  tbb::enumerable_thread_specific<std::array<Statistics, kMaxEyes>> counts;
  for_each(&TileReport::Thread::fragment_ms, run.tile_count(), [&](std::size_t i) {
    TileMemory& memory = memories.local();
    std::uint32_t* const both_eyes = shared ? grow_to(memory.colors, tile_pixels) : nullptr;
    for (std::size_t eye = 0; eye < passes.size(); ++eye) {
      draw_tile(passes[eye], int(i) % across, int(i) / across, memory, both_eyes,
                counts.local()[eye]);
    }
  });
  for (const auto& part : counts) {
    for (std::size_t eye = 0; eye < passes.size(); ++eye) {
      add(part[eye], pictures[eye].statistics());
    }
  }
}

// ---- a picture ----

namespace {

// Adds the counts of a round (some of the draws) to the report.
void count_round(const DrawRound& round, TileReport& report) {
  for (std::size_t i = 0; i < round.chunk_count; ++i) {
    report.triangles += round.chunks[i].count;
    report.list_entries += round.chunks[i].entries.size();
  }
  report.large_triangles += round.large.size();
  report.runs += round.slots.size();
  for (const DrawSlot& slot : round.slots) report.draws += slot.draws.size();
}

std::uint64_t plane_bytes(const Framebuffer& f) {
  return 4 * (f.color.pixels.size() + f.depth.pixels.size() + f.distance.pixels.size() +
              f.id.pixels.size() + f.writes.pixels.size());
}

}  // namespace

TileEngine::TileEngine(const TileOptions& options) : state_(std::make_unique<State>(options)) {}
TileEngine::~TileEngine() = default;

PairCullCounts TileEngine::draw(const PictureJob& job) {
  render(job.scene, job.prepared, job.eyes);
  return {};
}

void TileEngine::render(const Scene& scene, const PreparedScene& prepared,
                        std::span<const EyePicture> eyes, TileReport* report) {
  assert(!eyes.empty() && eyes.size() <= kMaxEyes);
  State& s = *state_;
  for (const EyePicture& eye : eyes) eye.statistics = {};
  Statistics& shared = eyes.front().statistics;
  State::Pictures pictures;
  {
    const Stopwatch watch(shared.prepare_ms);
    plan_picture(scene, prepared, eyes, s.options.planner, s.options.plan, s.planned);
    for (std::size_t i = 0; i < eyes.size(); ++i) {
      pictures.emplace_back(eyes[i], s.planned.lists[i], s.planned.plans[i], s.options.tile_side);
    }
  }
  for (const TilePicture& picture : pictures) picture.count_input();
  s.report = report;
  s.at_work.clear();

  const std::size_t draws = pictures.front().plan().order.size();
  std::size_t first = 0;
  do {
    const std::size_t end = s.begin_round(pictures, first);
    if (first == 0) {
      const Stopwatch watch(shared.prepare_ms);
      for (TilePicture& picture : pictures) picture.prepare_framebuffer(end == draws);
    }
    {
      const Stopwatch watch(shared.vertex_ms);
      s.cull_clusters(pictures);
      s.transform_vertices(pictures);
    }
    {
      const Stopwatch watch(shared.triangle_ms);
      s.fill_chunks(pictures);
    }
    {
      const Stopwatch watch(shared.fragment_ms);
      std::vector<TilePass> passes;
      for (std::size_t eye = 0; eye < pictures.size(); ++eye) {
        passes.push_back(pictures[eye].pass(s.kernels, s.rounds[eye], first == 0));
      }
      passes.front().resolve.drawn_over = eyes.size() > 1 && eyes.back().draws_over();
      s.draw_tiles(pictures, passes);
    }
    if (report != nullptr) {
      for (std::size_t eye = 0; eye < pictures.size(); ++eye) count_round(s.rounds[eye], *report);
    }
    first = end;
    if (report != nullptr) ++report->rounds;
  } while (first < draws);
  for (const TilePicture& picture : pictures) picture.finish();
  if (report != nullptr) {
    report->threads.assign(s.at_work.begin(), s.at_work.end());
    const auto tiles = [&](float side_px) {
      return std::uint64_t(int(side_px) + s.options.tile_side - 1) /
             std::uint64_t(s.options.tile_side);
    };
    report->textures = prepared.textures.size();
    report->textures_made = std::uint64_t(std::ranges::count_if(
        prepared.textures, [](const auto& texture) { return texture->made(); }));
    for (const EyePicture& eye : eyes) {
      report->tiles += tiles(eye.view.viewport.width()) * tiles(eye.view.viewport.height());
      report->plane_bytes += plane_bytes(eye.target);
    }
  }
}

void TileEngine::render(const Scene& scene, const PreparedScene& prepared, const View& view,
                        const RenderSettings& settings, Rendering& into, TileReport* report) {
  const EyePicture eye{view, settings, into.buffers, into.buffers.color, into.statistics};
  render(scene, prepared, {&eye, 1}, report);
}

Rendering render_tiled(const Scene& scene, const View& view, const RenderSettings& settings,
                       const TileOptions& options) {
  Rendering rendering;
  const PreparedScene prepared = prepare_scene(scene, settings.transfer);
  TileEngine(options).render(scene, prepared, view, settings, rendering);
  return rendering;
}

}  // namespace glassbox
