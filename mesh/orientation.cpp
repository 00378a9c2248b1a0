#include <glassbox/mesh/orientation.h>

#include <array>
#include <cmath>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/bounding_box.h>
#include <glassbox/mesh/normals.h>
#include <glassbox/mesh/topology.h>
#include <glassbox/mesh/triangulate.h>

namespace glassbox {
namespace {

using Arrow = Vector<Object, double>;

Arrow from(const Point<Object, double>& origin, const Point<Object>& p) {
  return Point<Object, double>(double(p.x), double(p.y), double(p.z)) - origin;
}

double length(const Arrow& v) {
  return std::sqrt(dot(v, v));
}

// The signed solid angle of a triangle, as a fraction of the whole sphere: positive if its corners
// run clockwise seen from the origin, so that it shows its back there.
double share_of_sphere(const Arrow& a, const Arrow& b, const Arrow& c) {
  const double la = length(a), lb = length(b), lc = length(c);
  const double volume = dot(a, cross(b, c));
  const double cosines = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
  if (volume == 0 && cosines == 0) return 0;
  return arctan2(volume, cosines) / (2 * kPi);
}

}  // namespace

std::optional<double> signed_volume(const Mesh& mesh) {
  const Topology topology = find_topology(mesh, Weld::kByCoordinates);
  if (!topology.closed() || topology.inconsistent_edges > 0) return std::nullopt;
  const Point<Object, double> middle = bounds(mesh).center();
  double volume = 0;
  for (const Face& face : mesh.faces) {
    if (face.count == 0) continue;
    const Point<Object>& corner = mesh.positions[mesh.corners[face.first].position];
    volume += dot(from(middle, corner), newell_vector(mesh, face)) / 6;
  }
  return volume;
}

double winding_number(const Mesh& mesh, const Point<Object, double>& point) {
  double sum = 0;
  for (const Triangle& triangle : triangulate(mesh).triangles) {
    std::array<Arrow, 3> to;
    for (std::size_t k = 0; k < 3; ++k) {
      to[k] = from(point, mesh.positions[mesh.corners[triangle.corners[k]].position]);
    }
    sum += share_of_sphere(to[0], to[1], to[2]);
  }
  return sum;
}

}  // namespace glassbox
