// Lab 12 in a picture: the student's functions pack the left eye's layers, warp them to the right
// eye and draw them as splats, in an order in which later samples are nearer.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/LU>

#include "labs/12-layers/cases.h"
#include "labs/drawing/drawing.h"
#include "views/layers/depth_peeling.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_camera.h"

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>

namespace glassbox::labs {

namespace lab_12_drawing {

constexpr int kLayers = 3;
constexpr int kRows = 16;  // how many rows of a picture one question has
constexpr double kEpsilon = 0x1p-10;
constexpr double kMaxPx = 64;
using Screens = Transform<Screen, Screen>;

// ---- the reference ----

struct Sample {
  int x, y;
  float depth;
  double colour;
};

Numbers pack(RecordReader& in) {
  const int width = in.integer(), height = in.integer();
  const double epsilon = in.number();
  std::vector<std::vector<Sample>> pixels(std::size_t(width) * std::size_t(height));
  while (in.more()) {
    const int x = in.integer(), y = in.integer();
    const float depth = in.real();
    pixels[std::size_t(height - 1 - y) * std::size_t(width) + std::size_t(x)].push_back(
        {x, y, depth, in.number()});
  }
  Numbers out{0}, samples;
  for (std::vector<Sample>& here : pixels) {
    std::ranges::stable_sort(here, std::greater<>(), &Sample::depth);
    std::vector<Sample> kept;
    for (const Sample& s : here) {
      const double front = kept.empty() ? 0 : double(kept.back().depth);
      if (kept.empty() || front - double(s.depth) > epsilon * front) kept.push_back(s);
    }
    for (std::size_t i = kept.size(); i-- > 0;)
      samples.insert(samples.end(), {double(kept[i].depth), kept[i].colour});
    out.push_back(double(samples.size() / 2));
  }
  out.insert(out.end(), samples.begin(), samples.end());
  return out;
}

views::LayerCamera camera(RecordReader& in) {
  return {views::matrix_of(in.matrix<Transform<Screen, World>>()), 0, 0};
}

Numbers matrix(RecordReader& in) {
  const views::LayerCamera first = camera(in), second = camera(in);
  const Eigen::Matrix4d warp = views::warp_matrix(second, first);
  Numbers out;
  for (int i = 0; i < 16; ++i) out.push_back(warp(i / 4, i % 4));
  return out;
}

// The sums start anew every 64 pixels, as in the sample solution. A different order of additions
// has other rounding errors, with which one sample in some thousands would be at another pixel.
Numbers row(RecordReader& in) {
  const auto warp = in.matrix<Screens>();
  const int y = in.integer();
  std::array<float, 4> start{};
  Numbers out;
  for (int x = 0; in.more(); ++x) {
    for (int i = 0; i < 4; ++i) {
      float& sum = start[std::size_t(i)];
      sum = x % 64 == 0
                ? float(warp.at(i, 0) * (x + 0.5) + warp.at(i, 1) * (y + 0.5) + warp.at(i, 3))
                : sum + float(warp.at(i, 0));
    }
    for (int count = in.integer(); count > 0; --count) {
      const float z = in.real();
      for (int i = 0; i < 4; ++i)
        out.push_back(double(start[std::size_t(i)] + z * float(warp.at(i, 2))));
    }
  }
  return out;
}

Numbers size(RecordReader& in) {
  const double focal_ratio = in.number();
  Numbers out;
  while (in.more()) {
    const double side = focal_ratio / in.number();
    out.insert(out.end(), {std::clamp(side, 1.0, kMaxPx), side > kMaxPx ? 1.0 : 0.0});
  }
  return out;
}

Numbers order(RecordReader& in) {
  const double epipole = in.number(), w = in.number();
  const std::vector<int> visits = views::visiting_order(epipole, w, in.integer());
  return {visits.begin(), visits.end()};
}

Numbers draw_samples(RecordReader& in) {
  const int width = in.integer(), height = in.integer();
  Numbers picture(std::size_t(width) * std::size_t(height), in.number());
  while (in.more()) {
    const double xw = in.number(), yw = in.number(), zw = in.number(), w = in.number();
    const double half = in.number() / 2, colour = in.number();
    if (!(w > 0) || zw / w > 1) continue;
    const auto edge = [](double v, int end) {
      return int(std::clamp(std::floor(v + 0.5), 0.0, double(end)));
    };
    const int right = edge(xw / w + half, width), bottom = edge(yw / w + half, height);
    for (int j = edge(yw / w - half, height); j < bottom; ++j) {
      for (int i = edge(xw / w - half, width); i < right; ++i)
        picture[std::size_t(j) * std::size_t(width) + std::size_t(i)] = colour;
    }
  }
  return picture;
}

// ---- judgement ----

std::optional<WrongNumber> judge_exactly(const Numbers& yours, const Numbers& reference,
                                         const std::function<std::string(std::size_t)>& name) {
  const auto nothing = [](std::size_t) { return 0; };
  return first_wrong(yours, reference, nothing, "", name);
}

std::optional<WrongNumber> judge_pack(const Numbers& in, const Numbers& yours,
                                      const Numbers& reference) {
  const auto offsets = std::size_t(in[0] * in[1]) + 1;
  return judge_exactly(yours, reference, [&](std::size_t i) {
    if (i < offsets) return fmt::format("offset of pixel {}", i);
    const std::size_t k = i - offsets;
    return fmt::format("{} of sample {}", k % 2 == 0 ? "depth" : "colour", k / 2);
  });
}

// The bound of student.h for the student's matrix, and as much for the reference's, which is also
// computed with an inverse in double.
std::optional<WrongNumber> judge_matrix(const Numbers& in, const Numbers& yours,
                                        const Numbers& reference) {
  using ByRows = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  const Eigen::Matrix4d first = Eigen::Map<const ByRows>(in.data()),
                        second = Eigen::Map<const ByRows>(in.data() + 16);
  const Eigen::Matrix4d inverse = first.inverse().cwiseAbs();
  const Eigen::Matrix4d sizes = second.cwiseAbs() * inverse * first.cwiseAbs() * inverse;
  return first_wrong(
      yours, reference,
      [&](std::size_t i) {
        return 2 * 256 * unit_roundoff<double> * sizes.row(Eigen::Index(i / 4)).maxCoeff();
      },
      "", [](std::size_t i) { return fmt::format("row {}, column {}", i / 4, i % 4); });
}

// The bound: 72 u of the largest coordinate of the row for the student's answer, and as much for
// the reference's. u is the unit roundoff of float.
std::optional<WrongNumber> judge_row(const Numbers& in, const Numbers& yours,
                                     const Numbers& reference) {
  std::array<double, 4> largest{};
  for (std::size_t i = 0; i < reference.size(); ++i)
    largest[i % 4] = std::max(largest[i % 4], std::abs(reference[i]));
  // The bound needs |start| + |added|, where `added` is the depth (at most 1) times the third
  // column of the matrix. |start| is at most the coordinate's size plus |added|, hence the 2.
  for (std::size_t i = 0; i < 4; ++i) largest[i] += 2 * std::abs(in[4 * i + 2]);
  return first_wrong(
      yours, reference,
      [&](std::size_t i) { return 2 * 72 * double(unit_roundoff<float>) * largest[i % 4]; }, "",
      [](std::size_t i) {
        static constexpr const char* kNames[] = {"x w", "y w", "z w", "w"};
        return fmt::format("sample {}, {}", i / 4, kNames[i % 4]);
      });
}

std::optional<WrongNumber> judge_size(const Numbers&, const Numbers& yours,
                                      const Numbers& reference) {
  return first_wrong(
      yours, reference,
      [&](std::size_t i) { return i % 2 == 0 ? 16 * unit_roundoff<double> * reference[i] : 0; },
      "px",
      [](std::size_t i) {
        return fmt::format("sample {}, {}", i / 2, i % 2 == 0 ? "side" : "is cut");
      });
}

std::optional<WrongNumber> judge_order(const Numbers&, const Numbers& yours,
                                       const Numbers& reference) {
  return judge_exactly(yours, reference, [](std::size_t i) { return fmt::format("visit {}", i); });
}

std::optional<WrongNumber> judge_draw(const Numbers& in, const Numbers& yours,
                                      const Numbers& reference) {
  const auto width = std::size_t(in[0]);
  return judge_exactly(yours, reference, [&](std::size_t i) {
    return fmt::format("row {} of {}, column {}", i / width, in[1], i % width);
  });
}

const std::vector<DrawnStage>& stages() {
  static const std::vector<DrawnStage> all{
      {"pack", "eye", "pack", pack, judge_pack,
       in_words({{"width, height", 2},
                 {"epsilon"},
                 {"x, y, depth, colour of sample", 4, kAllThatFollow}})},
      {"matrix", "clip", "warp_matrix", matrix, judge_matrix,
       in_words({{"first matrix", 16}, {"second matrix", 16}})},
      {"row", "screen", "warp_row", row, judge_row,
       in_words({{"warp", 16}, {"y"}, {"depths of pixel", kCounted, kAllThatFollow}})},
      {"size", "coverage", "splat_size", size, judge_size,
       in_words({{"F2/F1"}, {"w of sample", 1, kAllThatFollow}})},
      {"order", "depth", "visiting_order", order, judge_order,
       in_words({{"epipole times w"}, {"w"}, {"columns"}})},
      {"draw", "shading", "draw", draw_samples, judge_draw,
       in_words({{"width, height", 2},
                 {"background"},
                 {"x w, y w, z w, w, side, colour of sample", 6, kAllThatFollow}})}};
  return all;
}
enum Stage : std::size_t { kPack, kMatrix, kRow, kSize, kOrder, kDraw };

// ---- in the pipeline ----

Result<std::vector<Numbers>> ask(AnswerSource& answer_source, Stage stage,
                                 const std::vector<Question>& questions) {
  return answer_source.ask(stages()[stage], questions);
}
Result<Numbers> ask_one(AnswerSource& answer_source, Stage stage, Numbers numbers) {
  return ask(answer_source, stage, {{std::move(numbers)}}).map([](std::vector<Numbers>&& answers) {
    return std::move(answers[0]);
  });
}

Rgba8 unpacked_colour(double colour) {
  const auto rgb =
      std::uint32_t(std::clamp(std::isfinite(colour) ? colour : 0, 0.0, double(0xffffff)));
  return {std::uint8_t(rgb >> 16), std::uint8_t(rgb >> 8), std::uint8_t(rgb), 255};
}

// A sample of the first picture. A Row has, for each pixel of a row from left to right, the samples
// that the student's pack() keeps.
struct DepthSample {
  double depth = 0, colour = 0;
};
using Row = std::vector<std::vector<DepthSample>>;

std::vector<Question> pack_questions(const View& first, const std::vector<views::Layer>& layers) {
  const int width = int(first.viewport.width()), height = int(first.viewport.height());
  std::vector<Question> questions;
  for (int top = 0; top < height; top += kRows) {
    const int rows = std::min(kRows, height - top);
    Numbers numbers{double(width), double(rows), kEpsilon};
    for (const views::Layer& layer : layers) {
      for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < width; ++x) {
          const auto z = double(layer.distance.at(x, top + y));
          if (!std::isfinite(z)) continue;
          const auto depth = double(float(views::depth_of(first, z)));
          const double colour = lab_12::number_of_colour(layer.color.at(x, top + y));
          numbers.insert(numbers.end(), {double(x), double(y), depth, colour});
        }
      }
    }
    questions.push_back({std::move(numbers)});
  }
  return questions;
}

