#include "views/files/colmap_file.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "views/files/number_rows.h"

#include <glassbox/base/printable.h>

namespace glassbox::views {

namespace {

struct Line {
  std::size_t number = 0;  // from 1
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
std::vector<Line> lines_of(std::string_view text) {
  std::vector<Line> lines;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.empty() || line.front() != '#') lines.push_back({number, words_of(line)});
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

Result<std::vector<double>> numbers_of(const Line& line, std::size_t first, std::size_t count,
                                       const char* file) {
  const std::string place = fmt::format("{}, line {}", file, line.number);
  if (line.words.size() < first + count) {
    return fail(
        place,
        fmt::format("has {} of the {} words that are needed", line.words.size(), first + count),
        "export the model from COLMAP again, as text");
  }
  std::vector<double> numbers;
  for (std::size_t i = first; i < first + count; ++i) {
    const auto number = number_of(line.words[i]);
    if (!number) {
      constexpr std::size_t kShort = 40;
      return fail(place,
                  in_quotes(std::string(line.words[i].substr(0, kShort))) + " is not a number",
                  "export the model from COLMAP again, as text");
    }
    numbers.push_back(*number);
  }
  return numbers;
}

// How the parameters of a camera model are read: one or two focal lengths, then the principal
// point, then distortion.
struct Model {
  std::string_view name;
  std::size_t focal, distortion;
};
constexpr Model kModels[] = {{"SIMPLE_PINHOLE", 1, 0}, {"PINHOLE", 2, 0}, {"SIMPLE_RADIAL", 1, 1},
                             {"RADIAL", 1, 2},         {"OPENCV", 2, 4},  {"FULL_OPENCV", 2, 8}};

Result<Matrix3d> lens_of(const Line& line) {
  const std::string place = fmt::format("cameras.txt, line {}", line.number);
  if (line.words.size() < 2) {
    return fail(place, "a camera needs a number, a model, a width, a height and parameters",
                "export the model from COLMAP again, as text");
  }
  const auto model = std::ranges::find(kModels, line.words[1], &Model::name);
  if (model == std::end(kModels)) {
    constexpr std::size_t kShort = 40;
    return fail(place,
                in_quotes(std::string(line.words[1].substr(0, kShort))) + " is not a pinhole model",
                "undistort the pictures (colmap image_undistorter), which makes the model PINHOLE");
  }
  const auto read = numbers_of(line, 4, model->focal + 2 + model->distortion, "cameras.txt");
  if (!read) return tl::unexpected(read.error());
  const double fx = (*read)[0], fy = (*read)[model->focal - 1];
  if (!(fx > 0) || !(fy > 0)) {
    return fail(place, "a focal length is not positive",
                "calibrate the camera again, and export the model as text");
  }
  for (std::size_t i = model->focal + 2; i < read->size(); ++i) {
    if ((*read)[i] == 0) continue;
    return fail(
        place, "the camera has distortion, but only pinhole cameras without distortion can be read",
        "undistort the pictures (colmap image_undistorter), which makes the model PINHOLE");
  }
  Matrix3d k;
  k << fx, 0, (*read)[model->focal], 0, fy, (*read)[model->focal + 1], 0, 0, 1;
  return k;
}

Result<std::map<std::string_view, Matrix3d>> lenses_of(std::string_view text) {
  std::map<std::string_view, Matrix3d> lenses;
  for (const Line& line : lines_of(text)) {
    if (line.words.empty()) continue;
    const auto lens = lens_of(line);
    if (!lens) return tl::unexpected(lens.error());
    if (!lenses.emplace(line.words[0], *lens).second) {
      return fail(fmt::format("cameras.txt, line {}", line.number),
                  "another camera has the same number", "give each camera its own number");
    }
  }
  return lenses;
}

Result<NamedCamera> camera_of(const Line& line,
                              const std::map<std::string_view, Matrix3d>& lenses) {
  const std::string place = fmt::format("images.txt, line {}", line.number);
  const auto read = numbers_of(line, 1, 7, "images.txt");
  if (!read) return tl::unexpected(read.error());
  if (line.words.size() != 10) {
    return fail(place,
                "a picture needs ten words: its number, four numbers of the rotation, three of the "
                "translation, the camera's number and a name",
                "export the model again; names must have no blanks");
  }
  const std::vector<double>& n = *read;
  const Eigen::Quaterniond turn(n[0], n[1], n[2], n[3]);
  constexpr double kFewDigits = 1e-3;
  if (!(std::abs(turn.norm() - 1) <= kFewDigits)) {
    return fail(place,
                fmt::format("the length of the quaternion is {:.3g}, but a rotation needs length 1",
                            turn.norm()),
                "give a quaternion of length 1");
  }
  const auto lens = lenses.find(line.words[8]);
  if (lens == lenses.end()) {
    return fail(place, "cameras.txt has no camera with the number that this picture names",
                "export both files together");
  }
  NamedCamera camera{std::string(line.words[9]), {}};
  camera.camera.intrinsic = lens->second;
  camera.camera.camera_from_world = turn.normalized().toRotationMatrix();
  camera.camera.centre = -camera.camera.camera_from_world.transpose() * Vector3d(n[4], n[5], n[6]);
  return camera;
}

}  // namespace

Result<std::vector<NamedCamera>> parse_colmap(std::string_view cameras, std::string_view images) {
  const auto lenses = lenses_of(cameras);
  if (!lenses) return tl::unexpected(lenses.error());
  std::vector<NamedCamera> all;
  // Each picture's line is followed by a line of its points, which may be empty.
  const std::vector<Line> lines = lines_of(images);
  for (std::size_t i = 0; i < lines.size(); i += 2) {
    if (lines[i].words.empty()) {
      if (i + 1 >= lines.size()) break;
      return fail(fmt::format("images.txt, line {}", lines[i].number),
                  "is empty, but should describe a picture",
                  "export the model from COLMAP again, as text");
    }
    auto camera = camera_of(lines[i], *lenses);
    if (!camera) return tl::unexpected(camera.error());
    all.push_back(std::move(*camera));
  }
  std::ranges::sort(all, {}, &NamedCamera::picture);
  const auto twice = std::ranges::adjacent_find(all, {}, &NamedCamera::picture);
  if (twice != all.end()) {
    return fail("images.txt", "two pictures have the name " + in_quotes(twice->picture),
                "give each picture its own name");
  }
  return all;
}

}  // namespace glassbox::views
