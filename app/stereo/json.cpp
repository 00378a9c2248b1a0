#include "app/stereo/report.h"

#include <nlohmann/json.hpp>

#include "cli/report/number_json.h"

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

Json parallax_json(const StereoFindings& found) {
  Json rows = Json::array();
  for (const ParallaxRow& row : parallax_rows(found)) {
    rows.push_back({{"name", row.name},
                    {"distance", finite_or_inf(row.parallax.distance)},
                    {"px", finite_or_inf(row.parallax.px)},
                    {"percent_of_width", finite_or_inf(row.parallax.percent)},
                    {"display_mm", finite_or_inf(row.displayed.mm)},
                    {"display_degrees", finite_or_inf(row.displayed.degrees)},
                    {"diverges", row.displayed.diverges}});
  }
  return rows;
}

Json eye_json(const DisparitySummary& summary, const MonocularCounts& monocular) {
  return {{"drawn", summary.drawn},
          {"least_px", summary.least_px},
          {"greatest_px", summary.greatest_px},
          {"too_near", summary.too_near},
          {"too_far", summary.too_far},
          {"monocular",
           {{"hidden", monocular.hidden},
            {"beside", monocular.beside},
            {"missing", monocular.missing}}}};
}

Json disparity_json(const DepthFindings& depth, const StereoCriteria& criteria) {
  const DisparityHistogram& histogram = depth.histogram;
  return {{"budget_percent", criteria.budget_percent},
          {"budget_in_front_px", depth.budget.in_front_px},
          {"budget_behind_px", depth.budget.behind_px},
          {"share_beyond_budget", depth.share_beyond_budget()},
          {"left", eye_json(depth.summary.left, depth.monocular_counts.left)},
          {"right", eye_json(depth.summary.right, depth.monocular_counts.right)},
          {"histogram",
           {{"first_px", histogram.first_px},
            {"bin_px", histogram.bin_px},
            {"counts", histogram.counts}}}};
}

Json violations_json(const Scene& scene, const WindowViolations& violations) {
  Json all = Json::array();
  for (const WindowViolation& one : violations.found) {
    Json instances = Json::array();
    for (const CutInstance& cut : one.instances) {
      const Instance& instance = scene.instances[cut.instance];
      instances.push_back({{"instance", cut.instance},
                           {"node", scene.nodes[instance.node].name},
                           {"mesh", scene.meshes[instance.mesh].name},
                           {"rows", cut.rows},
                           {"least_px", cut.least_px}});
    }
    all.push_back({{"eye", one.eye == Side::kLeft ? "left" : "right"},
                   {"left_edge", one.left_edge},
                   {"right_edge", one.right_edge},
                   {"box", {one.x0, one.y0, one.x1, one.y1}},
                   {"pixels", one.pixels},
                   {"rows", one.rows},
                   {"least_px", one.least_px},
                   {"nearest", one.nearest},
                   {"what", names_of_cut(scene, one)},
                   {"instances", std::move(instances)}});
  }
  return all;
}

Json recolour_json(const Compromise& one) {
  return {{"desaturate", one.recolour.desaturate},
          {"brighten", one.recolour.brighten},
          {"rivalry", one.rivalry},
          {"ciede2000", one.difference}};
}

Json colour_json(const ColourFindings& colour, const StereoCriteria& criteria) {
  Json methods = Json::array();
  for (const MethodFindings& one : colour.methods) {
    methods.push_back({{"method", name_of(one.method)},
                       {"mean_rivalry", one.rivalry},
                       {"mean_ghost", one.ghosts}});
  }
  Json json{{"method", name_of(criteria.method)},
            {"glasses", name_of(criteria.glasses)},
            {"target_rivalry", criteria.target_rivalry},
            {"mean_rivalry", colour.mean_rivalry},
            {"worst_rivalry", colour.worst_rivalry},
            {"measured_lenses", colour.measured_lenses},
            {"ghosts",
             {{"mean_left", colour.mean_ghost.left},
              {"mean_right", colour.mean_ghost.right},
              {"worst_left", colour.worst_ghost.left},
              {"worst_right", colour.worst_ghost.right},
              {"white_left", colour.white_leak.left},
              {"white_right", colour.white_leak.right}}},
            {"methods", std::move(methods)}};
  if (const auto& suggestion = colour.suggestion) {
    Json curve = Json::array();
    for (const Compromise& one : suggestion->curve) curve.push_back(recolour_json(one));
    json["recolour"] = recolour_json(suggestion->chosen);
    json["recolour"]["meets_target"] = suggestion->meets_target;
    json["recolour"]["curve"] = std::move(curve);
  }
  return json;
}

Json order_json(const OrderEvidence& evidence) {
  constexpr const char* kOrders[] = {"in-order", "swapped", "unknown"};
  return {{"order", kOrders[std::size_t(evidence.order)]},
          {"windows", evidence.windows},
          {"in_order", evidence.in_order},
          {"swapped", evidence.swapped}};
}

Json words_json(const StereoWords& words) {
  Json verdicts = Json::array(), advice = Json::array();
  for (const Verdict& one : words.verdicts) {
    verdicts.push_back({{"about", one.about}, {"level", name_of(one.level)}, {"text", one.text}});
  }
  for (const Advice& one : words.advice) {
    advice.push_back({{"text", one.text}, {"options", one.options}});
  }
  return {{"verdicts", std::move(verdicts)}, {"advice", std::move(advice)}};
}

}  // namespace

Json stereo_json(const Scene& scene, const StereoFindings& found, const StereoWords& words) {
  const ChosenPair& eyes = found.chosen.eyes;
  const VerticalFindings& vertical = found.vertical;
  const StereoInformation& information = found.information;
  Json json{
      {"eyes",
       {{"separation", 2 * eyes.pair.half_separation},
        {"separation_is_from", eyes.separation_is_from},
        {"window", finite_or_inf(eyes.pair.window)},
        {"window_is_at", eyes.window_is_at},
        {"projection", found.chosen.centre.perspective ? "perspective" : "parallel"},
        {"passes", found.rendering.passes}}},
      {"display",
       {{"width_mm", found.criteria.display.width_mm},
        {"viewing_distance_mm", found.criteria.display.viewing_distance_mm},
        {"pupil_distance_mm", kPupilDistanceMm}}},
      {"parallax", parallax_json(found)},
      {"disparity", disparity_json(found.depth, found.criteria)},
      {"window_violations", violations_json(scene, found.depth.violations)},
      {"vertical_parallax",
       {{"skewed_px", vertical.skewed_px},
        {"toed_in_px", vertical.toed_in_px},
        {"toed_in_at", {vertical.x, vertical.y}}}},
      {"anaglyph", colour_json(found.colour, found.criteria)},
      {"order",
       {{"pair", order_json(found.pair_order)}, {"anaglyph", order_json(found.anaglyph_order)}}},
      {"information",
       {{"pixels", information.pixels},
        {"edges", information.edges},
        {"displaced", information.displaced},
        {"score", information.score},
        {"share", information.share}}},
      {"centre_culling",
       {{"lost_triangles", found.culling.triangles},
        {"lost_px_left", found.culling.pixels.left},
        {"lost_px_right", found.culling.pixels.right}}},
      {"cost",
       {{"one_ms", found.cost.one_ms},
        {"both_ms", found.cost.both_ms},
        {"ratio", found.cost.ratio()}}}};
  json.update(words_json(words));
  return json;
}

}  // namespace glassbox::app
