#include "views/commands/left_out_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/exit_codes.h"

#include <glassbox/base/printable.h>

namespace glassbox::views {

std::string left_out_text(const std::string& picture, const views::TextureErrors& errors) {
  const std::string name = printable(picture, kLongestMessage);
  if (errors.covered == 0)
    return fmt::format("{}, which was left out: polygons cover no pixel of its object\n", name);
  return fmt::format(
      "{}, which was left out: PSNR {:.2f} dB, RMS {:.2f}, over the {:.1f} % of its object that "
      "polygons cover\n",
      name, errors.psnr, errors.rms, 100 * errors.covered);
}

nlohmann::ordered_json left_out_json(const std::string& picture,
                                     const views::TextureErrors& errors) {
  return {{"picture", picture},
          {"psnr", errors.psnr},
          {"rms", errors.rms},
          {"covered", errors.covered},
          {"pixels", errors.pixels}};
}

}  // namespace glassbox::views
