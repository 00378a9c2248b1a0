// Calls your functions with the cells and edges of a solid.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_14 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

// Input: sets of inside corners, one bit for each corner. Output: for each set its polygons (the
// number of edges, then the edges), and then 0.
void polygons(RecordReader& in, Numbers& out) {
  while (in.more()) {
    for (const std::vector<int>& polygon : cell_polygons(unsigned(in.integer()))) {
      out.push_back(double(polygon.size()));
      out.insert(out.end(), polygon.begin(), polygon.end());
    }
    out.push_back(0);
  }
}

// Input: the level, then the values at the two ends of each edge. Output: for each edge the
// fraction of its length at which the surface crosses it.
void shares(RecordReader& in, Numbers& out) {
  const double level = in.number();
  while (in.more()) {
    const double from = in.number();
    out.push_back(crossing(from, in.number(), level));
  }
}

}  // namespace
}  // namespace lab_14

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_14;
  return {{"polygons", polygons}, {"shares", shares}};
}
