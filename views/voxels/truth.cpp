#include "views/voxels/truth.h"

#include <algorithm>
#include <cmath>

#include <glassbox/base/elementary.h>
#include <glassbox/render/renderer.h>

namespace glassbox::views {

namespace {

struct Crossing {
  double z;
  int winding;
};

// Calls each(a, b, c) with the corners of every triangle, in grid coordinates.
template <class Each>
void for_each_triangle(const Scene& scene, const VoxelGrid& grid, const Each& each) {
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const auto& world_from_object = scene.nodes[instance.node].world_from_node;
    std::vector<Vector3d> points;
    for (const Point<Object>& p : mesh.positions) {
      const auto world =
          world_from_object * Point<Object, double>(double(p.x), double(p.y), double(p.z));
      points.push_back(grid.coordinates({world.x, world.y, world.z}));
    }
    for (const Face& face : mesh.faces) {
      for (std::uint32_t i = 2; i < face.count; ++i) {
        const auto at = [&](std::uint32_t corner) {
          return points[mesh.corners[face.first + corner].position];
        };
        each(at(0), at(i - 1), at(i));
      }
    }
  }
}

// The lines that are intersected with the triangles pass the voxels' centres at a slight distance.
// Exactly through the centres, they would often meet an edge in scenes whose corners have few
// digits. The distances are numbers that such corners cannot have. A line that meets an edge
// nevertheless counts it once too often or not at all.
constexpr double kLineOffsetX = 0x1.6a09e6p-22, kLineOffsetY = 0x1.bb67aep-23;

class CrossingLists {
public:
  explicit CrossingLists(const VoxelGrid& grid)
      : count_(grid.count), crossings_(std::size_t(count_[0]) * std::size_t(count_[1])) {}

  void add_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const double area = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
    if (area == 0) return;
    const int x0 = first(std::min({a.x(), b.x(), c.x()}), 0),
              x1 = last(std::max({a.x(), b.x(), c.x()}), 0);
    const int y0 = first(std::min({a.y(), b.y(), c.y()}), 1),
              y1 = last(std::max({a.y(), b.y(), c.y()}), 1);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const double px = x + 0.5 + kLineOffsetX, py = y + 0.5 + kLineOffsetY;
        const auto edge = [&](const Vector3d& p, const Vector3d& q) {
          return ((q.x() - p.x()) * (py - p.y()) - (q.y() - p.y()) * (px - p.x())) / area;
        };
        const double u = edge(b, c), v = edge(c, a), w = edge(a, b);
        if (u < 0 || v < 0 || w < 0) continue;
        const double z = (u * a.z() + v * b.z() + w * c.z()) / (u + v + w);
        at(x, y).push_back({z, area > 0 ? 1 : -1});
      }
    }
  }

  std::vector<Crossing>& at(int x, int y) {
    return crossings_[std::size_t(y) * std::size_t(count_[0]) + std::size_t(x)];
  }

private:
  int first(double low, std::size_t axis) const {
    return int(std::clamp(std::floor(low - 0.5), 0.0, double(count_[axis])));
  }
  int last(double high, std::size_t axis) const {
    return int(std::clamp(std::ceil(high), -1.0, double(count_[axis] - 1)));
  }
  std::array<int, 3> count_;
  std::vector<std::vector<Crossing>> crossings_;
};

// Points sorted into cells of a few voxels, to find nearest neighbours.
class PointGrid {
public:
  explicit PointGrid(const std::vector<Vector3d>& points) : points_(points) {
    low_ = Vector3d::Constant(INFINITY);
    Vector3d high = -low_;
    for (const Vector3d& p : points) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    if (points.empty()) return;
    // About one point for each cell: otherwise few points far apart would be searched for in many
    // empty cells.
    const Vector3d room = high - low_ + Vector3d::Constant(1);
    cell_ = std::max(cell_, cube_root(room.prod() / double(points.size())));
    for (int axis = 0; axis < 3; ++axis)
      count_[std::size_t(axis)] = int((high[axis] - low_[axis]) / cell_) + 1;
    begin_.assign(std::size_t(count_[0]) * std::size_t(count_[1]) * std::size_t(count_[2]) + 1, 0);
    for (const Vector3d& p : points) ++begin_[index(cell(p)) + 1];
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    order_.resize(points.size());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      order_[next[index(cell(points[i]))]++] = std::uint32_t(i);
  }

