// The expected answers of lab 5 for faces and outcodes, computed by the pipeline's own tests. Those
// for crossings and polygons are in outlines.h.
#include <array>
#include <cstdint>

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

enum class NearPlane { kRight, kOpengl, kNone };

// The outcode by the inequalities of student.h; or, which are typical mistakes, with OpenGL's near
// plane, z >= -w, or without any.
std::uint32_t outcode_by(const Point<Clip>& p, NearPlane near) {
  const bool inside[] = {near == NearPlane::kNone || p.z >= (near == NearPlane::kOpengl ? -p.w : 0),
                         p.z <= p.w,
                         p.x >= -p.w,
                         p.x <= p.w,
                         p.y >= -p.w,
                         p.y <= p.w};
  std::uint32_t code = 0;
  for (std::uint32_t i = 0; i < 6; ++i) code |= std::uint32_t(!inside[i]) << i;
  return code;
}

Expected outcode_of(const Point<Clip>& p, NearPlane near = NearPlane::kRight) {
  return numbers("outcode", {double(outcode_by(p, near))});
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
                  {"opengl-depth", {outcode_of(p, NearPlane::kOpengl)}},
                  {"no-near-plane", {outcode_of(p, NearPlane::kNone)}}}};
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

// ---- generated inputs ----

// In steps of 1/16 all numbers are whole. With fewer than 2^4 corners Newell's sums are below
// 2^(14 + 14 + 4), and the dot product is below 2^48.
bool right_face(const lab_05::FaceCase& questions, const Answer& answer) {
  const auto& [face, eye] = questions[0];
  using Whole = std::array<std::int64_t, 3>;
  const auto whole = [](const Point<World>& p) {
    return Whole{std::int64_t(p.x * 16), std::int64_t(p.y * 16), std::int64_t(p.z * 16)};
  };
  Whole m{};
  for (std::size_t i = 0; i < face.size(); ++i) {
    const Whole p = whole(face[i]), n = whole(face[(i + 1) % face.size()]);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      m[k] += (p[a] - n[a]) * (p[b] + n[b]);
    }
  }
  const Whole p = whole(face[0]), e = whole(eye);
  const std::int64_t value = (p[0] - e[0]) * m[0] + (p[1] - e[1]) * m[1] + (p[2] - e[2]) * m[2];
  return has_numbers(answer, "back", {value > 0 ? 1.0 : 0.0});
}

bool right_outcode(const Point<Clip>& p, const Answer& answer) {
  return has_numbers(answer, "outcode", {double(outcode_by(p, NearPlane::kRight))});
}

bool right_verdict(const std::vector<std::uint32_t>& codes, const Answer& answer) {
  return has_numbers(answer, "verdict", {double(trivial_verdict(codes))});
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
       generated_check("any face", "5.1", "world", generated_faces, expect_faces, right_face),
       hidden_check("an eye in the face's plane", "5.1", "world", faces_edge_on, expect_faces),
       check("which planes a point is outside of", "5.2", "clip", points, expect_outcode),
       generated_check("any point", "5.2", "clip", generated_clip_points, expect_outcode,
                       right_outcode),
       hidden_check("points on, before and behind every plane", "5.2", "clip", lattice_points,
                    expect_outcode),
       check("accepted, rejected or clipped", "5.2", "clip", outcode_lists, expect_verdict),
       generated_check("any outcodes", "5.2", "clip", generated_codes, expect_verdict,
                       right_verdict),
       check("where an edge meets a plane", "5.3", "clip", some_edges, expect_crossing),
       check("the same bits from either end", "5.3", "clip", edges_both_ways, expect_both_ways),
       generated_check("any edge", "5.3", "clip", generated_edges, expect_edge, right_edge),
       hidden_check("a crossing lies on its plane", "5.3", "clip", other_edges, expect_on_plane),
       hidden_check("crossings between two floats", "5.3", "clip", ties, expect_both_ways),
       check("a polygon and one plane", "5.4", "clip", polygons, expect_polygon),
       generated_check("any polygon and plane", "5.4", "clip", generated_polygons, expect_polygon,
                       right_part),
       hidden_check("polygons that touch the plane", "5.4", "clip", more_polygons, expect_polygon),
       check("a triangle and the frustum", "5.5", "clip", triangles, expect_triangle),
       generated_check("any triangle", "5.5", "clip", generated_triangles, expect_triangle,
                       right_triangle),
       check("a shared edge is cut at one place", "5.5", "clip", pairs_of_triangles, expect_pairs),
       generated_check("any two triangles with a common edge", "5.5", "clip", generated_pairs,
                       expect_pairs, right_pairs),
       hidden_check("triangles through many planes", "5.5", "clip", more_triangles,
                    expect_triangle),
       hidden_check("triangles around a point fill the picture", "5.5", "clip", fan_counts,
                    expect_fan)}};
}

}  // namespace glassbox::labs
