// Calls your functions with the projection and the fragments of a scene.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_07 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

// Input: near, far, range. Output: the entries [2][2] and [2][3] of the projection matrix.
void row(RecordReader& in, Numbers& out) {
  const double near = in.number(), far = in.number();
  const DepthRow made = depth_row(near, far, Range(in.integer()));
  out.insert(out.end(), {made.a, made.b});
}

// Input: a format, then depths. Output: the code of each.
void codes(RecordReader& in, Numbers& out) {
  const auto format = Format(in.integer());
  while (in.more()) out.push_back(double(depth_code(format, in.real())));
}

// Input: a format, the number of pixels, then a pixel and a depth for each fragment. Output: the
// number of the visible fragment at each pixel.
void seen(RecordReader& in, Numbers& out) {
  const auto format = Format(in.integer());
  const int pixels = in.integer();
  std::vector<Fragment> fragments;
  while (in.more()) {
    const int pixel = in.integer();
    fragments.push_back({pixel, in.real()});
  }
  const std::vector<int> winners = visible(fragments, pixels, format);
  out.insert(out.end(), winners.begin(), winners.end());
}

// Input: near, far, range, then depths. Output: the distance of each.
void distances(RecordReader& in, Numbers& out) {
  const double near = in.number(), far = in.number();
  const auto range = Range(in.integer());
  while (in.more()) out.push_back(distance_of(in.number(), near, far, range));
}

}  // namespace
}  // namespace lab_07

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_07;
  return {{"row", row}, {"codes", codes}, {"seen", seen}, {"distances", distances}};
}
