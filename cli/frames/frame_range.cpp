#include "cli/frames/frame_range.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
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
  throw CLI::ValidationError("--frames",
                             fmt::format("needs N, or FIRST-LAST/N for frames FIRST to LAST of N, "
                                         "in whole numbers from 1 to {}, not {}",
                                         kMaxFrames, in_quotes(text)));
}

namespace {

namespace fs = std::filesystem;

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

tl::unexpected<Error> bad_pattern(const std::string& output, const std::string& cause) {
  return tl::unexpected<Error>(Error{
      output, "", cause, "write %d or %04d where the number goes, and %% for a per cent sign"});
}

}  // namespace

Result<FrameNames> FrameNames::from_output(const std::string& output, const std::string& usual,
                                           int count) {
  std::string whole = output.empty() ? usual : output;
  std::error_code ignored;
  if (whole.ends_with('/') || fs::is_directory(whole, ignored)) {
    whole = (fs::path(whole) / usual).string();
  }
  FrameNames names;
  names.digits_ = std::max(4, int(std::to_string(count).size()));
  if (output.find('%') == std::string::npos) {
    const fs::path path(whole);
    names.before_ = (path.parent_path() / path.stem()).string() + "-";
    names.after_ = path.extension().string();
    return names;
  }
  bool numbered = false;
  std::string* part = &names.before_;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (whole[i] != '%') {
      *part += whole[i];
      continue;
    }
    if (whole.compare(i, 2, "%%") == 0) {
      *part += '%';
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (end < whole.size() && is_digit(whole[end])) ++end;
    const std::string width = whole.substr(i + 1, end - i - 1);
    const bool legal = end < whole.size() && whole[end] == 'd' &&
                       (width.empty() || (width.size() == 2 && width[0] == '0'));
    if (!legal) return bad_pattern(output, "the name has a % that does not begin a frame number");
    if (numbered) return bad_pattern(output, "the name has two places for the frame number");
    numbered = true;
    names.digits_ = width.empty() ? 1 : width[1] - '0';
    part = &names.after_;
    i = end;
  }
  if (!numbered) return bad_pattern(output, "the name has no place for the frame number");
  return names;
}

std::string FrameNames::name(int number) const {
  return fmt::format("{}{:0{}}{}", before_, number, digits_, after_);
}

std::string FrameNames::plot() const {
  const fs::path path(before_);
  std::string stem = path.filename().string();
  while (!stem.empty() && (stem.back() == '-' || stem.back() == '_' || stem.back() == '.')) {
    stem.pop_back();
  }
  return (path.parent_path() / ((stem.empty() ? "frames" : stem) + ".svg")).string();
}

}  // namespace glassbox
