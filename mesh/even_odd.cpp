#include <glassbox/mesh/even_odd.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace glassbox {
namespace {

// The corners of an outline at one place are one vertex, which has the number of the first of them.
using Vertex = std::uint32_t;

bool is_before(const FlatPoint& a, const FlatPoint& b) {
  return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

// Whether p, which is on the line through a and b, is strictly between them.
bool is_between(const FlatPoint& p, const FlatPoint& a, const FlatPoint& b) {
  return is_before(a, p) == is_before(p, b) && p != a && p != b;
}

std::vector<Vertex> find_vertices(std::span<const FlatPoint> points) {
  std::vector<Vertex> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](Vertex a, Vertex b) { return is_before(points[a], points[b]); });
  std::vector<Vertex> vertex_of(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && points[order[i]] == points[order[i - 1]];
    vertex_of[order[i]] = same ? vertex_of[order[i - 1]] : order[i];
  }
  return vertex_of;
}

// ---- which edges meet ----

// A vertex that lies on an edge, between its ends. Edge i goes from corner i to the next one.
struct Split {
  std::uint32_t edge;
  Vertex vertex;
};

struct Meetings {
  bool examined = true;
  bool crossing = false;
  std::vector<Split> splits;
};

class MeetingFinder {
public:
  explicit MeetingFinder(std::span<const FlatPoint> points)
      : points_(points), budget_((std::int64_t(1) << 27) + (std::int64_t(points.size()) << 10)) {}

  // Compares all edges whose boxes meet. The edges are sorted by the lower end of their boxes along
  // the axis on which the boxes are shorter altogether.
  Meetings run() {
    std::vector<Box> boxes;
    double width = 0, height = 0;
    for (std::uint32_t i = 0; i < points_.size(); ++i) {
      const FlatPoint &a = points_[i], &b = points_[after(i)];
      if (a == b) continue;
      boxes.push_back(
          {i, std::min(a.x, b.x), std::max(a.x, b.x), std::min(a.y, b.y), std::max(a.y, b.y)});
      width += double(boxes.back().right) - boxes.back().left;
      height += double(boxes.back().top) - boxes.back().bottom;
    }
    if (height < width) {
      for (Box& box : boxes) {
        std::swap(box.left, box.bottom);
        std::swap(box.right, box.top);
      }
    }
    std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) {
      return std::tie(a.left, a.edge) < std::tie(b.left, b.edge);
    });
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = i + 1; j < boxes.size() && boxes[j].left <= boxes[i].right; ++j) {
        if (--budget_ < 0) return {false, false, {}};
        if (boxes[j].bottom > boxes[i].top || boxes[j].top < boxes[i].bottom) continue;
        compare(boxes[i].edge, boxes[j].edge);
        if (found_.crossing) return std::move(found_);
      }
    }
    return std::move(found_);
  }

private:
  struct Box {
    std::uint32_t edge;
    float left, right, bottom, top;
  };

  std::uint32_t after(std::uint32_t corner) const {
    return corner + 1 == points_.size() ? 0 : corner + 1;
  }

  void compare(std::uint32_t e, std::uint32_t f) {
    const FlatPoint &a = points_[e], &b = points_[after(e)], &c = points_[f],
                    &d = points_[after(f)];
    const int c_side = orientation(a, b, c), d_side = orientation(a, b, d);
    if (c_side * d_side > 0) return;
    const int a_side = orientation(c, d, a), b_side = orientation(c, d, b);
    if (c_side * d_side < 0 && a_side * b_side < 0) found_.crossing = true;
    if (c_side == 0 && is_between(c, a, b)) add_split(e, f);
    if (d_side == 0 && is_between(d, a, b)) add_split(e, after(f));
    if (a_side == 0 && is_between(a, c, d)) add_split(f, e);
    if (b_side == 0 && is_between(b, c, d)) add_split(f, after(e));
  }

  // A split takes memory, and time for exact arithmetic, so it counts more than a comparison.
  void add_split(std::uint32_t edge, std::uint32_t corner) {
    budget_ -= 512;
    found_.splits.push_back({edge, corner});
  }

  std::span<const FlatPoint> points_;
  std::int64_t budget_;
  Meetings found_;
};

// ---- the parts of the plane between the edges ----

