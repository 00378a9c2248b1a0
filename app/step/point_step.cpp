#include "app/step/point_step.h"

#include <algorithm>

#include <fmt/format.h>

#include <glassbox/base/printable.h>

namespace glassbox::app {

namespace {

Result<void> read_matrix(const char* option, const std::optional<std::string>& source,
                         std::optional<NumberOrder> asked, GivenMatrix& matrix) {
  if (!source) return {};
  const auto located = [&](Error error) {
    error.place = error.place.empty() ? option : std::string(option) + ", " + error.place;
    return tl::unexpected(std::move(error));
  };
  const auto read = read_matrix_source(*source);
  if (!read) return located(read.error());
  const auto parsed = parse_matrix_text(read->text, read->name);
  if (!parsed) return located(parsed.error());
  const NumberOrder order = order_of(*parsed, asked);
  matrix = to_matrix(*parsed, order);
  matrix.origin = fmt::format("{}, read by {}", printable(read->name),
                              order == NumberOrder::kRows ? "rows" : "columns");
  if (!parsed->recognised.empty()) matrix.origin += fmt::format(" ({})", parsed->recognised);
  return {};
}

Result<void> read_matrices(const PointStepOptions& o, MatrixSetup& s) {
  const auto is_stdin = [](const std::optional<std::string>& source) {
    return source && *source == "-" ? 1 : 0;
  };
  if (is_stdin(o.model) + is_stdin(o.view) + is_stdin(o.projection) > 1) {
    return fail("--model, --view, --proj", "more than one of them is standard input",
                "put the others into files");
  }
  const auto model = read_matrix("--model", o.model, o.order, s.model);
  if (!model) return model;
  const auto view = read_matrix("--view", o.view, o.order, s.view);
  if (!view) return view;
  return read_matrix("--proj", o.projection, o.order, s.projection);
}

void choose_dialect(const ApiDialect* asked, PointStep& step) {
  if (asked != nullptr) {
    step.setup.dialect = *asked;
    step.dialect_reason = "as given";
  } else {
    const GuessedDialect guess = guess_dialect(step.setup.projection);
    step.setup.dialect = *guess.dialect;
    step.dialect_reason = "guessed: " + guess.reason;
  }
}

// A viewport of negative height, as in Vulkan, flips y. This is treated as a clip space whose y
// points the other way.
void take_window(const std::optional<std::array<double, 4>>& asked, PointStep& step) {
  MatrixSetup& setup = step.setup;
  if (asked) step.window = *asked;
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

}  // namespace

Result<PointStep> step_points(const PointStepOptions& o) {
  if (!o.model && !o.view && !o.projection) {
    return fail("", "no matrix is given", "give at least one of --model, --view and --proj");
  }
  if (o.expected.size() > o.points.size()) {
    return fail("--expect", "there are more expected positions than points", "give one for each");
  }
  PointStep step;
  step.bits = o.bits;
  step.setup.world = o.world;
  if (const auto read = read_matrices(o, step.setup); !read) return tl::unexpected(read.error());
  choose_dialect(o.dialect, step);
  take_window(o.window, step);
  if (step.setup.projection.given) {
    const ProjectionFacts lens = projection_facts(step.setup.projection, step.setup.dialect.depth);
    if (!lens.looks_transposed) step.lens = lens;
  }

  std::vector<CheckedPoint> checked;
  for (std::size_t i = 0; i < o.points.size(); ++i) {
    step.walks.push_back(walk_point(glm::vec4(o.points[i]), step));
    if (i < o.expected.size()) step.walks.back().expected = o.expected[i];
    checked.push_back({o.points[i], step.walks.back().expected});
  }
  step.findings = check_matrices(step.setup);
  if (step.setup.projection.given) {
    step.conventions = check_conventions(step.setup, step.viewport, checked);
  }
  return step;
}

}  // namespace glassbox::app
