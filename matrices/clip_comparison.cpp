#include <glassbox/matrices/clip_comparison.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/matrix.hpp>

#include <glassbox/base/rounding.h>
#include <glassbox/matrices/convention_mistakes.h>
#include <glassbox/pipeline/affine.h>

namespace glassbox {

namespace {

// ---- one vertex ----

glm::dmat4 sizes_of(const glm::dmat4& m) {
  glm::dmat4 sizes;
  for (int column = 0; column < 4; ++column) sizes[column] = glm::abs(m[column]);
  return sizes;
}

// The product of the three matrices, and the largest amount by which computing in float and the
// printed digits can change a coordinate.
class ClipFromObject {
public:
  explicit ClipFromObject(const MatrixSetup& s)
      : product_(s.projection.m * s.view.m * s.model.m),
        sizes_(sizes_of(s.projection.m) * sizes_of(s.view.m) * sizes_of(s.model.m)),
        open_(s.projection.uncertainty * sizes_of(s.view.m) * sizes_of(s.model.m) +
              sizes_of(s.projection.m) * s.view.uncertainty * sizes_of(s.model.m) +
              sizes_of(s.projection.m) * sizes_of(s.view.m) * s.model.uncertainty) {}

  glm::dvec4 position(const TableVertex& object) const { return product_ * object.position; }

  glm::dvec4 tolerance(const TableVertex& object, const TableVertex& theirs) const {
    const glm::dvec4 size = glm::abs(object.position);
    // Three matrices, each with at most four products and three sums, and rounded to float before.
    const double rounding = 2 * gamma<float>(3 * 4 + 1);
    return rounding * (sizes_ * size) + open_ * size + sizes_ * object.uncertainty +
           theirs.uncertainty;
  }

private:
  glm::dmat4 product_, sizes_, open_;
};

bool agree(const glm::dvec4& ours, const glm::dvec4& theirs, const glm::dvec4& tolerance) {
  for (int i = 0; i < 4; ++i) {
    if (!(std::abs(ours[i] - theirs[i]) <= tolerance[i])) return false;
  }
  return true;
}

// ---- explanations ----

// A way of using the matrices. `apply` returns false if the setup cannot be used so.
struct Usage {
  const char* id;
  const char* text;
  bool (*apply)(MatrixSetup& setup);
};

bool leave_out(GivenMatrix& matrix) {
  const bool given = matrix.given;
  matrix = {};
  return given;
}

constexpr std::array kUsages{
    Usage{"no-model", "it leaves out the model matrix",
          [](MatrixSetup& s) { return leave_out(s.model); }},
    Usage{"no-view", "it leaves out the view matrix",
          [](MatrixSetup& s) { return leave_out(s.view); }},
    Usage{"no-projection", "it leaves out the projection",
          [](MatrixSetup& s) { return leave_out(s.projection); }},
    Usage{"model-twice", "it applies the model matrix twice",
          [](MatrixSetup& s) {
            s.model.m = s.model.m * s.model.m;
            return s.model.given;
          }},
    Usage{"view-twice", "it applies the view matrix twice",
          [](MatrixSetup& s) {
            s.view.m = s.view.m * s.view.m;
            return s.view.given;
          }},
    Usage{"reversed-order", "it multiplies in the reversed order: model * view * projection",
          [](MatrixSetup& s) {
            std::swap(s.model, s.projection);
            return s.model.given && s.projection.given;
          }},
    Usage{"depth-to-zero-one", "it converts z to the range 0 .. w: z = (z + w)/2",
          [](MatrixSetup& s) {
            for (int c = 0; c < 4; ++c) {
              s.projection.m[c].z = (s.projection.m[c].z + s.projection.m[c].w) / 2;
            }
            return s.projection.given;
          }},
    Usage{"depth-to-minus-one-one", "it converts z to the range -w .. w: z = 2z - w",
          [](MatrixSetup& s) {
            for (int c = 0; c < 4; ++c) {
              s.projection.m[c].z = 2 * s.projection.m[c].z - s.projection.m[c].w;
            }
            return s.projection.given;
          }},
    Usage{"reversed-depth", "it reverses z: z = w - z",
          [](MatrixSetup& s) {
            for (int c = 0; c < 4; ++c) {
              s.projection.m[c].z = s.projection.m[c].w - s.projection.m[c].z;
            }
            return s.projection.given;
          }},
};

struct Vertices {
  std::span<const TableVertex> object, theirs;

