#include "views/commands/voxels_report.h"

#include <algorithm>
#include <unordered_set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/exit_codes.h"
#include "views/commands/picture_choice.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::views {

namespace {

using Json = nlohmann::ordered_json;

double box_sides(const views::VoxelGrid& grid) {
  const auto [nx, ny, nz] = grid.count;
  return 2 * (double(nx) * ny + double(ny) * nz + double(nz) * nx);
}

// An upper bound of the memory in bytes for all outputs, in addition to colouring the voxels. All
// data are counted as if they existed at the same time.
double extra_bytes(const VoxelsInput& input, const views::ColoringRequest& request,
                   const VoxelsReportOptions& options, const views::VoxelGrid& grid) {
  const double coloured = box_sides(grid);
  double bytes = 0;
  // A verdict for each voxel, and a second copy for the page; for one picture at a time, the layers
  // that hide its pixels.
  if (options.wants_verdicts) {
    constexpr double kPixel = sizeof(int) + 2, kVoxel = 10;
    bytes += 2 * double(grid.voxels()) + views::pixels_of(input.set) * kPixel + coloured * kVoxel;
  }
  if (input.truth) {
    bytes += views::TrueVolume::bytes_for(grid) + views::surface_error_bytes(input.set, coloured);
  }
  // The voxels of the full colouring, and a hash set of their positions: for each position a node
  // with a number and a pointer, and a bucket.
  if (options.against_full && request.levels > 0) {
    constexpr double kNode = 4 * sizeof(void*) + sizeof(void*);
    bytes += coloured * (sizeof(views::ColoredVoxel) + kNode);
  }
  // The left-out picture, and a colour and a distance for each of its pixels.
  if (input.left_out) {
    constexpr double kPixel = sizeof(Rgba8) + sizeof(float);
    bytes +=
        views::bytes_of(*input.left_out) + double(input.left_out->color.pixels.size()) * kPixel;
  }
  return bytes;
}

Result<VoxelsReport::FullComparison> compare_full(const VoxelsInput& input,
                                                  views::ColoringRequest request,
                                                  const views::Coloring& coarse) {
  request.levels = 0;
  const auto full = views::color_voxels(input.set, request);
  if (!full) return tl::unexpected(full.error());
  std::unordered_set<std::uint64_t> all;
  for (const views::ColoredVoxel& voxel : full->voxels) all.insert(views::key_of(voxel.at));
  VoxelsReport::FullComparison against;
  against.full = std::int64_t(full->voxels.size());
  std::int64_t both = 0;
  for (const views::ColoredVoxel& voxel : coarse.voxels)
    both += all.contains(views::key_of(voxel.at));
  against.lost = against.full - both;
  against.added = std::int64_t(coarse.voxels.size()) - both;
  against.milliseconds = full->milliseconds;
  return against;
}

// The mean number of pictures and the mean deviation over the coloured voxels.
struct Means {
  double views = 0, deviation = 0;
};
Means means_of(const views::Coloring& coloring) {
  Means means;
  for (const views::ColoredVoxel& voxel : coloring.voxels) {
    means.views += voxel.views;
    means.deviation += double(voxel.deviation);
  }
  const double count = std::max(1.0, double(coloring.voxels.size()));
  return {means.views / count, means.deviation / count};
}

std::string test_text(const views::ColoringSettings& settings) {
  std::string text = settings.consistency == views::Consistency::kDeviation
                         ? fmt::format("sigma < {:g}", settings.threshold)
                     : settings.consistency == views::Consistency::kLikelihood
                         ? fmt::format("likelihood ratio, noise {:g}, significance {:g}",
                                       settings.noise, settings.significance)
                         : fmt::format("sigma < {:g} M + {:g}", settings.k1, settings.k2);
  text += settings.space == views::ColorSpace::kRgb
              ? " in RGB"
              : fmt::format(" in CIELab, L times {:g}", settings.lightness);
  if (settings.edge > 0) text += fmt::format(", edges of {:g}", settings.edge);
  return text;
}

// The direction of the layers in words; empty for space carving, which has none.
std::string layer_direction_text(const views::Coloring& coloring) {
  if (coloring.order == views::ColoringOrder::kCarve) return "";
  if (coloring.in_shells) return "shells";
  if (!coloring.grid.axes.isIdentity()) return "the oblique direction";
  return (coloring.direction[1] > 0 ? "" : "-") + std::string(1, char('x' + coloring.direction[0]));
}

std::string order_text(const views::Coloring& coloring) {
  if (coloring.order == views::ColoringOrder::kCarve)
    return fmt::format("carved in {} of six sweeps", counted(coloring.passes, "pass", "passes"));
  if (coloring.in_shells) return "swept outwards in " + counted(coloring.layers, "shell");
  return fmt::format("swept in {} along {}", counted(coloring.layers, "layer"),
                     layer_direction_text(coloring));
}

}  // namespace

