#include <glassbox/render/stereo/window_violations.h>

#include <algorithm>
#include <map>
#include <tuple>

#include <glassbox/mesh/triangulate.h>

namespace glassbox {
namespace {

// Returns for each instance the number that follows its last triangle's.
std::vector<std::uint64_t> ends_of_instances(const Scene& scene) {
  std::vector<std::uint64_t> of_mesh;
  for (const Mesh& mesh : scene.meshes) {
    std::uint64_t count = 0;
    for (const Face& face : mesh.faces) count += triangle_number_count(face);
    of_mesh.push_back(count);
  }
  std::vector<std::uint64_t> ends;
  std::uint64_t end = 0;
  for (const Instance& instance : scene.instances) ends.push_back(end += of_mesh[instance.mesh]);
  return ends;
}

class PieceFinder {
public:
  PieceFinder(const std::vector<std::uint64_t>& instance_ends, Side side, const EyeBuffers& eye,
              double limit_px)
      : ends_(instance_ends),
        side_(side),
        eye_(eye),
        limit_px_(limit_px),
        marks_(eye.disparity.width, eye.disparity.height, 0) {}

  // Finds the connected regions of pixels in front of the window that touch the left or right edge
  // of the picture.
  std::vector<WindowViolation> find() {
    std::vector<WindowViolation> found;
    const int last = marks_.width - 1;
    for (int y = 0; y < marks_.height; ++y) {
      for (const int x : {0, last}) {
        if (stands_out(x, y) && marks_.at(x, y) == 0) found.push_back(piece_from(x, y));
      }
    }
    return found;
  }

  Image<std::uint8_t> marks() && { return std::move(marks_); }

private:
  bool stands_out(int x, int y) const {
    return double(eye_.disparity.at(x, y)) < -limit_px_;  // false for NaN (nothing drawn)
  }

  void visit(int x, int y) {
    if (x < 0 || y < 0 || x >= marks_.width || y >= marks_.height) return;
    if (marks_.at(x, y) != 0 || !stands_out(x, y)) return;
    marks_.at(x, y) = 1;
    waiting_.emplace_back(x, y);
  }

  void add_edge_pixel(int x, int y, WindowViolation& piece,
                      std::map<std::uint32_t, CutInstance>& cut) const {
    const double px = double(eye_.disparity.at(x, y));
    const double distance = double(eye_.buffers.distance.at(x, y));
    piece.left_edge |= x == 0;
    piece.right_edge |= x == marks_.width - 1;
    if (piece.rows == 0 || px < piece.least_px) {
      piece.least_px = px;
      piece.nearest = distance;
    }
    ++piece.rows;
    const std::uint32_t id = eye_.buffers.id.at(x, y);
    if (id == 0) return;
    const auto instance = std::uint32_t(
        std::upper_bound(ends_.begin(), ends_.end(), std::uint64_t(id - 1)) - ends_.begin());
    CutInstance& one = cut.try_emplace(instance, CutInstance{instance, 0, px}).first->second;
    ++one.rows;
    one.least_px = std::min(one.least_px, px);
  }

  WindowViolation piece_from(int from_x, int from_y) {
    WindowViolation piece;
    piece.eye = side_;
    piece.x0 = from_x;
    piece.y0 = from_y;
    std::map<std::uint32_t, CutInstance> cut;
    visit(from_x, from_y);
    while (!waiting_.empty()) {
      const auto [x, y] = waiting_.back();
      waiting_.pop_back();
      piece.x0 = std::min(piece.x0, x);
      piece.x1 = std::max(piece.x1, x + 1);
      piece.y0 = std::min(piece.y0, y);
      piece.y1 = std::max(piece.y1, y + 1);
      ++piece.pixels;
      if (x == 0 || x == marks_.width - 1) add_edge_pixel(x, y, piece, cut);
      visit(x - 1, y);
      visit(x + 1, y);
      visit(x, y - 1);
      visit(x, y + 1);
    }
    for (const auto& [number, instance] : cut) piece.instances.push_back(instance);
    std::ranges::stable_sort(piece.instances, [](const CutInstance& a, const CutInstance& b) {
      return a.rows > b.rows;
    });
    return piece;
  }

  const std::vector<std::uint64_t>& ends_;
  Side side_;
  const EyeBuffers& eye_;
  double limit_px_;
  Image<std::uint8_t> marks_;
  std::vector<std::pair<int, int>> waiting_;
};

}  // namespace

WindowViolations window_violations(const Scene& scene, const EyeBuffers& left,
                                   const EyeBuffers& right, double limit_px) {
  const std::vector<std::uint64_t> ends = ends_of_instances(scene);
  PieceFinder of_left(ends, Side::kLeft, left, limit_px);
  PieceFinder of_right(ends, Side::kRight, right, limit_px);
  WindowViolations all;
  all.found = of_left.find();
  for (WindowViolation& one : of_right.find()) all.found.push_back(std::move(one));
  std::ranges::stable_sort(all.found, [](const WindowViolation& a, const WindowViolation& b) {
    return a.rows > b.rows;
  });
  all.left = std::move(of_left).marks();
  all.right = std::move(of_right).marks();
  return all;
}

}  // namespace glassbox
