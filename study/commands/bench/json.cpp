#include "study/commands/bench/json.h"

#include <nlohmann/json.hpp>

#include "views/commands/eye_error_json.h"

namespace glassbox::study {

namespace {

using Json = nlohmann::ordered_json;
using study::Measurement;
using study::Quartiles;
using study::Scaling;

Json quartiles_json(const Quartiles& q) {
  return Json::array({q.lower, q.upper});
}

// [renderer, number of pixels] for each kind of difference that occurs.
Json differences_json(const study::PictureMatch& match) {
  Json json = Json::array();
  for (std::size_t by = 1; by < match.differences.size(); ++by) {
    if (match.differences[by] > 0) json.push_back(Json::array({by, match.differences[by]}));
  }
  return json;
}

Json match_json(const study::PictureMatch& match) {
  return {{"same", match.same()},
          {"covered", match.covered},
          {"peer_covered", match.peer_covered},
          {"coverage_differs", match.coverage_differs},
          {"color_differs", match.color_differs},
          {"edges", match.edges},
          {"at_edges", match.at_edges()},
          {"allowed_at_edges", match.allowed_at_edges()},
          {"away_from_edges", match.covered_away_from_edges + match.colored_away_from_edges},
          {"largest_away_from_edges", match.largest_away_from_edges},
          {"largest_elsewhere", match.largest_elsewhere},
          {"differences", differences_json(match)}};
}

Json floor_json(const study::Floor& floor) {
  return {{"threads", floor.threads},
          {"read_bytes_per_second", floor.read_bytes_per_second},
          {"written_bytes_per_second", floor.written_bytes_per_second},
          {"operations_per_second", floor.operations_per_second}};
}

Json result_json(const BenchReport& report, const Measurement& result) {
  Json json{{"scene", result.scene},  {"threads", result.threads}, {"samples", result.samples},
            {"ms", result.ms.median}, {"peer", nullptr},           {"peer_ms", nullptr},
            {"ratio", nullptr}};
  json["ms_quartiles"] = quartiles_json(result.ms);
  if (result.against) {
    json["peer"] = result.against->peer;
    json["peer_ms"] = result.against->ms.median;
    json["ratio"] = result.ratio();
    json["peer_ms_quartiles"] = quartiles_json(result.against->ms);
    json["frame_ratio_quartiles"] = quartiles_json(result.against->frame_ratio);
    json["pictures"] = match_json(result.against->match);
  }
  if (result.stereo) {
    json["stereo"] = {{"mono_ms", result.stereo->mono_ms},
                      {"shared_ms", result.stereo->shared_ms},
                      {"cost", result.stereo->shared_ms / result.stereo->mono_ms}};
    if (const auto& eye = result.stereo->warped) {
      json["stereo"]["warped"] = eye_error_json(eye->warped);
      json["stereo"]["warped"]["cost"] = eye->both_warped_ms / eye->one_eye_ms;
    }
  }
  if (result.rejected_ms) json["rejected_ms"] = *result.rejected_ms;
  json["least_bytes_read"] = result.least.read_bytes;
  json["least_bytes_written"] = result.least.written_bytes;
  if (const study::Floor* floor = report.floor_of(result)) {
    json["floor_ms"] = study::floor_ms(*floor, result.least);
  }
  return json;
}

Json scaling_json(const Scaling& scaling) {
  Json json{{"by", name_of(scaling.by)}, {"scene", scaling.what}, {"points", Json::array()}};
  for (const study::ScalingPoint& point : scaling.points) {
    json["points"].push_back({{"x", point.x},
                              {"ms", point.ms.median},
                              {"ms_quartiles", quartiles_json(point.ms)},
                              {"peak_bytes", point.peak_bytes}});
  }
  if (scaling.ratios) json["ratios"] = {{"x", scaling.ratios->x}, {"ms", scaling.ratios->ms}};
  if (scaling.law) json["exponent"] = scaling.law->exponent;
  if (scaling.bend) {
    json["bend"] = {{"at", scaling.bend->at},
                    {"exponent_before", scaling.bend->before.exponent},
                    {"exponent_after", scaling.bend->after.exponent}};
  }
  if (scaling.bytes_per_triangle) json["bytes_per_triangle"] = *scaling.bytes_per_triangle;
  if (!scaling.stopped.empty()) json["stopped"] = scaling.stopped;
  return json;
}

}  // namespace

Json bench_json(const BenchReport& report) {
  Json json{{"machine", report.machine}, {"compiler", report.compiler}, {"target", report.target},
            {"engine", report.engine},   {"width", report.width},       {"height", report.height},
            {"frames", report.frames},   {"results", Json::array()}};
  for (const Measurement& result : report.results)
    json["results"].push_back(result_json(report, result));
  if (!report.floors.empty()) json["floor"] = Json::array();
  for (const study::Floor& floor : report.floors) json["floor"].push_back(floor_json(floor));
  if (!report.scalings.empty()) json["scaling"] = Json::array();
  for (const Scaling& scaling : report.scalings) json["scaling"].push_back(scaling_json(scaling));
  if (!report.notes.empty()) json["notes"] = report.notes;
  return json;
}

}  // namespace glassbox::study
