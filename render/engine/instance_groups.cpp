#include <glassbox/render/engine/instance_groups.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glassbox/base/rounding.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/prepared_scene.h>

namespace glassbox {

namespace {

using Vec3 = std::array<double, 3>;

// The extent of a mesh, from which the bounds of its instances are computed.
struct MeshExtent {
  Vec3 centre{}, half{};  // centre and half size of the box, object space
  Vec3 anchor{};
  Vec3 size{};  // by axis, the largest |coordinate - anchor|
  bool empty = true, finite = true;
};

MeshExtent extent_of(const PreparedMesh& mesh) {
  MeshExtent extent;
  extent.finite = mesh.all_finite;
  extent.empty = mesh.bounds.empty();
  if (extent.empty) return extent;
  const Vector<Object> a = anchor_for(mesh.bounds);
  const Vec3 low{mesh.bounds.low.x, mesh.bounds.low.y, mesh.bounds.low.z};
  const Vec3 high{mesh.bounds.high.x, mesh.bounds.high.y, mesh.bounds.high.z};
  extent.anchor = {double(a.x), double(a.y), double(a.z)};
  for (std::size_t k = 0; k < 3; ++k) {
    extent.centre[k] = low[k] * 0.5 + high[k] * 0.5;
    extent.half[k] = high[k] * 0.5 - low[k] * 0.5;
    extent.size[k] =
        std::max(std::abs(low[k] - extent.anchor[k]), std::abs(high[k] - extent.anchor[k]));
  }
  return extent;
}

// Makes a group of one instance. Each of its numbers is a sum of at most eight products of doubles.
// To be an upper bound in spite of rounding, it is increased by gamma(16) times the sum of the
// absolute values of its terms. (gamma(n) = n u / (1 - n u), u is the unit roundoff.)
InstanceGroup group_of_one(const Transform<World, Object>& world_from_object,
                           const MeshExtent& extent) {
  constexpr double kUp = 1 + gamma<double>(16);
  InstanceGroup one;
  one.all_finite = extent.finite;
  if (extent.empty) return one;
  const auto at = [&](std::size_t row, std::size_t k) {
    return world_from_object.at(int(row), int(k));
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const double length =
        std::sqrt(at(0, k) * at(0, k) + at(1, k) * at(1, k) + at(2, k) * at(2, k)) * kUp;
    one.column = std::max(one.column, length);
    one.reach += length * extent.size[k] * kUp;
    one.sizes += extent.size[k] * kUp;
  }
  Vec3 centre{}, half{};
  for (std::size_t row = 0; row < 3; ++row) {
    double terms = std::abs(at(row, 3));
    centre[row] = at(row, 3);
    for (std::size_t k = 0; k < 3; ++k) {
      centre[row] += at(row, k) * extent.centre[k];
      half[row] += std::abs(at(row, k)) * extent.half[k];
      terms += std::abs(at(row, k)) * (std::abs(extent.anchor[k]) + extent.size[k]);
    }
    one.far = std::max(one.far, terms * kUp);
    half[row] += gamma<double>(16) * terms;
  }
  one.box.low = {centre[0] - half[0], centre[1] - half[1], centre[2] - half[2]};
  one.box.high = {centre[0] + half[0], centre[1] + half[1], centre[2] + half[2]};
  one.all_finite = one.all_finite && std::isfinite(one.far) && std::isfinite(one.reach);
  return one;
}

void extend_group(const InstanceGroup& one, InstanceGroup& group) {
  group.box.include(one.box);
  group.all_finite = group.all_finite && one.all_finite;
  group.reach = std::max(group.reach, one.reach);
  group.sizes = std::max(group.sizes, one.sizes);
  group.column = std::max(group.column, one.column);
  group.far = std::max(group.far, one.far);
}

// Moves bit i of a coordinate to bit 3 i, so that the bits of three coordinates can alternate.
std::uint64_t spread(std::uint64_t bits) {
  std::uint64_t wide = 0;
  for (int i = 0; i < 16; ++i) wide |= ((bits >> i) & 1) << (3 * i);
  return wide;
}

// Returns the position of a point along the curve that visits one octant of a cube after the other
// (Morton 1966).
std::uint64_t place_on_curve(const Box<World>& cube, double side, const Point<World, double>& p) {
  const auto cell = [&](double x, double low) {
    return std::uint64_t(std::clamp((x - low) / side * 65535.0, 0.0, 65535.0));
  };
  return spread(cell(p.x, cube.low.x)) | spread(cell(p.y, cube.low.y)) << 1 |
         spread(cell(p.z, cube.low.z)) << 2;
}

}  // namespace

InstanceGroups make_instance_groups(const Scene& scene, const std::vector<PreparedMesh>& meshes) {
  InstanceGroups made;
  std::vector<MeshExtent> extents;
  extents.reserve(meshes.size());
  for (const PreparedMesh& mesh : meshes) extents.push_back(extent_of(mesh));
  std::vector<InstanceGroup> ones;
  ones.reserve(scene.instances.size());
  Box<World> all;
  for (const Instance& instance : scene.instances) {
    ones.push_back(
        group_of_one(scene.nodes[instance.node].world_from_node, extents[instance.mesh]));
    if (ones.back().all_finite) all.include(ones.back().box);
  }
  const double side =
      std::max({all.high.x - all.low.x, all.high.y - all.low.y, all.high.z - all.low.z, 0x1p-1000});

  std::vector<std::pair<std::uint64_t, std::uint32_t>> along_curve;
  along_curve.reserve(ones.size());
  for (std::uint32_t i = 0; i < ones.size(); ++i) {
    const bool somewhere = ones[i].all_finite && !ones[i].box.empty();
    along_curve.emplace_back(somewhere ? place_on_curve(all, side, ones[i].box.center()) : 0, i);
  }
  std::ranges::sort(along_curve);
  made.of_instance.resize(ones.size());
  for (std::size_t at = 0; at < along_curve.size(); ++at) {
    if (at % kGroupInstances == 0) made.groups.emplace_back();
    extend_group(ones[along_curve[at].second], made.groups.back());
    made.of_instance[along_curve[at].second] = std::uint32_t(at / kGroupInstances);
  }
  return made;
}

}  // namespace glassbox
