#include <glassbox/mesh/obj/smoothing.h>

#include <algorithm>
#include <span>
#include <tuple>

#include <glassbox/mesh/normals.h>

namespace glassbox::obj {
namespace {

// A corner of a face in a smoothing group. Corners with the same vertex and group share a normal.
struct GroupCorner {
  std::uint32_t position, group;
  std::uint32_t reference;  // in Tables::references
  std::uint32_t face;       // in the list of Newell vectors
};

Vector<Object, double> newell_vector_of(const Tables& tables, const Element& face) {
  std::vector<Point<Object, double>> outline;
  for (std::uint32_t i = 0; i < face.count; ++i) {
    const Point<Object>& p = tables.positions[tables.references[face.first + i].position];
    outline.emplace_back(p.x, p.y, p.z);
  }
  return newell_vector<double>(std::span<const Point<Object, double>>(outline));
}

}  // namespace

void add_group_normals(Tables& tables) {
  if (!tables.normals.empty()) return;
  std::vector<Vector<Object, double>> newell_vectors;
  std::vector<GroupCorner> corners;
  for (const Element& element : tables.elements) {
    if (element.kind != ElementKind::kFace || element.smoothing_group == 0) continue;
    for (std::uint32_t i = element.first; i < element.first + element.count; ++i) {
      corners.push_back({tables.references[i].position, element.smoothing_group, i,
                         std::uint32_t(newell_vectors.size())});
    }
    newell_vectors.push_back(newell_vector_of(tables, element));
  }
  // Sorted also by their places in the file, so that each sum has one order.
  std::sort(corners.begin(), corners.end(), [](const GroupCorner& a, const GroupCorner& b) {
    return std::tie(a.position, a.group, a.reference) < std::tie(b.position, b.group, b.reference);
  });
  for (std::size_t begin = 0, end = 0; begin < corners.size(); begin = end) {
    Vector<Object, double> sum(0, 0, 0);
    for (; end < corners.size() && corners[end].position == corners[begin].position &&
           corners[end].group == corners[begin].group;
         ++end) {
      sum = sum + newell_vectors[corners[end].face];
    }
    const auto normal = unit_normal(sum);
    if (!normal) continue;
    for (std::size_t i = begin; i < end; ++i) {
      tables.references[corners[i].reference].normal = std::uint32_t(tables.normals.size());
    }
    tables.normals.push_back(*normal);
  }
}

}  // namespace glassbox::obj
