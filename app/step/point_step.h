// glassbox step --point X,Y,Z --model FILE --view FILE --proj FILE: transforms points by the user's
// own matrices, space by space, and checks each matrix. If a point is not visible, searches for the
// convention that would make it visible.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/step/printed_matrix.h"

#include <glassbox/base/error.h>
#include <glassbox/matrices/conventions_check.h>
#include <glassbox/matrices/findings.h>
#include <glassbox/matrices/projection_facts.h>
#include <glassbox/pipeline/vertex_chain.h>

namespace glassbox::app {

struct PointStepOptions {
  std::vector<glm::dvec4> points;
  std::vector<glm::dvec2> expected;  // window positions where the first points should appear
  // Sources of matrices, in the form that read_matrix_source accepts.
  std::optional<std::string> model, view, projection;
  std::optional<NumberOrder> order;
  const ApiDialect* dialect = nullptr;          // nullptr: guess it
  std::optional<std::array<double, 4>> window;  // x, y, width, height
  std::optional<Handedness> world;
  bool bits = false;
};

struct PointStep {
  struct Walk {
    VertexChain chain;
    // How uncertain the position in the window is because the matrices were printed with few
    // digits, px. The rounding error bounds do not include it.
    double digits_uncertainty_px = 0;
    std::optional<glm::dvec2> expected;
  };

  MatrixSetup setup;
  // What the projection matrix does. ProjectionKind::kNone if no matrix was given, or if it is no
  // projection; the report then does not use `lens`.
  ProjectionFacts lens;
  std::string dialect_reason;
  std::array<double, 4> window{0, 0, 1280, 720};
  Viewport viewport;  // the window in the form that to_screen needs
  bool bits = false;
  std::vector<Walk> walks;  // in the order of the points
  std::vector<Finding> findings;
  ConventionsReport conventions;  // only if a projection was given
};

Result<PointStep> step_points(const PointStepOptions& options);

std::string point_step_text(const PointStep& step);             // point_verdict_text.cpp
nlohmann::ordered_json point_step_json(const PointStep& step);  // point_json.cpp

}  // namespace glassbox::app
