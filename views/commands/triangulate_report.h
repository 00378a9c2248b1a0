// The report of `glassbox views triangulate` on the points that matches show.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "views/commands/geometry.h"
#include "views/two_view/located_point.h"

namespace glassbox::views {

struct TriangulationInput {
  GeometryInput pair;                    // the matches, and the pictures if they are known
  std::array<PinholeCamera, 2> cameras;  // in world space
  Triangulator how = Triangulator::kMidpoint;
  double sigma = 0.5;  // px: standard deviation of each coordinate of a match
};

// The medians over the points in front of both cameras.
struct TriangulationMedians {
  double gap = 0, distance = 0;      // world units; the distance is from the left camera
  double residual = 0;               // px
  double angle = 0;                  // between the rays, radians
  double longest = 0, shortest = 0;  // half axes of the ellipsoids, world units
};

struct TriangulationReport {
  std::vector<LocatedPoint> points;                           // one for each match
  std::array<std::size_t, std::size(kPointStates)> counts{};  // by state
  std::size_t parallel_behind = 0;  // of those with nearly parallel rays: not in front of both
  std::size_t unlikely = 0;         // residuals above three sigma
  std::optional<TriangulationMedians> medians;  // absent if no point is in front of both cameras

  std::size_t count(PointState state) const { return counts[std::size_t(state)]; }
};

TriangulationReport triangulation_report(const TriangulationInput& input);

// The report in lines of at most 100 columns, with a table of the first `rows` matches.
// `in_full` is the number of a match, from 1, that is printed with all its numbers.
std::string triangulation_text(const TriangulationInput& input, const TriangulationReport& report,
                               std::size_t rows, std::optional<std::size_t> in_full);

// Numbers that are not known or not finite are null.
nlohmann::ordered_json triangulation_json(const TriangulationInput& input,
                                          const TriangulationReport& report);

// The points in front of both cameras, with the colours of the left picture if it is known: a
// binary PLY file with floats.
std::string triangulation_ply(const TriangulationInput& input, const TriangulationReport& report);

// A row for each match, with its state. Fields of numbers that are not known are empty.
std::string triangulation_csv(const TriangulationInput& input, const TriangulationReport& report);

// The report as one HTML page that needs no other file: both cameras, the rays and the points in
// space. It has the first 2000 matches.
std::string triangulation_page(const TriangulationInput& input, const TriangulationReport& report,
                               const std::string& command);

}  // namespace glassbox::views
