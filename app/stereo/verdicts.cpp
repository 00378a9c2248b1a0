#include "app/stereo/verdicts.h"

#include <algorithm>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::app {

namespace {

double percent_of(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100 * double(part) / double(whole);
}

std::string name_of_instance(const Scene& scene, std::uint32_t index) {
  constexpr std::size_t kLongName = 60;
  const Instance& instance = scene.instances[index];
  const std::string& node = scene.nodes[instance.node].name;
  const std::string& name = node.empty() ? scene.meshes[instance.mesh].name : node;
  return name.empty() ? fmt::format("instance {}", index) : printable(name, kLongName);
}

Verdict about_parallax(const StereoFindings& found) {
  const DepthFindings& depth = found.depth;
  const std::string seen = fmt::format(
      "the visible parallax is {:+.3f} % to {:+.3f} % of the width, and {:g} % is allowed in "
      "either direction",
      depth.nearest.percent, depth.farthest.percent, found.criteria.budget_percent);
  const double share = depth.share_beyond_budget();
  if (share == 0) return {"parallax", Level::kGood, "within the budget: " + seen};
  constexpr double kFew = 0.01;  // fraction of the pixels that is too small to tire the eyes
  return {"parallax", share < kFew ? Level::kWarning : Level::kBad,
          fmt::format("above the budget in {:.3g} % of the pixels: {}", 100 * share, seen)};
}

Verdict about_window(const Scene& scene, const StereoFindings& found) {
  const auto& cuts = found.depth.violations.found;
  if (cuts.empty()) {
    return {"window edges", Level::kGood,
            "nothing in front of the window is cut by the left or right edge"};
  }
  const auto worst = std::ranges::min_element(cuts, {}, &WindowViolation::least_px);
  return {"window edges", Level::kWarning,
          fmt::format(
              "{} in front of the window, cut by the left or right edge of a picture; the "
              "nearest stands out by {:.1f} px ({})",
              cuts.size() == 1 ? "one piece stands" : fmt::format("{} pieces stand", cuts.size()),
              -worst->least_px, names_of_cut(scene, *worst))};
}

Verdict about_divergence(const StereoFindings& found) {
  const DisplayedParallax& far = found.depth.farthest_displayed;
  const Display& display = found.criteria.display;
  const std::string where = fmt::format("on a display {:g} mm wide, {:g} mm away", display.width_mm,
                                        display.viewing_distance_mm);
  if (far.diverges) {
    return {"divergence", Level::kBad,
            fmt::format("{} the farthest visible surface has {:.0f} mm of parallax, and pupils are "
                        "{:g} mm apart: the eyes would have to diverge",
                        where, far.mm, kPupilDistanceMm)};
  }
  return {
      "divergence", Level::kGood,
      fmt::format("none: {} the farthest visible surface has {:.3g} mm of parallax, {:.2f} degrees",
                  where, far.mm, far.degrees)};
}

Verdict about_vertical(const StereoFindings& found) {
  const VerticalFindings& v = found.vertical;
  const std::string toed_in =
      v.toed_in_px == 0 ? "Cameras that are toed in would have no vertical parallax here either"
                        : fmt::format(
                              "Cameras that are toed in would have vertical parallax of up to "
                              "{:.3g} px, at pixel ({}, {})",
                              v.toed_in_px, v.x, v.y);
  if (v.skewed_px == 0) {
    return {"vertical parallax", Level::kGood,
            "none: the frusta are skewed, so the eyes look in the same direction. " + toed_in};
  }
  return {"vertical parallax", Level::kBad, fmt::format("{:.3g} px. {}", v.skewed_px, toed_in)};
}

Verdict about_rivalry(const StereoFindings& found) {
  const ColourFindings& colour = found.colour;
  const bool good = colour.mean_rivalry <= found.criteria.target_rivalry;
  return {"rivalry", good ? Level::kGood : Level::kWarning,
          fmt::format("{} anaglyph: {:.3f} on average, {:.3f} at worst (0: the same to both eyes, "
                      "1: white to one and black to the other); the target is {:g}",
                      name_of(found.criteria.method), colour.mean_rivalry, colour.worst_rivalry,
                      found.criteria.target_rivalry)};
}

Verdict about_ghosts(const StereoFindings& found) {
  const ColourFindings& colour = found.colour;
  if (!colour.measured_lenses) {
    return {"ghosts", Level::kFact,
            fmt::format("not known for {} glasses: their lenses were not measured, and ideal "
                        "lenses leak nothing",
                        name_of(found.criteria.glasses))};
  }
  return {"ghosts", Level::kFact,
          fmt::format(
              "light of the other eye's picture, compared with white: left {:.1f} % on average and "
              "{:.1f} % at worst, right {:.1f} % and {:.1f} %",
              100 * colour.mean_ghost.left, 100 * colour.worst_ghost.left,
              100 * colour.mean_ghost.right, 100 * colour.worst_ghost.right)};
}

Verdict about_order(const StereoFindings& found) {
  const OrderEvidence& pair = found.pair_order;
  const OrderEvidence& anaglyph = found.anaglyph_order;
  if (pair.order == EyeOrder::kSwapped || anaglyph.order == EyeOrder::kSwapped) {
    return {"order of the eyes", Level::kBad, "swapped: near things look far, and far things near"};
  }
  if (pair.order == EyeOrder::kUnknown) {
    return {"order of the eyes", Level::kFact,
            "unknown: these pictures have too little texture with parallax"};
  }
  return {
      "order of the eyes", Level::kGood,
      fmt::format(
          "correct: {} of {} small squares with texture fit this order, {} fit the swapped order{}",
          pair.in_order, pair.windows, pair.swapped,
          anaglyph.order == EyeOrder::kUnknown ? "; the anaglyph's colours do not show it" : "")};
}

Verdict about_information(const StereoFindings& found) {
  const StereoInformation& i = found.information;
  return {"stereo information", Level::kFact,
          fmt::format("{} pixels, {:.2f} % of the left picture, are edges with parallax ({:.1f} % "
                      "of the drawn pixels are edges, {:.1f} % have parallax)",
                      i.score, 100 * i.share, percent_of(i.edges, i.pixels),
                      percent_of(i.displaced, i.pixels))};
}

Verdict about_one_eye(const StereoFindings& found) {
  const auto& counts = found.depth.monocular_counts;
  const auto share = [](const MonocularCounts& eye, const DisparitySummary& summary) {
    return fmt::format(
        "{:.2f} % ({} hidden, {} outside the other picture, {} on surfaces that face away or are "
        "too thin)",
        percent_of(eye.all(), summary.drawn), eye.hidden, eye.beside, eye.missing);
  };
  return {"seen by one eye", Level::kFact,
          fmt::format("in the left picture {}, in the right one {}",
                      share(counts.left, found.depth.summary.left),
                      share(counts.right, found.depth.summary.right))};
}

Verdict about_culling(const StereoFindings& found) {
  const CullingFindings& lost = found.culling;
  return {
      "centre culling", Level::kFact,
      lost.triangles == 0
          ? "culling by the camera between the eyes would lose nothing here"
          : fmt::format("culling by the camera between the eyes would lose {}: {} px "
                        "of the left picture, {} px of the right one",
                        counted(lost.triangles, "triangle"), lost.pixels.left, lost.pixels.right)};
}

Verdict about_cost(const StereoFindings& found) {
  return {
      "cost", Level::kFact,
      fmt::format("both eyes took {:.2f} times as long as one picture ({:.1f} ms and {:.1f} ms, "
                  "one run each)",
                  found.cost.ratio(), found.cost.both_ms, found.cost.one_ms)};
}

}  // namespace

