// Calls your functions with the eyes, the triangles and the fragments of a scene.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_09 {
namespace {

using glassbox::labs::append_matrix;
using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

// Input: half the separation s, the window's distance f, 0 for the left eye or 1 for the right one,
// and the centre camera's projection. Output: the eye's projection.
void eye(RecordReader& in, Numbers& out) {
  const Pair pair{in.number(), in.number()};
  const Side side = in.number() == 0 ? Side::kLeft : Side::kRight;
  append_matrix(out, eye_projection(in.matrix<Transform<Clip, Eye>>(), pair, side));
}

// Input: three corners: x for the left eye, x for the right eye, y, z, w. Output: the Verdict.
void verdict(RecordReader& in, Numbers& out) {
  std::array<StereoPoint, 3> triangle;
  for (StereoPoint& p : triangle) {
    p.left_x = in.real();
    p.right_x = in.real();
    p.y = in.real();
    p.z = in.real();
    p.w = in.real();
  }
  out.push_back(double(cull(triangle)));
}

Rgba8 colour(RecordReader& in) {
  const auto rgb = std::uint32_t(in.number());
  return {std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb), 255};
}

// Input: width, height, background, how many fragments the left eye has, then the left eye's
// fragments and the right eye's: x, y, depth, colour (65536 red + 256 green + blue). Output: the
// picture's width and height, then its pixels row by row.
void anaglyph(RecordReader& in, Numbers& out) {
  Anaglyph asked;
  asked.width = in.integer();
  asked.height = in.integer();
  asked.background = colour(in);
  const int of_left = in.integer();
  for (int i = 0; in.more(); ++i) {
    Fragment fragment;
    fragment.x = in.integer();
    fragment.y = in.integer();
    fragment.depth = in.real();
    fragment.colour = colour(in);
    (i < of_left ? asked.left : asked.right).push_back(fragment);
  }
  const Image<Rgba8> shown = draw_anaglyph(asked);
  out.push_back(shown.width);
  out.push_back(shown.height);
  for (const Rgba8& p : shown.pixels) out.push_back(65536.0 * p.r + 256.0 * p.g + p.b);
}

}  // namespace
}  // namespace lab_09

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_09;
  return {{"eye", eye}, {"verdict", verdict}, {"anaglyph", anaglyph}};
}
