#include <glassbox/render/tile/tile_engine.h>

#include <algorithm>
#include <cstddef>

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <glassbox/render/show.h>
#include <glassbox/render/stopwatch.h>
#include <glassbox/render/tile/round.h>
#include <glassbox/render/tile/tile_pass.h>

namespace glassbox {

namespace {

// Entries that one task of the vertex stage takes, and triangles of one chunk.
constexpr std::size_t kVertexBatch = 4096;
constexpr std::uint32_t kChunkTriangles = 8192;

void add(const Statistics& part, Statistics& sum) {
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

std::size_t size_of(const Draw& draw) {
  return std::max(draw.mesh->positions.size(), draw.triangulation->triangles.size());
}

// Part of the vertex stage's work.
struct VertexTask {
  enum class Kind { kPositions, kNormals, kFaceNormals };
  Kind kind = Kind::kPositions;
  std::uint32_t slot = 0;
  std::size_t first = 0, count = 0;
};

}  // namespace

struct TileEngine::State {
  explicit State(const TileOptions& o)
      : options(o),
        kernels(glassbox::kernels(o.target)),
        threads(o.threads > 0 ? o.threads : tbb::info::default_concurrency()),
        allowed(tbb::global_control::max_allowed_parallelism,
                std::size_t(std::max(threads, tbb::info::default_concurrency()))),
        arena(threads),
        buffers([side = o.tile_side] { return TileBuffer(side); }) {}

  template <class Work>
  void for_each(std::size_t count, const Work& work) {
    arena.execute(
        [&] { tbb::parallel_for(std::size_t{0}, count, work, tbb::simple_partitioner()); });
  }

  // ---- a round ----

  // Slots for draws from `first` on, as many as a round takes; returns the one after the last.
  std::size_t begin_round(const TileRun& run, std::size_t first);
  void transform_vertices(const TileRun& run);
  void fill_chunks(const TileRun& run);
  void draw_tiles(const TilePass& pass, Statistics& statistics);

