#include "app/views/match_page.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/report/picture_uri.h"
#include "viewsmatch_page.h"  // made by html/embed.cmake

#include <glassbox/html/blob.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;
using Bytes = std::vector<std::uint8_t>;

constexpr std::int64_t kMostPixels = std::int64_t(1) << 21;  // 1920 x 1080 fits
constexpr std::int64_t kMostSums = std::int64_t(1) << 24;    // bytes, before they are packed

// 32-bit floats, the least significant byte first.
Bytes float_bytes(const Image<float>& values) {
  Bytes bytes;
  bytes.reserve(4 * values.pixels.size());
  for (const float value : values.pixels) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(std::uint8_t(bits >> shift));
  }
  return bytes;
}

// Bit 0: the right picture shows it; the others: why it was in doubt.
Bytes mark_bytes(const MatchInput& input, const views::DenseMatch& match) {
  Bytes bytes;
  for (std::size_t i = 0; i < match.doubts.pixels.size(); ++i) {
    const int visible = input.truth ? input.truth->is_visible.pixels[i] : 0;
    bytes.push_back(std::uint8_t(visible | int(match.doubts.pixels[i]) << 1));
  }
  return bytes;
}

Bytes confidence_bytes(const Image<float>& confidence) {
  Bytes bytes;
  for (const float value : confidence.pixels) bytes.push_back(std::uint8_t(255 * value + 0.5f));
  return bytes;
}

// The sums in steps, so that the greatest of those that are sought fits a byte.
struct SteppedSums {
  int step = 1;
  Bytes bytes;  // of each pixel, its disparities; 255 where the other pixel lies beside the picture
};
SteppedSums stepped(const views::CostVolume& sums) {
  SteppedSums result;
  int greatest = 0;
  const auto for_sums = [&](const auto& one) {
    for (int y = 0; y < sums.height; ++y) {
      for (int x = 0; x < sums.width; ++x) {
        for (int i = 0; i < sums.count; ++i) {
          one(int(sums.at(x, y)[i]), i >= sums.from(x) && i < sums.to(x));
        }
      }
    }
  };
  for_sums([&](int sum, bool is_sought) {
    if (is_sought) greatest = std::max(greatest, sum);
  });
  constexpr int kMost = 254;
  result.step = greatest / kMost + 1;
  for_sums([&](int sum, bool is_sought) {
    result.bytes.push_back(std::uint8_t(is_sought ? sum / result.step : 255));
  });
  return result;
}

Json calibration_json(const views::Calibration& calibration, int width, int height) {
  const views::Principal centre = views::principal_of(calibration, width, height);
  return {{"focal_px", calibration.focal_px},
          {"baseline", calibration.baseline},
          {"offset_px", calibration.offset_px},
          {"centre", {centre.x, centre.y}}};
}

Result<void> add_block(std::string& content, const char* id, const Bytes& bytes) {
  const auto packed = packed_text(bytes);
  if (!packed) return tl::unexpected(packed.error());
  content += data_block(id, *packed);
  return {};
}

}  // namespace

bool has_room_for_sums(const MatchInput& input, const views::DisparityRange& range) {
  return std::int64_t(input.left.width) * input.left.height * range.count() <= kMostSums;
}

Result<void> check_match_page(const MatchInput& input) {
  if (std::int64_t(input.left.width) * input.left.height <= kMostPixels) return {};
  return fail("--html",
              fmt::format("a page of pictures of {} x {} would be too large for a browser",
                          input.left.width, input.left.height),
              fmt::format("give pictures of at most {} pixels", kMostPixels));
}

Result<std::string> make_match_page(const MatchInput& input, const views::DenseMatch& match,
                                    const Json& report, const MatchPageOrigin& origin) {
  const auto left = picture_uri(input.left);
  if (!left) return tl::unexpected(left.error());
  const auto right = picture_uri(input.right);
  if (!right) return tl::unexpected(right.error());
  Json manifest = report;
  manifest["program"] = origin.program;
  manifest["command"] = origin.command;
  manifest["pictures"] = {{"left", *left}, {"right", *right}};
  manifest["calibration"] =
      input.calibration ? calibration_json(*input.calibration, input.left.width, input.left.height)
                        : Json(nullptr);
  manifest["has_truth"] = input.truth.has_value();
  manifest["sums_step"] = nullptr;
  std::string blocks;
  for (const auto& [id, bytes] : {std::pair{"disparity", float_bytes(match.disparity)},
                                  std::pair{"marks", mark_bytes(input, match)},
                                  std::pair{"confidence", confidence_bytes(match.confidence)}}) {
    if (const auto added = add_block(blocks, id, bytes); !added) {
      return tl::unexpected(added.error());
    }
  }
  if (input.truth) {
    const auto added = add_block(blocks, "truth", float_bytes(input.truth->disparity));
    if (!added) return tl::unexpected(added.error());
  }
  if (!match.sums.costs.empty()) {
    const SteppedSums sums = stepped(match.sums);
    manifest["sums_step"] = sums.step;
    const auto added = add_block(blocks, "sums", sums.bytes);
    if (!added) return tl::unexpected(added.error());
  }
  return assemble_page(kViewsMatchPage, "glassbox views match",
                       blocks + json_block("manifest", manifest));
}

}  // namespace glassbox::app
