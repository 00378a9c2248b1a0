#include <glassbox/mesh/ear_clipping.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace glassbox {
namespace {

// A grid that finds the corners near a triangle without testing all of them. It has about as many
// cells as entries. The cell index of a coordinate never decreases as the coordinate grows
// (subtraction, multiplication and floor are monotone, rounding included), so every point in a
// triangle is in one of the cells of the triangle's box.
class Grid {
public:
  Grid(std::span<const FlatPoint> points, std::size_t entries) {
    FlatPoint high = points[0];
    low_ = points[0];
    for (const FlatPoint& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    side_ = std::clamp(int(std::sqrt(double(entries))), 1, 1024);
    scale_x_ = high.x > low_.x ? side_ / (double(high.x) - low_.x) : 0;
    scale_y_ = high.y > low_.y ? side_ / (double(high.y) - low_.y) : 0;
    cells_.resize(std::size_t(side_) * std::size_t(side_));
  }

  void insert(const FlatPoint& p, std::uint32_t index) {
    cell(column(p.x), row(p.y)).push_back(index);
  }

  std::uint64_t cells_in_box(const FlatPoint& low, const FlatPoint& high) const {
    return std::uint64_t(column(high.x) - column(low.x) + 1) *
           std::uint64_t(row(high.y) - row(low.y) + 1);
  }

  // Visits the points in the cells of a box until `visit` returns true; returns whether it did.
  template <class Visit>
  bool any_in_box(const FlatPoint& low, const FlatPoint& high, Visit visit) {
    const int left = column(low.x), right = column(high.x);
    const int top = row(high.y);
    for (int y = row(low.y); y <= top; ++y) {
      for (int x = left; x <= right; ++x) {
        for (const std::uint32_t index : cell(x, y)) {
          if (visit(index)) return true;
        }
      }
    }
    return false;
  }

private:
  int column(float x) const { return std::min(side_ - 1, int((double(x) - low_.x) * scale_x_)); }
  int row(float y) const { return std::min(side_ - 1, int((double(y) - low_.y) * scale_y_)); }
  std::vector<std::uint32_t>& cell(int x, int y) {
    return cells_[std::size_t(y) * std::size_t(side_) + std::size_t(x)];
  }

  FlatPoint low_;
  int side_ = 1;
  double scale_x_ = 0, scale_y_ = 0;
  std::vector<std::vector<std::uint32_t>> cells_;
};

enum class Inside { kClosed, kStrictly };

class EarClipper {
public:
  EarClipper(std::span<const FlatPoint> outline,
             const std::function<void(const std::array<std::uint32_t, 3>&)>& cut)
      : points_(outline),
        cut_(cut),
        left_(std::uint32_t(outline.size())),
        budget_(ear_budget(outline.size())),
        previous_(outline.size()),
        next_(outline.size()),
        turn_(outline.size()),
        in_grid_(outline.size(), false),
        removed_(outline.size(), false),
        ticket_(outline.size(), 0),
        grid_(outline, 1) {
    std::size_t blockers = 0;
    for (std::uint32_t i = 0; i < left_; ++i) {
      previous_[i] = i == 0 ? left_ - 1 : i - 1;
      next_[i] = i + 1 == left_ ? 0 : i + 1;
      turn_[i] = turn_at(i);
      blockers += turn_[i] <= 0;
    }
    grid_ = Grid(outline, blockers);
    for (std::uint32_t i = 0; i < left_; ++i) {
      remember_blocker(i);
      enqueue_corner(i);
    }
  }

  EarClipping run() {
    const std::int64_t budget = budget_;
    while (left_ > 3 && budget_ > 0) {
      if (const auto ear = next_ear()) {
        clip(*ear);
      } else if (const auto corner = first_without_area()) {
        clip(*corner);
      } else if (const auto loose = first_loose_ear()) {
        clip(*loose);
      } else {
        break;
      }
    }
    const std::int64_t test_count = budget - budget_;
    return {cut_fan(), test_count};
  }

private:
  struct QueuedCorner {
    std::uint32_t corner;
    // Counts the entries made for this corner. An entry with a smaller number than ticket_[corner]
    // is out of date.
    std::uint32_t ticket;
  };

  void enqueue_corner(std::uint32_t corner) { queue_.push_back({corner, ++ticket_[corner]}); }

