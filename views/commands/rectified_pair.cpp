#include "views/commands/rectified_pair.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/text_layout.h"
#include "views/commands/matrix_report.h"

#include <glassbox/images/write.h>

namespace glassbox::views {

namespace {

using Json = nlohmann::ordered_json;

std::string six_digits(double value) {
  return fmt::format("{:13.6g}", value + 0.0);  // adding 0 turns -0 into 0
}

}  // namespace

Result<RectifiedPair> rectify(const Image<Rgba8>& left, const Image<Rgba8>& right,
                              const views::StereoRig& rig) {
  const auto rectification = views::rectification_of(rig, left.width, left.height);
  if (!rectification) return tl::unexpected(rectification.error());
  return RectifiedPair{*rectification, views::rectified(left, rectification->left),
                       views::rectified(right, rectification->right)};
}

std::string rectification_text(const views::Rectification& rectification) {
  return wrapped("rectified   ",
                 fmt::format("{:.1f} % of the left picture and {:.1f} % of the right one are cut "
                             "off; {:.1f} and {:.1f} % of the rectified pictures show nothing",
                             100 * rectification.lost_left, 100 * rectification.lost_right,
                             100 * rectification.empty_left, 100 * rectification.empty_right)) +
         matrix_lines("H_left", rectification.left, "new pixel = H (x, y, 1)", six_digits) +
         matrix_lines("H_right", rectification.right, "", six_digits) +
         matrix_lines("K", rectification.intrinsic, "for both", six_digits) +
         fmt::format("  {:<8}{:13.6g}   along the rows: Z = {:.6g} * {:.6g}/disparity\n",
                     "baseline", rectification.baseline, rectification.intrinsic(0, 0),
                     rectification.baseline);
}

Json rectification_json(const views::Rectification& rectification) {
  return {{"H_left", matrix_json(rectification.left)},
          {"H_right", matrix_json(rectification.right)},
          {"K", matrix_json(rectification.intrinsic)},
          {"R", matrix_json(rectification.from_left)},
          {"baseline", rectification.baseline},
          {"lost_percent",
           {{"left", 100 * rectification.lost_left}, {"right", 100 * rectification.lost_right}}},
          {"empty_percent",
           {{"left", 100 * rectification.empty_left}, {"right", 100 * rectification.empty_right}}}};
}

Result<void> write_rectified(const std::pair<std::string, std::string>& names,
                             const RectifiedPair& pair) {
  if (const auto written = write_image(names.first, pair.left); !written) return written;
  return write_image(names.second, pair.right);
}

}  // namespace glassbox::views