// The samples of row y of a band, which is the student's answer for some rows. A pixel is empty if
// its offsets in the answer are not valid.
Row row_of(const Numbers& band, int width, int rows, int y) {
  Row row(static_cast<std::size_t>(width));
  const std::size_t offsets = std::size_t(width) * std::size_t(rows) + 1;
  if (band.size() < offsets) return row;
  const std::size_t samples = (band.size() - offsets) / 2;
  for (std::size_t x = 0; x < row.size(); ++x) {
    const std::size_t pixel = std::size_t(rows - 1 - y) * std::size_t(width) + x;
    const double begin = band[pixel], end = band[pixel + 1];
    if (!(begin >= 0 && begin <= end && end <= double(samples))) continue;
    for (auto i = std::size_t(begin); i < std::size_t(end); ++i) {
      const double depth = band[offsets + 2 * i];
      row[x].push_back({std::isfinite(depth) ? depth : 0, band[offsets + 2 * i + 1]});
    }
  }
  return row;
}

Question row_question(const Numbers& warp, int y, const Row& row) {
  Question question{warp};
  question.numbers.resize(16);
  question.numbers.push_back(y);
  for (const auto& here : row) {
    question.numbers.push_back(double(here.size()));
    for (const DepthSample& sample : here) question.numbers.push_back(sample.depth);
  }
  return question;
}