// The outline as a graph in the plane: edges end where a vertex lies on them, and edges between the
// same two vertices are one edge. The graph is connected, so each part of the plane between its
// edges has a border of one closed walk, with the part on its left.
class PlaneGraph {
public:
  PlaneGraph(std::span<const FlatPoint> points, const std::vector<Vertex>& vertex_of,
             std::vector<Split> splits)
      : points_(points), vertex_of_(vertex_of) {
    for (Split& split : splits) split.vertex = vertex_of[split.vertex];
    add_passages(std::move(splits));
    add_half_edges();
    sort_around_vertices();
    find_walks();
  }

  // The walks around the parts that are inside by even-odd.
  std::vector<std::vector<std::uint32_t>> inside_rings() const {
    const std::vector<bool> inside = inside_walks();
    std::vector<std::vector<std::uint32_t>> rings;
    for (std::size_t walk = 0; walk < walk_begins_.size(); ++walk) {
      if (inside[walk]) rings.push_back(ring_along(walk_begins_[walk]));
    }
    return rings;
  }

private:
  // The outline's way along one edge of the graph, with its corners there.
  struct Passage {
    Vertex low, high;
    bool ascending;  // from `low` to `high`
    std::uint32_t from, to;
  };
  // One side of an edge: the side on the left when it is walked from `from` to `to` (corners).
  // The two sides of an edge have the indices 2 i and 2 i + 1.
  struct HalfEdge {
    std::uint32_t from, to;
    bool border;                  // the outline passes the edge an odd number of times
    std::uint32_t next = kUnset;  // along the border of the part on the left
    std::uint32_t walk = kUnset;
  };
  static constexpr std::uint32_t kUnset = std::numeric_limits<std::uint32_t>::max();

  const FlatPoint& start(std::uint32_t half_edge) const {
    return points_[half_edges_[half_edge].from];
  }
  const FlatPoint& end(std::uint32_t half_edge) const { return points_[half_edges_[half_edge].to]; }

  void add_passages(std::vector<Split> splits) {
    std::sort(splits.begin(), splits.end(), [&](const Split& a, const Split& b) {
      if (a.edge != b.edge) return a.edge < b.edge;
      if (a.vertex == b.vertex) return false;
      const bool ascending = is_before(points_[a.edge], points_[after(a.edge)]);
      return is_before(points_[a.vertex], points_[b.vertex]) == ascending;
    });
    auto split = splits.begin();
    on_an_edge_.assign(points_.size(), false);
    for (std::uint32_t edge = 0; edge < points_.size(); ++edge) {
      std::uint32_t from = edge;
      for (; split != splits.end() && split->edge == edge; ++split) {
        on_an_edge_[split->vertex] = true;
        add_passage(from, split->vertex);
        from = split->vertex;
      }
      add_passage(from, after(edge));
    }
  }

  void add_passage(std::uint32_t from, std::uint32_t to) {
    const Vertex a = vertex_of_[from], b = vertex_of_[to];
    if (a == b) return;
    passages_.push_back({std::min(a, b), std::max(a, b), a < b, from, to});
  }

  std::uint32_t after(std::uint32_t corner) const {
    return corner + 1 == points_.size() ? 0 : corner + 1;
  }

  void add_half_edges() {
    std::stable_sort(passages_.begin(), passages_.end(), [](const Passage& a, const Passage& b) {
      return std::tie(a.low, a.high) < std::tie(b.low, b.high);
    });
    for (std::size_t begin = 0, stop = 0; begin < passages_.size(); begin = stop) {
      const Passage& first = passages_[begin];
      // Each side takes the corners of a passage in its direction if there is one, because corners
      // at one place may differ in their colours or texture coordinates.
      std::array<const Passage*, 2> along = {&first, &first};
      for (; stop < passages_.size() && passages_[stop].low == first.low &&
             passages_[stop].high == first.high;
           ++stop) {
        along[passages_[stop].ascending ? 0 : 1] = &passages_[stop];
      }
      const bool border = (stop - begin) % 2 == 1;
      const auto [up, down] = along;
      half_edges_.push_back(
          {up->ascending ? up->from : up->to, up->ascending ? up->to : up->from, border});
      half_edges_.push_back({down->ascending ? down->to : down->from,
                             down->ascending ? down->from : down->to, border});
    }
  }

