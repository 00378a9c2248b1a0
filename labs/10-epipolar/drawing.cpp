// Lab 10 in a picture: the picture of the second camera, with the epipolar lines of some of the
// first camera's pixels, and the points at the positions that the student's pose gives.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "labs/10-epipolar/reference.h"
#include "labs/drawing/drawing.h"
#include "views/two_view/pose.h"
#include "views/two_view/truth.h"

namespace glassbox::labs {

namespace lab_10_drawing {

using views::Matrix3d;
using views::Vector3d;

// ---- the numbers of questions and answers ----

lab_10::Vector vector(RecordReader& in) {
  const double x = in.number(), y = in.number();
  return {x, y, in.number()};
}
lab_10::Matrix matrix(RecordReader& in) {
  const lab_10::Vector first = vector(in), second = vector(in);
  return {first, second, vector(in)};
}
lab_10::Camera camera(RecordReader& in) {
  const lab_10::Vector v = vector(in);
  return {v[0], v[1], v[2]};
}
lab_10::Pixel pixel(RecordReader& in) {
  const double x = in.number();
  return {x, in.number()};
}
views::Matches matches(RecordReader& in) {
  std::vector<lab_10::Match> all;
  while (in.more()) {
    const lab_10::Pixel left = pixel(in);
    all.push_back({left, pixel(in)});
  }
  return epipolar::matches_of(all);
}

RecordReader reader(const Numbers& numbers) {
  return {numbers.data(), numbers.size()};
}

void append(Numbers& out, const Matrix3d& m) {
  const std::vector<double> entries = epipolar::entries_of(m);
  out.insert(out.end(), entries.begin(), entries.end());
}
void append(Numbers& out, const Vector3d& v) {
  out.insert(out.end(), {v[0], v[1], v[2]});
}
void append(Numbers& out, const views::Matches& matches) {
  for (const views::Match& m : matches)
    out.insert(out.end(), {m.left.x(), m.left.y(), m.right.x(), m.right.y()});
}

// The answer with exactly `count` numbers, finite and not too large, so that the later stages can
// compute with it.
Numbers finite_answer(Numbers answer, std::size_t count) {
  answer.resize(count);
  for (double& x : answer) x = std::isfinite(x) ? std::clamp(x, -1e9, 1e9) : 0;
  return answer;
}

// ---- the reference ----

Numbers matrix_stage(RecordReader& in) {
  Numbers out;
  append(out, epipolar::solve(matches(in)).essential);
  return out;
}

std::optional<views::ChosenPose> pose_of_record(RecordReader& in) {
  const Matrix3d e = epipolar::matrix_of(matrix(in));
  return views::pose_in_front(e, matches(in));
}

Numbers pose_stage(RecordReader& in) {
  const auto chosen = pose_of_record(in);
  const views::RelativePose pose = chosen ? chosen->pose : views::RelativePose{};
  Numbers out;
  append(out, pose.rotation);
  append(out, pose.translation);
  return out;
}

Numbers lines_stage(RecordReader& in) {
  const lab_10::Matrix e = matrix(in);
  const lab_10::Camera left = camera(in), right = camera(in);
  Numbers out;
  while (in.more()) {
    const lab_10::Line line = epipolar::exact_line_of(e, left, right, pixel(in)).line;
    out.insert(out.end(), {line.a, line.b, line.c});
  }
  return out;
}

std::vector<epipolar::ExactPoint> points_of_record(RecordReader& in) {
  const lab_10::Matrix rotation = matrix(in);
  const lab_10::Pose pose{rotation, vector(in)};
  std::vector<epipolar::ExactPoint> points;
  for (const views::Match& m : matches(in))
    points.push_back(
        epipolar::exact_point_of({m.left.x(), m.left.y()}, {m.right.x(), m.right.y()}, pose));
  return points;
}

Numbers points_stage(RecordReader& in) {
  Numbers out;
  for (const epipolar::ExactPoint& point : points_of_record(in)) {
    out.insert(out.end(), point.place.begin(), point.place.end());
    out.push_back(point.w);
  }
  return out;
}

// ---- judgement ----

std::optional<WrongNumber> judge_matrix(const Numbers& in, const Numbers& yours,
                                        const Numbers& reference) {
  RecordReader record = reader(in);
  const double bound = epipolar::solve(matches(record)).bound;
  return first_wrong(
      yours, reference, [bound](std::size_t) { return bound; }, "",
      [](std::size_t i) { return fmt::format("E, row {}, column {}", i / 3, i % 3); });
}

// If several poses have the largest number of matches in front of both cameras, no pose is the
// right one, and any answer is accepted.
std::optional<WrongNumber> judge_pose(const Numbers& in, const Numbers& yours,
                                      const Numbers& reference) {
  RecordReader record = reader(in);
  if (!pose_of_record(record)) return std::nullopt;
  return first_wrong(
      yours, reference, [](std::size_t) { return epipolar::kPoseBound; }, "",
      [](std::size_t i) {
        return i < 9 ? fmt::format("R, row {}, column {}", i / 3, i % 3)
                     : fmt::format("T, number {}", i - 9);
      });
}

std::optional<WrongNumber> judge_lines(const Numbers& in, const Numbers& yours,
                                       const Numbers& reference) {
  RecordReader record = reader(in);
  const lab_10::Matrix e = matrix(record);
  const lab_10::Camera left = camera(record), right = camera(record);
  std::vector<double> bounds;
  while (record.more()) {
    const epipolar::ExactLine exact = epipolar::exact_line_of(e, left, right, pixel(record));
    bounds.insert(bounds.end(), {exact.bound_of_ab, exact.bound_of_ab, exact.bound_of_c});
  }
  return first_wrong(
      yours, reference, [&](std::size_t i) { return i < bounds.size() ? bounds[i] : 0; }, "px",
      [](std::size_t i) { return fmt::format("line {}, {}", i / 3, "abc"[i % 3]); });
}

std::optional<WrongNumber> judge_points(const Numbers& in, const Numbers& yours,
                                        const Numbers& reference) {
  RecordReader record = reader(in);
  std::vector<double> bounds;
  for (const epipolar::ExactPoint& point : points_of_record(record)) {
    // Where rounding decides whether the lines are parallel, both answers are right.
    const bool between = epipolar::is_between(point);
    bounds.insert(bounds.end(), 3, between ? INFINITY : point.bound);
    bounds.push_back(between ? 1 : 0);
  }
  return first_wrong(
      yours, reference, [&](std::size_t i) { return i < bounds.size() ? bounds[i] : 0; },
      "times |T|", [](std::size_t i) { return fmt::format("point {}, {}", i / 4, "xyzw"[i % 4]); });
}

const std::vector<DrawnStage>& stages() {
  static const InputPart match{"left x, left y, right x, right y of match", 4, kAllThatFollow};
  static const std::vector<DrawnStage> all{
      {"matrix", "eye", "normalising, eight_point", matrix_stage, judge_matrix, in_words({match})},
      {"pose", "eye", "relative_pose", pose_stage, judge_pose, in_words({{"E", 9}, match})},
      {"points", "eye", "triangulate", points_stage, judge_points,
       in_words({{"R", 9}, {"T", 3}, match})},
      {"lines", "screen", "epipolar_line", lines_stage, judge_lines,
       in_words({{"E", 9},
                 {"left f, principal point", 3},
                 {"right f, principal point", 3},
                 {"pixel", 2, kAllThatFollow}})}};
  return all;
}

// ---- the pair ----

// The second camera is to the right of the first one and a little above it, turned towards the
// centre of the window, and rolled.
View second_view(const View& first, const StereoPair& pair) {
  const double right = 2 * pair.half_separation, up = 0.3 * right;
  // a quaternion with w = 1
  const double x = up / pair.window / 2, y = -right / pair.window / 2, z = 0.04;
  const double n = 1 + x * x + y * y + z * z;
  Transform<Eye, Eye> turn;
  const double entries[3][3] = {
      {(1 + x * x - y * y - z * z) / n, 2 * (x * y - z) / n, 2 * (x * z + y) / n},
      {2 * (x * y + z) / n, (1 - x * x + y * y - z * z) / n, 2 * (y * z - x) / n},
      {2 * (x * z - y) / n, 2 * (y * z + x) / n, (1 - x * x - y * y + z * z) / n}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) turn.at(i, j) = entries[i][j];
    turn.at(i, 3) = -(entries[i][0] * right + entries[i][1] * up);
  }
  View second = first;
  second.eye_from_world = turn * first.eye_from_world;
  return second;
}

constexpr int kColumns = 12, kRows = 9;  // the grid of pixels whose points are matched
constexpr std::size_t kFewest = 16;      // matches, twice the eight that are needed
constexpr std::size_t kShownEach = 6;    // every sixth match has its line drawn

struct Pair {
  lab_10::Camera left, right;
  std::vector<lab_10::Pixel> pixels;  // pixels of the left picture
  views::Matches calibrated;
};

lab_10::Camera camera_of(const views::PinholeCamera& camera) {
  return {camera.intrinsic(0, 0), camera.intrinsic(0, 2), camera.intrinsic(1, 2)};
}

// The true matches of a grid of pixels, without the pixels whose points the second camera does not
// see. The rasterizer knows which point each pixel shows.
Result<Pair> matched(const DrawingInput& input, const View& second) {
  const auto left = views::known_picture(input.scene, input.view, input.settings);
  if (!left) return tl::unexpected(left.error());
  const auto right = views::known_picture(input.scene, second, input.settings);
  if (!right) return tl::unexpected(right.error());
  const Image<views::TrueMatch> truth = views::true_matches(*left, *right);
  Pair pair{camera_of(left->camera), camera_of(right->camera), {}, {}};
  for (int i = 0; i < kColumns * kRows; ++i) {
    const int x = (2 * (i % kColumns) + 1) * truth.width / (2 * kColumns);
    const int y = (2 * (i / kColumns) + 1) * truth.height / (2 * kRows);
    const views::TrueMatch& match = truth.at(x, y);
    if (match.visibility != OtherEyeVisibility::kVisible) continue;
    pair.pixels.push_back({x + 0.5, y + 0.5});
    pair.calibrated.push_back(
        {views::ray_through(left->camera.intrinsic, {x + 0.5, y + 0.5}).head<2>(),
         views::ray_through(right->camera.intrinsic, {double(match.x), double(match.y)})
             .head<2>()});
  }
  if (pair.pixels.size() >= kFewest) return pair;
  return fail("the pair",
              fmt::format("both cameras see {} of {} points, fewer than {}", pair.pixels.size(),
                          kColumns * kRows, kFewest),
              "choose a smaller --eye-separation, or a camera that sees more of the scene");
}

// ---- in the picture ----

// The colour of epipolar line i: one of twelve hues.
Rgba8 line_colour(std::size_t i) {
  const double turn = double(i * 5 % 12) / 2;
  const auto channel = [turn](double at) {
    const double away = std::abs(std::remainder(turn - at, 6.0));
    return std::uint8_t(255 * std::clamp(2 - away, 0.0, 1.0));
  };
  return {channel(0), channel(2), channel(4), 255};
}

void set_pixel(Image<Rgba8>& picture, int x, int y, const Rgba8& colour) {
  if (x >= 0 && y >= 0 && x < picture.width && y < picture.height) picture.at(x, y) = colour;
}

// Draws one pixel of the line in each column of the picture, or in each row if the line is steep.
void draw_line(Image<Rgba8>& picture, const lab_10::Line& line, const Rgba8& colour) {
  const bool steep = std::abs(line.a) > std::abs(line.b);
  const double along = steep ? line.b : line.a, across = steep ? line.a : line.b;
  if (across == 0) return;
  const int count = steep ? picture.height : picture.width;
  for (int i = 0; i < count; ++i) {
    const double at = std::clamp(std::floor(-(along * (i + 0.5) + line.c) / across), -1e6, 1e6);
    set_pixel(picture, steep ? int(at) : i, steep ? i : int(at), colour);
  }
}

// Draws a white cross with a black centre at the position where the point is seen.
void draw_point(Image<Rgba8>& picture, const Vector3d& seen, const lab_10::Camera& camera) {
  if (!(seen.z() > 0)) return;
  const auto place = [](double x) { return int(std::clamp(std::floor(x), -1e6, 1e6)); };
  const int x = place(camera.f * seen.x() / seen.z() + camera.x);
  const int y = place(camera.f * seen.y() / seen.z() + camera.y);
  for (int i = -2; i <= 2; ++i) {
    set_pixel(picture, x + i, y, {255, 255, 255, 255});
    set_pixel(picture, x, y + i, {255, 255, 255, 255});
  }
  set_pixel(picture, x, y, {0, 0, 0, 255});
}

struct Answers {
  Numbers lines, pose, points;
};

Result<Answers> ask(const Pair& pair, const std::vector<lab_10::Pixel>& shown,
                    const views::Matches& shown_matches, AnswerSource& answer_source) {
  const auto one = [&](std::size_t stage, const Numbers& question,
                       std::size_t count) -> Result<Numbers> {
    auto answer = answer_source.ask(stages()[stage], std::vector<Question>{{question}});
    if (!answer) return tl::unexpected(answer.error());
    return finite_answer(std::move((*answer)[0]), count);
  };
  Numbers question;
  append(question, pair.calibrated);
  const auto e = one(0, question, 9);
  if (!e) return tl::unexpected(e.error());
  question = *e;
  append(question, pair.calibrated);
  const auto pose = one(1, question, 12);
  if (!pose) return tl::unexpected(pose.error());
  question = *pose;
  append(question, shown_matches);
  const auto points = one(2, question, 4 * shown.size());
  if (!points) return tl::unexpected(points.error());
  question = *e;
  for (const lab_10::Camera& c : {pair.left, pair.right})
    question.insert(question.end(), {c.f, c.x, c.y});
  for (const lab_10::Pixel& p : shown) question.insert(question.end(), {p.x, p.y});
  const auto lines = one(3, question, 3 * shown.size());
  if (!lines) return tl::unexpected(lines.error());
  return Answers{*lines, *pose, *points};
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  if (input.pair.half_separation == 0)
    return fail("--eye-separation", "0: both cameras are at the same place, so there is no depth",
                "give a separation above 0");
  const View second = second_view(input.view, input.pair);
  const auto pair = matched(input, second);
  if (!pair) return tl::unexpected(pair.error());
  std::vector<lab_10::Pixel> shown;
  views::Matches shown_matches;
  for (std::size_t i = 0; i < pair->pixels.size(); i += kShownEach) {
    shown.push_back(pair->pixels[i]);
    shown_matches.push_back(pair->calibrated[i]);
  }
  const auto answers = ask(*pair, shown, shown_matches, answer_source);
  if (!answers) return tl::unexpected(answers.error());

  PictureSetup made{input.scene, second, input.settings, nullptr, {}};
  made.finish = [answers = *answers, camera = pair->right](Framebuffer& picture) {
    RecordReader lines = reader(answers.lines), points = reader(answers.points);
    RecordReader pose = reader(answers.pose);
    for (std::size_t i = 0; lines.more(); ++i) {
      const lab_10::Vector line = vector(lines);
      draw_line(picture.color, {line[0], line[1], line[2]}, line_colour(i));
    }
    const Matrix3d rotation = epipolar::matrix_of(matrix(pose));
    const Vector3d centre = epipolar::vector_of(vector(pose));
    while (points.more()) {
      const Vector3d point = epipolar::vector_of(vector(points));
      draw_point(picture.color, rotation * (point - points.number() * centre), camera);
    }
  };
  return made;
}

}  // namespace lab_10_drawing

LabDrawing drawing_10() {
  using namespace lab_10_drawing;
  return {stages(), draw, "essential and centre_from_shift"};
}

}  // namespace glassbox::labs