// The focal length in pixels. It is the same for both axes if pixels are square; otherwise this is
// the geometric mean.
double focal_length(const views::LayerCamera& camera) {
  const Eigen::Vector3d gaze = camera.screen_from_world.row(3).head<3>();
  const auto across = [&](int i) {
    const Eigen::Vector3d row = camera.screen_from_world.row(i).head<3>();
    return (row - row.dot(gaze) * gaze).norm();
  };
  return std::sqrt(across(0) * across(1));
}

struct WarpedSample {
  double x, y, z, w;  // x, y and z are multiplied by w
  double side, colour;
};

// One question for each band of kRows rows of the second picture: the samples that may cover it, in
// the order in which they are visited. A sample that is not in front of the eye has no position; it
// is treated as if it were in the top row.
std::vector<Question> draw_questions(const std::vector<WarpedSample>& samples, int width,
                                     int height, double background) {
  std::vector<Question> questions;
  for (int top = 0; top < height; top += kRows)
    questions.push_back({{double(width), double(std::min(kRows, height - top)), background}});
  for (const WarpedSample& s : samples) {
    const bool is_before = s.w > 0;
    const double y = is_before ? s.y / s.w : 0, half = s.side / 2 + 1;
    if (!std::isfinite(y) || !std::isfinite(half)) continue;
    const auto last = double(questions.size() - 1);
    const auto begin = std::size_t(std::clamp(std::floor((y - half) / kRows), 0.0, last));
    const auto end = std::size_t(std::clamp(std::floor((y + half) / kRows), 0.0, last));
    for (std::size_t band = begin; band <= end; ++band) {
      Numbers& numbers = questions[band].numbers;
      const auto in_band = double(float(s.y - double(band) * kRows * s.w));
      numbers.insert(numbers.end(), {s.x, in_band, s.z, s.w, s.side, s.colour});
    }
  }
  return questions;
}

