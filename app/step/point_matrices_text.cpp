// The first part of the text about points: what the three matrices are.
#include <fmt/format.h>

#include "app/step/number_text.h"
#include "app/step/point_texts.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/trig.h>
#include <glassbox/matrices/decimal.h>
#include <glassbox/matrices/projection_factors.h>

namespace glassbox::app {

namespace {

std::string turn_text(const MatrixFacts& facts) {
  if (!facts.rotation || facts.rotation->radians < kSmall) return {};
  return fmt::format("a rotation by {} degrees about {}",
                     short_number(degrees_from_radians(facts.rotation->radians), 5),
                     short_vector_text(facts.rotation->axis, 4));
}

std::string joined(std::initializer_list<std::string> parts) {
  std::string text;
  for (const std::string& part : parts) {
    if (!part.empty()) text += (text.empty() ? "" : ", then ") + part;
  }
  return text;
}

std::string rigidity_text(const MatrixFacts& facts) {
  return facts.orthogonality == 0 ? "exactly" : "to within " + short_number(facts.orthogonality, 2);
}

std::string heading(const char* name, const char* from_to, const GivenMatrix& matrix) {
  return wrapped(fmt::format("{:<11} ", name),
                 from_to + (matrix.given ? "; " + matrix.origin : ": none given"));
}

std::string indented(const std::string& text) {
  return wrapped("  ", text);
}

std::string model_text(const GivenMatrix& model) {
  std::string text = heading("MODEL", "world from object", model);
  if (!model.given) return text;
  return text + matrix_rows(model.m, "  ") + indented(affine_sentence(matrix_facts(model.m)));
}

// The view matrix in words. `lens` is the projection that belongs to it; ProjectionKind::kNone if
// none is known.
std::string view_sentences(const GivenMatrix& view, const ProjectionFacts& lens) {
  const MatrixFacts facts = matrix_facts(view.m);
  std::string text = indented(affine_sentence(facts));
  const auto eye = facts.affine ? eyepoint_of(view) : std::nullopt;
  if (!eye) return text;
  text += indented(fmt::format("the eye stands at {}; right is {}, up {}", position_text(*eye),
                               short_vector_text(eye->right, 4), short_vector_text(eye->up, 4)));
  if (lens.kind == ProjectionKind::kNone) {
    return text +
           indented(fmt::format("it looks along {} if it looks down -z, and in the opposite "
                                "direction if it looks down +z, which the projection determines",
                                short_vector_text(-eye->back, 4)));
  }
  return text + indented(fmt::format(
                    "it looks along {}, because the projection looks down {}z",
                    short_vector_text(lens.looks_down_minus_z ? -eye->back : eye->back, 4),
                    lens.looks_down_minus_z ? "-" : "+"));
}

std::string view_text(const MatrixSetup& setup) {
  std::string text = heading("VIEW", "eye from world", setup.view);
  if (!setup.view.given) return text;
  ProjectionFacts lens;
  if (setup.projection.given && !is_transposed_projection(setup.projection)) {
    lens = projection_facts(projection_part(setup.projection), setup.dialect.depth);
  }
  return text + matrix_rows(setup.view.m, "  ") + view_sentences(setup.view, lens);
}

// The depths at the planes in words: "0 at the near plane 0.1, 1 at the far plane 100"
std::string reading_text(const DepthReading& r) {
  if (!r.possible) return "none";
  const char* low = r.from_minus_one ? "-1" : "0";
  return fmt::format("{} at the near plane {}, {} at the far plane {}", r.reversed ? "1" : low,
                     rounded_text(r.near, r.near_uncertainty), r.reversed ? low : "1",
                     rounded_text(r.far, r.far_uncertainty));
}

std::string depth_text(const ProjectionFacts& p, const ApiDialect& dialect) {
  if (p.depth_lost) return indented("the depth is the same at all distances (rank 3)");
  if (p.oblique_depth) return indented("depth depends on x and y: an oblique near plane");
  const DepthReading &ours = dialect.z_from_minus_w ? p.minus_one_to_one : p.zero_to_one,
                     &other = dialect.z_from_minus_w ? p.zero_to_one : p.minus_one_to_one;
  return indented(
             fmt::format("with the depth range of {}: {}", dialect.title, reading_text(ours))) +
         indented(fmt::format("with the depth range {} instead: {}",
                              other.from_minus_one ? "-1 .. 1" : "0 .. 1", reading_text(other)));
}

std::string perspective_text(const ProjectionFacts& p) {
  std::string text = indented(
      p.looks_down_minus_z ? "perspective; w grows along -z: a right-handed eye, looking down -z"
                           : "perspective; w grows along +z: a left-handed eye, looking down +z");
  std::string window =
      fmt::format("vertical angle of view {} degrees, aspect ratio {}",
                  rounded_text(p.fovy_degrees, p.fovy_uncertainty), short_number(p.aspect, 5));
  if (p.off_centre()) {
    window += fmt::format("; off-centre: the gaze meets the picture at NDC ({}, {})",
                          short_number(p.centre.x), short_number(p.centre.y));
  }
  if (p.shift != glm::dvec2(0)) {
    window +=
        fmt::format("; the eye is moved to x = {}, y = {}", short_number(-p.shift.x / p.scale.x),
                    short_number(-p.shift.y / p.scale.y));
  }
  return text + indented(window);
}

std::string parallel_text(const ProjectionFacts& p, const ApiDialect& dialect) {
  const auto edge = [&](int axis, double side) {
    return short_number((side - p.centre[axis]) / p.scale[axis]);
  };
  return indented("parallel: w is the same everywhere") +
         indented(fmt::format("the window is x from {} to {}, y from {} to {}", edge(0, -1),
                              edge(0, 1), edge(1, -1), edge(1, 1))) +
         indented(fmt::format("with the depth range of {} the eye looks down {}z", dialect.title,
                              p.looks_down_minus_z ? "-" : "+"));
}

std::string lens_text(const ProjectionFacts& p, const ApiDialect& dialect) {
  return (p.kind == ProjectionKind::kPerspective ? perspective_text(p)
                                                 : parallel_text(p, dialect)) +
         depth_text(p, dialect);
}

std::string projection_text(const GivenMatrix& given, const ApiDialect& dialect) {
  std::string text = heading("PROJECTION", "clip from eye", given);
  if (!given.given) return text;
  text += matrix_rows(given.m, "  ");
  const ProjectionFacts plain = projection_facts(given, dialect.depth);
  if (plain.kind != ProjectionKind::kNone && !plain.looks_transposed) {
    return text + lens_text(plain, dialect);
  }
  if (const auto parts = factor_projection(given); parts && !plain.looks_transposed) {
    const ProjectionFacts lens = projection_facts(parts->projection, dialect.depth);
    return text + indented("a projection with a view in it. The view's part:") +
           view_sentences(parts->view, lens) + indented("The projection's part:") +
           lens_text(lens, dialect);
  }
  const MatrixFacts facts = matrix_facts(given.m);
  return text + indented(facts.affine ? "as a matrix: " + affine_sentence(facts)
                                      : fmt::format("not a projection (rank {})", facts.rank));
}

}  // namespace

std::string affine_sentence(const MatrixFacts& facts) {
  const std::string moved = facts.translation == glm::dvec3(0)
                                ? ""
                                : "a translation by " + short_vector_text(facts.translation);
  const std::string mirror = facts.mirror() ? fmt::format("; it mirrors (determinant {})",
                                                          short_number(facts.determinant, 4))
                                            : "";
  switch (facts.shape) {
    case MatrixShape::kNotFinite:
      return "not all of its entries are finite";
    case MatrixShape::kIdentity:
      return "the identity";
    case MatrixShape::kTranslation:
      return moved + ", and nothing else";
    case MatrixShape::kRigid:
      return fmt::format("rigid {}: {}{}", rigidity_text(facts),
                         joined({facts.mirror() ? "a reflection" : turn_text(facts), moved}),
                         mirror);
    case MatrixShape::kSimilarity:
      return joined(
                 {"a scale by " + short_number(std::abs(facts.scale.x)), turn_text(facts), moved}) +
             mirror;
    case MatrixShape::kScaled:
      return joined({"scales by " + short_vector_text(facts.scale) + " along the axes",
                     turn_text(facts), moved}) +
             mirror;
    case MatrixShape::kScaledAfter:
      return joined({"a rotation, then scales along fixed axes, which shears the object", moved}) +
             mirror;
    case MatrixShape::kSheared:
      return joined({"affine, with a shear", moved}) + mirror;
    case MatrixShape::kFlat:
      return fmt::format("affine, but it flattens space: rank {}, determinant {}", facts.rank,
                         short_number(facts.determinant, 3));
    case MatrixShape::kProjective:
      return fmt::format("not affine, because the last row is not 0 0 0 1 (rank {})", facts.rank);
  }
  return "";
}

std::string matrices_text(const MatrixSetup& setup) {
  return model_text(setup.model) + "\n" + view_text(setup) + "\n" +
         projection_text(setup.projection, setup.dialect);
}

}  // namespace glassbox::app