  // Searches cubes of cells of growing radius, until no remaining cell can contain a nearer point.
  double distance(const Vector3d& p) const {
    if (points_.empty()) return INFINITY;
    const std::array<int, 3> middle = cell(p);
    double nearest = INFINITY;
    const int most = std::max({count_[0], count_[1], count_[2]});
    for (int radius = 0; radius <= most; ++radius) {
      visit_shell(middle, radius, [&](std::size_t c) {
        for (std::uint32_t i = begin_[c]; i < begin_[c + 1]; ++i)
          nearest = std::min(nearest, (points_[order_[i]] - p).squaredNorm());
      });
      // Points in cells that were not visited are at least this far from p. (If p is outside of all
      // cells, it is up to outside(p) away from the middle cell.)
      const double certain = radius * cell_ - outside(p);
      if (certain > 0 && nearest <= certain * certain) break;
    }
    return std::sqrt(nearest);
  }

private:
  double cell_ = 3;  // voxels

  std::array<int, 3> cell(const Vector3d& p) const {
    std::array<int, 3> at;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double along = (p[int(axis)] - low_[int(axis)]) / cell_;
      at[axis] = int(std::clamp(std::floor(along), 0.0, double(count_[axis] - 1)));
    }
    return at;
  }
  // How far p is outside of the cells' bounding box.
  double outside(const Vector3d& p) const {
    double most = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double high = low_[axis] + cell_ * count_[std::size_t(axis)];
      most = std::max({most, low_[axis] - p[axis], p[axis] - high});
    }
    return most;
  }
  std::size_t index(const std::array<int, 3>& at) const {
    return voxel_index(count_, {at[0], at[1], at[2]});
  }
  template <class Visit>
  void visit_shell(const std::array<int, 3>& middle, int radius, const Visit& visit) const {
    const auto from = [&](std::size_t axis) { return std::max(middle[axis] - radius, 0); };
    const auto to = [&](std::size_t axis) {
      return std::min(middle[axis] + radius, count_[axis] - 1);
    };
    for (int z = from(2); z <= to(2); ++z) {
      for (int y = from(1); y <= to(1); ++y) {
        const bool is_face = std::abs(z - middle[2]) == radius || std::abs(y - middle[1]) == radius;
        for (int x = from(0); x <= to(0); ++x) {
          if (is_face || std::abs(x - middle[0]) == radius) visit(index({x, y, z}));
        }
      }
    }
  }

  const std::vector<Vector3d>& points_;
  Vector3d low_;
  std::array<int, 3> count_{0, 0, 0};
  std::vector<std::uint32_t> begin_, order_;
};

}  // namespace

double TrueVolume::bytes_for(const VoxelGrid& grid) {
  // Most lines have two crossings.
  return double(grid.voxels()) / 8 + double(grid.count[0]) * grid.count[1] *
                                         (sizeof(std::vector<Crossing>) + 2 * sizeof(Crossing));
}

TrueVolume::TrueVolume(const Scene& scene, const VoxelGrid& grid)
    : count_(grid.count), bits_(std::size_t(grid.voxels() + 63) / 64, 0) {
  CrossingLists lines(grid);
  for_each_triangle(scene, grid, [&](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    lines.add_triangle(a, b, c);
  });
  for (int y = 0; y < count_[1]; ++y) {
    for (int x = 0; x < count_[0]; ++x) {
      std::vector<Crossing>& crossings = lines.at(x, y);
      std::ranges::sort(crossings, {}, &Crossing::z);
      int winding = 0;
      for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].winding;
        if (winding == 0) continue;
        const int from = int(std::clamp(std::ceil(crossings[i].z - 0.5), 0.0, double(count_[2])));
        const int to = int(std::clamp(std::ceil(crossings[i + 1].z - 0.5), 0.0, double(count_[2])));
        for (int z = from; z < to; ++z) {
          const std::size_t at = voxel_index(count_, {x, y, z});
          bits_[at / 64] |= std::uint64_t(1) << (at % 64);
          ++voxels_;
        }
      }
    }
  }
}

void Overlap::add(const VoxelRun& run) {
  for (int i = 0; i < run.count; ++i) add(run.at(i));
}

void Overlap::add(std::span<const VoxelRun> runs, std::span<const Verdict> verdicts) {
  std::size_t at = 0;
  for (const VoxelRun& run : runs) {
    for (int i = 0; i < run.count; ++i, ++at) {
      const Verdict verdict = verdicts[at];
      if (verdict == Verdict::kColored || verdict == Verdict::kHidden) add(run.at(i));
    }
  }
}

