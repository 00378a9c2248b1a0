// Calls your functions with distances and fragments, for glassbox lab measure.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_07 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

std::vector<Fragment> fragments_of(RecordReader& in) {
  std::vector<Fragment> fragments;
  for (int pixel = 0; in.more(); ++pixel) fragments.push_back({pixel, in.real()});
  return fragments;
}

constexpr int kWhatIsTimed = 1;

// Input: 0, a format, near and far, then distances. Output: the code of each distance. If the input
// is that of prepare(): the number of the visible fragment at each pixel.
void answer(RecordReader& in, Numbers& out) {
  const bool is_timed = in.integer() == kWhatIsTimed;
  const auto format = Format(in.integer());
  if (is_timed) {
    const std::vector<Fragment> fragments = fragments_of(in);
    for (const int seen : visible(fragments, int(fragments.size()), format))
      out.push_back(double(seen));
    return;
  }
  const double near = in.number(), far = in.number();
  const Range range = format == Format::kFloat32Reversed ? Range::kReversed : Range::kStandard;
  const DepthRow row = depth_row(near, far, range);
  while (in.more()) {
    const double distance = in.number();
    out.push_back(double(depth_code(format, float((row.b - row.a * distance) / distance))));
  }
}

// Input: 1, a format, then depths: one fragment for each pixel.
std::function<void()> prepare(RecordReader& in) {
  in.integer();
  const auto format = Format(in.integer());
  return
      [format, fragments = fragments_of(in)] { visible(fragments, int(fragments.size()), format); };
}

}  // namespace
}  // namespace lab_07

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"measured", lab_07::answer, lab_07::prepare}};
}
