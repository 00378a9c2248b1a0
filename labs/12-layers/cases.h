// The inputs of lab 12's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_12 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

// ---- samples to pack (task 12.1) ----

struct PackCase {
  std::string what;
  int width, height;
  std::vector<Sample> samples;
  double epsilon = 0;
};

// A colour as one number: 65536 red + 256 green + blue.
inline double number_of_colour(const Rgba8& c) {
  return 65536.0 * c.r + 256.0 * c.g + c.b;
}

// A colour that encodes the number of a sample.
inline Rgba8 number_colour(int n) {
  return {std::uint8_t(n >> 16), std::uint8_t(n >> 8), std::uint8_t(n), 255};
}
inline std::vector<Sample> numbered(std::vector<Sample> samples) {
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i].colour = number_colour(int(i) + 1);
  return samples;
}
// Samples of one pixel. The depth of each is smaller than the depth before it by `step` times that
// depth.
inline std::vector<Sample> chain(int x, int y, int count, double step) {
  std::vector<Sample> all;
  double depth = 0.5;
  for (int i = 0; i < count; ++i, depth *= 1 - step) all.push_back({x, y, float(depth), {}});
  return all;
}

inline std::vector<PackCase> packs() {
  // The samples of a chain in mixed order, as if from several pictures.
  std::vector<Sample> mixed = chain(1, 0, 7, 0.9 / 64);
  std::swap(mixed[0], mixed[3]);
  std::swap(mixed[1], mixed[6]);
  return {
      {"one sample in each corner", 3, 2,
       numbered({{0, 0, 0.5f, {}}, {2, 0, 0.25f, {}}, {0, 1, 0.125f, {}}, {2, 1, 0.75f, {}}})},
      {"three surfaces in one pixel, empty ones around it (C-85)", 3, 3,
       numbered({{1, 1, 0.25f, {}}, {1, 1, 0.75f, {}}, {1, 1, 0.5f, {}}, {2, 1, 0.5f, {}}})},
      {"no samples (C-85)", 4, 2, {}},
      {"two pictures' samples of the same surfaces", 2, 1,
       numbered({{0, 0, 0.5f, {}}, {0, 0, 0.2f, {}}, {0, 0, 0.501f, {}}, {0, 0, 0.1999f, {}}}),
       1.0 / 64},
      {"a chain of samples, each of which is near only to the next one (C-84)", 2, 1,
       numbered(mixed), 1.0 / 64},
      {"equal depths", 1, 1, numbered({{0, 0, 0.5f, {}}, {0, 0, 0.25f, {}}, {0, 0, 0.5f, {}}}), 0},
  };
}
// BEGIN HIDDEN
inline PackCase random_pack(glassbox::Random& random) {
  PackCase made{"any samples", 6, 5, {}, 1.0 / 32};
  for (int i = 0; i < 120; ++i)
    made.samples.push_back(
        {int(random.integer(0, 5)), int(random.integer(0, 4)), float(random.between(0.01, 1)), {}});
  made.samples = numbered(made.samples);
  return made;
}
inline std::vector<PackCase> hidden_packs() {
  glassbox::Random random = glassbox::labs::varied(121);
  return glassbox::labs::with_varied(
      std::vector<PackCase>{
          {"300 samples in one pixel (C-85)", 2, 2, numbered(chain(0, 1, 300, 1.0 / 64)), 0},
          {"samples exactly epsilon apart", 1, 1,
           numbered({{0, 0, 0.5f, {}}, {0, 0, 0.375f, {}}, {0, 0, 0.3749f, {}}}), 0.25},
          {"near samples that stay separate, and far ones at the same distance from each other "
           "that are merged",
           2, 1,
           numbered({{0, 0, 0.9f, {}}, {0, 0, 0.88f, {}}, {0, 0, 0.010f, {}}, {0, 0, 0.0099f, {}}}),
           1.0 / 64},
          random_pack(random),
      },
      122, 2, random_pack);
}
// END HIDDEN

// ---- cameras (tasks 12.2, 12.3) ----

