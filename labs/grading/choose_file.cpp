#include "labs/grading/choose_file.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <string_view>
#include <tuple>

#include <fmt/format.h>

#include <glassbox/base/ascii_case.h>
#include <glassbox/base/printable.h>

namespace glassbox::labs::grading {

namespace {

namespace fs = std::filesystem;

struct Numbered {
  std::string stem;  // the name without number and ending
  int number = 0;    // 0: the name has none
};

// Separates the number of a copy from a name without its ending: "a (1)", "a(1)", "a-1".
Numbered numbered(const std::string& stem) {
  constexpr std::size_t kMostDigits = 6;
  const bool in_brackets = stem.ends_with(')');
  const std::size_t end = stem.size() - (in_brackets ? 1 : 0);
  std::size_t begin = end;
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(stem[begin - 1])) != 0) --begin;
  const std::size_t digits = end - begin;
  if (digits == 0 || digits > kMostDigits || begin < 2) return {stem, 0};
  if (stem[begin - 1] != (in_brackets ? '(' : '-')) return {stem, 0};
  const std::size_t blank = in_brackets && stem[begin - 2] == ' ' ? 1 : 0;
  return {stem.substr(0, begin - 1 - blank), std::stoi(stem.substr(begin, digits))};
}

auto depth(const fs::path& path) {
  return std::distance(path.begin(), path.end());
}

// Where a path comes in the order; a smaller one is taken.
auto order_of(const fs::path& path, const std::string& wanted) {
  const std::string name = path.filename().string();
  const int number = lower_case(name) == lower_case(wanted) ? 0 : numbered(path.stem()).number;
  return std::tuple(depth(path), name != wanted, number != 0, -number, path.generic_string());
}

auto order_of_archive(const fs::path& path) {
  const int number = numbered(archive_stem(path)).number;
  return std::tuple(depth(path), number != 0, -number, path.generic_string());
}

}  // namespace

std::string archive_stem(const fs::path& file) {
  const std::string name = file.filename().string(), lower = lower_case(name);
  for (const std::string_view end :
       {".zip", ".7z", ".rar", ".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tar.xz", ".tar.zst"}) {
    if (lower.ends_with(end)) return name.substr(0, name.size() - end.size());
  }
  return name;
}

bool has_wanted_name(const fs::path& file, const std::string& wanted) {
  const fs::path name = lower_case(file.filename().string()), other = lower_case(wanted);
  if (name == other) return true;
  return name.extension() == other.extension() &&
         numbered(name.stem().string()).stem == other.stem().string();
}

bool is_taken_before(const fs::path& a, const fs::path& b, const std::string& wanted) {
  return order_of(a, wanted) < order_of(b, wanted);
}

bool is_archive_taken_before(const fs::path& a, const fs::path& b) {
  return order_of_archive(a) < order_of_archive(b);
}

bool is_ignored(const fs::path& path) {
  return std::any_of(path.begin(), path.end(), [](const fs::path& part) {
    return part.native().starts_with('.') || part == "__MACOSX";
  });
}

std::string note_of_choice(const fs::path& taken, std::vector<fs::path> not_taken,
                           const std::string& wanted) {
  constexpr std::size_t kNamed = 8, kLongestName = 120;
  if (not_taken.empty() && taken.filename() == wanted) return {};
  std::string note = fmt::format("Graded: {}.\n", printable(taken.generic_string(), kLongestName));
  if (not_taken.empty()) return note;
  std::sort(not_taken.begin(), not_taken.end());
  note += "Not graded: ";
  for (std::size_t i = 0; i < std::min(not_taken.size(), kNamed); ++i)
    note += (i == 0 ? "" : ", ") + printable(not_taken[i].generic_string(), kLongestName);
  if (not_taken.size() > kNamed) note += fmt::format(", and {} more", not_taken.size() - kNamed);
  return note +
         fmt::format(
             ".\nOne file is graded: the one in the fewest folders, then the one that is called "
             "{}, then the copy with the highest number.\n",
             wanted);
}

}  // namespace glassbox::labs::grading
