#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "views/files/colmap_model.h"
#include "views/files/number_rows.h"

#include <glassbox/base/printable.h>

namespace glassbox::views {

namespace {

constexpr const char* kExport = "export the model from COLMAP again, as text";

struct Line {
  std::string place;  // "images.txt, line 3"
  std::vector<std::string_view> words;
};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  constexpr std::string_view kBlanks = " \t\r";
  while (true) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return words;
    text.remove_prefix(begin);
    const std::size_t length = std::min(text.find_first_of(kBlanks), text.size());
    words.push_back(text.substr(0, length));
    text.remove_prefix(length);
  }
}

// All lines except comments. Empty lines are kept, because a picture without points has an empty
// line for its points.
std::vector<Line> lines_of(const char* file, std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.empty() || line.front() != '#') {
      lines.push_back({fmt::format("{}, line {}", file, number), words_of(line)});
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

Result<std::vector<double>> numbers_of(const Line& line, std::size_t first, std::size_t count) {
  if (line.words.size() < first + count) {
    return fail(
        line.place,
        fmt::format("has {} of the {} words that are needed", line.words.size(), first + count),
        kExport);
  }
  std::vector<double> numbers;
  for (std::size_t i = first; i < first + count; ++i) {
    const auto number = number_of(line.words[i]);
    if (!number) return fail(line.place, in_quotes(line.words[i]) + " is not a number", kExport);
    numbers.push_back(*number);
  }
  return numbers;
}

// The number of a camera, which is its name.
Result<std::int64_t> id_of(const Line& line, std::size_t word) {
  const auto number = number_of(line.words[word]);
  constexpr double kMax = 9007199254740992;  // 2^53: up to here a double holds every whole number
  if (number && *number == std::floor(*number) && std::abs(*number) <= kMax) {
    return std::int64_t(*number);
  }
  return fail(line.place, in_quotes(line.words[word]) + " is not the number of a camera", kExport);
}

Result<ColmapLens> lens_of(const Line& line) {
  if (line.words.size() < 2) {
    return fail(line.place, "a camera needs a number, a model, a width, a height and parameters",
                kExport);
  }
  const auto kind = std::ranges::find(kColmapLensKinds, line.words[1], &ColmapLensKind::name);
  if (kind == std::end(kColmapLensKinds)) {
    return fail(line.place, in_quotes(line.words[1]) + " is not a pinhole model",
                "undistort the pictures (colmap image_undistorter), which makes the model PINHOLE");
  }
  const auto read = numbers_of(line, 2, 2 + kind->parameters);
  if (!read) return tl::unexpected(read.error());
  const auto size = colmap_size(line.place, (*read)[0], (*read)[1]);
  if (!size) return tl::unexpected(size.error());
  return ColmapLens{line.place, *kind, *size, {read->begin() + 2, read->end()}};
}

Result<ColmapLenses> lenses_of(std::string_view text) {
  ColmapLenses lenses;
  for (const Line& line : lines_of("cameras.txt", text)) {
    if (line.words.empty()) continue;
    const auto id = id_of(line, 0);
    if (!id) return tl::unexpected(id.error());
    if (!lenses.emplace(*id, lens_of(line)).second) {
      return fail(line.place, "another camera has the same number",
                  "give each camera its own number");
    }
  }
  return lenses;
}

Result<ColmapPicture> picture_of(const Line& line) {
  const auto read = numbers_of(line, 1, 7);
  if (!read) return tl::unexpected(read.error());
  if (line.words.size() != 10) {
    return fail(line.place,
                "a picture needs ten words: its number, four numbers of the rotation, three of the "
                "translation, the camera's number and a name",
                "export the model again; names must have no blanks");
  }
  const auto lens = id_of(line, 8);
  if (!lens) return tl::unexpected(lens.error());
  const std::vector<double>& n = *read;
  return ColmapPicture{
      line.place, {n[0], n[1], n[2], n[3]}, {n[4], n[5], n[6]}, *lens, std::string(line.words[9])};
}

}  // namespace

Result<ColmapModel> parse_colmap(std::string_view cameras, std::string_view images) {
  const auto lenses = lenses_of(cameras);
  if (!lenses) return tl::unexpected(lenses.error());
  std::vector<ColmapPicture> pictures;
  // Each picture's line is followed by a line of its points, which may be empty.
  const std::vector<Line> lines = lines_of("images.txt", images);
  for (std::size_t i = 0; i < lines.size(); i += 2) {
    if (lines[i].words.empty()) {
      if (i + 1 >= lines.size()) break;
      return fail(lines[i].place, "is empty, but should describe a picture", kExport);
    }
    auto picture = picture_of(lines[i]);
    if (!picture) return tl::unexpected(picture.error());
    pictures.push_back(std::move(*picture));
  }
  return colmap_model(*lenses, pictures);
}

}  // namespace glassbox::views
