// Outlines that touch themselves are filled by the even-odd rule.
#include <glassbox/mesh/even_odd.h>

#include <algorithm>
#include <map>

#include <glassbox/mesh/triangulate.h>

#include <glassbox/base/random.h>
#include "tests/mesh/outlines.h"
#include "tests/mesh/polygons.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

// ---- what is inside, computed without the graph that the library makes ----

// Twice the area inside an outline whose edges do not cross between corners. No corner lies between
// two neighbouring whole heights y and y + 1, so the edges there make trapezoids, whose area is the
// width at half the height.
Rational twice_even_odd_area(const Outline& outline) {
  std::map<std::int64_t, std::vector<Rational>> rows;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Int2 a = outline[i], b = outline[(i + 1) % outline.size()];
    if (a.y > b.y) std::swap(a, b);
    for (std::int64_t y = a.y; y < b.y; ++y) {
      rows[y].push_back(2 * a.x + Rational((2 * y + 1 - 2 * a.y) * (b.x - a.x), b.y - a.y));
    }
  }
  Rational area = 0;
  for (auto& [y, crossings] : rows) {
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i < crossings.size(); i += 2) area += crossings[i + 1] - crossings[i];
  }
  return area;
}

// Whether a point that lies on no edge is inside, by the edges to its right.
bool is_inside(const Int2& p, const Outline& outline) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Int2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.y > p.y) != (b.y > p.y)) inside ^= (turn(a, b, p) > 0) == (b.y > a.y);
  }
  return inside;
}

Outline times(std::int64_t factor, Outline outline) {
  for (Int2& p : outline) p = {factor * p.x, factor * p.y};
  return outline;
}

// How the edges of an outline meet. `kUnclear` contains what an outline may do where one of the
// edges has no corner: it may cross the edge there, or go along it and leave it on the other side.
enum class Meets { kTouching, kUnclear, kCrossing };
Meets how_it_meets(const Outline& p) {
  const std::size_t n = p.size();
  bool unclear = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Int2 &a = p[i], &b = p[(i + 1) % n];
    for (std::size_t j = 0; j < n; ++j) {
      const Int2 &before = p[(j + n - 1) % n], &c = p[j], &d = p[(j + 1) % n];
      if (sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 &&
          sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0)
        return Meets::kCrossing;
      if (c == a || c == b || !on_segment(c, a, b)) continue;
      unclear = unclear || sign(turn(a, b, before)) * sign(turn(a, b, d)) <= 0;
    }
  }
  return unclear ? Meets::kUnclear : Meets::kTouching;
}

// ---- random outlines that touch themselves ----

// A closed walk along the edges of a lattice, from which some straight corners are left out: it has
// repeated corners, spikes, edges that are walked several times, and corners on edges.
Outline random_walk(Random& random) {
  Outline p;
  const std::int64_t side = random.integer(1, 4);
  Int2 at = {0, 0};
  const std::int64_t steps = random.integer(4, 24);
  const bool triangles = random.integer(0, 1) == 1;  // a lattice of triangles, or of squares
  for (std::int64_t i = 0; i < steps; ++i) {
    constexpr Int2 kSteps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, -1}};
    const Int2& step = kSteps[random.integer(0, triangles ? 5 : 3)];
    const Int2 next = {at.x + step.x, at.y + step.y};
    if (next.x < 0 || next.y < 0 || next.x > side || next.y > side) continue;
    p.push_back(at = next);
    if (random.integer(0, 15) == 0) p.push_back(at);
  }
  while (at.x > 0) p.push_back(at = {at.x - 1, at.y});
  while (at.y > 0) p.push_back(at = {at.x, at.y - 1});
  for (std::size_t i = 1; i + 1 < p.size();) {
    const bool straight = on_segment(p[i], p[i - 1], p[i + 1]);
    if (straight && random.integer(0, 1) == 0) {
      p.erase(p.begin() + std::ptrdiff_t(i));
    } else {
      ++i;
    }
  }
  return p;
}

