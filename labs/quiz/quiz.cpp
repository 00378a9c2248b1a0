#include "labs/quiz/quiz.h"

#include <array>
#include <cmath>

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/projection.h>

namespace glassbox::labs {

namespace {

using Map = Transform<World, Object>;
using WorldPoint = Point<World, double>;
using WorldVector = Vector<World, double>;

// ---- samples ----

// Maps of every kind: a translation, a rotation, a non-uniform scale, a shear, a mirror, and
// products of them.
std::vector<Map> affine_maps() {
  const Map shift = translate<World, Object>({3, -1, 2});
  const Map turn = *rotate_degrees<World, Object>({1, 2, 3}, 40);
  const Map scaled = scale<World, Object>(2, 0.5, 1);
  const Map leaning = shear<World, Object>(Axis::kX, Axis::kY, 1);
  const Map mirror = scale<World, Object>(-1, 1, 1);
  const auto then = [](const Map& first, const Map& second) {
    return Map((Transform<World, World>(second.columns) * first).columns);
  };
  return {Map(), shift, turn, scaled, leaning, mirror, then(turn, shift), then(leaning, turn)};
}

std::vector<Point<Object, double>> sample_points() {
  return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, -3, 1}, {-1, 4, 0.5}};
}

// A perspective with a field of view of a right angle, the near plane at 1 and no far plane: x and
// y divided by the distance.
WorldPoint project_to_picture(const WorldPoint& p) {
  const auto m = *perspective_degrees(90, 1, {1});
  const auto clip = m * Point<Eye, double>(p.x, p.y, p.z);
  return {clip.x / clip.w, clip.y / clip.w, clip.z / clip.w};
}

// Points in front of the eye, at various distances.
std::vector<WorldPoint> visible_points() {
  return {{0, 0, -2}, {1, 0, -2}, {1, 1, -4}, {-2, 1, -3}, {0.5, -1, -8}, {3, 2, -5}};
}
std::vector<WorldVector> directions() {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {1, 1, 0}, {1, 0, -2}, {-1, 2, -1}};
}

// ---- comparisons ----

bool nearly_equal(double a, double b) {
  return std::abs(a - b) <=
         1e-12 * (1 + std::abs(a) + std::abs(b));  // 1e-12: some thousand roundings of double
}
bool nearly_equal(const WorldVector& a, const WorldVector& b) {
  return nearly_equal(a.x, b.x) && nearly_equal(a.y, b.y) && nearly_equal(a.z, b.z);
}
WorldVector without_depth(const WorldVector& v) {
  return {v.x, v.y, 0};
}
bool parallel(const WorldVector& a, const WorldVector& b) {
  return nearly_equal(cross(a, b), {0, 0, 0});
}

template <class Items, class Test>
bool holds_for_all(const Items& items, const Test& test) {
  for (const auto& each : items) {
    if (!test(each)) return false;
  }
  return true;
}

// Whether the test holds for every map and every two points.
template <class Test>
bool holds_for_all_pairs(const Test& test) {
  return holds_for_all(affine_maps(), [&](const Map& m) {
    return holds_for_all(sample_points(), [&](const auto& p) {
      return holds_for_all(sample_points(), [&](const auto& q) { return test(m, p, q); });
    });
  });
}

Point<Object, double> midpoint(const Point<Object, double>& a, const Point<Object, double>& b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
}
WorldPoint midpoint(const WorldPoint& a, const WorldPoint& b) {
  return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
}

// ---- affine maps ----