std::string names_of_cut(const Scene& scene, const WindowViolation& violation) {
  constexpr std::size_t kNamed = 3;
  std::string names;
  const std::size_t count = violation.instances.size();
  for (std::size_t i = 0; i < std::min(count, kNamed); ++i) {
    if (i > 0) names += i + 1 == count ? " and " : ", ";
    names += name_of_instance(scene, violation.instances[i].instance);
  }
  if (count > kNamed) names += fmt::format(" and {} more", count - kNamed);
  return count == 0 ? "lines or points" : names;
}

std::vector<Verdict> verdicts_of(const Scene& scene, const StereoFindings& found) {
  if (!found.depth.seen) {
    return {{"pictures", Level::kBad, "no part of the scene is in the pictures"},
            about_cost(found)};
  }
  if (found.rendering.passes == 1) {
    return {{"eyes", Level::kWarning,
             "the eyes are in one place, so both pictures are the same, and one run made them"},
            about_rivalry(found),
            about_ghosts(found)};
  }
  return {about_parallax(found), about_window(scene, found), about_divergence(found),
          about_vertical(found), about_rivalry(found),       about_ghosts(found),
          about_order(found),    about_information(found),   about_one_eye(found),
          about_culling(found),  about_cost(found)};
}

}  // namespace glassbox::app