// A simple outline with a second one walked from one of its corners: as a hole, as an island, or
// both; with spikes, and with corners twice.
Outline random_joined(Random& random) {
  const auto outer_count = std::size_t(random.integer(3, 8));
  Outline p = random_simple(random, outer_count, 6);
  const auto inner_count = std::size_t(random.integer(3, 6));
  const Outline q = random_simple(random, inner_count, 6);
  if (p.empty() || q.empty()) return {};
  const auto at = std::size_t(random.integer(0, std::int64_t(p.size()) - 1));
  Outline loop;
  const bool joined_by_edge = random.integer(0, 1) == 1;
  const Int2 shift = joined_by_edge ? Int2{0, 0} : Int2{p[at].x - q[0].x, p[at].y - q[0].y};
  for (const Int2& c : q) loop.push_back({c.x + shift.x, c.y + shift.y});
  if (random.integer(0, 1) == 1) std::reverse(loop.begin() + 1, loop.end());
  loop.push_back(loop[0]);
  loop.push_back(p[at]);
  p.insert(p.begin() + std::ptrdiff_t(at) + 1, loop.begin(), loop.end());
  for (std::int64_t spikes = random.integer(0, 2); spikes > 0; --spikes) {
    const auto i = std::size_t(random.integer(0, std::int64_t(p.size()) - 1));
    const std::int64_t x = random.integer(-6, 6);
    const Int2 tip = {x, random.integer(-6, 6)}, foot = p[i];
    p.insert(p.begin() + std::ptrdiff_t(i) + 1, {tip, foot});
  }
  return p;
}

// ---- the comparison ----

// The first difference between the triangles and the inside of the outline; empty if there is none.
// Triangles that cover the inside's area and no place outside cover all of it once.
std::string difference(const Outline& outline) {
  const Triangulation t = triangulate(flat_mesh(outline));
  if (t.numbered != outline.size() - 2) return "numbers";
  if (!t.fallback_faces.empty()) return "said to cross itself";
  const bool dropped = !t.degenerate_faces.empty();
  if (!dropped && t.triangles.size() + t.degenerate_triangles != t.numbered) return "counts";
  const std::int64_t winding = twice_area(outline) > 0 ? 1 : -1;
  std::int64_t covered = 0;
  for (const Triangle& triangle : t.triangles) {
    const auto [a, b, c] = triangle.corners;
    const std::int64_t area = winding * turn(outline[a], outline[b], outline[c]);
    if (area <= 0) return "a triangle is turned";
    covered += area;
  }
  if (covered != twice_even_odd_area(outline)) return "area";
  const Outline large = times(1000, outline);
  const auto by_x = [](const Int2& a, const Int2& b) { return a.x < b.x; };
  const auto by_y = [](const Int2& a, const Int2& b) { return a.y < b.y; };
  const auto [left, right] = std::minmax_element(outline.begin(), outline.end(), by_x);
  const auto [low, high] = std::minmax_element(outline.begin(), outline.end(), by_y);
  for (std::int64_t y = low->y; y < high->y; ++y) {
    for (std::int64_t x = left->x; x < right->x; ++x) {
      const Int2 p = {1000 * x + 327, 1000 * y + 611};
      int count = 0;
      for (const Triangle& triangle : t.triangles) {
        const auto [a, b, c] = triangle.corners;
        count += is_inside(p, {large[a], large[b], large[c]});
      }
      if (count != int(is_inside(p, large))) {
        return "covered " + std::to_string(count) + " times at (" + std::to_string(p.x) + ", " +
               std::to_string(p.y) + ") / 1000";
      }
    }
  }
  return "";
}

// The outline from each of its corners and in both directions.
std::vector<Outline> all_orders(Outline outline) {
  std::vector<Outline> orders;
  for (int direction = 0; direction < 2; ++direction) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      orders.push_back(outline);
      std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    }
    std::reverse(outline.begin(), outline.end());
  }
  return orders;
}

TEST_CASE("random outlines that touch themselves are filled by even-odd from every corner") {
  Random random(11);
  int filled = 0, crossing = 0, unclear = 0;
  for (int trial = 0; trial < 1600; ++trial) {
    const Outline outline = trial % 2 == 0 ? random_walk(random) : random_joined(random);
    // Without an area vector it is not known from which side the face is seen.
    if (outline.size() < 4 || twice_area(outline) == 0) continue;
    const Meets meets = how_it_meets(outline);
    const bool crosses = !triangulate(flat_mesh(outline)).fallback_faces.empty();
    INFO("trial " << trial << ": " << text(outline));
    if (meets == Meets::kCrossing) {
      ++crossing;
      REQUIRE(crosses);
      continue;
    }
    unclear += meets == Meets::kUnclear;
    if (meets == Meets::kUnclear && crosses) continue;
    ++filled;
    for (const Outline& order : all_orders(outline)) {
      INFO("as " << text(order));
      REQUIRE(difference(order) == "");
    }
  }
  CHECK(filled > 600);
  CHECK(crossing > 60);
  CHECK(unclear < filled / 2);
}