  TileOptions options;
  const Kernels& kernels;
  int threads;
  tbb::global_control allowed;  // more threads than the machine has, if that is what was asked for
  tbb::task_arena arena;
  tbb::enumerable_thread_specific<TileBuffer> buffers;
  Round round;
  std::vector<VertexTask> vertex_tasks;
};

std::size_t TileEngine::State::begin_round(const TileRun& run, std::size_t first) {
  round.slots.clear();
  std::size_t positions = 0, normals = 0, eye_positions = 0, size = 0;
  Reference reference = 1;
  std::size_t end = first;
  for (; end < run.list.draws.size(); ++end) {
    const Draw& draw = run.list.draws[end];
    size += size_of(draw);
    if (end > first && size > options.round_size) break;
    const DrawMethod& method = run.methods[end];
    DrawSlot slot;
    slot.draw = std::uint32_t(end);
    slot.first_position = positions;
    slot.first_normal = normals;
    slot.first_eye_position = eye_positions;
    slot.first_reference = reference;
    positions += draw.mesh->positions.size();
    if (needs_normals(draw, run.settings)) {
      normals += draw.mesh->normals.size();
      if (needs_face_normals(draw, run.settings)) normals += draw.mesh->faces.size();
    }
    if (method.eye_positions) eye_positions += draw.mesh->positions.size();
    reference += Reference(draw.triangulation->triangles.size());
    round.slots.push_back(slot);
  }
  VertexTables& t = round.tables;
  SnappedEntry* screen = at_least(t.screen, positions);
  at_least(t.normals, normals);
  at_least(t.eye_positions, eye_positions);
  for (DrawSlot& slot : round.slots) {
    const Draw& draw = run.list.draws[slot.draw];
    slot.screen = screen + slot.first_position;
    slot.eye_space.lit = needs_normals(draw, run.settings);
    if (!slot.eye_space.lit) continue;
    const std::span all_normals(t.normals);
    slot.eye_space.normals = all_normals.subspan(slot.first_normal, draw.mesh->normals.size());
    if (needs_face_normals(draw, run.settings)) {
      slot.eye_space.face_normals = all_normals.subspan(
          slot.first_normal + draw.mesh->normals.size(), draw.mesh->faces.size());
    }
    if (run.methods[slot.draw].eye_positions) {
      slot.eye_space.positions =
          std::span(t.eye_positions).subspan(slot.first_eye_position, draw.mesh->positions.size());
    }
  }
  return end;
}

void TileEngine::State::transform_vertices(const TileRun& run) {
  vertex_tasks.clear();
  const auto add_tasks = [&](VertexTask::Kind kind, std::uint32_t slot, std::size_t size) {
    for (std::size_t at = 0; at < size; at += kVertexBatch) {
      vertex_tasks.push_back({kind, slot, at, std::min(kVertexBatch, size - at)});
    }
  };
  for (std::uint32_t i = 0; i < round.slots.size(); ++i) {
    const DrawSlot& slot = round.slots[i];
    add_tasks(VertexTask::Kind::kPositions, i, run.list.draws[slot.draw].mesh->positions.size());
    add_tasks(VertexTask::Kind::kNormals, i, slot.eye_space.normals.size());
    if (!slot.eye_space.face_normals.empty()) {
      vertex_tasks.push_back({VertexTask::Kind::kFaceNormals, i, 0, 0});
    }
  }
  for_each(vertex_tasks.size(), [&](std::size_t i) {
    const VertexTask& task = vertex_tasks[i];
    const DrawSlot& slot = round.slots[task.slot];
    switch (task.kind) {
      case VertexTask::Kind::kPositions:
        return transform_positions(run, kernels, slot, round.tables, task.first, task.count);
      case VertexTask::Kind::kNormals:
        return transform_normals(run, kernels, slot, round.tables, task.first, task.count);
      case VertexTask::Kind::kFaceNormals:
        return transform_face_normals(run, slot, round.tables);
    }
  });
}

void TileEngine::State::fill_chunks(const TileRun& run) {
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
    const Draw& draw = run.list.draws[round.slots[i].draw];
    const auto triangles = std::uint32_t(draw.triangulation->triangles.size());
    const bool staged = run.methods[round.slots[i].draw].staged_because != nullptr;
    for (std::uint32_t at = 0; at < triangles; at += kChunkTriangles) {
      add_chunk(staged ? Chunk::Kind::kStagedTriangles : Chunk::Kind::kLanes, i, at,
                std::min(kChunkTriangles, triangles - at));
    }
    if (!draw.mesh->lines.empty() || !draw.mesh->points.empty()) {
      add_chunk(Chunk::Kind::kLinesAndPoints, i, 0, 0);
    }
  }
  for_each(round.chunk_count,
           [&](std::size_t i) { fill_chunk(run, kernels, round, round.chunks[i]); });
  round.large.clear();
  for (std::size_t i = 0; i < round.chunk_count; ++i) {
    Chunk& chunk = round.chunks[i];
    chunk.first_large = std::uint32_t(round.large.size());
    for (const LargeTriangle& large : chunk.large) round.large.push_back(&large);
  }
}

void TileEngine::State::draw_tiles(const TilePass& pass, Statistics& statistics) {
  const int side = pass.run.tile_side;
  const int across = (pass.run.window.x1 + side - 1) / side;
  const int down = (pass.run.window.y1 + side - 1) / side;
  tbb::enumerable_thread_specific<Statistics> counts;
  for_each(std::size_t(across) * std::size_t(down), [&](std::size_t i) {
    draw_tile(pass, int(i) % across, int(i) / across, buffers.local(), counts.local());
  });
  for (const Statistics& part : counts) add(part, statistics);
}

// ---- a picture ----

namespace {

TileRun make_run(const DrawList& list, const View& view, const RenderSettings& settings,
                 int tile_side) {
  TileRun run{view, settings, list, {}, render_planes(view), {}, tile_side};
  run.window = {0, 0, int(view.viewport.width()), int(view.viewport.height())};
  for (const Draw& draw : list.draws) {
    run.methods.push_back(choose_method(draw, list.lighting, settings));
  }
  return run;
}

void count_input(const DrawList& list, Statistics& statistics) {
  for (const Draw& draw : list.draws) {
    ++statistics.instances;
    statistics.triangles += draw.triangulation->numbered;
    statistics.degenerate += draw.triangulation->numbered - draw.triangulation->triangles.size();
    statistics.lines += draw.mesh->lines.size();
    statistics.points += draw.mesh->points.size();
    statistics.vertices += draw.mesh->positions.size();
  }
}

// Some primitives write to the framebuffer themselves.
bool draws_in_framebuffer(const TileRun& run) {
  for (std::size_t i = 0; i < run.methods.size(); ++i) {
    const Mesh& mesh = *run.list.draws[i].mesh;
    if (run.methods[i].staged_because != nullptr || !mesh.lines.empty() || !mesh.points.empty()) {
      return true;
    }
  }
  return false;
}

bool is_whole(const ColorMask& mask) {
  return mask.r && mask.g && mask.b && mask.a;
}
bool is_empty(const ColorMask& mask) {
  return !mask.r && !mask.g && !mask.b && !mask.a;
}

// Shading of the small triangles of a draw, and of the large ones.
ShadeDraw shade_draw(const TileRun& run, const Round& round, const DrawSlot& slot) {
  const Draw& draw = run.list.draws[slot.draw];
  const DrawMethod& method = run.methods[slot.draw];
  const CornerIndices& indices = draw.prepared->indices;
  const auto or_positions = [&](const std::vector<std::uint32_t>& own) {
    return own.empty() ? indices.positions.data() : own.data();
  };
  ShadeDraw shade;
  shade.first_reference = slot.first_reference;
  shade.end_reference = slot.first_reference + Reference(draw.triangulation->triangles.size());
  shade.positions = indices.positions.data();
  shade.screen = slot.screen;
  shade.mirrored = draw.mirrored;
  shade.triangles = draw.triangulation->triangles.data();
  shade.first_number = draw.first_number;
  shade.material = draw.material;
  shade.light = method.light;
  shade.highlights = method.highlights;
  if (method.light != LightAt::kNowhere) {
    shade.normal_indices = or_positions(indices.normals);
    shade.normals = round.tables.normals.data() + slot.first_normal;
  }
  if (method.eye_positions) {
    shade.eye_positions = round.tables.eye_positions.data() + slot.first_eye_position;
  }
  if (method.texture) {
    shade.texture = draw.texture;
    shade.sampler = draw.sampler;
    if (indices.has_texcoords) {
      shade.texcoord_indices = or_positions(indices.texcoords);
      shade.texcoords = draw.mesh->texcoords.data();
    }
  }
  if (method.vertex_colors) {
    shade.color_indices = or_positions(indices.colors);
    shade.colors = draw.mesh->colors.data();
  }
  return shade;
}

// Planes of the right size with the values of a cleared framebuffer where `clear` says so; others are overwritten anyway.
void prepare_framebuffer(const TileRun& run, bool clear, bool with_depth, Framebuffer& target) {
  const int width = run.window.x1, height = run.window.y1;
  const auto plane = [&](auto& image, bool wanted, auto empty) {
    if (!wanted) {
      image = {};
    } else if (image.width != width || image.height != height) {
      image = {width, height, empty};
    } else if (clear) {
      std::ranges::fill(image.pixels, empty);
    }
  };
  const RenderSettings& s = run.settings;
  plane(target.color, true, s.background);
  plane(target.depth, with_depth, kEmptyDepth);
  plane(target.distance, s.want_distance || s.show == Show::kDepth,
        std::numeric_limits<float>::infinity());
  plane(target.id, s.want_id || s.show == Show::kId, std::uint32_t{0});
  plane(target.writes, s.show == Show::kOverdraw, std::uint32_t{0});
  std::ranges::fill(target.writes.pixels, 0u);  // which only staged fragments count up
}

}  // namespace

TileEngine::TileEngine(const TileOptions& options) : state_(std::make_unique<State>(options)) {}
TileEngine::~TileEngine() = default;

void TileEngine::render(const Scene& scene, const PreparedScene& prepared, const View& view,
                        const RenderSettings& settings, Rendering& into) {
  State& s = *state_;
  Statistics& statistics = into.statistics;
  statistics = {};
  DrawList list;
  std::optional<TileRun> made;
  {
    const Stopwatch watch(statistics.prepare_ms);
    list = make_draw_list(scene, prepared, view);
    made.emplace(make_run(list, view, settings, s.options.tile_side));
  }
  const TileRun& run = *made;
  count_input(list, statistics);

  const bool colors_are_painted_later = settings.show == Show::kDepth || settings.show == Show::kId;
  const bool wants_color = !colors_are_painted_later && !is_empty(settings.mask);
  std::size_t first = 0;
  do {
    const std::size_t end = s.begin_round(run, first);
    const bool many_rounds = first > 0 || end < list.draws.size();
    const bool through_framebuffer = many_rounds || draws_in_framebuffer(run);
    const bool keep = through_framebuffer || !is_whole(settings.mask) || !wants_color;
    if (first == 0) {
      const Stopwatch watch(statistics.prepare_ms);
      prepare_framebuffer(run, keep, through_framebuffer || settings.want_depth, into.buffers);
    }
    {
      const Stopwatch watch(statistics.vertex_ms);
      s.transform_vertices(run);
    }
    {
      const Stopwatch watch(statistics.triangle_ms);
      s.fill_chunks(run);
    }
    const Stopwatch watch(statistics.fragment_ms);
    for (std::size_t i = 0; i < s.round.chunk_count; ++i) {
      add(s.round.chunks[i].statistics, statistics);
    }
    std::vector<ShadeDraw> shades(list.draws.size());
    std::vector<std::uint32_t> by_reference;
    for (const DrawSlot& slot : s.round.slots) {
      shades[slot.draw] = shade_draw(run, s.round, slot);
      by_reference.push_back(slot.draw);
    }
    TilePass pass{
        run, s.kernels, s.round, {}, into.buffers, first > 0, many_rounds || settings.want_depth};
    ResolveJob& resolve = pass.resolve;
    resolve.draws = shades;
    resolve.by_reference = by_reference;
    resolve.large = s.round.large.data();
    resolve.lighting = &list.lighting;
    resolve.transfer = settings.transfer;
    resolve.mask = settings.mask;
    resolve.background = settings.background;
    resolve.keep_picture = keep;
    resolve.picture = wants_color ? &into.buffers.color : nullptr;
    resolve.distance = into.buffers.distance.pixels.empty() ? nullptr : &into.buffers.distance;
    resolve.id = into.buffers.id.pixels.empty() ? nullptr : &into.buffers.id;
    resolve.perspective = view.perspective;
    resolve.near = view.near;
    resolve.far = view.far;
    resolve.reversed = view.depth_range == DepthRange::kReversed;
    s.draw_tiles(pass, statistics);
    first = end;
  } while (first < list.draws.size());
  show(settings.show, into.buffers);
}

Rendering render_tiled(const Scene& scene, const View& view, const RenderSettings& settings,
                       const TileOptions& options) {
  Rendering rendering;
  const PreparedScene prepared = prepare(scene, settings.transfer);
  TileEngine(options).render(scene, prepared, view, settings, rendering);
  return rendering;
}

}  // namespace glassbox