// An eye at (x, y, z) that looks along -z and is then turned to the left by an angle. `left` is the
// tangent of half this angle, from which the runner and the checks get exactly the same cosine and
// sine. Focal length, width and height are in pixels.
inline Transform<Screen, World> camera(double focal, double width, double height, double near,
                                       double x, double y, double z, double left = 0) {
  const double c = (1 - left * left) / (1 + left * left), s = 2 * left / (1 + left * left);
  // The rows of the rotation: the eye's directions right, up and back.
  const double rows[3][3] = {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
  double e[4][4] = {};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) e[i][j] = rows[i][j];
    e[i][3] = -(rows[i][0] * x + rows[i][1] * y + rows[i][2] * z);
  }
  e[3][3] = 1;
  Transform<Screen, World> m;
  for (int j = 0; j < 4; ++j) {
    m.at(0, j) = focal * e[0][j] - width / 2 * e[2][j];
    m.at(1, j) = -focal * e[1][j] - height / 2 * e[2][j];
    m.at(2, j) = near * e[3][j];
    m.at(3, j) = -e[2][j];
  }
  return m;
}

struct MatrixCase {
  const char* what;
  Transform<Screen, World> first, second;
};
inline std::vector<MatrixCase> matrices() {
  return {
      {"an eye to the right", camera(320, 320, 240, 0.5, 0, 0, 0),
       camera(320, 320, 240, 0.5, 0.25, 0, 0)},
      {"an eye farther forward, with a longer focal length", camera(320, 320, 240, 0.5, 0, 0, 0),
       camera(640, 320, 240, 0.5, 0, 0, -1)},
      {"a near plane at a millimetre (C-37)", camera(500, 640, 480, 0.001, 3, 1, 2, 0.25),
       camera(500, 640, 480, 0.001, 3.4, 1.1, 1.75, 0.125)},
  };
}
// BEGIN HIDDEN
inline MatrixCase random_matrix(glassbox::Random& random) {
  const auto anywhere = [&](double near) {
    const double focal = random.between(200, 900);
    const double x = random.between(-3, 3), y = random.between(-3, 3), z = random.between(-3, 3);
    return camera(focal, 640, 480, near, x, y, z, random.between(-1, 1));
  };
  return {"any two eyes", anywhere(0.125), anywhere(0.25)};
}
inline std::vector<MatrixCase> hidden_matrices() {
  glassbox::Random random = glassbox::labs::varied(123);
  return {random_matrix(random),
          random_matrix(random),
          {"the same eye", camera(320, 320, 240, 0.5, 1, 2, 3, 0.5),
           camera(320, 320, 240, 0.5, 1, 2, 3, 0.5)}};
}
// END HIDDEN

// ---- rows (task 12.3) ----

struct RowCase {
  std::string what;
  Transform<Screen, Screen> warp;
  int y;
  std::vector<std::vector<float>> depths;
};

// A warp whose entries have few binary digits, so that the runner and the checks have exactly the
// same numbers. One pixel further right in the first picture is nearly one pixel in the second one,
// and w changes along the row.
inline Transform<Screen, Screen> row_matrix(double width) {
  Transform<Screen, Screen> m;
  const double rows[4][4] = {{0.98, 0.004, 0.37 * width, 7.3},
                             {0.003, 1.013, -9.1, -2.7},
                             {1e-7, -3e-7, 0.97, 0.0011},
                             {0.11 / width, 0.00013, 0.21, 0.89}};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) m.at(i, j) = std::round(rows[i][j] * 0x1p40) * 0x1p-40;
  }
  return m;
}
inline std::vector<std::vector<float>> some_depths(int width, int most, std::uint64_t seed) {
  glassbox::Random random(seed);
  std::vector<std::vector<float>> depths(static_cast<std::size_t>(width));
  for (auto& here : depths) {
    for (int i = int(random.integer(0, most)); i > 0; --i)
      here.push_back(float(random.between(0.01, 1)));
  }
  return depths;
}
inline std::vector<RowCase> rows() {
  return {
      {"four pixels with one sample each", row_matrix(64), 5, {{0.5f}, {0.25f}, {0.75f}, {0.125f}}},
      {"empty pixels, and a pixel with several samples",
       row_matrix(64),
       0,
       {{}, {0.25f, 0.5f, 0.75f}, {}, {}, {0.125f, 1.0f}}},
      {"a row of 300 px", row_matrix(320), 117, some_depths(300, 2, 1231)},
      {"a row of 8192 px (C-80)", row_matrix(8192), 33, some_depths(8192, 1, 1232)}};
}
// BEGIN HIDDEN
inline std::vector<RowCase> hidden_rows() {
  const auto seed = glassbox::labs::varied_seed(124);
  return {{"one sample, behind empty pixels", row_matrix(64), 0, {{}, {}, {0.5f}}},
          {"a row of 1000 px", row_matrix(1024), 719, some_depths(1000, 3, seed)},
          {"a row of 16384 px (C-80)", row_matrix(16384), 2, some_depths(16384, 1, seed + 1)}};
}
// END HIDDEN

