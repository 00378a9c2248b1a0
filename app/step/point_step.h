// glassbox step --point X,Y,Z --model FILE --view FILE --proj FILE: points through one's own matrices, space by space, with a check
// of each matrix, and where a point vanishes the convention that would make it visible.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/step/matrices/conventions_check.h"
#include "app/step/matrices/findings.h"
#include "app/step/matrices/projection_facts.h"
#include "app/step/printed_matrix.h"

#include <glassbox/base/error.h>
#include <glassbox/pipeline/vertex_chain.h>

namespace glassbox::app {

struct PointStepOptions {
  std::vector<glm::dvec4> points;
  std::vector<glm::dvec2> expected;  // where the first of them should appear in the window
  // Sources, as read_matrix_source has them.
  std::optional<std::string> model, view, projection;
  std::optional<NumberOrder> order;
  const ApiDialect* dialect = nullptr;          // nullptr: to be guessed
  std::optional<std::array<double, 4>> window;  // x, y, width, height
  std::optional<Hand> world;
  bool bits = false;
};

struct PointStep {
  struct Walk {
    VertexChain chain;
    double open_px = 0;  // what the digits of the matrices add to the bounds in the window
    std::optional<glm::dvec2> expected;
  };

  MatrixSetup setup;
  // What the projection does. ProjectionKind::kNone where none was given, or it is not one: nothing is said in its terms.
  ProjectionFacts lens;
  std::string dialect_reason;
  std::array<double, 4> window{0, 0, 1280, 720};
  Viewport viewport;  // the same, made ready for to_screen
  bool bits = false;
  std::vector<Walk> walks;  // in the order of the points
  std::vector<Finding> findings;
  ConventionsReport conventions;  // only where a projection was given
};

Result<PointStep> step_points(const PointStepOptions& options);

std::string point_step_text(const PointStep& step);             // point_verdict_text.cpp
nlohmann::ordered_json point_step_json(const PointStep& step);  // point_json.cpp

}  // namespace glassbox::app