std::vector<std::size_t> numbers_below(const Numbers& answer, int count) {
  std::vector<std::size_t> all;
  for (const double each : answer) {
    if (each >= 0 && each < count) all.push_back(std::size_t(each));
  }
  all.resize(std::min(all.size(), std::size_t(count)));
  return all;
}

Numbers matrix_numbers(const views::LayerCamera& first, const views::LayerCamera& second) {
  Numbers numbers;
  for (const views::LayerCamera* camera : {&first, &second}) {
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column)
        numbers.push_back(camera->screen_from_world(row, column));
    }
  }
  return numbers;
}

// For each row of the first picture, from the top, and for each of its pixels: the samples with
// their positions in the second picture.
using WarpedRows = std::vector<std::vector<std::vector<WarpedSample>>>;

Result<WarpedRows> warp_samples(const std::vector<Numbers>& bands, const Numbers& warp, int width,
                                int height, double focal_ratio, AnswerSource& answer_source) {
  std::vector<Row> rows;
  std::vector<Question> questions;
  for (int y = 0; y < height; ++y) {
    const int band = y / kRows, band_rows = std::min(kRows, height - band * kRows);
    rows.push_back(row_of(bands[std::size_t(band)], width, band_rows, y % kRows));
    questions.push_back(row_question(warp, y, rows.back()));
  }
  auto warped = ask(answer_source, kRow, questions);
  if (!warped) return tl::unexpected(warped.error());
  // An answer with too few numbers is filled up with zeros.
  std::vector<Question> size_questions;
  for (std::size_t y = 0; y < rows.size(); ++y) {
    std::size_t samples = 0;
    for (const auto& here : rows[y]) samples += here.size();
    (*warped)[y].resize(4 * samples);
    Question question{{focal_ratio}};
    for (std::size_t i = 0; i < samples; ++i) {
      const double w = (*warped)[y][4 * i + 3];
      question.numbers.push_back(w > 0 ? w : 1);
    }
    size_questions.push_back(std::move(question));
  }
  auto sizes = ask(answer_source, kSize, size_questions);
  if (!sizes) return tl::unexpected(sizes.error());
  WarpedRows warped_rows(rows.size());
  for (std::size_t y = 0; y < rows.size(); ++y) {
    const Numbers& at = (*warped)[y];
    (*sizes)[y].resize(at.size() / 2);
    std::size_t i = 0;
    for (const auto& here : rows[y]) {
      warped_rows[y].emplace_back();
      for (const DepthSample& sample : here) {
        const double side = std::clamp((*sizes)[y][2 * i], 0.0, 4 * kMaxPx);
        warped_rows[y].back().push_back(
            {double(to_finite_float(at[4 * i])), double(to_finite_float(at[4 * i + 1])),
             double(to_finite_float(at[4 * i + 2])), double(to_finite_float(at[4 * i + 3])),
             std::isfinite(side) ? side : 0, sample.colour});
        ++i;
      }
    }
  }
  return warped_rows;
}

