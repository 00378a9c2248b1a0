#include "app/views/klt_page.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "viewsklt_page.h"  // made by html/embed.cmake

#include <glassbox/html/blob.h>

namespace glassbox::app {

namespace {

using Json = nlohmann::ordered_json;

// A plane of samples as 16 bits each between its least and greatest: to half a 65535th of its range.
struct Packed {
  double low = 0, high = 0;
  std::vector<std::uint8_t> bytes;
};
Packed packed(const std::vector<double>& samples) {
  Packed result;
  const auto [low, high] = std::ranges::minmax(samples);
  result.low = low;
  result.high = high;
  const double range = high > low ? high - low : 1;
  for (const double sample : samples) {
    const auto value = std::uint32_t((sample - low) / range * 65535 + 0.5);
    result.bytes.push_back(std::uint8_t(value & 255));
    result.bytes.push_back(std::uint8_t(value >> 8));
  }
  return result;
}

// Adds the planes as blocks "NAME0" ..., behind those whose ranges are there, and their ranges.
Result<void> add_planes(const std::string& name, const views::Bands& planes, Json& ranges,
                        std::string& blocks) {
  for (int i = 0; i < planes.count(); ++i) {
    const Packed plane = packed(planes.bands[std::size_t(i)].samples);
    const auto text = packed_text(plane.bytes);
    if (!text) return tl::unexpected(text.error());
    blocks += data_block(fmt::format("{}{}", name, ranges.size()), *text);
    ranges.push_back({plane.low, plane.high});
  }
  return {};
}

}  // namespace

Result<void> check_klt_page(std::uint64_t width, std::uint64_t height, std::uint64_t bands) {
  constexpr std::uint64_t kMostSamples = std::uint64_t(1) << 23;
  const std::uint64_t samples = 2 * width * height * bands;
  if (samples > kMostSamples) {
    return fail("--html",
                fmt::format("a page of {} samples would be too large for a browser", samples),
                "give smaller or fewer bands");
  }
  return {};
}

Result<std::string> make_klt_page(const KltInput& input, const KltReport& report, const Json& json,
                                  const KltPageOrigin& origin) {
  Json manifest = json;
  manifest["text"] = klt_text(input, report);
  manifest["program"] = origin.program;
  manifest["command"] = origin.command;
  std::string blocks;
  Json& bands = manifest["band_ranges"] = Json::array();
  if (const auto added = add_planes("band", input.bands, bands, blocks); !added)
    return tl::unexpected(added.error());
  Json& components = manifest["component_ranges"] = Json::array();
  const views::Bands dropped =
      views::components_of(input.bands, report.klt, input.bands.count(), report.kept);
  for (const views::Bands* planes : {&report.components, &dropped}) {
    if (const auto added = add_planes("component", *planes, components, blocks); !added)
      return tl::unexpected(added.error());
  }
  return assemble_page(kViewsKltPage, "glassbox views klt",
                       json_block("manifest", manifest) + blocks);
}

}  // namespace glassbox::app
