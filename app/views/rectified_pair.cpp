#include "app/views/rectified_pair.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report/text_layout.h"

#include <glassbox/images/write.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

std::string matrix_rows(const std::string& name, const views::Matrix3d& matrix,
                        const std::string& what) {
  std::string text;
  for (int row = 0; row < 3; ++row) {
    text += fmt::format("  {:<8}", row == 0 ? name : "");
    for (int column = 0; column < 3; ++column) {
      text += fmt::format("{:13.6g}", matrix(row, column) + 0.0);  // adding 0 makes 0 of -0
    }
    text += row == 0 ? "   " + what + "\n" : "\n";
  }
  return text;
}

Json matrix_json(const views::Matrix3d& matrix) {
  Json rows = Json::array();
  for (int row = 0; row < 3; ++row) {
    rows.push_back({matrix(row, 0), matrix(row, 1), matrix(row, 2)});
  }
  return rows;
}

}  // namespace

Result<RectifiedPair> rectify(const Image<Rgba8>& left, const Image<Rgba8>& right,
                              const views::StereoRig& rig) {
  const auto how = views::rectification_of(rig, left.width, left.height);
  if (!how) return tl::unexpected(how.error());
  return RectifiedPair{*how, views::rectified(left, how->left),
                       views::rectified(right, how->right)};
}

std::string rectification_text(const views::Rectification& how) {
  return wrapped("rectified   ",
                 fmt::format("of the left picture {:.1f} % has no place in the new one, of the "
                             "right one {:.1f} %; {:.1f} and {:.1f} % of the new ones show nothing",
                             100 * how.lost_left, 100 * how.lost_right, 100 * how.empty_left,
                             100 * how.empty_right)) +
         matrix_rows("H_left", how.left, "new pixel = H (x, y, 1)") +
         matrix_rows("H_right", how.right, "") + matrix_rows("K", how.intrinsic, "of both") +
         fmt::format("  {:<8}{:13.6g}   along the rows: Z = {:.6g} * {:.6g}/disparity\n",
                     "baseline", how.baseline, how.intrinsic(0, 0), how.baseline);
}

Json rectification_json(const views::Rectification& how) {
  return {{"H_left", matrix_json(how.left)},
          {"H_right", matrix_json(how.right)},
          {"K", matrix_json(how.intrinsic)},
          {"R", matrix_json(how.from_left)},
          {"baseline", how.baseline},
          {"lost_percent", {{"left", 100 * how.lost_left}, {"right", 100 * how.lost_right}}},
          {"empty_percent", {{"left", 100 * how.empty_left}, {"right", 100 * how.empty_right}}}};
}

Result<void> write_rectified(const std::pair<std::string, std::string>& names,
                             const RectifiedPair& pair) {
  if (const auto written = write_image(names.first, pair.left); !written) return written;
  return write_image(names.second, pair.right);
}

}  // namespace glassbox::app
