// The results of `glassbox views glyphs find`, and their reports.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "views/files/camera_file.h"
#include "views/glyphs/find_glyphs.h"
#include "views/glyphs/glyph_score.h"
#include "views/glyphs/pose.h"
#include "views/glyphs/wall.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::views {

struct GlyphsReport {
  std::string picture;
  int width = 0, height = 0;  // in px
  views::FoundGlyphs found;
  views::GlyphPoints points;
  views::KnownIntrinsics known = views::KnownIntrinsics::kCentre;
  std::optional<views::FoundPose> pose;
  std::string no_pose;  // the reason if no pose was found
  std::optional<views::PinholeCamera> truth;
  std::optional<views::PoseError> error;
  std::optional<views::GlyphScore> score;
};

std::string glyphs_text(const GlyphsReport& report);
nlohmann::ordered_json glyphs_json(const GlyphsReport& report, const views::Wall& wall);

// An error if the picture is too large for a browser.
Result<void> check_glyphs_page(const Image<Rgba8>& picture);

// The picture with the glyphs found, as one HTML page that needs no other file.
Result<std::string> make_glyphs_page(const Image<Rgba8>& picture, const GlyphsReport& report,
                                     const nlohmann::ordered_json& json,
                                     const std::string& command);

}  // namespace glassbox::views
