#include <fmt/format.h>

#include "labs/05-clipping/outlines.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

#include <glassbox/pipeline/back_face.h>

namespace glassbox::labs {

namespace {

// ---- 5.1 ----

std::vector<Case> face_cases(const std::vector<lab_05::FaceCase>& inputs) {
  std::vector<Case> cases;
  for (const lab_05::FaceCase& questions : inputs) {
    Case c;
    Expected expected{"back", Shape::kNumbers, {}, 0, "", 0};
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const auto& [face, eye] = questions[i];
      std::vector<Point<Object>> corners;
      c.restated += fmt::format("face {}:", i);
      for (const Point<World>& p : face) {
        corners.push_back({p.x, p.y, p.z});
        c.restated += fmt::format(" ({}, {}, {})", p.x, p.y, p.z);
      }
      // World space stands for object space: the model matrix is the identity.
      const BackFaceTest test = test_back_face(corners, {true, {eye.x, eye.y, eye.z}, {0, 0, 0}});
      expected.values.push_back(test.facing == Facing::kBack ? 1 : 0);
      c.restated += fmt::format(" seen from ({}, {}, {}): (P - eye) . m = {}\n", eye.x, eye.y,
                                eye.z, test.value);
    }
    c.where = fmt::format("{} faces", questions.size());
    c.restated.pop_back();
    c.expected = {expected};
    cases.push_back(c);
  }
  return cases;
}

// ---- 5.2 ----

std::string plane_names(std::uint32_t code) {
  static const char* const kNames[] = {"near", "far", "left", "right", "bottom", "top"};
  std::string text;
  for (std::uint32_t i = 0; i < 6; ++i) {
    if ((code >> i & 1) != 0) text += (text.empty() ? "" : ", ") + std::string(kNames[i]);
  }
  return text.empty() ? "none" : text;
}

Expected outcode_of(const Point<Clip>& p) {
  return {"outcode", Shape::kNumbers, {double(outcode(p, pipeline_frustum()))}, 0, "", 0};
}

std::vector<Case> outcode_cases(const std::vector<Point<Clip>>& points) {
  std::vector<Case> cases;
  for (const Point<Clip>& p : points) {
    Case c;
    c.where = fmt::format("point ({}, {}, {}, {})", p.x, p.y, p.z, p.w);
    const Expected expected = outcode_of(p);
    const auto wanted = std::uint32_t(expected.values[0]);
    c.restated = fmt::format("{}\noutside of: {}", restated(std::array{p}), plane_names(wanted));
    c.expected = {expected};
    c.slipped = {{"z-sign", {outcode_of({p.x, p.y, -p.z, p.w})}},
                 {"y-direction", {outcode_of({p.x, -p.y, p.z, p.w})}},
                 {"handedness", {outcode_of({-p.x, p.y, p.z, p.w})}}};
    c.judge = [expected, wanted](const Answer& answer) {
      auto found = compare(expected, answer).first;
      if (found && found->actual >= 0 && found->actual < 64)
        found->explanation =
            fmt::format("outside of: {} (expected), {} (yours)", plane_names(wanted),
                        plane_names(std::uint32_t(found->actual)));
      return found;
    };
    cases.push_back(c);
  }
  return cases;
}

std::vector<Case> verdict_cases() {
  std::vector<Case> cases;
  for (const auto& codes : lab_05::outcode_lists()) {
    Case c;
    for (const std::uint32_t code : codes)
      c.restated += fmt::format("{}a vertex outside of: {}", c.restated.empty() ? "" : "\n",
                                plane_names(code));
    c.where = fmt::format("outcodes {}", fmt::join(codes, ", "));
    // kReject, kAccept, kClip are 0, 1, 2 in both.
    static_assert(int(ClipVerdict::kReject) == int(lab_05::Verdict::kReject) &&
                  int(ClipVerdict::kAccept) == int(lab_05::Verdict::kAccept));
    c.expected = {{"verdict", Shape::kNumbers, {double(trivial_verdict(codes))}, 0, "", 0}};
    cases.push_back(c);
  }
  return cases;
}

}  // namespace

Lab lab_05() {
  Lab lab{5, "05-clipping", "Culling and clipping", {}, {}};
  lab.tasks = {{"5.1", "Faces that look away", 20},
               {"5.2", "Outcodes", 20},
               {"5.3", "Where an edge meets a plane", 20},
               {"5.4", "A polygon and one plane", 20},
               {"5.5", "A triangle and the frustum", 20}};
  const auto add = [&](const char* name, const char* task, const char* stage, bool hidden,
                       auto cases) {
    lab.checks.push_back({name, task, stage, hidden, cases});
  };
  add("faces of solids that look away", "5.1", "world", false,
      [] { return face_cases(lab_05::solids()); });
  add("an eye in the face's plane", "5.1", "world", true,
      [] { return face_cases(lab_05::faces_edge_on()); });
  add("which planes a point is outside of", "5.2", "clip", false,
      [] { return outcode_cases(lab_05::points()); });
  add("points on, before and behind every plane", "5.2", "clip", true,
      [] { return outcode_cases(lab_05::lattice_points()); });
  add("accepted, rejected or clipped", "5.2", "clip", false, verdict_cases);
  add("where an edge meets a plane", "5.3", "clip", false, crossing_cases);
  add("the same bits from either end", "5.3", "clip", false,
      [] { return both_ways_cases(lab_05::edges_both_ways()); });
  add("a crossing lies on its plane", "5.3", "clip", true, on_plane_cases);
  add("crossings between two floats", "5.3", "clip", true,
      [] { return both_ways_cases(lab_05::ties()); });
  add("a polygon and one plane", "5.4", "clip", false,
      [] { return plane_cases(lab_05::polygons()); });
  add("polygons that touch the plane", "5.4", "clip", true,
      [] { return plane_cases(lab_05::more_polygons()); });
  add("a triangle and the frustum", "5.5", "clip", false,
      [] { return frustum_cases(lab_05::triangles()); });
  add("a shared edge is cut at one place", "5.5", "clip", false, pair_cases);
  add("triangles through many planes", "5.5", "clip", true,
      [] { return frustum_cases(lab_05::more_triangles()); });
  add("triangles around a point fill the picture", "5.5", "clip", true, fan_cases);
  return lab;
}

}  // namespace glassbox::labs
