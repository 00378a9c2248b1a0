// Clipped polygons under judgement: the exact ones, and how far an answer may be from them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "labs/05-clipping/cases.h"
#include "labs/framework/lab.h"

#include <glassbox/pipeline/clip.h>

namespace glassbox::labs {

glassbox::ClipPlane pipeline_plane(const lab_05::Plane& plane);

// The frustum's planes in the lab's order.
std::vector<glassbox::ClipPlane> pipeline_frustum();

// The same with OpenGL's near plane, z >= -w.
std::vector<glassbox::ClipPlane> opengl_frustum();

// A polygon of clip space in NDC and on a screen of 640 x 480 pixels, with its winding where it has one.
std::string restated(std::span<const Point<Clip>> polygon);

// The part inside all planes in rationals, rounded once; empty where it has less than three vertices. Each number may be
// off by `bound`.
Expected exact_clip(std::span<const Point<Clip>> polygon, std::span<const ClipPlane> planes);

// Any vertex may come first. Nothing if the answer's field is right. Vertices nearer to each other than the bound may be one: no two
// neighbours may be equal, though, and less than three vertices are none.
std::optional<Divergence> compare_outlines(const Expected& expected, const Answer& answer);

// The same edge in two triangles: each end of what is left of it must be a vertex of both, with the same bits.
std::optional<Divergence> compare_shared_edges(const lab_05::PairsCase& pairs,
                                               const Answer& answer);

// Every pixel of a picture must be covered once by the answer's `count` polygons.
std::optional<Divergence> compare_coverage(int count, const Answer& answer);

// What is expected in tasks 5.3 to 5.5 (checks_clip.cpp).
Case expect_crossing(const lab_05::Edge& edge);
Case expect_on_plane(const lab_05::Edge& edge);
Case expect_both_ways(const lab_05::EdgesCase& edges);
Case expect_polygon(const lab_05::PlaneCase& input);
Case expect_triangle(const lab_05::FrustumCase& input);
Case expect_pairs(const lab_05::PairsCase& pairs);
Case expect_fan(const int& count);

// What each plane may add to the error of a vertex: 8 roundings of the largest coordinate of the edge's ends (student.h).
inline constexpr double kRoundings = 8;

}  // namespace glassbox::labs
