#include "app/stereo/page.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report/picture_uri.h"
#include "app/stereo/maps.h"
#include "stereo_page.h"  // made by html/embed.cmake

#include <glassbox/html/blob.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

std::string hex_of(const Rgba8& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

// The largest disparity that has a colour of its own: all there is, but no more than twice the budget, because one
// thing right before the camera would leave no colours for the rest.
double disparity_limit(const DepthFindings& depth) {
  const double largest = std::max({std::abs(depth.nearest.px), std::abs(depth.farthest.px)});
  const double budget = std::max(depth.budget.in_front_px, depth.budget.behind_px);
  return budget > 0 ? std::min(largest, 2 * budget) : largest;
}

Json disparity_colours(double limit_px) {
  constexpr int kSteps = 32;  // to either side
  Json colours = Json::array();
  for (int i = -kSteps; i <= kSteps; ++i) {
    // A scale without extent has one colour, that of the window.
    colours.push_back(hex_of(disparity_colour(limit_px * i / kSteps, limit_px)));
  }
  return colours;
}

Json heat_names() {
  Json colours = Json::array();
  constexpr int kSteps = 128;
  for (int i = 0; i <= kSteps; ++i) colours.push_back(hex_of(heat_colour(double(i) / kSteps)));
  return colours;
}

double ghost_limit(const ColourFindings& colour) {
  return std::max({std::abs(colour.white_leak.left), std::abs(colour.white_leak.right),
                   colour.worst_ghost.left, colour.worst_ghost.right});
}

// Pictures by the names that the page's script knows, as data URIs.
class Pictures {
public:
  Result<void> add(const char* name, const Image<Rgba8>& image) {
    const auto uri = picture_uri(image);
    if (!uri) return tl::unexpected(uri.error());
    json_[name] = *uri;
    return {};
  }
  const Json& json() const { return json_; }

private:
  Json json_ = Json::object();
};

Result<Json> pictures_of(const StereoFindings& found) {
  const Image<Rgba8>&left = found.rendering.left.color, &right = found.rendering.right.color;
  const DepthFindings& depth = found.depth;
  const ColourFindings& colour = found.colour;
  Pictures pictures;
  Result<void> added;
  const auto add = [&](const char* name, const auto& make) {
    if (added) added = pictures.add(name, make());
  };
  add("left", [&]() -> const Image<Rgba8>& { return left; });
  add("right", [&]() -> const Image<Rgba8>& { return right; });
  add("anaglyph", [&]() -> const Image<Rgba8>& { return colour.anaglyph; });
  add("disparity", [&] {
    return disparity_picture(depth.disparity.left, depth.budget, disparity_limit(depth));
  });
  if (!depth.violations.found.empty()) {
    add("cut_left", [&] { return violation_picture(left, depth.violations.left); });
    add("cut_right", [&] { return violation_picture(right, depth.violations.right); });
  }
  add("one_eye_left", [&] { return monocular_picture(left, depth.monocular.left); });
  add("one_eye_right", [&] { return monocular_picture(right, depth.monocular.right); });
  add("rivalry", [&] { return heat_of(colour.rivalry.left, 1); });
  if (colour.measured_lenses) {
    add("ghosts", [&] {
      return heat_of(larger_of(colour.ghosts.left, colour.ghosts.right), ghost_limit(colour));
    });
  }
  add("information", [&] { return information_picture(left, found.information_map); });
  if (!added) return tl::unexpected(added.error());
  return pictures.json();
}

}  // namespace

Result<void> check_page_size(int width, int height) {
  constexpr std::int64_t kMostPixels = std::int64_t(1) << 23;  // 3840 x 2160 fits
  if (std::int64_t(width) * height <= kMostPixels) return {};
  return fail(
      "--html",
      fmt::format("a page of pictures of {} x {} would be too large for a browser", width, height),
      fmt::format("give a --size of at most {} pixels, 3840x2160 for example", kMostPixels));
}

Result<std::string> make_stereo_page(const StereoFindings& found, const Json& report,
                                     const StereoPageOrigin& origin) {
  Result<Json> pictures = pictures_of(found);
  if (!pictures) return tl::unexpected(pictures.error());
  Json manifest = report;
  manifest["program"] = origin.program;
  manifest["command"] = origin.command;
  const double limit_px = disparity_limit(found.depth);
  manifest["scales"] = {
      {"disparity", {{"limit", limit_px}, {"colours", disparity_colours(limit_px)}}},
      {"heat", heat_names()},
      {"ghost_limit", ghost_limit(found.colour)}};
  manifest["pictures"] = std::move(*pictures);
  return assemble_page(kStereoPage, "glassbox stereo", json_block("manifest", manifest));
}

}  // namespace glassbox::app
