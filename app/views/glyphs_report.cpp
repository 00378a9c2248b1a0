#include "app/views/glyphs_report.h"

#include <cmath>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report/exit_codes.h"
#include "app/report/picture_uri.h"
#include "app/views/matrix_report.h"
#include "viewsglyphs_page.h"  // made by html/embed.cmake

#include <glassbox/base/printable.h>
#include <glassbox/html/blob.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const views::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

constexpr const char* kColorNames[] = {"red", "green", "blue", "cyan", "magenta", "yellow"};

std::string code_text(const views::GlyphCode& code) {
  if (code[0] < 0) return "none";
  return fmt::format("{}, {}, {}", kColorNames[code[0]], kColorNames[code[1]],
                     kColorNames[code[2]]);
}

}  // namespace

std::string glyphs_text(const GlyphsReport& report) {
  std::string text =
      fmt::format("{}: {} regions of {} x {} px, {} of them glyphs\n",
                  printable(report.picture, kLongestMessage), report.found.regions.size(),
                  report.width, report.height, report.found.glyphs());
  std::map<std::string_view, int> broken;
  for (const views::GlyphRegion& region : report.found.regions) {
    if (region.broken) ++broken[views::name_of(*region.broken)];
  }
  for (int rule = 0; rule < views::kGlyphRules; ++rule) {
    const auto found = broken.find(views::name_of(views::GlyphRule(rule)));
    if (found != broken.end())
      text += fmt::format("  left out: {} by the rule '{}'\n", found->second, found->first);
  }
  if (report.pose) {
    const views::PinholeCamera& camera = report.pose->camera;
    const views::Vector3d& at = camera.centre;
    text += fmt::format(
        "camera at {:.4f}, {:.4f}, {:.4f} m, f = {:.2f} px, principal point {:.2f}, {:.2f} (lens: "
        "{})\n"
        "{} of {} glyphs agree, RMS {:.3f} px\n",
        at.x(), at.y(), at.z(), camera.intrinsic(0, 0), camera.intrinsic(0, 2),
        camera.intrinsic(1, 2), views::name_of(report.known), report.pose->inliers,
        report.points.points.size(), report.pose->rms);
  } else {
    text += "no camera: " + printable(report.no_pose, kLongestMessage) + "\n";
  }
  if (report.error)
    text += fmt::format("off the truth by {:.4f} degrees and {:.3f} mm\n", report.error->degrees,
                        1000 * report.error->distance);
  if (report.score) {
    text += fmt::format("{} glyphs are whole in the picture: {} right, {} wrong, {} missed\n",
                        report.score->visible, report.score->right, report.score->wrong,
                        report.score->visible - report.score->right);
  }
  return text;
}

Json glyphs_json(const GlyphsReport& report, const views::Wall& wall) {
  Json json{{"picture", report.picture},
            {"width", report.width},
            {"height", report.height},
            {"glyphs", report.found.glyphs()},
            {"lens", views::name_of(report.known)},
            {"regions", Json::array()}};
  std::map<std::size_t, bool> agrees;
  for (std::size_t i = 0; report.pose && i < report.points.of.size(); ++i)
    agrees[report.points.of[i]] = report.pose->is_inlier[i];
  for (std::size_t i = 0; i < report.found.regions.size(); ++i) {
    const views::GlyphRegion& region = report.found.regions[i];
    const views::Ellipse& ellipse = region.ellipse;
    Json one{{"x", ellipse.centre.x()},
             {"y", ellipse.centre.y()},
             {"moments", {ellipse.moments(0, 0), ellipse.moments(0, 1), ellipse.moments(1, 1)}},
             {"diameter_px", ellipse.diameter()},
             {"across_px", ellipse.shorter_diameter()},
             {"identity", region.identity},
             {"code", code_text(region.code)},
             {"broken", region.broken ? Json(views::name_of(*region.broken)) : Json()},
             {"classified", region.classified},
             {"others", region.others},
             {"shares", region.shares},
             {"apart_px", region.apart}};
    if (const auto found = agrees.find(i); found != agrees.end()) one["agrees"] = found->second;
    if (const views::WallGlyph* glyph = wall.find(region.identity); glyph != nullptr)
      one["world"] = vector_json(glyph->centre);
    json["regions"].push_back(std::move(one));
  }
  if (report.pose) {
    const views::PinholeCamera& camera = report.pose->camera;
    json["camera"] = {{"K", matrix_json(camera.intrinsic)},
                      {"R", matrix_json(camera.camera_from_world)},
                      {"centre", vector_json(camera.centre)},
                      {"inliers", report.pose->inliers},
                      {"rms_px", report.pose->rms}};
  } else {
    json["no_camera"] = report.no_pose;
  }
  if (report.error)
    json["error"] = {{"degrees", report.error->degrees},
                     {"millimetres", 1000 * report.error->distance}};
  if (report.score) {
    json["score"] = {{"visible", report.score->visible},
                     {"right", report.score->right},
                     {"wrong", report.score->wrong},
                     {"precision", report.score->precision()},
                     {"recall", report.score->recall()}};
  }
  return json;
}

Result<void> check_glyphs_page(const Image<Rgba8>& picture) {
  constexpr std::size_t kMostPixels = std::size_t(1) << 24;
  if (picture.pixels.size() > kMostPixels)
    return fail(
        "--html",
        fmt::format("a page of {} pixels would be too large for a browser", picture.pixels.size()),
        "give a smaller picture");
  return {};
}

Result<std::string> make_glyphs_page(const Image<Rgba8>& picture, const GlyphsReport& report,
                                     const Json& json, const std::string& command) {
  const auto uri = picture_uri(picture);
  if (!uri) return tl::unexpected(uri.error());
  Json manifest = json;
  manifest["text"] = glyphs_text(report);
  manifest["program"] = "glassbox " GLASSBOX_VERSION;
  manifest["command"] = command;
  manifest["uri"] = *uri;
  return assemble_page(kViewsGlyphsPage, "glassbox views glyphs", json_block("manifest", manifest));
}

}  // namespace glassbox::app
