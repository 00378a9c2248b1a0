// The expected answers of lab 5 for faces and outcodes, computed by the pipeline's own tests. Those
// for crossings and polygons are in outlines.h.
#include <fmt/format.h>

#include "labs/05-clipping/outlines.h"
#include "labs/framework/compare.h"
#include "labs/framework/lab.h"

#include <glassbox/pipeline/back_face.h>

namespace glassbox::labs {

namespace {

// ---- 5.1 ----

Case expect_faces(const lab_05::FaceCase& questions) {
  std::vector<double> back, front;
  std::string text;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const auto& [face, eye] = questions[i];
    std::vector<Point<Object>> corners;
    text += fmt::format("{}face {}:", i == 0 ? "" : "\n", i);
    for (const Point<World>& p : face) {
      corners.push_back({p.x, p.y, p.z});
      text += fmt::format(" ({}, {}, {})", p.x, p.y, p.z);
    }
    // World space is used as object space: the model matrix is the identity.
    const BackFaceTest test = test_back_face(corners, {true, {eye.x, eye.y, eye.z}, {0, 0, 0}});
    back.push_back(test.facing == Facing::kBack ? 1 : 0);
    front.push_back(test.value < 0 ? 1 : 0);
    text +=
        fmt::format(" seen from ({}, {}, {}): (P - eye) . m = {}", eye.x, eye.y, eye.z, test.value);
  }
  return {.where = fmt::format("{} faces", questions.size()),
          .restated = text,
          .expected = {numbers("back", back)},
          .slipped = {{"winding", {numbers("back", front)}}}};
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
  return numbers("outcode", {double(outcode(p, pipeline_frustum()))});
}

// The outcode with OpenGL's near plane, z = -w: a typical mistake.
Expected opengl_outcode_of(const Point<Clip>& p) {
  return numbers("outcode", {double(outcode(p, opengl_frustum()))});
}

Case expect_outcode(const Point<Clip>& p) {
  const Expected expected = outcode_of(p);
  const auto wanted = std::uint32_t(expected.values[0]);
  const auto judge = [expected, wanted](const Answer& answer) {
    auto found = compare(expected, answer).first;
    if (found && found->actual >= 0 && found->actual < 64)
      found->explanation = fmt::format("outside of: {} (expected), {} (yours)", plane_names(wanted),
                                       plane_names(std::uint32_t(found->actual)));
    return found;
  };
  return {
      .where = fmt::format("point ({}, {}, {}, {})", p.x, p.y, p.z, p.w),
      .restated = fmt::format("{}\noutside of: {}", restated(std::array{p}), plane_names(wanted)),
      .expected = {expected},
      .judge = judge,
      .slipped = {{"z-sign", {outcode_of({p.x, p.y, -p.z, p.w})}},
                  {"y-direction", {outcode_of({p.x, -p.y, p.z, p.w})}},
                  {"handedness", {outcode_of({-p.x, p.y, p.z, p.w})}},
                  {"opengl-depth", {opengl_outcode_of(p)}}}};
}

Case expect_verdict(const std::vector<std::uint32_t>& codes) {
  std::string text;
  for (const std::uint32_t code : codes)
    text += fmt::format("{}a vertex outside of: {}", text.empty() ? "" : "\n", plane_names(code));
  // kReject, kAccept, kClip have the values 0, 1, 2 in both enums.
  static_assert(int(ClipVerdict::kReject) == int(lab_05::Verdict::kReject) &&
                int(ClipVerdict::kAccept) == int(lab_05::Verdict::kAccept));
  return {fmt::format("outcodes {}", fmt::join(codes, ", ")),
          text,
          {numbers("verdict", {double(trivial_verdict(codes))})}};
}

}  // namespace

Lab lab_05() {
  using namespace lab_05;
  return {
      5,
      "05-clipping",
      "Culling and clipping",
      {{"5.1", "Faces that look away", 15},
       {"5.2", "Outcodes", 15},
       {"5.3", "Where an edge meets a plane", 20},
       {"5.4", "A polygon and one plane", 20},
       {"5.5", "A triangle and the frustum", 30}},
      {check("faces of solids that look away", "5.1", "world", solids, expect_faces),
       hidden_check("an eye in the face's plane", "5.1", "world", faces_edge_on, expect_faces),
       check("which planes a point is outside of", "5.2", "clip", points, expect_outcode),
       hidden_check("points on, before and behind every plane", "5.2", "clip", lattice_points,
                    expect_outcode),
       check("accepted, rejected or clipped", "5.2", "clip", outcode_lists, expect_verdict),
       check("where an edge meets a plane", "5.3", "clip", some_edges, expect_crossing),
       check("the same bits from either end", "5.3", "clip", edges_both_ways, expect_both_ways),
       hidden_check("a crossing lies on its plane", "5.3", "clip", other_edges, expect_on_plane),
       hidden_check("crossings between two floats", "5.3", "clip", ties, expect_both_ways),
       check("a polygon and one plane", "5.4", "clip", polygons, expect_polygon),
       hidden_check("polygons that touch the plane", "5.4", "clip", more_polygons, expect_polygon),
       check("a triangle and the frustum", "5.5", "clip", triangles, expect_triangle),
       check("a shared edge is cut at one place", "5.5", "clip", pairs_of_triangles, expect_pairs),
       hidden_check("triangles through many planes", "5.5", "clip", more_triangles,
                    expect_triangle),
       hidden_check("triangles around a point fill the picture", "5.5", "clip", fan_counts,
                    expect_fan)}};
}

}  // namespace glassbox::labs