// ---- sizes (task 12.4) ----

struct SizeCase {
  const char* what;
  double focal_ratio, w, cosine_first, cosine_second;
};
inline std::vector<SizeCase> sizes() {
  return {
      {"a sample at the same distance from both eyes", 1, 1, 0.7, 0.7},
      {"a sample seen from a quarter of the distance (C-81)", 1, 0.25, 1, 1},
      {"a sample seen with three times the focal length (C-81)", 3, 1, 1, 1},
      {"a sample that the first eye sees at 60 degrees and the second straight on", 1, 0.5, 0.5, 1},
      {"smaller than a pixel", 1, 5, 1, 1},
      {"a sample very near the eye (C-86)", 1, 0.001, 1, 1}};
}
// BEGIN HIDDEN
inline std::vector<SizeCase> hidden_sizes() {
  return glassbox::labs::with_varied(
      std::vector<SizeCase>{
          {"a sample whose surface faces away from the second eye", 2, 0.5, 0.9, 0.3},
          {"exactly 64 px", 1, 1.0 / 64, 1, 1},
          {"a surface that the first eye sees edge-on (C-86)", 1, 1, 0, 0.5},
          {"a surface that both eyes see edge-on", 1, 1, 0, 0},
          {"a shorter focal length, from nearer", 0.4, 0.1, 0.8, 0.9},
          {"a surface that is seen nearly edge-on (C-86)", 1, 0.5, 1e-9, 1}},
      125, 3, [](glassbox::Random& random) {
        const double ratio = random.between(0.5, 3), w = random.between(0.1, 2);
        const double first = random.between(0.1, 1);
        return SizeCase{"any", ratio, w, first, random.between(0.1, 1)};
      });
}
// END HIDDEN

// ---- orders (task 12.5) ----

struct OrderCase {
  const char* what;
  double epipole, w;
  int count;
};
inline std::vector<OrderCase> orders() {
  return {
      {"the other eye is in front, inside the picture", 2.7, 1, 6},
      {"the other eye is in front, outside the picture on the right", 90, 1, 5},
      {"the other eye is behind, on a line through the picture (C-82)", -2.25, -0.75, 6},
      {"the other eye is to the right, where the epipole is infinitely far away (C-82)", 4, 0, 5},
      {"the other eye is to the left, where the epipole is infinitely far away", -4, 0, 5}};
}
// BEGIN HIDDEN
inline std::vector<OrderCase> hidden_orders() {
  return glassbox::labs::with_varied(
      std::vector<OrderCase>{
          {"the other eye is in front, outside the picture on the left", -7, 0.5, 6},
          {"the other eye is behind, outside the picture on the right", -40, -2, 7},
          {"the other eye is behind, outside the picture on the left", 3, -1, 4},
          {"the epipole is exactly on a pixel's centre, with the other eye in front", 2.5, 1, 6},
          {"the epipole is exactly on a pixel's centre, with the other eye behind", -5, -2, 6},
          {"the epipole is given with w = 3", 9.9, 3, 8},
          {"one column", 5, 1, 1}},
      126, 3, [](glassbox::Random& random) {
        const double w = random.between(-2, 2);
        return OrderCase{"any", w * random.between(-5, 25), w, 20};
      });
}
// END HIDDEN

// ---- pictures (task 12.6) ----

