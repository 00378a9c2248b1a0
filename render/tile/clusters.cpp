#include <algorithm>

#include <glassbox/render/tile/draw_round.h>

namespace glassbox {

namespace {

constexpr std::size_t kClustersOfTask = 1024;

const Clusters& clusters_of(const TileRun& run, const DrawSlot& slot) {
  return run.list.draws[slot.draw].prepared->clusters;
}

bool uses_cluster_culling(const TileRun& run, const DrawSlot& slot) {
  return run.methods[slot.draw].no_clusters_because == nullptr;
}

std::size_t blocks_in(std::size_t table_size) {
  return (table_size + kTableBlock - 1) / kTableBlock;
}

}  // namespace

void begin_clusters(const TileRun& run, DrawRound& round) {
  round.cluster_culls.clear();
  round.cluster_tasks.clear();
  std::size_t size = 0;
  for (const DrawSlot& slot : round.slots) {
    if (uses_cluster_culling(run, slot)) size += clusters_of(run, slot).clusters.size();
  }
  ClusterVerdict* next = grow_to(round.verdicts, size);
  for (std::uint32_t i = 0; i < round.slots.size(); ++i) {
    DrawSlot& slot = round.slots[i];
    if (!uses_cluster_culling(run, slot)) continue;
    const std::size_t count = clusters_of(run, slot).clusters.size();
    slot.verdicts = std::span(next, count);
    next += count;
    const auto cull = std::uint32_t(round.cluster_culls.size());
    round.cluster_culls.emplace_back(run.list.draws[slot.draw], run.view, run.settings.cull,
                                     run.methods[slot.draw].classification.inside);
    for (std::size_t at = 0; at < count; at += kClustersOfTask) {
      round.cluster_tasks.push_back({i, cull, at, std::min(kClustersOfTask, count - at)});
    }
  }
}

void test_clusters(const TileRun& run, const DrawRound& round, const ClusterTask& task) {
  const DrawSlot& slot = round.slots[task.slot];
  const ClusterCull& cull = round.cluster_culls[task.cull];
  const std::span all(clusters_of(run, slot).clusters);
  std::ranges::transform(all.subspan(task.first, task.count),
                         slot.verdicts.begin() + std::ptrdiff_t(task.first),
                         [&](const Cluster& cluster) { return cull.classify(cluster); });
}

void count_clusters(const TileRun& run, const DrawRound& round, Statistics& statistics) {
  for (const DrawSlot& slot : round.slots) {
    const std::size_t triangles = run.list.draws[slot.draw].triangulation->triangles.size();
    statistics.clusters += slot.verdicts.size();
    for (std::size_t i = 0; i < slot.verdicts.size(); ++i) {
      const ClusterVerdict verdict = slot.verdicts[i];
      statistics.clusters_outside += verdict == ClusterVerdict::kOutside;
      statistics.clusters_turned_away += verdict == ClusterVerdict::kTurnedAway;
      if (verdict == ClusterVerdict::kDrawn) continue;
      const std::size_t first = i * kClusterTriangles;
      const auto count = std::min<std::size_t>(kClusterTriangles, triangles - first);
      statistics.left_out += count;
      statistics.left_out_in_clusters += count;
    }
  }
}

void find_needed_vertices(const TileRun& run, std::span<DrawRound> rounds) {
  DrawRound& first = rounds.front();
  const auto all_drawn = [&](std::size_t slot) {
    return std::ranges::any_of(
        rounds, [&](const DrawRound& round) { return round.slots[slot].verdicts.empty(); });
  };
  std::size_t size = 0;
  for (std::size_t i = 0; i < first.slots.size(); ++i) {
    if (all_drawn(i)) continue;
    const Mesh& mesh = *run.list.draws[first.slots[i].draw].mesh;
    size += blocks_in(mesh.positions.size()) + blocks_in(mesh.normals.size());
  }
  std::uint8_t* next = grow_to(first.needed, size);
  std::fill_n(next, size, std::uint8_t(0));

  const auto mark = [&](std::size_t slot, const ClusterBlocks& blocks, std::size_t table_size) {
    const std::span needed(next, blocks_in(table_size));
    next += needed.size();
    for (const DrawRound& round : rounds) {
      const std::span<const ClusterVerdict> verdicts = round.slots[slot].verdicts;
      for (std::size_t cluster = 0; cluster < verdicts.size(); ++cluster) {
        if (verdicts[cluster] != ClusterVerdict::kDrawn) continue;
        for (const std::uint32_t block : blocks.of_cluster(cluster)) needed[block] = 1;
      }
    }
    return needed;
  };
  for (std::size_t i = 0; i < first.slots.size(); ++i) {
    if (all_drawn(i)) continue;
    DrawSlot& slot = first.slots[i];
    const Draw& draw = run.list.draws[slot.draw];
    const Clusters& clusters = draw.prepared->clusters;
    slot.needed_positions = mark(i, clusters.positions, draw.mesh->positions.size());
    slot.needed_normals = mark(i, clusters.normals, draw.mesh->normals.size());
  }
}

}  // namespace glassbox
