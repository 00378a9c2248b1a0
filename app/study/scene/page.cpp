#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/stereo/maps.h"
#include "app/study/scene/curve_report.h"
#include "curve_page.h"  // made by html/embed.cmake

#include <glassbox/compare/metrics/flip.h>
#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/html/blob.h>
#include <glassbox/images/stored_image.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;
using Picture = Image<Rgba8>;

// Red, green and blue, a plane each: planes of differences are packed smaller than pixels.
template <class Value>
std::vector<std::uint8_t> planes(const Picture& picture, const Value& value) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * picture.pixels.size());
  for (const auto channel : {&Rgba8::r, &Rgba8::g, &Rgba8::b}) {
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
      bytes.push_back(std::uint8_t(value(i, channel)));
  }
  return bytes;
}

std::vector<std::uint8_t> planes_of(const Picture& picture) {
  return planes(picture, [&](std::size_t i, auto channel) { return picture.pixels[i].*channel; });
}

// Each byte less the other picture's, modulo 256.
std::vector<std::uint8_t> difference_planes(const Picture& picture, const Picture& from) {
  return planes(picture, [&](std::size_t i, auto channel) {
    return picture.pixels[i].*channel - from.pixels[i].*channel;
  });
}

std::size_t differing(const Picture& a, const Picture& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) count += a.pixels[i] != b.pixels[i];
  return count;
}

// Of the pictures before this one, the one that it differs from in the fewest pixels; none where that is the reference.
std::optional<std::size_t> nearest_before(const study::Curve& curve, std::size_t picture) {
  std::optional<std::size_t> nearest;
  std::size_t fewest = differing(curve.pictures[picture], curve.reference);
  for (std::size_t i = 0; i < picture; ++i) {
    const std::size_t count = differing(curve.pictures[picture], curve.pictures[i]);
    if (count >= fewest) continue;
    fewest = count;
    nearest = i;
  }
  return nearest;
}

// Levels of heat_map.h, of which every eighth is enough to look at.
std::vector<std::uint8_t> flip_levels(const Picture& picture, const Picture& reference) {
  const StoredImage test = as_stored(picture), right = as_stored(reference);
  const Selection all(picture.width, picture.height);
  std::vector<std::uint8_t> levels;
  for (const std::uint8_t level : flip_heat_map(PicturePair{right, test, all}).pixels)
    levels.push_back(std::uint8_t(std::min((level + 7) / 8 * 8, int(kHeatHottest))));
  return levels;
}

// By level, from black for nothing to be seen.
Json colours_of_levels() {
  Json colours = Json::array();
  for (int level = 0; level <= kHeatHottest; ++level) {
    const Rgba8 colour = heat_colour(double(level) / kHeatHottest);
    colours.push_back({colour.r, colour.g, colour.b});
  }
  return colours;
}

// Blocks of the page, one after the other.
class Blocks {
public:
  void add(const std::string& id, const std::vector<std::uint8_t>& bytes) {
    if (!added_) return;
    auto packed = packed_text(bytes);
    if (packed)
      text_ += data_block(id, *packed);
    else
      added_ = tl::unexpected(packed.error());
  }
  Result<std::string> text() && {
    if (!added_) return tl::unexpected(added_.error());
    return std::move(text_);
  }

private:
  std::string text_;
  Result<void> added_;
};

}  // namespace

Result<std::string> curve_page(const CurveReport& report) {
  const study::Curve& curve = report.curve;
  Json manifest = curve_json(report);
  manifest["heat"] = colours_of_levels();
  // Most pictures are nearly another one's, and stand as what they differ from it by.
  Json& bases = manifest["bases"] = Json::array();
  Blocks blocks;
  blocks.add("reference", planes_of(curve.reference));
  for (std::size_t i = 0; i < curve.pictures.size(); ++i) {
    const Picture& picture = curve.pictures[i];
    const auto base = nearest_before(curve, i);
    bases.push_back(base ? Json(*base) : Json(nullptr));
    const Picture& from = base ? curve.pictures[*base] : curve.reference;
    blocks.add(fmt::format("difference{}", i), difference_planes(picture, from));
    blocks.add(fmt::format("flip{}", i), flip_levels(picture, curve.reference));
  }
  if (!report.second_eyes.warped.empty()) {
    const std::vector<views::SecondEyeError>& warped = report.second_eyes.warped;
    const Picture& drawn = warped.front().drawn;
    blocks.add("right-eye", planes_of(drawn));
    for (const views::SecondEyeError& eye : warped)
      blocks.add(fmt::format("right-eye-warp:{}", eye.layers),
                 difference_planes(eye.picture, drawn));
    blocks.add("right-eye-left", difference_planes(warped.front().left_picture, drawn));
  }
  return std::move(blocks).text().map([&](const std::string& text) {
    return assemble_page(kCurvePage, "glassbox study scene",
                         json_block("manifest", manifest) + text);
  });
}

}  // namespace glassbox::app
