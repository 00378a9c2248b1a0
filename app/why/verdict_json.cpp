#include "app/why/verdict_text.h"

#include <nlohmann/json.hpp>

#include "app/trace/json.h"
#include "cli/report/number_json.h"

namespace glassbox {

namespace {

using Json = nlohmann::ordered_json;

Json optional_number(std::optional<std::uint32_t> number) {
  return number ? Json(*number) : Json();
}

Json json_of(const ViewConventions& c) {
  return {{"right_handed_eye", c.right_handed_eye},
          {"gaze_is_minus_z", c.gaze_is_minus_z},
          {"hands_mixed", c.hands_mixed},
          {"near_depth", c.near_depth},
          {"opengl_range", c.opengl_range}};
}

Json json_of(const NoAreaVerdict& found) {
  constexpr const char* kReasons[] = {"repeated-position", "collinear", "whole-face"};
  Json corners = Json::array();
  for (const Point<Object>& corner : found.corners) corners.push_back(numbers_json(corner));
  return {{"reason", kReasons[std::size_t(found.reason)]}, {"face_corners", corners}};
}

Json json_of(const ClippingVerdict& found) {
  const ClipPlane& e = found.equation;
  Json json{{"plane", e.name}, {"equation", {e.a, e.b, e.c, e.d, e.e}}};
  for (const ClippedCorner& corner : found.corners) {
    Json one{{"clip", numbers_json(corner.clip)},
             {"along_gaze", corner.along_gaze},
             {"inside", corner.inside}};
    if (corner.screen) one["screen"] = numbers_json(*corner.screen);
    json["corners"].push_back(one);
  }
  for (const ClipCount& step : found.steps) {
    json["steps"].push_back({{"plane", step.plane}, {"vertices_left", step.vertices_left}});
  }
  json["inside_opengl_depth"] = found.inside_opengl_depth;
  return json;
}

Json json_of(const NoScreenAreaVerdict& found) {
  Json json{{"area_px2", found.area_px2}};
  for (std::size_t k = 0; k < 3; ++k) {
    json["screen"].push_back({found.screen[k].x, found.screen[k].y});
    json["snapped"].push_back({found.snapped[k].x, found.snapped[k].y});
  }
  return json;
}

Json json_of(const CullVerdict& found) {
  constexpr const char* kRules[] = {"material", "back", "front", "none"};
  Json json{{"area_px2", found.area_px2},
            {"shows", found.front ? "front" : "back"},
            {"mirrored", found.mirrored},
            {"cull", kRules[std::size_t(found.rule)]},
            {"double_sided", found.double_sided}};
  if (found.object_space) json["object_space"] = to_json(*found.object_space);
  return json;
}

Json json_of(const OutsideDistances& o) {
  Json json{{"left_px", double(o.left) / kSubpixels},
            {"top_px", double(o.top) / kSubpixels},
            {"right_px", double(o.right) / kSubpixels},
            {"bottom_px", double(o.bottom) / kSubpixels}};
  if (o.beyond_edge) json["beyond_edge_px"] = *o.beyond_edge / kSubpixels;
  return json;
}

Json json_of(const std::vector<Occluder>& occluders) {
  Json json = Json::array();
  for (const Occluder& occluder : occluders) {
    json.push_back({{"triangle", optional_number(occluder.number)}, {"pixels", occluder.pixels}});
  }
  return json;
}

Json json_of(const std::vector<DepthFight>& fights) {
  Json json = Json::array();
  for (const DepthFight& fight : fights) json.push_back(to_json(fight));
  return json;
}

Json json_of(const TriangleFragmentCounts& t, const FragmentDetails& d) {
  Json json{{"covered", t.covered},
            {"hidden", t.hidden},
            {"discarded", t.discarded},
            {"masked", t.masked},
            {"overwritten", t.overwritten},
            {"visible", t.visible},
            {"unchanged", t.unchanged},
            {"veiled", t.under_translucent},
            {"hidden_by", json_of(d.hidden_by)},
            {"overwritten_by", json_of(d.overwritten_by)}};
  if (const auto& h = d.closest_hidden) {
    json["closest_hidden"] = {{"at", {h->x, h->y}},
                              {"code", h->code},
                              {"stored", h->stored},
                              {"distance", h->distance},
                              {"stored_distance", h->stored_distance},
                              {"by", optional_number(h->by)}};
  }
  if (const auto& discarded = d.closest_discarded) {
    json["closest_discarded"] = {{"at", {discarded->x, discarded->y}},
                                 {"alpha", discarded->alpha},
                                 {"cutoff", discarded->cutoff}};
  }
  if (const auto& u = d.unchanged) {
    json["unchanged_example"] = {{"at", {u->x, u->y}},
                                 {"blended", u->blended},
                                 {"alpha", u->alpha},
                                 {"bytes", numbers_json(u->bytes)}};
  }
  if (d.example) {
    json["box"] = numbers_json(d.visible_box);
    json["example"] = *d.example;
  }
  return json;
}

}  // namespace

Json to_json(const CentreMiss& miss) {
  return {{"at", {miss.x, miss.y}},
          {"edge", miss.edge},
          {"value", miss.value},
          {"subpixels", miss.subpixels}};
}

Json to_json(const DepthFight& fight) {
  return {{"triangles", {fight.first, fight.second}},
          {"pixels", fight.pixels},
          {"at", {fight.x, fight.y}},
          {"distances", {fight.first_distance, fight.second_distance}}};
}

Json to_json(const TriangleVerdict& verdict) {
  Json json{{"triangle", verdict.triangle.number},
            {"instance", verdict.triangle.instance},
            {"face", verdict.triangle.face},
            {"end", name_of(verdict.result)},
            {"stage", stage_of(verdict.result)},
            {"seen", is_seen(verdict.result)},
            {"view", json_of(verdict.conventions)},
            {"pieces",
             {{"without_area", verdict.pieces_without_area},
              {"turned_away", verdict.pieces_turned_away},
              {"set_up", verdict.pieces_set_up}}}};
  if (verdict.no_area) json["no_area"] = json_of(*verdict.no_area);
  if (verdict.clipping) json["clipping"] = json_of(*verdict.clipping);
  if (verdict.no_screen_area) json["no_screen_area"] = json_of(*verdict.no_screen_area);
  if (verdict.cull) json["cull"] = json_of(*verdict.cull);
  if (verdict.outside) json["outside"] = json_of(*verdict.outside);
  if (verdict.nearest_centre) json["nearest_centre"] = to_json(*verdict.nearest_centre);
  if (verdict.result == TriangleResult::kLines) json["line_pixels"] = verdict.line_pixels;
  if (verdict.fragments.covered > 0) {
    json["fragments"] = json_of(verdict.fragments, verdict.details);
    json["depth_fights"] = json_of(verdict.fights);
  }
  return json;
}

Json to_json(const SceneVerdict& verdict) {
  Json json{{"triangles", verdict.triangles},
            {"pixels", verdict.pixels},
            {"shown_pixels", verdict.shown_pixels},
            {"view", json_of(verdict.conventions)}};
  json["depth_fights"] = json_of(verdict.fights);
  json["causes"] = Json::array();
  for (const SceneCause& cause : verdict.causes) {
    json["causes"].push_back({{"cause", name_of(cause.cause)},
                              {"triangles", cause.triangles},
                              {"example", optional_number(cause.example)}});
  }
  json["ends"] = Json::array();
  for (std::size_t i = 0; i < kTriangleResults; ++i) {
    const SceneVerdict::Group& group = verdict.groups[i];
    if (group.triangles == 0) continue;
    json["ends"].push_back({{"end", name_of(TriangleResult(i))},
                            {"stage", stage_of(TriangleResult(i))},
                            {"triangles", group.triangles},
                            {"example", group.example}});
  }
  return json;
}

}  // namespace glassbox
