#include "app/pixel/history_json.h"

#include <nlohmann/json.hpp>

#include "app/why/verdict_text.h"
#include "cli/report/number_json.h"

namespace glassbox {

namespace {

using Json = nlohmann::ordered_json;

Json index_or_null(const std::optional<std::size_t>& index) {
  return index ? Json(*index) : Json();
}

Json json_of(const Scene& scene, const PixelEvent& event) {
  const Mesh& mesh = scene.meshes[scene.instances[event.instance].mesh];
  Json json{{"fate", name_of(event.kind)}};
  if (event.source.is_triangle) json["triangle"] = event.source.number;
  json["instance"] = event.instance;
  json["mesh"] = mesh.name;
  if (event.source.is_triangle) json["face"] = event.face;
  json["material"] = scene.materials[mesh.material].name;
  if (event.source.is_triangle) json["piece"] = event.source.piece;
  if (event.kind == PixelEventKind::kTurnedAway) {
    json["shows"] = event.front ? "front" : "back";
    json["area_px2"] = event.area_px2;
    return json;
  }
  json["distance"] = event.distance;
  if (event.kind == PixelEventKind::kClipped) {
    json["plane"] = event.plane;
    json["inside"] = event.inside;
    json["shows"] = event.front ? "front" : "back";
    return json;
  }
  json["depth"] = {{"code", event.code},
                   {"stored", event.stored},
                   {"stored_by", index_or_null(event.stored_by)},
                   {"passes", event.kind != PixelEventKind::kHidden},
                   {"writes", event.writes_depth}};
  if (event.kind == PixelEventKind::kHidden) return json;
  json["alpha"] = event.alpha;
  if (event.kind == PixelEventKind::kDiscarded) {
    json["cutoff"] = event.cutoff;
    return json;
  }
  json["light"] = numbers_json(event.light);
  json["before"] = numbers_json(event.before);
  json["after"] = numbers_json(event.after);
  json["overwritten_by"] = index_or_null(event.overwritten_by);
  return json;
}

}  // namespace

Json to_json(const Scene& scene, const PixelHistory& history) {
  Json json{{"cleared", numbers_json(history.cleared)},
            {"events", Json::array()},
            {"misses", Json::array()}};
  for (const PixelEvent& event : history.events) json["events"].push_back(json_of(scene, event));
  for (const PixelMiss& missed : history.misses) {
    Json one{{"triangle", missed.number}, {"instance", missed.instance}, {"face", missed.face}};
    one.update(to_json(missed.miss));
    one.erase("at");
    json["misses"].push_back(one);
  }
  json["without_area"] = history.without_area;
  json["shows"] = index_or_null(history.shows);
  json["shown"] = numbers_json(history.shown);
  json["shows_bytes"] = history.shows_bytes;
  json["complete"] = history.complete;
  return json;
}

}  // namespace glassbox