TEST_CASE("quads that touch themselves are filled by even-odd from every corner") {
  // All quads on a lattice of 3 x 3 places.
  for (int code = 0; code < 9 * 9 * 9 * 9; ++code) {
    Outline outline;
    for (int rest = code; outline.size() < 4; rest /= 9)
      outline.push_back({rest % 3, rest / 3 % 3});
    if (twice_area(outline) == 0 || how_it_meets(outline) != Meets::kTouching) continue;
    INFO(text(outline));
    REQUIRE(difference(outline) == "");
  }
}

TEST_CASE("each way in which an outline may touch itself is filled by even-odd") {
  const Outline two_squares = {{0, 0}, {2, 0}, {2, 2}, {4, 2}, {4, 4}, {2, 4}, {2, 2}, {0, 2}};
  const Outline spike = {{0, 4}, {0, 9}, {0, 4}, {-4, 4}, {-4, -4}, {4, -4}, {4, 4}};
  const Outline folded_back = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 8}, {0, 3}};
  const Outline keyhole = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0},
                           {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}};
  const Outline corner_on_edge = {{0, 0}, {6, 0}, {6, 6}, {3, 0}, {0, 6}};
  const Outline hole_at_corner = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 4}, {4, 2}};
  const Outline spike_inside = {{0, 0}, {6, 0}, {6, 6}, {3, 3}, {6, 6}, {0, 6}};
  const Outline same_place = {{0, 0}, {0, 0}, {6, 0}, {6, 6}, {6, 6}, {6, 6}, {0, 6}};
  for (const Outline& outline : {two_squares, spike, folded_back, keyhole, corner_on_edge,
                                 hole_at_corner, spike_inside, same_place}) {
    for (const Outline& order : all_orders(outline)) {
      INFO(text(order));
      CHECK(difference(order) == "");
    }
  }
}

TEST_CASE("an outline that is walked twice encloses nothing") {
  const Outline square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 2}, {0, 2}};
  const Triangulation t = triangulate(flat_mesh(square));
  CHECK(t.triangles.empty());
  CHECK(t.degenerate_faces == Indices{0});
}

TEST_CASE("an outline that crosses itself is said to, also if all its corners turn left") {
  const Outline pentagram = {{0, 0}, {10, 7}, {-2, 7}, {8, 0}, {4, 12}};
  CHECK(triangulate(flat_mesh(pentagram)).fallback_faces == Indices{0});
  // A loop that begins in the middle of an edge cannot be cut into triangles of the corners.
  const Outline curl = {{0, 0}, {2, -4}, {8, -4}, {8, 8}, {-4, 8}, {-4, 0}, {2, 0}, {2, 2}, {0, 2}};
  for (const Outline& order : all_orders(curl)) {
    CHECK(how_it_meets(order) == Meets::kUnclear);
    CHECK(triangulate(flat_mesh(order)).fallback_faces == Indices{0});
  }
}

TEST_CASE("both sides of a bridge keep their own corners, which may have other attributes") {
  // The bridge goes from corner 4 to corner 5 and back from 9 to 0.
  const std::vector<FlatPoint> keyhole = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0},
                                          {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}};
  const EvenOdd even_odd = find_even_odd(keyhole);
  REQUIRE(even_odd.rings.size() == 1);
  std::vector<std::uint32_t> ring = even_odd.rings[0];
  std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), 0u), ring.end());
  CHECK(ring == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
}

TEST_CASE("a long outline that touches itself is filled in a moment") {
  // A row of squares, each with one corner on the next one's.
  constexpr std::int64_t kSquares = 5000;
  Outline there, back;
  for (std::int64_t i = 0; i < kSquares; ++i) {
    there.push_back({i, i});
    there.push_back({i + 1, i});
    back.push_back({kSquares - i, kSquares - i});
    back.push_back({kSquares - 1 - i, kSquares - i});
  }
  there.insert(there.end(), back.begin(), back.end());
  const Triangulation t = triangulate(flat_mesh(there));
  CHECK(t.triangles.size() == 2 * kSquares);
  CHECK(t.fallback_faces.empty());
}

TEST_CASE("an outline that goes to and fro on one line is not examined for ever") {
  // Each of n edges lies on all others, so n^2 corners lie on edges.
  Outline outline;
  for (std::int64_t i = 0; i < 5000; ++i) outline.push_back({i % 2 == 0 ? i : 10000 - i, 0});
  outline.push_back({5000, 1});
  const Triangulation t = triangulate(flat_mesh(outline));
  CHECK(t.triangles.size() + t.degenerate_triangles == outline.size() - 2);
}

}  // namespace
}  // namespace glassbox::test