  // Sorts the half edges by the vertex from which they go, and around it by their direction,
  // counter-clockwise from the positive x axis. Then each half edge is followed by the first one
  // clockwise from the way back.
  void sort_around_vertices() {
    std::vector<std::uint32_t> order(half_edges_.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto vertex = [&](std::uint32_t h) { return vertex_of_[half_edges_[h].from]; };
    const auto is_downward = [&](std::uint32_t h) {
      return std::pair(end(h).y, end(h).x) < std::pair(start(h).y, start(h).x);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      if (vertex(a) != vertex(b)) return vertex(a) < vertex(b);
      if (is_downward(a) != is_downward(b)) return is_downward(b);
      return orientation(start(a), end(a), end(b)) > 0;
    });
    Vertex lowest = vertex(order[0]);
    for (std::size_t begin = 0, stop = 0; begin < order.size(); begin = stop) {
      while (stop < order.size() && vertex(order[stop]) == vertex(order[begin])) ++stop;
      for (std::size_t i = begin; i < stop; ++i) {
        half_edges_[order[i] ^ 1].next = order[i == begin ? stop - 1 : i - 1];
      }
      const FlatPoint &here = start(order[begin]), &least = points_[lowest];
      if (std::pair(here.y, here.x) <= std::pair(least.y, least.x)) {
        lowest = vertex(order[begin]);
        // All edges of the lowest vertex go up, so the last of them has the outside on its left.
        outermost_ = order[stop - 1];
      }
    }
  }

  void find_walks() {
    for (std::uint32_t first = 0; first < half_edges_.size(); ++first) {
      if (half_edges_[first].walk != kUnset) continue;
      const auto number = std::uint32_t(walk_begins_.size());
      walk_begins_.push_back(first);
      for (std::uint32_t h = first; half_edges_[h].walk == kUnset; h = half_edges_[h].next) {
        half_edges_[h].walk = number;
      }
    }
  }

  // Goes from the outside from part to part. A border is between inside and outside, any other edge
  // is not.
  std::vector<bool> inside_walks() const {
    std::vector<bool> inside(walk_begins_.size(), false), reached(walk_begins_.size(), false);
    std::vector<std::uint32_t> left = {half_edges_[outermost_].walk};
    reached[left[0]] = true;
    while (!left.empty()) {
      const std::uint32_t walk = left.back();
      left.pop_back();
      std::uint32_t h = walk_begins_[walk];
      do {
        const std::uint32_t other = half_edges_[h ^ 1].walk;
        if (!reached[other]) {
          reached[other] = true;
          inside[other] = inside[walk] != half_edges_[h].border;
          left.push_back(other);
        }
        h = half_edges_[h].next;
      } while (h != walk_begins_[walk]);
    }
    return inside;
  }

  // The corners along a walk. A straight corner is left out at a vertex that lies on another edge:
  // it may be there only because the edge was divided.
  std::vector<std::uint32_t> ring_along(std::uint32_t first) const {
    std::vector<std::uint32_t> ring;
    std::uint32_t h = first;
    do {
      const std::uint32_t next = half_edges_[h].next;
      const bool straight = next != (h ^ 1) && orientation(start(h), end(h), end(next)) == 0;
      if (!straight || !on_an_edge_[vertex_of_[half_edges_[h].to]]) {
        ring.push_back(half_edges_[h].to);
      }
      h = next;
    } while (h != first);
    return ring;
  }

  std::span<const FlatPoint> points_;
  const std::vector<Vertex>& vertex_of_;
  std::vector<bool> on_an_edge_;  // by vertex: whether it lies between the ends of an edge
  std::vector<Passage> passages_;
  std::vector<HalfEdge> half_edges_;
  std::uint32_t outermost_ = 0;
  std::vector<std::uint32_t> walk_begins_;  // a half edge of each walk
};

}  // namespace

EvenOdd find_even_odd(std::span<const FlatPoint> outline) {
  Meetings meetings = MeetingFinder(outline).run();
  if (!meetings.examined) return {};
  if (meetings.crossing) return {Meeting::kCross, {}};
  const std::vector<Vertex> vertex_of = find_vertices(outline);
  bool repeats = false;
  for (Vertex i = 0; i < vertex_of.size(); ++i) repeats = repeats || vertex_of[i] != i;
  if (!repeats && meetings.splits.empty()) return {};

  EvenOdd result{Meeting::kTouch,
                 PlaneGraph(outline, vertex_of, std::move(meetings.splits)).inside_rings()};
  // Rings that need more triangles than n - 2 come only from an outline that crosses itself where
  // one of the two edges has no corner (a loop that begins in the middle of an edge).
  std::size_t triangles = 0;
  for (const auto& ring : result.rings) triangles += ring.size() - 2;
  if (triangles > outline.size() - 2) return {Meeting::kCross, {}};
  return result;
}

}  // namespace glassbox