Result<VoxelsReport> report_voxels(const VoxelsInput& input, const views::ColoringRequest& request,
                                   const VoxelsReportOptions& options, Progress& progress) {
  VoxelsReport report;
  const auto plan = views::plan_coloring(input.set, request);
  if (!plan) return tl::unexpected(plan.error());
  const views::VoxelGrid* const grid = &plan->grid;
  report.bytes = std::uint64_t(double(plan->bytes) + extra_bytes(input, request, options, *grid));
  const auto legal = check_memory(request.size_option,
                                  fmt::format("{} x {} x {} voxels and the requested outputs",
                                              grid->count[0], grid->count[1], grid->count[2]),
                                  double(report.bytes), request.most_bytes);
  if (!legal) return tl::unexpected(legal.error());
  std::optional<views::TrueVolume> truth;
  std::optional<views::Overlap> overlap;
  if (input.truth) {
    progress.phase("computing which voxels are inside the scene");
    truth.emplace(*input.truth, *grid);
    overlap.emplace(*truth);
  }
  views::LayerWatcher watch;
  if (options.wants_verdicts) report.verdicts.assign(std::size_t(grid->voxels()), Verdict::kHidden);
  if (options.wants_verdicts || overlap) {
    watch = [&](int, std::span<const views::VoxelRun> runs, std::span<const Verdict> verdicts) {
      if (overlap) overlap->add(runs, verdicts);
      if (!options.wants_verdicts) return;
      std::size_t next = 0;
      for (const views::VoxelRun& run : runs) {
        for (int i = 0; i < run.count; ++i) {
          report.verdicts[grid->index(run.at(i))] = verdicts[next++];
        }
      }
    };
  }
  progress.phase("colouring voxels");
  report.coloring = views::color_voxels(input.set, request, *plan, watch);
  if (overlap) {
    for (const views::VoxelRun& run : report.coloring.solid) overlap->add(run);
    progress.phase("measuring the surface");
    const auto distances = views::true_distances(*input.truth, input.set);
    if (!distances) return tl::unexpected(distances.error());
    report.truth = VoxelsReport::TruthComparison{
        truth->voxels(), overlap->found(), overlap->iou(),
        views::surface_errors(report.coloring.voxels,
                              views::visible_surface(input.set, *distances, *grid))};
  }
  if (options.against_full && request.levels > 0) {
    progress.phase("colouring all voxels");
    const auto against = compare_full(input, request, report.coloring);
    if (!against) return tl::unexpected(against.error());
    report.against_full = *against;
  }
  if (input.left_out) {
    const views::CalibratedPicture& picture = *input.left_out;
    report.drawn = views::draw_voxels(report.coloring.grid, report.coloring.voxels, picture.camera,
                                      picture.color.width, picture.color.height, {0, 0, 0, 255});
    report.left_out = views::voxel_picture_errors(*report.drawn, picture);
  }
  return report;
}

