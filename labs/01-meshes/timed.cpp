// Calls your newell_vector with polygons, for glassbox lab measure.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_01 {
namespace {

using glassbox::labs::append_point;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;
using Polygon = std::vector<Point<Object>>;

// Reads the number of corners per polygon, then all corners.
std::vector<Polygon> polygons(RecordReader& in) {
  const int corners = in.integer();
  std::vector<Polygon> all;
  while (in.more()) {
    Polygon& polygon = all.emplace_back();
    for (int i = 0; i < corners; ++i) polygon.push_back(in.point<Point<Object>>());
  }
  return all;
}

void answer(RecordReader& in, Numbers& out) {
  for (const Polygon& polygon : polygons(in)) append_point(out, newell_vector(polygon));
}

std::function<void()> prepare(RecordReader& in) {
  return [all = polygons(in)] {
    for (const Polygon& polygon : all) newell_vector(polygon);
  };
}

}  // namespace
}  // namespace lab_01

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"measured", lab_01::answer, lab_01::prepare}};
}
