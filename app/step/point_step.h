// glassbox step --point X,Y,Z --model FILE --view FILE --proj FILE: transforms points by the user's
// own matrices, space by space, and checks each matrix. If a point is not visible, searches for the
// convention that would make it visible.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/base/error.h>
#include <glassbox/matrices/clip_comparison.h>
#include <glassbox/matrices/conventions_check.h>
#include <glassbox/matrices/findings.h>
#include <glassbox/matrices/projection_facts.h>
#include <glassbox/matrices/vertex_table.h>
#include <glassbox/pipeline/vertex_chain.h>

namespace glassbox::app {

struct PointStepOptions {
  std::vector<glm::dvec4> points;
  // Points from a table, in place of `points`, and the clip positions that a program computed for
  // the points, in the same order; empty if there are none.
  std::vector<TableVertex> table;
  std::vector<TableVertex> program_clip;
  std::vector<glm::dvec2> expected;  // window positions where the first points should appear
  std::optional<std::array<double, 4>> window;  // x, y, width, height
  // If there is no window: its size, and whether the user gave it.
  glm::ivec2 size{1280, 720};
  bool size_is_given = false;
  bool bits = false;
  bool brief = false;  // only the summary
  bool check = false;  // the exit code tells whether something is wrong
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
  bool bits = false, brief = false, check = false;
  std::vector<Walk> walks;  // in the order of the points
  // How many points there are. If a table has more than kMaxWalks, so many of them have a walk,
  // spread evenly.
  std::size_t points = 0;
  std::optional<ClipComparison> clip;  // with the positions that a program computed
  std::vector<Finding> findings;
  ConventionsReport conventions;  // only if a projection was given
};

inline constexpr std::size_t kMaxWalks = 100;

Result<PointStep> step_points(const PointStepOptions& options, const OwnMatrices& matrices);

std::string point_step_text(const PointStep& step);             // point_verdict_text.cpp
std::string clip_comparison_text(const ClipComparison& found);  // clip_comparison.cpp
nlohmann::ordered_json clip_comparison_json(const ClipComparison& found);
nlohmann::ordered_json point_step_json(const PointStep& step);  // point_json.cpp

}  // namespace glassbox::app
