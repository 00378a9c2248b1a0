#include <glassbox/compare/report/json.h>

#include <cmath>

#include <nlohmann/json.hpp>

#include <glassbox/compare/report/text.h>

namespace glassbox {
namespace {

using Json = nlohmann::ordered_json;

// JSON cannot represent infinities, so they become strings.
Json number(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return std::isnan(value) ? Json("nan") : Json(value);
}

Json steps(std::uint32_t steps) {
  return steps == kUnbounded ? Json("unbounded") : Json(steps);
}

Json point(PixelPosition pixel) {
  return {{"x", pixel.x}, {"y", pixel.y}};
}

Json box(const PixelBox& box) {
  return {{"x", box.x}, {"y", box.y}, {"width", box.width}, {"height", box.height}};
}

Json canvas(const Canvas& canvas) {
  return {{"width", canvas.width},
          {"height", canvas.height},
          {"reference", box(canvas.reference)},
          {"test", box(canvas.test)},
          {"overlap", box(canvas.overlap())}};
}

Json picture(const PictureFacts& facts) {
  Json json{{"path", facts.path}};
  if (facts.width == 0) return json;
  json["width"] = facts.width;
  json["height"] = facts.height;
  json["channels"] = facts.channels;
  json["format"] = facts.format;
  return json;
}

Json region(const Region& region) {
  return {{"box", box(region.box)},
          {"pixels", region.pixels},
          {"largest", steps(region.largest)},
          {"worst", point(region.worst)}};
}

Json set_aside(const SetAsidePixels& aside) {
  return {{"pixels", aside.pixels}, {"largest", steps(aside.largest)}};
}

Json differences(const Differences& found, const SetAside& aside) {
  Json json{{"compared_pixels", found.compared},
            {"differing_pixels", found.differing},
            {"largest", steps(found.largest)}};
  if (aside.moved_edges) json["moved_edges"] = set_aside(found.moved_edges);
  if (aside.threshold) json["below_threshold"] = set_aside(found.below_threshold);
  if (found.differing == 0) return json;
  json["first"] = point(found.first);
  json["box"] = box(found.box);
  json["region_count"] = found.region_count;
  for (const Region& one : found.regions) json["regions"].push_back(region(one));
  return json;
}

Json metric(const MetricValue& metric) {
  Json json{{"name", metric.name}};
  json["value"] = metric.value ? number(*metric.value) : Json(nullptr);
  if (!metric.value) json["why_not"] = metric.why_not;
  if (metric.limit) {
    json["limit"] = to_string(MetricRequest{metric.name, metric.limit});
    json["passes"] = metric.passes;
  }
  return json;
}

Json error(const Error& error) {
  return {{"file", error.file},
          {"place", error.place},
          {"cause", error.cause},
          {"remedy", error.remedy}};
}

void add_words(Json& json, const char* key, const std::vector<std::string>& sentences) {
  if (!sentences.empty()) json[key] = sentences;
}

void add_word(Json& json, const char* key, const std::string& text) {
  if (!text.empty()) json[key] = text;
}

}  // namespace

const char* verdict_word(Verdict verdict) {
  constexpr const char* kWords[] = {"same", "within-tolerance", "different",
                                    "new",  "missing",          "uncompared"};
  static_assert(std::size(kWords) == std::size_t(Verdict::kUncompared) + 1);
  return kWords[int(verdict)];
}

Json to_json(const Comparison& comparison) {
  Json json{{"name", comparison.name}, {"verdict", verdict_word(comparison.verdict)}};
  if (comparison.error) json["error"] = error(*comparison.error);
  json["reference"] = picture(comparison.reference);
  json["test"] = picture(comparison.test);
  if (comparison.differences) {
    json["differences"] = differences(*comparison.differences, comparison.set_aside);
  }
  if (comparison.canvas) json["canvas"] = canvas(*comparison.canvas);
  for (const MetricValue& one : comparison.metrics) json["metrics"].push_back(metric(one));
  for (const PixelBox& one : comparison.ignore) json["ignore"].push_back(box(one));
  add_word(json, "mask", comparison.mask);
  add_word(json, "tolerance", comparison.tolerance);
  add_word(json, "tolerance_reason", comparison.tolerance_reason);
  add_words(json, "reasons", comparison.reasons);
  add_words(json, "hints", comparison.hints);
  std::vector<std::string> notes = comparison.notes;
  const std::string alpha = opaque_alpha_text(std::span(&comparison, 1));
  if (!alpha.empty()) notes.push_back(alpha);
  add_words(json, "notes", notes);
  add_words(json, "suggestions", comparison.suggestions);
  add_word(json, "inspect_command", comparison.inspect_command);
  return json;
}

Json json_report(std::span<const Comparison> comparisons) {
  Json summary = Json::object();
  for (const Verdict verdict : {Verdict::kSame, Verdict::kWithinTolerance, Verdict::kDifferent,
                                Verdict::kNew, Verdict::kMissing, Verdict::kUncompared}) {
    summary[verdict_word(verdict)] = 0;
  }
  Json pictures = Json::array();
  for (const Comparison& comparison : comparisons) {
    Json& count = summary[verdict_word(comparison.verdict)];
    count = count.get<std::uint64_t>() + 1;
    pictures.push_back(to_json(comparison));
  }
  return {{"schema", "glassbox-diff-1"}, {"summary", summary}, {"pictures", pictures}};
}

}  // namespace glassbox
