#include "cli/frames/frame_range.h"

#include <charconv>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/frames/path_file.h"

#include <glassbox/base/printable.h>

namespace glassbox {

namespace {

// A frame's number, from 1 to the largest number of frames allowed; none if the text is no such
// number.
std::optional<int> frame_number(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && number >= 1 && number <= kMaxFrames ? std::optional(number) : std::nullopt;
}

std::optional<FrameRange> range_of(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    const auto count = frame_number(text);
    return count ? std::optional(FrameRange{1, *count, *count}) : std::nullopt;
  }
  const std::string_view slice = text.substr(0, slash);
  const std::size_t dash = slice.find('-');
  const auto first = frame_number(slice.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : frame_number(slice.substr(dash + 1));
  const auto count = frame_number(text.substr(slash + 1));
  if (!first || !last || !count || *first > *last || *last > *count) return std::nullopt;
  return FrameRange{*first, *last, *count};
}

}  // namespace

FrameRange parse_frames(const std::string& text) {
  if (const auto range = range_of(text)) return *range;
  throw CLI::ValidationError(
      "--frames", fmt::format("needs N, or FIRST-LAST/N for those of N frames, in whole numbers "
                              "from 1 to {}, not {}",
                              kMaxFrames, in_quotes(text)));
}

}  // namespace glassbox
