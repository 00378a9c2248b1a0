#include "labs/framework/strip_solution.h"

#include <cctype>
#include <map>
#include <string_view>

#include <fmt/format.h>

namespace glassbox::labs {

namespace {

std::string_view trimmed_line(std::string_view line) {
  while (!line.empty() && std::isspace(static_cast<unsigned char>(line.front())))
    line.remove_prefix(1);
  while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())))
    line.remove_suffix(1);
  return line;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    if (end == std::string_view::npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

// The letters of a line in lower case, by which a misspelt marker is recognised.
std::string letters_of(std::string_view line) {
  std::string letters;
  for (const char c : line) {
    if (std::isalpha(static_cast<unsigned char>(c)))
      letters += char(std::tolower(static_cast<unsigned char>(c)));
  }
  return letters;
}

bool looks_like_marker(std::string_view line) {
  const std::string_view text = trimmed_line(line);
  if (!text.starts_with("//") && !text.starts_with("/*")) return false;
  const std::string letters = letters_of(text);
  for (const char* marker : {"beginsolution", "endsolution", "beginhidden", "endhidden"}) {
    if (letters.starts_with(marker)) return true;
  }
  return text.substr(2).starts_with("STUB") || trimmed_line(text.substr(2)).starts_with("STUB:");
}

constexpr std::string_view kStub = "// STUB:";

class Stripper {
public:
  explicit Stripper(const std::string& name) : name_(name) {}

  // Processes one line. An error says why the line is not allowed at this place.
  Result<void> take(std::string_view line) {
    ++number_;
    const std::string_view text = trimmed_line(line);
    if (text == "// BEGIN SOLUTION") return begin(Region::kSolution);
    if (text == "// BEGIN HIDDEN") return begin(Region::kHidden);
    if (text == "// END SOLUTION") return end(Region::kSolution);
    if (text == "// END HIDDEN") return end(Region::kHidden);
    if (text.starts_with(kStub)) return stub(line);
    if (looks_like_marker(line))
      return error(fmt::format("\"{}\" looks like a marker, but is misspelt", text),
                   "write it exactly as // BEGIN SOLUTION, // STUB: code, // END SOLUTION, // "
                   "BEGIN HIDDEN or // END HIDDEN, alone on its line");
    if (region_ == Region::kNone) keep(line);
    return {};
  }

  Result<std::string> finish() {
    if (region_ == Region::kNone) return std::move(kept_);
    number_ = opened_;
    return tl::unexpected(error(fmt::format("{} has no end", region_name(region_)),
                                fmt::format("close it with // END {}", marker_word(region_)))
                              .error());
  }

private:
  enum class Region { kNone, kSolution, kHidden };

  static const char* region_name(Region region) {
    return region == Region::kHidden ? "a hidden part" : "a solution";
  }
  static const char* marker_word(Region region) {
    return region == Region::kHidden ? "HIDDEN" : "SOLUTION";
  }

  void keep(std::string_view line) {
    kept_ += line;
    kept_ += '\n';
  }

  Result<void> begin(Region region) {
    if (region_ != Region::kNone)
      return error(fmt::format("{} begins inside the one that begins in line {}",
                               region_name(region), opened_),
                   "end the part that began first: such parts cannot be nested");
    region_ = region;
    opened_ = number_;
    stubs_ = 0;
    return {};
  }

  Result<void> end(Region region) {
    if (region_ != region)
      return error(fmt::format("{} ends here, but does not begin anywhere", region_name(region)),
                   fmt::format("open it with // BEGIN {}", marker_word(region)));
    if (region == Region::kSolution && stubs_ == 0) {
      number_ = opened_;
      return error("a solution has no // STUB: line",
                   "write after // STUB: what students get instead of the solution, such as // "
                   "STUB: return {};");
    }
    region_ = Region::kNone;
    return {};
  }

  Result<void> stub(std::string_view line) {
    if (region_ != Region::kSolution)
      return error("a // STUB: line is outside of a solution",
                   "put it between // BEGIN SOLUTION and // END SOLUTION");
    ++stubs_;
    const std::size_t indent = line.find(kStub);
    std::string_view code = line.substr(indent + kStub.size());
    if (code.starts_with(' ')) code.remove_prefix(1);
    keep(std::string(line.substr(0, indent)) + std::string(code));
    return {};
  }

  Result<void> error(std::string cause, std::string remedy) const {
    return tl::unexpected(
        Error{name_, fmt::format("line {}", number_), std::move(cause), std::move(remedy)});
  }

  std::string name_, kept_;
  Region region_ = Region::kNone;
  int number_ = 0, opened_ = 0, stubs_ = 0;
};

}  // namespace

Result<std::string> strip_solution(const std::string& text, const std::string& name) {
  Stripper stripper(name);
  for (const std::string_view line : lines_of(text)) {
    if (auto taken = stripper.take(line); !taken) return tl::unexpected(taken.error());
  }
  return stripper.finish();
}

std::vector<Leak> find_leaks(const std::string& solution, const std::string& starter) {
  // The lines that the starter may have, and how often: every line that is not between two markers,
  // and the stubs.
  std::map<std::string, int, std::less<>> allowed;
  // lines of the solution, each with its line number
  std::map<std::string, int, std::less<>> secret;
  int inside = 0, number = 0;
  for (const std::string_view line : lines_of(solution)) {
    ++number;
    const std::string text(trimmed_line(line));
    const std::string letters = letters_of(text);
    const bool comment = text.starts_with("/");
    if (comment && (letters == "beginsolution" || letters == "beginhidden")) {
      ++inside;
    } else if (comment && (letters == "endsolution" || letters == "endhidden")) {
      --inside;
    } else if (inside > 0 && text.starts_with("// STUB:")) {
      ++allowed[std::string(trimmed_line(std::string_view(text).substr(8)))];
    } else if (inside > 0) {
      secret.try_emplace(text, number);
    } else {
      ++allowed[text];
    }
  }
  std::vector<Leak> leaks;
  for (const std::string_view line : lines_of(starter)) {
    const std::string text(trimmed_line(line));
    if (text.empty()) continue;
    const auto found = allowed.find(text);
    if (found != allowed.end() && --found->second >= 0) continue;
    const auto from = secret.find(text);
    leaks.push_back({from != secret.end() ? from->second : 0, text});
  }
  return leaks;
}

}  // namespace glassbox::labs