VisibleSurface visible_surface(const PictureSet& set, const std::vector<Image<float>>& distances,
                               const VoxelGrid& grid) {
  VisibleSurface surface;
  const double diagonal = grid.size * std::sqrt(3.0);
  std::size_t shown = 0;
  for (const Image<float>& image : distances)
    shown +=
        std::size_t(std::ranges::count_if(image.pixels, [](float d) { return std::isfinite(d); }));
  surface.in_one_picture.reserve(shown);
  surface.in_two_pictures.reserve(shown);
  for (std::size_t p = 0; p < set.pictures.size(); ++p) {
    const PinholeCamera& camera = set.pictures[p].camera;
    for (int y = 0; y < distances[p].height; ++y) {
      for (int x = 0; x < distances[p].width; ++x) {
        const double distance = double(distances[p].at(x, y));
        if (!std::isfinite(distance)) continue;
        const Vector3d ray = ray_through(camera.intrinsic, {x + 0.5, y + 0.5});
        const Vector3d world =
            camera.centre + camera.camera_from_world.transpose() * (distance * ray);
        const Vector3d point = grid.coordinates(world);
        bool is_in = true;
        for (int axis = 0; axis < 3; ++axis)
          is_in = is_in && point[axis] >= 0 && point[axis] <= grid.count[std::size_t(axis)];
        if (!is_in) continue;
        surface.in_one_picture.push_back(point);
        for (std::size_t q = 0; q < set.pictures.size(); ++q) {
          if (q == p) continue;
          const Vector3d there = project(set.pictures[q].camera, world);
          const auto column = std::floor(there.x()), row = std::floor(there.y());
          if (!(there.z() > 0) || !(column >= 0 && column < distances[q].width) ||
              !(row >= 0 && row < distances[q].height))
            continue;
          const double seen = double(distances[q].at(int(column), int(row)));
          if (std::abs(seen - there.z()) > diagonal) continue;
          surface.in_two_pictures.push_back(point);
          break;
        }
      }
    }
  }
  return surface;
}

Result<std::vector<Image<float>>> true_distances(const Scene& scene, const PictureSet& set) {
  std::vector<Image<float>> distances;
  RenderSettings settings;
  settings.want_distance = true;
  settings.shading = Shading::kUnlit;
  Renderer renderer(scene, settings.transfer);
  const WorldBox box = box_of(scene);
  for (const CalibratedPicture& picture : set.pictures) {
    const auto view = view_of(picture.camera, picture.color.width, picture.color.height, box);
    if (!view) return tl::unexpected(view.error());
    distances.push_back(renderer.render(*view, settings).buffers.distance);
  }
  return distances;
}

double surface_error_bytes(const PictureSet& set, double voxels) {
  // A distance for each pixel; the points that at least one picture sees and those that at least
  // two see; and the voxels' centres. For one of these sets of points at a time, three numbers for
  // each point say in which cell it is (PointGrid).
  constexpr double kPoint = sizeof(Vector3d), kCellNumbers = 3 * sizeof(std::uint32_t);
  const double points = object_pixels_of(set);
  return pixels_of(set) * sizeof(float) + 2 * points * kPoint + voxels * kPoint +
         std::max(points, voxels) * kCellNumbers;
}

SurfaceErrors surface_errors(const std::vector<ColoredVoxel>& voxels,
                             const VisibleSurface& surface) {
  SurfaceErrors errors;
  std::vector<Vector3d> centres;
  centres.reserve(voxels.size());
  for (const ColoredVoxel& voxel : voxels)
    centres.emplace_back(voxel.at.x + 0.5, voxel.at.y + 0.5, voxel.at.z + 0.5);
  const auto measure = [](const std::vector<Vector3d>& from, const std::vector<Vector3d>& to,
                          double& mean, double& most) {
    if (from.empty() || to.empty()) {
      mean = most = INFINITY;
      return;
    }
    const PointGrid points(to);
    for (const Vector3d& p : from) {
      const double distance = points.distance(p);
      mean += distance / double(from.size());
      most = std::max(most, distance);
    }
  };
  measure(centres, surface.in_one_picture, errors.to_truth_mean, errors.to_truth_most);
  measure(surface.in_two_pictures, centres, errors.from_truth_mean, errors.from_truth_most);
  return errors;
}

}  // namespace glassbox::views