Quiz affine_quiz() {
  const std::string shift = "--model '1 0 0 3  0 1 0 0  0 0 1 0  0 0 0 1'";
  const std::string shear = "--model '1 1 0 0  0 1 0 0  0 0 1 0  0 0 0 1'";
  const std::string eye = " --proj '1 0 0 0  0 1 0 0  0 0 -1 -10  0 0 0 1' --dialect glassbox";
  return {2,
          "Affine maps",
          {{"Every affine map is linear.", false,
            "A linear map leaves the origin where it is, and a translation does not. An affine map "
            "is a linear map followed by a translation.",
            "step --point 0,0,0 " + shift + eye,
            [] {
              return holds_for_all(affine_maps(), [](const Map& m) {
                return nearly_equal(m * Point<Object, double>(0, 0, 0) - WorldPoint(0, 0, 0),
                                    {0, 0, 0});
              });
            }},
           {"An affine map is a combination of linear transformations.", false,
            "Products and sums of linear maps are linear, so none of them is a translation "
            "(erratum E10). With a fourth coordinate, which stays 1, an affine map is a linear map "
            "of four coordinates.",
            "step --point 0,0,0 --point 1,0,0 " + shift + eye,
            [] {
              // A linear map takes a sum to the sum of the images; tested on p + q, and on the
              // origin.
              return holds_for_all_pairs([](const Map& m, const auto& p, const auto& q) {
                const WorldPoint sum = m * Point<Object, double>(p.x + q.x, p.y + q.y, p.z + q.z);
                return nearly_equal(sum - (m * p), (m * q) - WorldPoint(0, 0, 0));
              });
            }},
           {"The last row of an affine map of space, with column vectors, is (0, 0, 0, 1).", true,
            "This row keeps w = 1. With row vectors it would be the last column.",
            "step --point 1,2,3 " + shear + eye,
            [] {
              return holds_for_all(affine_maps(), [](const Map& m) {
                return m.at(3, 0) == 0 && m.at(3, 1) == 0 && m.at(3, 2) == 0 && m.at(3, 3) == 1;
              });
            }},
           {"An affine map can change w.", false,
            "Its last row gives 0 x + 0 y + 0 z + 1 w, which is w.",
            "step --point 1,2,3 " + shift + eye,
            [] {
              return holds_for_all(affine_maps(), [](const Map& m) {
                return !nearly_equal(m.at(3, 0) + m.at(3, 1) + m.at(3, 2) + m.at(3, 3), 1);
              });
            }},
           {"Affine maps keep parallel lines parallel.", true,
            "Two lines with the same direction d both have the direction A d afterwards.",
            "step --point 0,0,0 --point 0,1,0 --point 1,0,0 --point 1,1,0 " + shear + eye,
            [] {
              return holds_for_all_pairs([](const Map& m, const auto& p, const auto& q) {
                const Point<Object, double> p2(p.x + 1, p.y + 2, p.z + 3),
                    q2(q.x + 1, q.y + 2, q.z + 3);
                return parallel((m * p2) - (m * p), (m * q2) - (m * q));
              });
            }},
           {"Affine maps carry the middle of a segment to the middle of its image.", true,
            "They keep sums whose weights add up to 1: A (p + q)/2 + t = (A p + t + A q + t)/2.",
            "step --point 0,0,0 --point 1,1,0 --point 2,2,0 " + shear + eye,
            [] {
              return holds_for_all_pairs([](const Map& m, const auto& p, const auto& q) {
                return nearly_equal((m * midpoint(p, q)) - midpoint(m * p, m * q), {0, 0, 0});
              });
            }},
           {"Affine maps carry right angles to right angles.", false,
            "A shear tilts one axis and leaves the other, so the angle between them changes.",
            "step --point 0,0,0 --point 1,0,0 --point 0,1,0 " + shear + eye,
            [] {
              return holds_for_all(affine_maps(), [](const Map& m) {
                const WorldPoint o = m * Point<Object, double>(0, 0, 0);
                return nearly_equal(dot((m * Point<Object, double>(1, 0, 0)) - o,
                                        (m * Point<Object, double>(0, 1, 0)) - o),
                                    0);
              });
            }},
           {"It does not matter whether an object is first rotated and then translated, or the "
            "other way round.",
            false, "T R has the translation t, and R T has R t: they differ by (R - I) t.",
            "step --point 1,0,0 --model '0 -1 0 0  1 0 0 3  0 0 1 0  0 0 0 1'" + eye,
            [] {
              const auto turn = *rotate_degrees<World, World>({0, 0, 1}, 90);
              const auto shift = translate<World, World>({3, 0, 0});
              return turn * shift == shift * turn;
            }},
           {"Any three pairs of points determine an affine map of the plane.", false,
            "Not if the first three points are on a line: a shear along that line moves none of "
            "them, so the map is not unique.",
            "step --point 0,0,0 --point 1,0,0 --point 2,0,0 " + shear + eye, [] {
              return affine_from_three_points({{{0, 0}, {1, 0}, {2, 0}}},
                                              {{{0, 0}, {1, 0}, {2, 0}}})
                  .has_value();
            }}}};
}

// ---- perspective ----