  // Returns the next corner in the queue that is an ear. A corner that is not an ear is tested
  // again only after a neighbour has changed: in a simple outline nothing else can make it an ear.
  std::optional<std::uint32_t> next_ear() {
    while (queue_head_ < queue_.size() && budget_ > 0) {
      const QueuedCorner queued = queue_[queue_head_++];
      const std::uint32_t corner = queued.corner;
      if (removed_[corner] || queued.ticket != ticket_[corner]) continue;
      if (turn_[corner] > 0 && !blocked(corner, Inside::kClosed)) return corner;
    }
    return std::nullopt;
  }

  std::optional<std::uint32_t> first_without_area() {
    std::uint32_t corner = first_left();
    for (std::uint32_t step = 0; step < left_; ++step, corner = next_[corner]) {
      --budget_;
      if (turn_[corner] == 0) return corner;
    }
    return std::nullopt;
  }

  std::optional<std::uint32_t> first_loose_ear() {
    std::uint32_t corner = first_left();
    for (std::uint32_t step = 0; step < left_ && budget_ > 0; ++step, corner = next_[corner]) {
      if (turn_[corner] > 0 && !blocked(corner, Inside::kStrictly)) return corner;
    }
    return std::nullopt;
  }

  // The remaining corner of the ring with the lowest index. Corners are never added, so the search
  // need not start from 0 again.
  std::uint32_t first_left() {
    while (removed_[first_left_]) ++first_left_;
    return first_left_;
  }

  int turn_at(std::uint32_t corner) const {
    return orientation(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
  }

  // Whether another corner is inside the triangle that would be cut off at `corner`. Corners that
  // turn left are not tested: if any corner is inside, one that does not turn left is inside, too.
  // A corner at the same place as one of the triangle's own corners is ignored, because it may
  // touch the triangle from outside. Its edges can enter the triangle only if their other ends are
  // inside, and then those are found.
  bool blocked(std::uint32_t corner, Inside inside) {
    const FlatPoint &a = points_[previous_[corner]], &b = points_[corner],
                    &c = points_[next_[corner]];
    const FlatPoint low = {std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})};
    const FlatPoint high = {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})};
    budget_ -= std::int64_t(grid_.cells_in_box(low, high));
    const int least = inside == Inside::kClosed ? 0 : 1;
    return grid_.any_in_box(low, high, [&](std::uint32_t other) {
      --budget_;
      const FlatPoint& p = points_[other];
      if (removed_[other] || turn_[other] > 0 || p == a || p == b || p == c) return false;
      if (p.x < low.x || p.x > high.x || p.y < low.y || p.y > high.y) return false;
      return orientation(a, b, p) >= least && orientation(b, c, p) >= least &&
             orientation(c, a, p) >= least;
    });
  }

  void clip(std::uint32_t corner) {
    const std::uint32_t before = previous_[corner], after = next_[corner];
    cut_({before, corner, after});
    next_[before] = after;
    previous_[after] = before;
    removed_[corner] = true;
    --left_;
    for (const std::uint32_t neighbour : {before, after}) {
      turn_[neighbour] = turn_at(neighbour);
      remember_blocker(neighbour);
      enqueue_corner(neighbour);
    }
  }

  void remember_blocker(std::uint32_t corner) {
    if (turn_[corner] > 0 || in_grid_[corner]) return;
    in_grid_[corner] = true;
    grid_.insert(points_[corner], corner);
  }

  // Cuts what is left into a fan: the last triangle, or the rest of an outline that crosses itself.
  // Returns whether no triangle is clockwise.
  bool cut_fan() {
    const std::uint32_t first = first_left();
    bool none_clockwise = true;
    std::uint32_t second = next_[first];
    for (; left_ >= 3; --left_) {
      const std::uint32_t third = next_[second];
      none_clockwise =
          none_clockwise && orientation(points_[first], points_[second], points_[third]) >= 0;
      cut_({first, second, third});
      second = third;
    }
    return none_clockwise;
  }

  std::span<const FlatPoint> points_;
  const std::function<void(const std::array<std::uint32_t, 3>&)>& cut_;
  std::uint32_t left_;   // points still in the ring
  std::int64_t budget_;  // cells and corners that may still be tested
  std::vector<std::uint32_t> previous_, next_;
  std::vector<int> turn_;
  std::vector<bool> in_grid_, removed_;
  std::vector<std::uint32_t> ticket_;
  std::vector<QueuedCorner> queue_;
  std::size_t queue_head_ = 0;
  std::uint32_t first_left_ = 0;
  Grid grid_;
};

}  // namespace

EarClipping clip_ears(std::span<const FlatPoint> outline,
                      const std::function<void(const std::array<std::uint32_t, 3>&)>& cut) {
  return EarClipper(outline, cut).run();
}

}  // namespace glassbox