std::string voxels_text(const VoxelsInput& input, const views::ColoringRequest& request,
                        const VoxelsReport& report) {
  const views::Coloring& coloring = report.coloring;
  const auto& [nx, ny, nz] = coloring.grid.count;
  const bool is_carved = coloring.order == views::ColoringOrder::kCarve;
  std::string text = fmt::format(
      "{}: {}, cameras {}\n{} x {} x {} voxels of {:.6g}, {}\n{}; compared pixels of a voxel: {}; "
      "pixels that it hides: {}, after each {}\n",
      printable(input.set.source, kLongPath), counted(input.set.pictures.size(), "picture"),
      views::name_of(coloring.traversal), nx, ny, nz, coloring.grid.size, order_text(coloring),
      test_text(request.settings), views::name_of(request.settings.sampled),
      views::name_of(request.settings.hidden), views::name_of(request.settings.update));
  const Means means = means_of(coloring);
  text +=
      fmt::format("{}, seen by {:.1f} pictures on average, sigma {:.2f} on average\n",
                  counted(coloring.voxels.size(), "coloured voxel"), means.views, means.deviation);
  if (is_carved) {
    text += fmt::format("remaining voxels: {} at the surface are visible, {} are hidden\n",
                        coloring.counts[std::size_t(Verdict::kColored)],
                        coloring.counts[std::size_t(Verdict::kHidden)]);
  } else {
    text += fmt::format("{} voxels tested: {} background, {} hidden, {} inconsistent\n",
                        coloring.examined, coloring.counts[std::size_t(Verdict::kBackground)],
                        coloring.counts[std::size_t(Verdict::kHidden)],
                        coloring.counts[std::size_t(Verdict::kInconsistent)]);
  }
  if (request.levels > 0 && !is_carved) {
    text += fmt::format("coarse to fine: {} first, with {} tested\n",
                        counted(request.levels, "coarser level"),
                        counted(coloring.examined_coarse, "voxel"));
  }
  text += fmt::format("{:.1f} ms on {}, {} MB\n", coloring.milliseconds,
                      name_of(request.settings.target), (report.bytes + (1u << 20) - 1) >> 20);
  if (const auto& full = report.against_full) {
    text += fmt::format(
        "compared with testing all voxels, {} coloured in {:.1f} ms: {} lost ({:.3f} %), {} added; "
        "IoU {:.5f}\n",
        full->full, full->milliseconds, full->lost,
        100 * double(full->lost) / double(std::max<std::int64_t>(1, full->full)), full->added,
        full->iou());
  }
  if (const auto& errors = report.left_out) {
    text += fmt::format(
        "{} was left out: RMS {:.2f} ({:.2f} %) over the {:.1f} % of its object that voxels "
        "cover;\n"
        "  voxels outside it cover {:.1f} % of the object's area\n",
        printable(input.left_out->name, kLongPath), errors->rms, errors->rms_percent,
        100 * errors->covered, 100 * errors->beside);
  }
  if (const auto& truth = report.truth) {
    text += fmt::format(
        "compared with the truth: {} voxels are inside the true scene, {} are not proved empty; "
        "IoU {:.4f}\ndistances between the surfaces, in voxels: {:.2f} from found to true (at most "
        "{:.2f}), {:.2f} from true to found (at most {:.2f})\n",
        truth->inside, truth->not_empty, truth->iou, truth->surface.to_truth_mean,
        truth->surface.to_truth_most, truth->surface.from_truth_mean,
        truth->surface.from_truth_most);
  }
  const std::int64_t alone = coloring.counts[std::size_t(Verdict::kAlone)];
  if (alone > 0) {
    text += fmt::format("Left out: {} that only one picture sees (--alone keep keeps them).\n",
                        counted(alone, "voxel"));
  }
  if (!coloring.is_finished) {
    text += fmt::format(
        "Carving was stopped after {} passes, the largest number that is allowed, although the "
        "last pass still removed voxels: the shape may be too large.\n",
        coloring.passes);
  }
  if (std::ranges::any_of(input.set.pictures,
                          [](const auto& picture) { return picture.matte.pixels.empty(); })) {
    text +=
        "Left out: the background. In a picture without a mask every pixel counts as the object "
        "(--matte-above makes a mask).\n";
  }
  return text;
}

Json voxels_json(const VoxelsInput& input, const views::ColoringRequest& request,
                 const VoxelsReport& report) {
  const views::Coloring& coloring = report.coloring;
  const views::ColoringSettings& settings = request.settings;
  const Means means = means_of(coloring);
  Json json{{"cameras", input.set.source},
            {"pictures", input.set.pictures.size()},
            {"traversal", views::name_of(coloring.traversal)},
            {"order", views::name_of(coloring.order)},
            {"along", layer_direction_text(coloring)},
            {"layers", coloring.layers},
            {"passes", coloring.passes},
            {"finished", coloring.is_finished},
            {"count", {coloring.grid.count[0], coloring.grid.count[1], coloring.grid.count[2]}},
            {"voxel", coloring.grid.size},
            {"test", views::name_of(settings.consistency)},
            {"space", views::name_of(settings.space)},
            {"footprint", views::name_of(settings.sampled)},
            {"hides", views::name_of(settings.hidden)},
            {"update", views::name_of(settings.update)},
            {"coloured", coloring.voxels.size()},
            {"mean_views", means.views},
            {"mean_sigma", means.deviation},
            {"judged", coloring.examined},
            {"judged_coarse", coloring.examined_coarse}};
  for (int i = 0; i < views::kVerdicts; ++i)
    json["verdicts"][std::string(views::name_of(Verdict(i)))] = coloring.counts[std::size_t(i)];
  json["ms"] = coloring.milliseconds;
  json["target"] = name_of(settings.target);
  json["bytes"] = report.bytes;
  if (const auto& full = report.against_full) {
    json["against_full"] = {{"coloured", full->full},
                            {"lost", full->lost},
                            {"added", full->added},
                            {"iou", full->iou()},
                            {"ms", full->milliseconds}};
  }
  if (const auto& errors = report.left_out) {
    json["left_out"] = {{"picture", input.left_out->name},    {"rms", errors->rms},
                        {"rms_percent", errors->rms_percent}, {"covered", errors->covered},
                        {"beside", errors->beside},           {"pixels", errors->pixels}};
  }
  if (const auto& truth = report.truth) {
    json["truth"] = {{"inside", truth->inside},
                     {"not_empty", truth->not_empty},
                     {"iou", truth->iou},
                     {"to_truth_mean", truth->surface.to_truth_mean},
                     {"to_truth_most", truth->surface.to_truth_most},
                     {"from_truth_mean", truth->surface.from_truth_mean},
                     {"from_truth_most", truth->surface.from_truth_most}};
  }
  return json;
}

}  // namespace glassbox::views
