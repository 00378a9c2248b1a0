#include "cli/frames/frame_names.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

namespace glassbox {

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

Result<FrameNames> FrameNames::of(const std::string& output, const std::string& usual, int count) {
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
    if (!legal) return bad_pattern(output, "this is no place for a number");
    if (numbered) return bad_pattern(output, "there are two places for the number");
    numbered = true;
    names.digits_ = width.empty() ? 1 : width[1] - '0';
    part = &names.after_;
    i = end;
  }
  if (!numbered) return bad_pattern(output, "there is no place for the number");
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
