#include "app/trace/json_text.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "app/trace/json.h"

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

// Names come from files and may not be valid UTF-8: invalid bytes are replaced.
std::string dumped(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

// The first records of each kind are always written, so that the size of a short trace is not
// estimated.
constexpr std::uint64_t kAlways = 32;

Trace head_of(const View& view, const RenderSettings& settings) {
  Trace head = BoundsOfRun(view).trace();
  head.settings = with_one_sample(settings);
  return head;
}

}  // namespace

std::string head_text(const Scene& scene, const std::string& scene_name, const View& view,
                      const RenderSettings& settings, const std::vector<TracedDraw>& draws) {
  Trace head = head_of(view, settings);
  head.draws = draws;
  Json json = head_json(scene, head);
  json["scene"] = scene_name;
  return dumped(json, 2);
}

TraceText::TraceText(const Scene& scene, const View& view, const RenderSettings& settings,
                     std::uint64_t one_in)
    : scene_(scene), one_in_(one_in), head_(head_of(view, settings)), bounds_(view) {}

void TraceText::Lines::add(const std::string& line) {
  text += written++ == 0 ? "" : ",\n";
  text += line;
}

bool TraceText::is_due(std::uint64_t count) const {
  return count <= kAlways || count % one_in_ == 0;
}

void TraceText::draw(const TracedDraw& draw) {
  counter_.draw(draw);
  bounds_.draw(draw);
}

void TraceText::triangle(const TracedTriangle& triangle) {
  counter_.triangle(triangle);
  const TriangleBounds& bounds = bounds_.triangle(triangle).bounds;
  round_trips_.add(triangle, bounds);
  if (is_due(counts().triangles)) triangles_.add(dumped(to_json(head_, triangle, bounds)));
}

void TraceText::fragment(const TracedFragment& fragment) {
  counter_.fragment(fragment);
  if (!is_due(counts().fragments)) return;
  fragments_.add(dumped(to_json(head_, fragment, bounds_.of_fragment(fragment))));
}

std::uint64_t TraceText::estimate(const Lines& lines, std::uint64_t count) {
  if (lines.written == 0) return 0;
  return std::uint64_t(double(lines.text.size()) / double(lines.written) * double(count));
}

std::uint64_t TraceText::bytes() const {
  constexpr std::uint64_t kHead = 4000, kDraw = 4000;
  return kHead + kDraw * counts().draws + estimate(triangles_, counts().triangles) +
         estimate(fragments_, counts().fragments);
}

std::string TraceText::finish(const std::string& scene_name) {
  std::string text = head_text(scene_, scene_name, head_.view, head_.settings, counter_.draws());
  text.resize(text.rfind('\n'));  // without the closing brace
  text += ",\n  \"triangles\": [\n" + std::exchange(triangles_.text, {});
  text += "\n  ],\n  \"fragments\": [\n" + std::exchange(fragments_.text, {});
  text += "\n  ],\n  \"round_trip\": " + dumped(to_json(round_trips_)) + "\n}\n";
  return text;
}

}  // namespace glassbox::app
