#include "app/views/geometry_page.h"

#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report/picture_uri.h"
#include "viewsgeometry_page.h"  // made by html/embed.cmake

#include <glassbox/html/blob.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

Result<void> check_pictures(const GeometryInput& input) {
  if (!input.pictures) {
    return fail("--draw", "there are no pictures to draw on", "add --pair");
  }
  constexpr std::int64_t kMostPixels = std::int64_t(1) << 23;  // 3840 x 2160 fits
  const Image<Rgba8>& left = input.pictures->front();
  if (std::int64_t(left.width) * left.height <= kMostPixels) return {};
  return fail("--draw",
              fmt::format("a page of pictures of {} x {} would be too large for a browser",
                          left.width, left.height),
              fmt::format("give pictures of at most {} pixels", kMostPixels));
}

}  // namespace

Result<std::string> make_geometry_page(const GeometryInput& input, const Json& report,
                                       const GeometryPageOrigin& origin) {
  if (const auto legal = check_pictures(input); !legal) return tl::unexpected(legal.error());
  const auto left = picture_uri((*input.pictures)[0]);
  if (!left) return tl::unexpected(left.error());
  const auto right = picture_uri((*input.pictures)[1]);
  if (!right) return tl::unexpected(right.error());
  Json manifest = report;
  constexpr std::size_t kMostMatches = 2000;
  manifest["all_matches"] = input.matches.size();
  // An ordered object is a list, which moves as it grows: a reference into it is taken after that.
  if (Json& matches = manifest["matches"]; matches.size() > kMostMatches)
    matches.erase(matches.begin() + std::ptrdiff_t(kMostMatches), matches.end());
  manifest["program"] = origin.program;
  manifest["command"] = origin.command;
  manifest["picture_names"] = {{"left", input.picture_names[0]}, {"right", input.picture_names[1]}};
  manifest["pictures"] = {{"left", *left}, {"right", *right}};
  return assemble_page(kViewsGeometryPage, "glassbox views geometry",
                       json_block("manifest", manifest));
}

}  // namespace glassbox::app
