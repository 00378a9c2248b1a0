// A run as JSON text, schema "glassbox-trace/1", one record a line: written as the records come, so that no tree of the whole
// run is ever in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/arrays.h>

namespace glassbox::app {

// What a run is of, its view, settings, planes and draws, as a JSON object.
std::string head_text(const Scene& scene, const std::string& scene_name, const View& view,
                      const RenderSettings& settings, const std::vector<TracedDraw>& draws);

class TraceText : public TraceSink {
public:
  // `one_in`: only so many of the records are written, the others are counted, to know what the whole would take.
  TraceText(const Scene& scene, const View& view, const RenderSettings& settings,
            std::uint64_t one_in = 1);

  void draw(const TracedDraw& draw) override;
  void triangle(const TracedTriangle& triangle) override;
  void fragment(const TracedFragment& fragment) override;

  const TraceCounts& counts() const { return counter_.counts(); }

  // What the text has, or with one_in > 1 about what it would have, in bytes.
  std::uint64_t bytes() const;

  // The whole text, for the scene of this name. What was collected is gone then.
  std::string finish(const std::string& scene_name);

private:
  // Records as text, one a line.
  struct Lines {
    std::string text;
    std::uint64_t written = 0;
    void add(const std::string& line);
  };
  bool is_due(std::uint64_t count) const;
  static std::uint64_t estimate(const Lines& lines, std::uint64_t count);

  const Scene& scene_;
  const std::uint64_t one_in_;
  Trace head_;  // no draws, triangles and fragments
  BoundsOfRun bounds_;
  RoundTrips round_trips_;
  TraceCounter counter_;
  Lines triangles_, fragments_;
};

}  // namespace glassbox::app
