// Puts distances and fragments to your functions, for glassbox lab measure.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_07 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;

// A format, near and far, then distances. The code of each distance.
void answer(RecordReader& in, Numbers& out) {
  const auto format = Format(in.integer());
  const double near = in.number(), far = in.number();
  const Range range = format == Format::kFloat32Reversed ? Range::kReversed : Range::kStandard;
  const DepthRow row = depth_row(near, far, range);
  while (in.more()) {
    const double distance = in.number();
    out.push_back(double(depth_code(format, float((row.b - row.a * distance) / distance))));
  }
}

// Depths: a fragment for each pixel.
std::vector<Fragment> fragments(RecordReader& in) {
  std::vector<Fragment> all;
  for (int pixel = 0; in.more(); ++pixel) all.push_back({pixel, in.real()});
  return all;
}

// A format, then depths.
std::function<void()> prepare(RecordReader& in) {
  const auto format = Format(in.integer());
  return [format, all = fragments(in)] { visible(all, int(all.size()), format); };
}

// Which fragment each pixel shows.
void answer_timed(RecordReader& in, Numbers& out) {
  const auto format = Format(in.integer());
  const std::vector<Fragment> all = fragments(in);
  for (const auto seen : visible(all, int(all.size()), format)) out.push_back(double(seen));
}

}  // namespace
}  // namespace lab_07

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"measured", lab_07::answer, lab_07::prepare}, {"timed", lab_07::answer_timed}};
}