Quiz perspective_quiz() {
  const std::string eye = " --proj '1 0 0 0  0 1 0 0  0 0 -1 -1  0 0 -1 0' --dialect glassbox";
  const auto along = [](const WorldPoint& p, const WorldVector& d) {
    return project_to_picture(p + d) - project_to_picture(p);
  };
  return {
      4,
      "Perspective",
      {{"Parallel lines that go into the scene converge in the picture.", true,
        "All lines with the direction d run to the picture of d itself, the vanishing point (d.x, "
        "d.y) / -d.z.",
        "step --point 1,0,-2 --point 1,0,-200 --point -1,0,-2 --point -1,0,-200" + eye,
        [] {
          return holds_for_all(directions(), [](const WorldVector& d) {
            if (d.z == 0) return true;
            const WorldPoint goal = project_to_picture({d.x, d.y, d.z});
            // In the picture, the distance of a point on the line from the vanishing point is
            // inversely proportional to the point's distance along the gaze.
            return holds_for_all(visible_points(), [&](const WorldPoint& p) {
              const auto from_goal = [&](double t) {
                return without_depth(project_to_picture(p + d * t) - goal) * (-p.z - t * d.z);
              };
              return nearly_equal(from_goal(0), from_goal(3));
            });
          });
        }},
       {"All parallel lines converge in the picture.", false,
        "Lines parallel to the picture's plane stay parallel: w is the same all along them.",
        "step --point 0,0,-2 --point 1,0,-2 --point 0,1,-2 --point 1,1,-2" + eye,
        [along] {
          return holds_for_all(directions(), [&](const WorldVector& d) {
            return holds_for_all(visible_points(), [&](const WorldPoint& p) {
              return !parallel(without_depth(along(p, d)),
                               without_depth(along({p.x, p.y + 1, p.z}, d)));
            });
          });
        }},
       {"An object twice as far away is seen half as large.", true,
        "x and y are divided by w, which is the distance.",
        "step --point 1,1,-2 --point 1,1,-4" + eye,
        [] {
          return holds_for_all(visible_points(), [](const WorldPoint& p) {
            const WorldPoint near = project_to_picture(p),
                             far = project_to_picture({p.x, p.y, 2 * p.z});
            return nearly_equal(near.x, 2 * far.x) && nearly_equal(near.y, 2 * far.y);
          });
        }},
       {"Perspective carries the middle of a segment to the middle of its picture.", false,
        "The nearer half looks longer: foreshortening is not uniform.",
        "step --point 1,0,-2 --point 1,0,-4 --point 1,0,-6" + eye,
        [] {
          return holds_for_all(visible_points(), [](const WorldPoint& p) {
            return holds_for_all(visible_points(), [&](const WorldPoint& q) {
              return nearly_equal(
                  without_depth(project_to_picture(midpoint(p, q)) -
                                midpoint(project_to_picture(p), project_to_picture(q))),
                  {0, 0, 0});
            });
          });
        }},
       {"Perspective keeps straight lines straight.", true,
        "A line and the eye span a plane, which meets the picture in a line. So it is enough to "
        "project the ends of an edge.",
        "step --point 0,0,-2 --point 1,1,-4 --point 2,2,-6" + eye,
        [along] {
          return holds_for_all(directions(), [&](const WorldVector& d) {
            return holds_for_all(visible_points(), [&](const WorldPoint& p) {
              return parallel(without_depth(along(p, d)), without_depth(along(p, d * 3.0)));
            });
          });
        }},
       {"Perspective keeps angles.", false,
        "The right angle of a square on the floor is not a right angle in the picture.",
        "step --point 0,-1,-2 --point 1,-1,-2 --point 0,-1,-4" + eye,
        [along] {
          return holds_for_all(visible_points(), [&](const WorldPoint& p) {
            return nearly_equal(
                dot(without_depth(along(p, {1, 0, 0})), without_depth(along(p, {0, 0, -1}))), 0);
          });
        }},
       {"The last row of a perspective projection is (0, 0, 0, 1).", false,
        "It is (0, 0, -1, 0): w becomes the distance, and so the map is not affine.",
        "step --point 1,1,-2" + eye,
        [] {
          const auto m = *perspective_degrees(90, 1, {1});
          return m.at(3, 2) == 0 && m.at(3, 3) == 1;
        }},
       {"After a parallel projection w is still 1.", true,
        "It is affine. So the divide may be left out without changing a bit.",
        "step --point 1,1,-2 --proj '1 0 0 0  0 1 0 0  0 0 -0.1 0  0 0 0 1' --dialect glassbox",
        [] {
          const auto m = *orthographic({-1, 1, -1, 1}, {0, 10});
          return holds_for_all(visible_points(), [&](const WorldPoint& p) {
            return (m * Point<Eye, double>(p.x, p.y, p.z)).w == 1;
          });
        }},
       {"A point behind the eye is divided by its w, and therefore is not in the picture.", false,
        "Its w is negative, and (x, y)/w is in the picture, upside down. It has to be clipped "
        "before the divide.",
        "step --point 0.5,0.5,2" + eye,
        [] {
          return holds_for_all(visible_points(), [](const WorldPoint& p) {
            const WorldPoint behind = project_to_picture({p.x, p.y, -p.z});
            return std::abs(behind.x) > 1 || std::abs(behind.y) > 1;
          });
        }},
       {"Depth is a linear function of the distance.", false,
        "It is linear in 1/distance: half of all depths are nearer than twice the distance of the "
        "near plane.",
        "step --point 0,0,-1 --point 0,0,-2 --point 0,0,-3" + eye, [] {
          return nearly_equal(project_to_picture({0, 0, -3}).z - project_to_picture({0, 0, -2}).z,
                              project_to_picture({0, 0, -2}).z - project_to_picture({0, 0, -1}).z);
        }}}};
}

}  // namespace

const std::vector<Quiz>& all_quizzes() {
  static const std::vector<Quiz> all{affine_quiz(), perspective_quiz()};
  return all;
}

}  // namespace glassbox::labs
