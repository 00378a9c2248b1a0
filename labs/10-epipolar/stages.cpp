// Calls your functions with the matches and pixels of a pair of pictures.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_10 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

Vector vector(RecordReader& in) {
  const double x = in.number(), y = in.number();
  return {x, y, in.number()};
}
Matrix matrix(RecordReader& in) {
  const Vector first = vector(in), second = vector(in);
  return {first, second, vector(in)};
}
Pixel pixel(RecordReader& in) {
  const double x = in.number();
  return {x, in.number()};
}
std::vector<Match> matches(RecordReader& in) {
  std::vector<Match> all;
  while (in.more()) {
    const Pixel left = pixel(in);
    all.push_back({left, pixel(in)});
  }
  return all;
}
void append(Numbers& out, const Vector& v) {
  out.insert(out.end(), v.begin(), v.end());
}
void append(Numbers& out, const Matrix& m) {
  for (const Vector& row : m) append(out, row);
}

// Input: calibrated matches, each as left x, left y, right x, right y. Output: E with |E| = 1.
void matrix_stage(RecordReader& in, Numbers& out) {
  append(out, told(eight_point(matches(in))));
}

// Input: E and calibrated matches. Output: R and T.
void pose_stage(RecordReader& in, Numbers& out) {
  const Matrix e = matrix(in);
  const Pose pose = relative_pose(e, matches(in));
  append(out, pose.rotation);
  append(out, pose.translation);
}

// Input: E; the focal length f and the principal point x, y of both cameras; pixels of the left
// picture. Output: a, b, c of the epipolar line of each pixel.
void lines_stage(RecordReader& in, Numbers& out) {
  const Matrix e = matrix(in);
  const Vector left = vector(in), right = vector(in);
  while (in.more()) {
    const Line l =
        epipolar_line(e, {left[0], left[1], left[2]}, {right[0], right[1], right[2]}, pixel(in));
    append(out, Vector{l.a, l.b, l.c});
  }
}

// Input: R, T, calibrated matches. Output: x, y, z, w of each point.
void points_stage(RecordReader& in, Numbers& out) {
  const Matrix rotation = matrix(in);
  const Pose pose{rotation, vector(in)};
  for (const Match& match : matches(in)) {
    const Point p = triangulate(match.left, match.right, pose);
    out.insert(out.end(), {p.x, p.y, p.z, p.w});
  }
}

}  // namespace
}  // namespace lab_10

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_10;
  return {{"matrix", matrix_stage},
          {"pose", pose_stage},
          {"lines", lines_stage},
          {"points", points_stage}};
}