struct DrawCase {
  std::string what;
  Canvas canvas;
};
inline Placed placed(double x, double y, double z, double w, double side, int number) {
  return {{float(x * w), float(y * w), float(z * w), float(w)}, side, number_colour(number)};
}
inline Canvas canvas_of(Hiding hiding, std::vector<Placed> samples, int width = 8, int height = 6) {
  return {width, height, {0, 0, 0, 255}, hiding, std::move(samples)};
}
inline std::vector<DrawCase> pictures() {
  return {
      {"a sample of one pixel, and one of 3 x 3 pixels",
       canvas_of(Hiding::kNearest,
                 {placed(1.25, 4.5, 0.5, 1, 1, 1), placed(5.75, 2.25, 0.5, 2, 3, 2)})},
      {"a near sample that hides a far one",
       canvas_of(Hiding::kNearest,
                 {placed(3.25, 3.25, 0.5, 1, 3, 1), placed(4.25, 3.25, 0.25, 1, 3, 2),
                  placed(2.25, 2.25, 0.75, 1, 3, 3)})},
      {"the last stays", canvas_of(Hiding::kLast, {placed(3.25, 3.25, 0.5, 1, 3, 1),
                                                   placed(4.25, 3.25, 0.25, 1, 3, 2)})},
      {"samples behind the eye, and nearer than the near plane (C-83)",
       canvas_of(Hiding::kLast,
                 {placed(3.25, 3.25, 0.5, -1, 3, 1), placed(2.25, 3.25, 1.5, 1, 3, 2),
                  placed(5.25, 3.25, 0.5, 1, 1, 3)})},
      {"a sample half outside the picture",
       canvas_of(Hiding::kNearest,
                 {placed(-0.25, 0.25, 0.5, 1, 4, 1), placed(7.75, 5.75, 0.5, 1, 4, 2)})},
  };
}
// BEGIN HIDDEN
inline DrawCase random_picture(glassbox::Random& random) {
  Canvas canvas =
      canvas_of(random.integer(0, 1) == 0 ? Hiding::kNearest : Hiding::kLast, {}, 24, 16);
  // Positions are in eighths of a pixel and sides are whole pixels, chosen so that no edge is on a
  // pixel centre. w is a power of two.
  for (int i = 0; i < 60; ++i) {
    const double side = double(random.integer(1, 6));
    const double off = std::fmod(side, 2) == 0 ? 0.125 : 0.625;
    const double x = double(random.integer(-4, 28)) + off, y = double(random.integer(-4, 20)) + off;
    const double sign = random.integer(0, 9) == 0 ? -1 : 1;
    const double w = std::ldexp(sign, int(random.integer(-3, 3)));
    canvas.samples.push_back(placed(x, y, double(random.integer(1, 70)) / 64, w, side, i + 1));
  }
  return {"any samples", canvas};
}
inline std::vector<DrawCase> hidden_pictures() {
  glassbox::Random random = glassbox::labs::varied(127);
  Canvas far = canvas_of(Hiding::kNearest, {placed(3.25, 2.25, 0.5, 1, 1, 1)});
  far.samples.push_back({{1e30f, 1e30f, 0, 1e-20f}, 1, number_colour(2)});
  far.samples.push_back({{-1e30f, 2, 0, 1e-20f}, 64, number_colour(3)});
  far.samples.push_back({{1, 1, 0.5f, 0}, 64, number_colour(4)});
  return {
      {"equally near samples", canvas_of(Hiding::kNearest, {placed(3.25, 3.25, 0.5, 1, 3, 1),
                                                            placed(4.25, 3.25, 0.5, 2, 3, 2)})},
      {"squares with edges exactly on pixel centres, of which the right and the lower edge belong "
       "to the square",
       canvas_of(Hiding::kNearest, {placed(3, 3, 0.5, 1, 1, 1), placed(5.5, 2.5, 0.5, 1, 2, 2)})},
      {"a sample exactly on the near plane",
       canvas_of(Hiding::kNearest, {placed(3.25, 3.25, 1, 1, 3, 1)})},
      {"w = 0, and the largest distance of a float (C-83)", far},
      {"sides that are no whole numbers",
       canvas_of(Hiding::kLast,
                 {placed(3.4, 2.7, 0.5, 1, 2.6, 1), placed(5.9, 3.1, 0.4, 1, 1.4, 2)})},
      random_picture(random),
      random_picture(random)};
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_12
