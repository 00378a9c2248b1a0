#include <glassbox/mesh/normal_check.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/mesh/topology.h>

namespace glassbox {
namespace {

// A corner's normal, and the mean normal of the faces that meet at its position, of any length.
struct Pair {
  glm::dvec3 normal{0}, faces{0};
};

std::vector<Pair> pairs_of(const Mesh& mesh, NormalReport& report) {
  const auto vertex_of = find_topology(mesh, Weld::kByCoordinates).vertex_of_position;
  std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> vertices;  // by pair
  for (const Face& face : mesh.faces) {
    const glm::dvec3 own = to_glm(newell_vector(mesh, face));
    if (own == glm::dvec3(0)) continue;
    for (std::uint32_t i = face.first; i < face.first + face.count; ++i) {
      const Corner& corner = mesh.corners[i];
      sums[vertex_of[corner.position]] += own;
      if (corner.normal == kNone) continue;
      const glm::dvec3 normal(to_glm(mesh.normals[corner.normal]));
      report.against_faces += glm::dot(normal, own) < 0;
      pairs.push_back({normal, glm::dvec3(0)});
      vertices.push_back(vertex_of[corner.position]);
    }
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].faces = sums[vertices[i]];
  report.corners = std::uint32_t(pairs.size());
  return pairs;
}

double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return degrees_from_radians(arctan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

// The mean angle between the faces' normals and the corners' normals times `factors`.
double mean_degrees_off(const std::vector<Pair>& pairs, const glm::dvec3& factors) {
  double sum = 0;
  for (const Pair& pair : pairs) sum += degrees_between(factors * pair.normal, pair.faces);
  return pairs.empty() ? 0 : sum / double(pairs.size());
}

// The factors d, of length 1, that make the normals as parallel to the faces' normals as possible:
// they minimise the sum of |f x (d n)|^2, a quadratic form in d. Its matrix's eigenvector of the
// smallest eigenvalue is found by inverse iteration.
glm::dvec3 best_factors(const std::vector<Pair>& pairs) {
  glm::dmat3 form(0);
  for (const Pair& pair : pairs) {
    const double length = glm::length(pair.faces);
    if (length == 0) continue;
    const glm::dvec3 f = pair.faces / length, n = pair.normal;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        form[i][j] += ((i == j ? 1 : 0) - f[i] * f[j]) * n[i] * n[j];
      }
    }
  }
  const double size = form[0][0] + form[1][1] + form[2][2];
  const glm::dmat3 inverse = glm::inverse(form + glm::dmat3(1e-9 * size + 1e-30));
  glm::dvec3 factors(1);
  for (int i = 0; i < 50; ++i) factors = glm::normalize(inverse * factors);
  return factors;
}

// The scale that explains the factors: a normal that was multiplied by s and not by 1/s is mended
// by 1/s^2.
std::optional<glm::dvec3> scale_of(const glm::dvec3& factors) {
  if (!(factors.x > 0 && factors.y > 0 && factors.z > 0)) return std::nullopt;
  const glm::dvec3 scale(1 / std::sqrt(factors.x), 1 / std::sqrt(factors.y),
                         1 / std::sqrt(factors.z));
  return scale / std::min({scale.x, scale.y, scale.z});
}

}  // namespace

NormalReport normal_report(const Mesh& mesh) {
  // Smoothed normals differ from those of the faces by a few degrees, and the mend of a wrong scale
  // has to leave much less than there was.
  constexpr double kFew = 4, kMuchLess = 0.4, kClearScale = 1.1;
  NormalReport report;
  if (mesh.normals.empty()) return report;
  const std::vector<Pair> pairs = pairs_of(mesh, report);
  report.degrees_off = mean_degrees_off(pairs, glm::dvec3(1));
  if (report.inverted() || report.degrees_off < kFew) return report;
  const glm::dvec3 factors = best_factors(pairs);
  const auto scale = scale_of(factors);
  if (!scale || std::max({scale->x, scale->y, scale->z}) < kClearScale) return report;
  if (mean_degrees_off(pairs, factors) > kMuchLess * report.degrees_off) return report;
  report.scaled_by = scale;
  return report;
}

}  // namespace glassbox
