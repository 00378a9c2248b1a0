// Transforms vertices by your view matrix, for glassbox lab measure.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_03 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

struct ParsedQuestion {
  bool by_rotations = false;
  Camera camera;
  Transform<Clip, Eye> clip_from_eye;
  std::vector<Point<World, double>> points;
};

// Reads 0 (axes U, V, N) or 1 (two rotations); eye, target and up; a projection, row by row; then
// vertices.
ParsedQuestion read(RecordReader& in) {
  ParsedQuestion asked;
  asked.by_rotations = in.number() != 0;
  asked.camera.eye = in.point<Point<World, double>>();
  asked.camera.target = in.point<Point<World, double>>();
  asked.camera.up = in.point<Vector<World, double>>();
  asked.clip_from_eye = in.matrix<Transform<Clip, Eye>>();
  while (in.more()) asked.points.push_back(in.point<Point<World, double>>());
  return asked;
}

// Writes the depth of each vertex; nothing where there is no view matrix.
void depths(const ParsedQuestion& asked, Numbers& out) {
  const auto view = asked.by_rotations ? axis_angle_view(asked.camera) : uvn_view(asked.camera);
  if (!view) return;
  for (const auto& p : asked.points) {
    const Point<Clip, double> clip = asked.clip_from_eye * (*view * p);
    out.push_back(clip.z / clip.w);
  }
}

void answer(RecordReader& in, Numbers& out) {
  depths(read(in), out);
}

std::function<void()> prepare(RecordReader& in) {
  return [asked = read(in), out = Numbers()]() mutable {
    out.clear();
    depths(asked, out);
  };
}

}  // namespace
}  // namespace lab_03

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"measured", lab_03::answer, lab_03::prepare}};
}
