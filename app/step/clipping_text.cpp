// Stage 5 of a stepped triangle: clipping by one plane after the other.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/step/number_text.h"
#include "app/step/stage_texts.h"

#include <glassbox/matrices/decimal.h>

namespace glassbox::app {

namespace {

std::string distances_table(const SteppedTriangle& stepped, const StepTarget& target) {
  std::string text = fmt::format("     {:<20}", "distance inside of");
  std::array<std::array<PlaneDistance, kMaxClipPlanes>, 3> distances;
  for (std::size_t k = 0; k < 3; ++k) {
    distances[k] =
        plane_distances(stepped.trace, stepped.triangle->corners[k], stepped.bounds.corners[k]);
    if (target.wants(k)) text += fmt::format("{:<27}", fmt::format("vertex {}", k));
  }
  text += "\n";
  const auto& planes = stepped.trace.planes;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    text += fmt::format("     {:<20}", planes[i].name);
    for (std::size_t k = 0; k < 3; ++k) {
      if (!target.wants(k)) continue;
      const PlaneDistance& d = distances[k][i];
      text += fmt::format("{:<27}", short_number(d.distance, 7) + " " + bound_text(d.bound) +
                                        (d.distance < 0 ? " out" : ""));
    }
    text += "\n";
  }
  return text;
}

// The polygon after clipping by one plane: for each of its vertices, the position, and the vertices
// of the polygon before this plane that it comes from.
std::string polygon_text(const ClipStep& step) {
  std::string text;
  for (std::size_t i = 0; i < std::size_t(step.after.count); ++i) {
    const glm::vec4 p = to_glm(step.after.vertices[i].position);
    const auto [a, b] = step.sources[i];
    const std::string from = a == b ? fmt::format("was {}", a) : fmt::format("cuts {}-{}", a, b);
    text += fmt::format("       {}  {:<10} ({}, {}, {}, {})\n", i, from,
                        short_number(double(p.x), 9), short_number(double(p.y), 9),
                        short_number(double(p.z), 9), short_number(double(p.w), 9));
  }
  return text;
}

std::string cut_text(const SteppedTriangle& stepped) {
  std::string text;
  int before = 3;
  for (std::size_t i = 0; i < stepped.triangle->clipping.size(); ++i) {
    const ClipStep& step = stepped.triangle->clipping[i];
    const char* plane = stepped.trace.planes[i].name;
    const bool cuts = std::any_of(step.distances.begin(), step.distances.begin() + before,
                                  [](double distance) { return distance < 0; });
    before = step.after.count;
    if (!cuts) continue;
    text += sentence(step.after.count == 0 ? fmt::format("the {} plane leaves nothing", plane)
                                           : fmt::format("the {} plane leaves {} vertices:", plane,
                                                         step.after.count));
    text += polygon_text(step);
  }
  return text;
}

// The result for the triangle of --cull-stage object, which culls before anything is clipped.
std::string early_culling_text(const SteppedTriangle& stepped) {
  if (!stepped.object_culling) return "";
  if (!stepped.object_culling->test) {
    return sentence(fmt::format("not culled in object space: {}", stepped.object_culling->because));
  }
  const auto& corners = stepped.triangle->corners;
  const ObjectCull& cull = *stepped.object_culling->test;
  const ObjectCull::Evaluation evaluation =
      cull.evaluate({corners[0].object, corners[1].object, corners[2].object});
  const bool whole = std::ranges::all_of(corners, [](const auto& c) { return c.outcode == 0; });
  const char* verdict =
      !evaluation.removed ? "not certainly a back face, so the sign of the snapped area decides"
      : whole             ? "the triangle is removed, and does not reach the stages below"
              : "but a plane cuts the triangle, so the sign of the snapped area decides";
  const double rounding = evaluation.test.bound + evaluation.test.viewer_error_bound;
  std::string text = fmt::format("culling in object space, before clipping: (P - eye).m = {} {}",
                                 short_number(evaluation.test.value, 9), bound_text(rounding));
  if (std::isfinite(evaluation.margin)) {
    text += fmt::format("; snapping and rounding may change this number by {}",
                        short_number(evaluation.margin, 3));
  }
  return sentence(text + ": " + verdict);
}

}  // namespace

std::string clipping_text(const SteppedTriangle& stepped, const StepTarget& target) {
  std::string text = early_culling_text(stepped) + distances_table(stepped, target);
  std::array<Outcode, 3> codes;
  for (std::size_t k = 0; k < 3; ++k) codes[k] = stepped.triangle->corners[k].outcode;
  switch (trivial_verdict(codes)) {
    case ClipVerdict::kAccept:
      return text + sentence("decided: all corners are inside all planes; nothing is cut");
    case ClipVerdict::kReject: {
      const Outcode all = codes[0] & codes[1] & codes[2];
      if ((codes[0] | codes[1] | codes[2]) & kNotFinite) {
        return text + sentence("decided: a coordinate is not finite; the triangle is dropped");
      }
      for (std::size_t i = 0; i < stepped.trace.planes.size(); ++i) {
        if ((all >> i & 1) == 0) continue;
        return text + sentence(fmt::format(
                          "decided: all corners lie outside the {} plane; nothing is left",
                          stepped.trace.planes[i].name));
      }
      return text;
    }
    case ClipVerdict::kClip:
      break;
  }
  text += cut_text(stepped);
  return text + sentence(stepped.triangle->polygon.empty()
                             ? "decided: nothing is left"
                             : fmt::format("decided: a polygon of {} vertices remains",
                                           stepped.triangle->polygon.size()));
}

}  // namespace glassbox::app