View eye_of_pair(const DrawingInput& input, Side side) {
  return eye_view(input.view, input.pair, side);
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  if (const auto opaque = check_opaque(input.scene, "lab 12"); !opaque)
    return tl::unexpected(opaque.error());
  const View left = eye_of_pair(input, Side::kLeft), right = eye_of_pair(input, Side::kRight);
  PictureSetup made{input.scene, right, input.settings, nullptr, {}};
  made.settings.show = Show::kColor;
  const int width = int(left.viewport.width()), height = int(left.viewport.height());

  RenderSettings with_distance = made.settings;
  with_distance.want_distance = true;
  const auto bands =
      ask(answer_source, kPack,
          pack_questions(left, views::peel(input.scene, left, with_distance, kLayers)));
  if (!bands) return tl::unexpected(bands.error());
  const views::LayerCamera first = views::layer_camera(left), second = views::layer_camera(right);
  auto warp = ask_one(answer_source, kMatrix, matrix_numbers(first, second));
  if (!warp) return tl::unexpected(warp.error());
  warp->resize(16);
  for (double& entry : *warp) entry = std::isfinite(entry) ? entry : 0;
  const auto rows = warp_samples(*bands, *warp, width, height,
                                 focal_length(second) / focal_length(first), answer_source);
  if (!rows) return tl::unexpected(rows.error());

  const Eigen::Vector4d epipole = first.screen_from_world * views::eye_of(second);
  const auto orders = ask(
      answer_source, kOrder,
      {{{epipole.x(), epipole.w(), double(width)}}, {{epipole.y(), epipole.w(), double(height)}}});
  if (!orders) return tl::unexpected(orders.error());
  std::vector<WarpedSample> samples;
  const std::vector<std::size_t> columns = numbers_below((*orders)[0], width);
  for (const std::size_t y : numbers_below((*orders)[1], height)) {
    for (const std::size_t x : columns)
      samples.insert(samples.end(), (*rows)[y][x].begin(), (*rows)[y][x].end());
  }
  const auto drawn_bands = ask(
      answer_source, kDraw,
      draw_questions(samples, width, height, lab_12::number_of_colour(input.settings.background)));
  if (!drawn_bands) return tl::unexpected(drawn_bands.error());
  made.finish = [bands = *drawn_bands, width](Framebuffer& picture) {
    const std::size_t of_band = std::size_t(kRows) * std::size_t(width);
    for (std::size_t p = 0; p < picture.color.pixels.size(); ++p) {
      const Numbers& band = bands[p / of_band];
      if (p % of_band < band.size()) picture.color.pixels[p] = unpacked_colour(band[p % of_band]);
    }
  };
  return made;
}

// The right eye's picture as the pipeline itself draws it, for comparison.
PictureSetup truth(const DrawingInput& input) {
  PictureSetup right{input.scene, eye_of_pair(input, Side::kRight), input.settings, nullptr, {}};
  right.settings.show = Show::kColor;
  return right;
}

}  // namespace lab_12_drawing

LabDrawing drawing_12() {
  using namespace lab_12_drawing;
  return {.stages = stages(), .draw = draw, .not_drawn = "", .truth = truth};
}

}  // namespace glassbox::labs