  bool explained_by(const MatrixSetup& setup) const {
    const ClipFromObject clip(setup);
    for (std::size_t i = 0; i < object.size(); ++i) {
      if (!agree(clip.position(object[i]), theirs[i].position,
                 clip.tolerance(object[i], theirs[i]))) {
        return false;
      }
    }
    return true;
  }
};

std::vector<ClipExplanation> explanations_of(const MatrixSetup& setup, const Vertices& vertices) {
  std::vector<ClipExplanation> found;
  for (const Usage& usage : kUsages) {
    MatrixSetup used = setup;
    if (usage.apply(used) && vertices.explained_by(used)) found.push_back({usage.id, usage.text});
  }
  for (const ConventionMistake& mistake : convention_mistakes()) {
    MatrixSetup used = setup;
    if (!mistake.undo(used, {}) || !vertices.explained_by(used)) continue;
    found.push_back({mistake.id, std::string("its matrices are these after you ") + mistake.what});
  }
  return found;
}

// ---- the program's own matrix ----

// The matrix with clip = matrix * object, by least squares over all vertices; nothing if the
// vertices do not determine it.
std::optional<glm::dmat4> fitted_matrix(const Vertices& v) {
  if (v.object.size() < 5) return std::nullopt;
  glm::dmat4 normal(0), mixed(0);
  for (std::size_t i = 0; i < v.object.size(); ++i) {
    normal += glm::outerProduct(v.object[i].position, v.object[i].position);
    mixed += glm::outerProduct(v.theirs[i].position, v.object[i].position);
  }
  // Normal equations square the condition: beyond 2^20 the digits of a float are lost.
  const double trace = normal[0][0] + normal[1][1] + normal[2][2] + normal[3][3];
  const glm::dmat4 inverse = glm::inverse(normal);
  double largest = 0;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) largest = std::max(largest, std::abs(inverse[column][row]));
  }
  if (!(largest * trace < 0x1p40)) return std::nullopt;
  return mixed * inverse;
}

std::optional<glm::dmat4> matrix_of_program(const Vertices& v) {
  const auto fitted = fitted_matrix(v);
  if (!fitted) return std::nullopt;
  MatrixSetup setup;
  setup.projection.m = *fitted;
  setup.projection.given = true;
  // The fit inherits the uncertainty of the printed positions.
  for (std::size_t i = 0; i < v.object.size(); ++i) {
    const ClipFromObject clip(setup);
    const glm::dvec4 tolerance = 4.0 * clip.tolerance(v.object[i], v.theirs[i]);
    if (!agree(clip.position(v.object[i]), v.theirs[i].position, tolerance)) return std::nullopt;
  }
  return fitted;
}

}  // namespace

ClipComparison compare_clip_positions(const MatrixSetup& setup, std::span<const TableVertex> object,
                                      std::span<const TableVertex> theirs) {
  ClipComparison found;
  found.compared = object.size();
  const ClipFromObject clip(setup);
  for (std::size_t i = 0; i < object.size(); ++i) {
    const glm::dvec4 ours = clip.position(object[i]);
    const glm::dvec4 tolerance = clip.tolerance(object[i], theirs[i]);
    if (agree(ours, theirs[i].position, tolerance)) continue;
    if (found.different++ == 0) found.first = {i, ours, theirs[i].position, tolerance};
  }
  if (found.different == 0) return found;
  const Vertices vertices{object, theirs};
  found.explanations = explanations_of(setup, vertices);
  if (found.explanations.empty()) found.clip_from_object = matrix_of_program(vertices);
  return found;
}

}  // namespace glassbox
