#include "app/step/matrices/dialect_guess.h"

#include "app/step/matrices/projection_factors.h"

namespace glassbox {
namespace {

ProjectionFacts likely_facts(const GivenMatrix& projection) {
  if (is_transposed_projection(projection)) {
    return projection_facts(projection_part(transposed(projection)));
  }
  return projection_facts(projection_part(projection));
}

}  // namespace

GuessedDialect guess_dialect(const GivenMatrix& projection) {
  const auto guess = [](const char* name, std::string reason) {
    return GuessedDialect{find_dialect(name), std::move(reason)};
  };
  if (!projection.given) return guess("opengl", "there is no projection to tell");
  const ProjectionFacts facts = likely_facts(projection);
  if (facts.kind == ProjectionKind::kNone || facts.depth_lost) {
    return guess("opengl", "nothing tells; say --dialect for another");
  }
  const DepthReading* likely = facts.likely_range(1);
  if (facts.kind == ProjectionKind::kPerspective && facts.zero_to_one.possible &&
      facts.zero_to_one.reversed && (likely == nullptr || !likely->from_minus_one)) {
    return guess("reversed", "the projection's depth falls with distance");
  }
  if (likely == nullptr) {
    return guess("opengl", "the projection may be for either range of depth; say --dialect");
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

}  // namespace glassbox
