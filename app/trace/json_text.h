// Writes a run as JSON text with the schema "glassbox-trace/1", one record per line. Records are
// written as they arrive, so that the JSON values of the whole run are never in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/arrays.h>

namespace glassbox::app {

// A JSON object with the scene, the view, settings, planes and draws of a run.
std::string head_text(const Scene& scene, const std::string& scene_name, const View& view,
                      const RenderSettings& settings, const std::vector<TracedDraw>& draws);

class TraceText : public TraceSink {
public:
  // Writes only one record of every `one_in` and counts the rest. This gives an estimate of the
  // whole text's size.
  TraceText(const Scene& scene, const View& view, const RenderSettings& settings,
            std::uint64_t one_in = 1);

  void draw(const TracedDraw& draw) override;
  void triangle(const TracedTriangle& triangle) override;
  void fragment(const TracedFragment& fragment) override;

  const TraceCounts& counts() const { return counter_.counts(); }

  // The size of the text in bytes; with one_in > 1, an estimate of the whole text's size.
  std::uint64_t bytes() const;

  // Returns the whole text, with this name of the scene. Call it once: it moves the collected
  // records out.
  std::string finish(const std::string& scene_name);

private:
  // Records as text, one per line.
  struct Lines {
    std::string text;
    std::uint64_t written = 0;
    void add(const std::string& line);
  };
  bool is_due(std::uint64_t count) const;
  static std::uint64_t estimate(const Lines& lines, std::uint64_t count);

  const Scene& scene_;
  const std::uint64_t one_in_;
  Trace head_;  // has no draws, triangles or fragments
  BoundsOfRun bounds_;
  RoundTrips round_trips_;
  TraceCounter counter_;
  Lines triangles_, fragments_;
};

}  // namespace glassbox::app
