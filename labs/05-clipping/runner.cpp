// Calls your functions with the cases of lab 5.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_05 {
namespace {

using glassbox::labs::Answer;

std::vector<double> numbers_of(const Polygon& polygon) {
  std::vector<double> all;
  for (const Point<Clip>& p : polygon) all.insert(all.end(), {p.x, p.y, p.z, p.w});
  return all;
}

void ask_faces(const FaceCase& questions, Answer& answer) {
  std::vector<double> back;
  for (const FaceQuestion& each : questions)
    back.push_back(is_back_face(each.face, each.eye) ? 1 : 0);
  answer.emit("back", back);
}

void ask_outcode(const Point<Clip>& p, Answer& answer) {
  answer.emit("outcode", {double(outcode(p))});
}

void ask_verdict(const std::vector<std::uint32_t>& outcodes, Answer& answer) {
  answer.emit("verdict", {double(trivial_verdict(outcodes))});
}

void ask_crossing(const Edge& edge, Answer& answer) {
  answer.emit("crossing", numbers_of({crossing(edge.plane, edge.p, edge.q)}));
}

void ask_both_ways(const EdgesCase& edges, Answer& answer) {
  Polygon forward, backward;
  for (const Edge& edge : edges) {
    forward.push_back(crossing(edge.plane, edge.p, edge.q));
    backward.push_back(crossing(edge.plane, edge.q, edge.p));
  }
  answer.emit("p to q", numbers_of(forward));
  answer.emit("q to p", numbers_of(backward));
}

void ask_edge(const Edge& edge, Answer& answer) {
  ask_both_ways({edge}, answer);
}

void ask_plane(const PlaneCase& input, Answer& answer) {
  answer.emit("polygon", numbers_of(clip_by_plane(input.polygon, input.plane)));
}

void ask_frustum(const FrustumCase& input, Answer& answer) {
  answer.emit("polygon", numbers_of(clip_to_frustum(input.triangle)));
}

void ask_pairs(const PairsCase& pairs, Answer& answer) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    answer.emit("first " + std::to_string(i), numbers_of(clip_to_frustum(pairs[i].first())));
    answer.emit("second " + std::to_string(i), numbers_of(clip_to_frustum(pairs[i].second())));
  }
}

// BEGIN HIDDEN
void ask_fan(int count, Answer& answer) {
  int i = 0;
  for (const auto& triangle : fan_of_triangles(count))
    answer.emit("triangle " + std::to_string(i++), numbers_of(clip_to_frustum(triangle)));
}
// END HIDDEN

}  // namespace
}  // namespace lab_05

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_05;
  return {
      check("faces of solids that look away", solids(), ask_faces),
      check("which planes a point is outside of", points(), ask_outcode),
      check("accepted, rejected or clipped", outcode_lists(), ask_verdict),
      check("where an edge meets a plane", some_edges(), ask_crossing),
      check("the same bits from either end", edges_both_ways(), ask_both_ways),
      check("a polygon and one plane", polygons(), ask_plane),
      check("a triangle and the frustum", triangles(), ask_frustum),
      check("a shared edge is cut at one place", pairs_of_triangles(), ask_pairs),
      generated_check("any face", generated_faces(), ask_faces),
      generated_check("any point", generated_clip_points(), ask_outcode),
      generated_check("any outcodes", generated_codes(), ask_verdict),
      generated_check("any edge", generated_edges(), ask_edge),
      generated_check("any polygon and plane", generated_polygons(), ask_plane),
      generated_check("any triangle", generated_triangles(), ask_frustum),
      generated_check("any two triangles with a common edge", generated_pairs(), ask_pairs),
      // BEGIN HIDDEN
      check("an eye in the face's plane", faces_edge_on(), ask_faces),
      check("points on, before and behind every plane", lattice_points(), ask_outcode),
      check("a crossing lies on its plane", other_edges(), ask_crossing),
      check("crossings between two floats", ties(), ask_both_ways),
      check("polygons that touch the plane", more_polygons(), ask_plane),
      check("triangles through many planes", more_triangles(), ask_frustum),
      check("triangles around a point fill the picture", fan_counts(), ask_fan),
      // END HIDDEN
  };
}
