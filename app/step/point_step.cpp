#include "app/step/point_step.h"

#include <algorithm>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/base/rounding.h>

namespace glassbox::app {

namespace {

// A viewport of negative height, as in Vulkan, flips y. This is treated as a clip space whose y
// points the other way.
void take_window(const PointStepOptions& o, PointStep& step) {
  MatrixSetup& setup = step.setup;
  const bool asked = o.window || o.size_is_given;
  step.window = o.window.value_or(std::array<double, 4>{0, 0, double(o.size.x), double(o.size.y)});
  auto& [x, y, width, height] = step.window;
  if (height < 0) {
    y += height;
    height = -height;
    setup.dialect.ndc_y_down = !setup.dialect.ndc_y_down;
  }
  if (asked && width >= 1 && height >= 1) setup.picture = glm::ivec2(int(width), int(height));
  step.viewport = window_rectangle(setup.dialect, float(x), float(y), float(width), float(height));
}

ChainMatrices chain_matrices(const MatrixSetup& setup) {
  return {Transform<World, Object, float>(glm::mat4(setup.model.m)),
          Transform<Eye, World, float>(glm::mat4(setup.view.m)),
          Transform<Clip, Eye, float>(glm::mat4(setup.projection.m))};
}

PointStep::Walk walk_point(const glm::vec4& point, const PointStep& step) {
  const MatrixSetup& s = step.setup;
  ChainMatrices matrices = chain_matrices(s);
  PointStep::Walk walked{make_vertex_chain(point, matrices, s.dialect, step.viewport), 0,
                         std::nullopt};
  if (!walked.chain.screen) return walked;
  matrices.world_from_object_bound = s.model.uncertainty;
  matrices.eye_from_world_bound = s.view.uncertainty;
  matrices.clip_from_eye_bound = s.projection.uncertainty;
  const VertexChain open = make_vertex_chain(point, matrices, s.dialect, step.viewport);
  const glm::dvec3 added = open.screen->bound - walked.chain.screen->bound;
  walked.digits_uncertainty_px = std::max(added.x, added.y);
  return walked;
}

// All points, those of the table or those of the command line.
std::vector<TableVertex> points_of(const PointStepOptions& o) {
  if (!o.table.empty()) return o.table;
  std::vector<TableVertex> points;
  for (const glm::dvec4& point : o.points) {
    points.push_back({point, double(unit_roundoff<float>) * glm::abs(point), 0});
  }
  return points;
}

}  // namespace

Result<PointStep> step_points(const PointStepOptions& o, const OwnMatrices& matrices) {
  if (!matrices.any()) {
    return fail("", "no matrix is given", "give at least one of --model, --view and --proj");
  }
  const std::vector<TableVertex> points = points_of(o);
  if (!o.program_clip.empty() && o.program_clip.size() != points.size()) {
    return fail("--clip",
                fmt::format("there are {} and {}", counted(points.size(), "point"),
                            counted(o.program_clip.size(), "clip position")),
                "give one clip position for each point, in the same order");
  }
  if (o.expected.size() > points.size()) {
    return fail("--expect", "there are more expected positions than points",
                "give one expected position for each point");
  }
  PointStep step;
  step.bits = o.bits;
  step.brief = o.brief;
  step.check = o.check;
  NamedSetup named = setup_of(matrices);
  step.setup = std::move(named.setup);
  step.dialect_reason = std::move(named.dialect_reason);
  take_window(o, step);
  if (step.setup.projection.given) {
    const ProjectionFacts lens = projection_facts(step.setup.projection, step.setup.dialect.depth);
    if (!lens.looks_transposed) step.lens = lens;
  }

  std::vector<CheckedPoint> checked;
  step.points = points.size();
  const std::size_t walks = o.table.empty() ? points.size() : std::min(points.size(), kMaxWalks);
  for (std::size_t k = 0; k < walks; ++k) {
    const std::size_t i = k * points.size() / walks;
    step.walks.push_back(walk_point(glm::vec4(points[i].position), step));
    if (i < o.expected.size()) step.walks.back().expected = o.expected[i];
    checked.push_back({points[i].position, step.walks.back().expected});
  }
  if (!o.program_clip.empty()) {
    step.clip = compare_clip_positions(step.setup, points, o.program_clip);
  }
  step.findings = check_matrices(step.setup);
  if (step.setup.projection.given) {
    step.conventions = check_conventions(step.setup, step.viewport, checked);
  }
  return step;
}

}  // namespace glassbox::app
