// Judges clipped polygons: computes the exact polygon, and how far an answer may be from it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "labs/05-clipping/generators.h"
#include "labs/framework/lab.h"

#include <glassbox/pipeline/clip.h>

namespace glassbox::labs {

glassbox::ClipPlane pipeline_plane(const lab_05::Plane& plane);

// The frustum's planes in the lab's order.
std::vector<glassbox::ClipPlane> pipeline_frustum();

// The frustum's planes with OpenGL's near plane, z >= -w.
std::vector<glassbox::ClipPlane> opengl_frustum();

// The frustum's planes without the near plane, a typical mistake.
std::vector<glassbox::ClipPlane> frustum_without_near();

// Describes a polygon of clip space in NDC and on a screen of 640 x 480 pixels, with its winding if
// it has one.
std::string restated(std::span<const Point<Clip>> polygon);

// The part of the polygon inside all planes, computed in rational numbers and rounded once.
struct ExactOutline {
  Expected expected;            // empty if there are fewer than three vertices
  std::vector<double> touched;  // the vertices, if there are one or two
  std::vector<double> corners;  // of the polygon before it was clipped
};
// `expected.bound` is how far each number of an answer may be off.
ExactOutline exact_clip(std::span<const Point<Clip>> polygon, std::span<const ClipPlane> planes);

// Compares a clipped polygon with the expected one; any vertex may come first. Returns nothing if
// the answer's field is right. Vertices nearer to each other than the bound may be merged into one,
// and there may be other vertices on the same line, next to a plane, where rounding decides what
// the plane cuts off; but no two neighbours may be equal, and an answer must not have one or two
// vertices, or more than nine.
std::optional<Divergence> compare_outlines(const ExactOutline& outline, const Answer& answer);

// Compares how two triangles that share an edge were clipped: each end of the part of the edge that
// remains must be a vertex of both results, with the same bits.
std::optional<Divergence> compare_shared_edges(const lab_05::PairsCase& pairs,
                                               const Answer& answer);

// Checks that every pixel of a picture is covered exactly once by the answer's `count` polygons.
std::optional<Divergence> compare_coverage(int count, const Answer& answer);

// The expected answers of tasks 5.3 to 5.5 (checks_clip.cpp).
Case expect_crossing(const lab_05::Edge& edge);
Case expect_on_plane(const lab_05::Edge& edge);
Case expect_both_ways(const lab_05::EdgesCase& edges);
Case expect_polygon(const lab_05::PlaneCase& input);
Case expect_triangle(const lab_05::FrustumCase& input);
Case expect_pairs(const lab_05::PairsCase& pairs);
Case expect_fan(const int& count);

// The expected answers to generated inputs of tasks 5.3 to 5.5, and whether an answer is right
// (generated_check() in lab.h).
Case expect_edge(const lab_05::Edge& edge);
bool right_edge(const lab_05::Edge& edge, const Answer& answer);
bool right_part(const lab_05::PlaneCase& input, const Answer& answer);
bool right_triangle(const lab_05::FrustumCase& input, const Answer& answer);
bool right_pairs(const lab_05::PairsCase& pairs, const Answer& answer);

// What each plane may add to the error of a vertex: 8 roundings of the largest coordinate of the
// edge's ends (student.h).
inline constexpr double kRoundings = 8;

}  // namespace glassbox::labs
