// Calls your functions with the rows and paths of a pair of pictures.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_11 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

Picture picture(RecordReader& in, int width, int height) {
  Picture made{width, height, {}};
  for (int i = 0; i < width * height; ++i) made.grey.push_back(in.integer());
  return made;
}

void append(Numbers& out, const Numbers& more) {
  out.insert(out.end(), more.begin(), more.end());
}

// Input: the number of disparities, width, height, the row's number y, the grey values of both
// pictures. Output: for each pixel of the row and each disparity, sad() of squares of 3 x 3 pixels
// plus 32 times hamming() of the census words, or kNever.
void costs_stage(RecordReader& in, Numbers& out) {
  const int disparities = in.integer(), width = in.integer(), height = in.integer();
  const int y = in.integer();
  const Picture left = picture(in, width, height), right = picture(in, width, height);
  for (int x = 0; x < width; ++x) {
    const std::uint32_t word = census(left, x, y);
    for (int d = 0; d < disparities; ++d) {
      const int cost = sad(left, right, x, y, d, 1);
      out.push_back(cost >= kNever ? kNever : cost + 32 * hamming(word, census(right, x - d, y)));
    }
  }
}

// Input: the number of disparities, P1, P2, the costs of the path's pixels. Output: the sums along
// the path.
void paths_stage(RecordReader& in, Numbers& out) {
  const int disparities = in.integer(), p1 = in.integer(), p2 = in.integer();
  std::vector<int> costs;
  while (in.more()) costs.push_back(in.integer());
  for (const int sum : along_path(costs, disparities, p1, p2)) out.push_back(sum);
}

// Input: the number of disparities, the costs of the row's pixels. Output: the disparities of the
// left pixels.
void left_stage(RecordReader& in, Numbers& out) {
  const int disparities = in.integer();
  while (in.more()) {
    std::vector<int> costs;
    for (int d = 0; d < disparities; ++d) costs.push_back(in.integer());
    out.push_back(winner(costs));
  }
}

// Input: the number of disparities, the costs of the row's pixels. Output: the disparities of the
// right pixels.
void right_stage(RecordReader& in, Numbers& out) {
  const int disparities = in.integer();
  std::vector<int> costs;
  while (in.more()) costs.push_back(in.integer());
  append(out, right_winners(costs, int(costs.size()) / disparities, disparities));
}

// Input: the tolerance, the width, a row of left disparities and the same row of right ones.
// Output: the left disparities that the right ones confirm, with kNone in the other places.
void check_stage(RecordReader& in, Numbers& out) {
  const double tolerance = in.number();
  const int width = in.integer();
  Numbers left, right;
  for (int x = 0; x < width; ++x) left.push_back(in.number());
  for (int x = 0; x < width; ++x) right.push_back(in.number());
  append(out, left_right_check(left, right, tolerance));
}

// Input: focal length, baseline, offset, disparities. Output: depths.
void depth_stage(RecordReader& in, Numbers& out) {
  const double focal = in.number(), baseline = in.number();
  const Calibration calibration{focal, baseline, in.number()};
  while (in.more()) out.push_back(depth(in.number(), calibration));
}

}  // namespace
}  // namespace lab_11

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  using namespace lab_11;
  return {{"costs", costs_stage}, {"paths", paths_stage}, {"left", left_stage},
          {"right", right_stage}, {"check", check_stage}, {"depths", depth_stage}};
}
