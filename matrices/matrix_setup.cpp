#include <glassbox/matrices/matrix_setup.h>

#include <utility>

#include <glassbox/matrices/projection_factors.h>

namespace glassbox {
namespace {

ProjectionFacts likely_facts(const GivenMatrix& projection) {
  if (is_transposed_projection(projection)) {
    return projection_facts(projection_part(transposed(projection)));
  }
  return projection_facts(projection_part(projection));
}

}  // namespace

std::optional<Handedness> drawn_handedness(const MatrixSetup& setup) {
  const MatrixFacts view = matrix_facts(setup.view.m);
  const ProjectionFacts lens =
      projection_facts(projection_part(setup.projection), setup.dialect.depth);
  if (!view.invertible() || lens.kind == ProjectionKind::kNone || !setup.projection.given) {
    return std::nullopt;
  }
  bool right = lens.looks_down_minus_z;
  if (view.mirror()) right = !right;
  // The picture is mirrored left to right only if x is flipped and y is not. If only y is flipped,
  // the picture is upside down; if both are, it is turned by 180 degrees.
  const bool y_flipped = (lens.scale.y < 0) != setup.dialect.ndc_y_down;
  if (lens.scale.x < 0 && !y_flipped) right = !right;
  return right ? Handedness::kRight : Handedness::kLeft;
}

GuessedDialect guess_dialect(const GivenMatrix& projection) {
  const auto guess = [](const char* name, std::string reason) {
    return GuessedDialect{find_dialect(name), std::move(reason)};
  };
  if (!projection.given) return guess("opengl", "no projection is given");
  const ProjectionFacts facts = likely_facts(projection);
  if (facts.kind == ProjectionKind::kNone || facts.depth_lost) {
    return guess("opengl", "the projection does not show it; choose another with --dialect");
  }
  const DepthReading* likely = facts.likely_range(1);
  if (facts.kind == ProjectionKind::kPerspective && facts.zero_to_one.possible &&
      facts.zero_to_one.reversed && (likely == nullptr || !likely->from_minus_one)) {
    return guess("reversed", "the projection's depth falls with distance");
  }
  if (likely == nullptr) {
    return guess("opengl", "the projection fits either range of depth; choose with --dialect");
  }
  const std::string planes = planes_text(*likely);
  if (likely->from_minus_one) {
    return guess("opengl", "with depth -1 .. 1 the projection has " + planes);
  }
  if (facts.scale.y < 0) {
    return guess("vulkan",
                 "with depth 0 .. 1 the projection has " + planes + ", and y points down");
  }
  return guess("d3d", "with depth 0 .. 1 the projection has " + planes);
}

NamedSetup setup_of(const OwnMatrices& matrices) {
  NamedSetup named;
  named.setup.model = matrices.model;
  named.setup.view = matrices.view;
  named.setup.projection = matrices.projection;
  named.setup.world = matrices.world;
  named.setup.front = matrices.front;
  if (matrices.dialect != nullptr) {
    named.setup.dialect = *matrices.dialect;
    named.dialect_reason = "as given";
  } else {
    const GuessedDialect guess = guess_dialect(matrices.projection);
    named.setup.dialect = *guess.dialect;
    named.dialect_reason = "guessed: " + guess.reason;
  }
  return named;
}

}  // namespace glassbox
