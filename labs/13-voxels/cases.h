// The inputs of lab 13's test cases: for the runner, which calls the student's functions, and for
// the checks, which compute the expected answers.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <glassbox/base/random.h>

#include "labs/framework/varied_inputs.h"
#include "student.h"

namespace lab_13 {
// A namespace of its own: a function or type of yours in student.cpp may have the name of one of
// these, and does not replace it.
inline namespace inputs {

// ---- cameras around a box (task 13.1) ----

struct OrderCase {
  std::string what;
  std::vector<Place> cameras;
  Box box{{-1, -1, -1}, {1, 1, 1}};
};
inline std::vector<OrderCase> orders() {
  return {{"one camera, diagonally beyond a corner of the box", {{3, -4, 5}}},
          {"two cameras on a circle above the box", {{3, 4, 0}, {-3, 4, 0.5}}},
          {"one camera beside an edge of the box", {{3, 4, 0}}},
          {"four around (C-90)", {{4, 0, 0}, {0, 0, 4}, {-4, 0, 0}, {0, 0, -4}}},
          {"two inside", {{0.5, 0, 0}, {-0.5, 0.25, 0}}}};
}
// BEGIN HIDDEN
inline std::vector<OrderCase> hidden_orders() {
  return glassbox::labs::with_varied(
      std::vector<OrderCase>{
          {"exactly on a face", {{1, 0, 0}}},
          {"two cameras above a face, exactly in the plane of another face",
           {{1, 3, 0}, {1, 2, 0}}},
          {"one camera inside the box, one outside", {{0, 0, 0}, {3, 0, 0}}},
          {"cameras on both sides along one axis, and below the box along the others",
           {{-3, -2, -2}, {3, -2, -5}}},
          {"another box, for which the cameras are above along two axes",
           {{9, 5, 0}, {8, 6, 2}},
           {{2, 1, -1}, {7, 4, 3}}},
          {"one camera exactly on a corner of the box, one inside it", {{-1, -1, -1}, {0, 0, 0}}},
          {"one camera above the box, one inside it", {{0, 5, 0}, {0, 0, 0}}}},
      131, 4, [](glassbox::Random& random) {
        OrderCase made{"any", {}};
        const Place middle{random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)};
        for (int i = 0; i < 3; ++i)
          made.cameras.push_back({middle.x + random.between(-1, 1),
                                  middle.y + random.between(-1, 1),
                                  middle.z + random.between(-1, 1)});
        return made;
      });
}
// END HIDDEN

// ---- colours (task 13.2) ----

struct ColoursCase {
  std::string what;
  std::vector<Colour> colours;
};
inline std::vector<ColoursCase> colours() {
  return {{"two colours", {{10, 20, 30}, {14, 20, 38}}},
          {"five equal colours", std::vector<Colour>(5, {90, 100, 110})},
          {"three", {{0, 255, 0}, {255, 0, 0}, {0, 0, 255}}},
          {"one alone (C-89)", {{12, 200, 7}}}};
}
// BEGIN HIDDEN
inline ColoursCase bright_colours(glassbox::Random& random) {
  ColoursCase made{"a hundred within 0.001 of 250 (C-93)", {}};
  for (int i = 0; i < 100; ++i) {
    const auto near = [&] { return 250 + random.between(-0.001, 0.001); };
    const double a = near(), b = near();
    made.colours.push_back({a, b, near()});
  }
  return made;
}
inline std::vector<ColoursCase> hidden_colours() {
  glassbox::Random random = glassbox::labs::varied(132);
  return glassbox::labs::with_varied(
      std::vector<ColoursCase>{
          {"none at all (C-87)", {}},
          {"channels that have different means", {{0, 100, 200}, {4, 104, 204}}},
          {"one colour that is far from the others",
           {{10, 10, 10}, {10, 10, 10}, {10, 10, 10}, {250, 10, 10}}},
          bright_colours(random)},
      133, 2, bright_colours);
}
// END HIDDEN

// ---- verdicts (task 13.3) ----

struct JudgeCase {
  std::string what;
  std::vector<std::vector<Pixel>> pictures;
  Threshold threshold{0, 18};
};
inline Pixel grey(double level) {
  return {{level, level, level}, false, false};
}
inline Pixel hidden_grey(double level) {
  return {{level, level, level}, false, true};
}
inline Pixel background() {
  return {{0, 0, 0}, true, false};
}
inline std::vector<JudgeCase> judged() {
  return {
      {"one colour in three pictures", {{grey(100)}, {grey(104)}, {grey(98)}}},
      {"two colours", {{grey(100)}, {grey(200)}}},
      {"one picture shows background", {{grey(100)}, {background()}, {grey(100)}}},
      {"one picture alone (C-89)", {{grey(100)}, {hidden_grey(100)}}},
      {"no picture sees it", {{hidden_grey(100)}, {hidden_grey(30)}, {}}},
      {"hidden pixels, which are ignored", {{grey(100)}, {hidden_grey(250)}, {grey(103)}}},
      {"a checker board as fine as the voxels, with the adaptive threshold (C-94)",
       {{grey(0), grey(255)}, {grey(255), grey(0)}},
       {1, 10}},
      {"a checker board as fine as the voxels, with a fixed threshold (C-94)",
       {{grey(0), grey(255)}, {grey(255), grey(0)}},
       {0, 60}},
  };
}
// BEGIN HIDDEN
inline JudgeCase random_judged(glassbox::Random& random) {
  JudgeCase made{"any", {}, {random.between(0, 1), random.between(2, 30)}};
  for (int i = 0; i < 5; ++i) {
    made.pictures.emplace_back();
    for (auto k = random.integer(1, 4); k > 0; --k) {
      Pixel pixel = grey(random.between(90, 130));
      pixel.is_hidden = random.integer(0, 4) == 0;
      made.pictures.back().push_back(pixel);
    }
  }
  return made;
}
inline std::vector<JudgeCase> hidden_judged() {
  return glassbox::labs::with_varied(
      std::vector<JudgeCase>{
          {"no deviation and T = 0 (C-88)", {{grey(7)}, {grey(7)}}, {0, 0}},
          {"an infinite threshold (C-88)", {{grey(0)}, {grey(255)}}, {0, INFINITY}},
          {"background in a part of a footprint", {{grey(50), background()}, {grey(52)}}},
          {"background in one picture, hidden in the other", {{hidden_grey(50)}, {background()}}},
          {"a footprint with hidden pixels and background",
           {{hidden_grey(9), background()}, {grey(3)}}},
          {"a voxel outside all pictures", {{}, {}, {}}},
          {"two pixels of one picture", {{grey(100), grey(101)}, {hidden_grey(9)}, {}}},
          {"pictures with different numbers of pixels: M is the mean over pictures, not over "
           "pixels",
           {{grey(0), grey(60)}, {grey(30)}, {grey(30)}, {grey(30)}},
           {1, 10}},
          {"a picture that does not see the voxel, and so has no deviation",
           {{grey(0), grey(60)}, {grey(30), grey(30)}, {hidden_grey(1), hidden_grey(99)}},
           {1, 8}},
          {"exactly T", {{grey(0)}, {grey(0)}, {{{3, 0, 0}, false, false}}}, {0, 1}}},
      134, 6, random_judged);
}
// END HIDDEN

// ---- footprints (task 13.4) ----

struct FootprintCase {
  std::string what;
  Projection pixel_from_grid{};
  Voxel voxel;
  int width = 16, height = 12;
};
// A camera at (0, 0, -depth) that looks along z. `focal` is the size in px of a unit at distance 1,
// and the gaze is at pixel (cu, cv).
inline Projection along_z(double focal, double cu, double cv, double depth) {
  return {{{focal, 0, cu, cu * depth}, {0, focal, cv, cv * depth}, {0, 0, 1, depth}}};
}
inline std::vector<FootprintCase> footprints() {
  return {{"larger than pixels", along_z(48, 3.1, 2.2, 12.3), {1, 1, 0}},
          {"a voxel of half a pixel (C-87)", along_z(8, 3.7, 2.3, 16.3), {9, 7, 1}},
          {"a voxel half outside the picture", along_z(48, -1.3, 2.2, 12.3), {0, 0, 0}},
          {"behind the camera", along_z(4.1, 9, 7, -4.5), {1, 1, 0}}};
}
// BEGIN HIDDEN
inline FootprintCase random_footprint(glassbox::Random& random) {
  // The camera is turned about two axes by the angle with cosine 0.8 and sine 0.6.
  const double c = 0.8, s = 0.6, depth = random.between(20, 60), focal = random.between(10, 400);
  const double rows[3][3] = {{c, 0, -s}, {s * s, c, s * c}, {s * c, -s, c * c}};
  FootprintCase made{"any", {}, {}, 24, 18};
  const double at[3] = {random.between(-2, 2), random.between(-2, 2), depth};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto of = [&](std::size_t i) { return k < 3 ? rows[i][k] : at[i]; };
    made.pixel_from_grid[0][k] = focal * of(0) + 12 * of(2);
    made.pixel_from_grid[1][k] = focal * of(1) + 9 * of(2);
    made.pixel_from_grid[2][k] = of(2);
  }
  made.voxel = {int(random.integer(-3, 2)), int(random.integer(-3, 2)), int(random.integer(-3, 2))};
  return made;
}
inline std::vector<FootprintCase> hidden_footprints() {
  glassbox::Random random = glassbox::labs::varied(135);
  std::vector<FootprintCase> all{
      {"a tenth of a pixel (C-87)", along_z(1.7, 3.4, 2.4, 17.2), {20, 20, 0}},
      {"a voxel completely outside the picture", along_z(48, -60.3, 2.2, 12.3), {0, 0, 0}},
      {"a voxel with a corner behind the camera and its centre in front of it",
       along_z(2, 3.1, 2.2, -0.25),
       {0, 0, 0}},
      {"voxel centres exactly on the border of the picture", along_z(16, 0.5, 0.5, 8), {0, 1, 8}},
      {"a voxel whose centre and corner are in different pixels",
       along_z(1.7, 3.03, 2.4, 17.2),
       {20, 20, 0}},
      {"a voxel whose rectangle does not contain the pixel of its centre",
       along_z(4.5, 2.35, 2.35, 9.5),
       {3, 3, 0}},
      {"a voxel so far away that it is a millionth of a pixel wide",
       along_z(3, 4.4, 4.4, 3000000.1),
       {7, 7, 0}}};
  for (int i = 0; i < 12; ++i) all.push_back(random_footprint(random));
  return all;
}
// END HIDDEN

// ---- sweeps (task 13.5) ----

struct SweepCase {
  std::string what;
  std::vector<Picture> pictures;
  Grid grid;
  Threshold threshold{0, 18};
};
// An empty picture by a parallel projection: voxel (x, y, z) is at pixel (x - slope z + beside, y).
inline Picture flat_picture(double slope, double beside, int width, int height) {
  return {{{{1, 0, -slope, beside + slope / 2}, {0, 1, 0, 0}, {0, 0, 0, 1}}},
          width,
          height,
          std::vector<Pixel>(std::size_t(width) * std::size_t(height), background())};
}
// A coloured voxel. flat_pictures() draws such voxels of a grid of 8 x 3 x 5, one picture for each
// slope of flat_picture(); a voxel of smaller z is nearer and hides those behind it.
struct Solid {
  Voxel at;
  Colour colour;
};
inline std::vector<Picture> flat_pictures(std::vector<Solid> solids, std::vector<double> slopes) {
  std::vector<Picture> pictures;
  // The nearest voxels, those of smallest z, are painted last.
  std::stable_sort(solids.begin(), solids.end(),
                   [](const Solid& a, const Solid& b) { return a.at.z > b.at.z; });
  for (const double slope : slopes) {
    Picture picture = flat_picture(slope, 6, 20, 3);
    for (const Solid& solid : solids) {
      const auto column = std::size_t(solid.at.x - int(slope) * solid.at.z + 6);
      picture.pixels[std::size_t(solid.at.y) * 20 + column] = {solid.colour, false, false};
    }
    pictures.push_back(std::move(picture));
  }
  return pictures;
}
inline constexpr Colour kRed{200, 30, 20}, kBlue{20, 40, 220}, kGreen{30, 180, 60};
inline const Grid kGrid{{8, 3, 5}, 2, 1};

inline std::vector<SweepCase> sweeps() {
  return {{"one voxel, three pictures", flat_pictures({{{3, 1, 2}, kRed}}, {-1, 0, 1}), kGrid},
          {"two scenes that look the same: the nearer one (C-91)",
           flat_pictures({{{3, 1, 2}, kRed}, {{5, 1, 2}, kRed}}, {-1, 1}), kGrid},
          {"nearer voxels hide those behind them",
           flat_pictures({{{3, 0, 1}, kRed}, {{3, 0, 3}, kBlue}, {{5, 2, 4}, kGreen}}, {-1, 0, 1}),
           kGrid}};
}
// BEGIN HIDDEN
// The same pictures for a grid whose layers are stacked along another axis: two axes of the grid
// are swapped.
inline SweepCase turned(SweepCase made, int axis, int away) {
  const std::size_t to = std::size_t(axis);
  for (Picture& picture : made.pictures) {
    for (auto& row : picture.pixel_from_grid) {
      std::swap(row[to], row[2]);
      // If away is -1, coordinate c becomes n - c, where n is the number of layers.
      if (away > 0) continue;
      row[3] += row[to] * made.grid.count[2];
      row[to] = -row[to];
    }
  }
  std::swap(made.grid.count[to], made.grid.count[2]);
  made.grid.axis = axis;
  made.grid.away = away;
  return made;
}
inline SweepCase noisy_wall(glassbox::Random& random) {
  std::vector<Solid> wall;
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 8; ++x) {
      const auto level = [&] { return double(random.integer(0, 255)); };
      const double r = level(), g = level();
      wall.push_back({{x, y, x < 4 ? 1 : 3}, {r, g, level()}});
    }
  }
  SweepCase made{"a textured wall with a step", flat_pictures(wall, {-1, 0, 1}), kGrid, {0, 6}};
  for (Picture& picture : made.pictures) {
    for (Pixel& pixel : picture.pixels) pixel.colour[1] += double(random.integer(-1, 1));
  }
  return made;
}
inline std::vector<SweepCase> hidden_sweeps() {
  glassbox::Random random = glassbox::labs::varied(136);
  const SweepCase wall = noisy_wall(random);
  SweepCase no_masks{"pictures without background, an infinite threshold (C-88)",
                     flat_pictures({}, {-1, 0, 1}),
                     kGrid,
                     {0, INFINITY}};
  for (Picture& picture : no_masks.pictures)
    for (Pixel& pixel : picture.pixels) pixel = grey(double(random.integer(0, 255)));
  SweepCase shared{"two voxels of a layer that share a pixel",
                   flat_pictures({{{3, 1, 2}, kRed}}, {-1, 0, 1}),
                   {{16, 6, 10}, 2, 1}};
  for (Picture& picture : shared.pictures) {
    for (auto& row : picture.pixel_from_grid)
      for (std::size_t k = 0; k < 3; ++k) row[k] /= 2;
  }
  SweepCase behind = wall;
  behind.what = "one camera behind the grid";
  // All entries change their sign: u and v stay the same, but w < 0, so all voxels are behind the
  // camera.
  for (auto& row : behind.pictures[0].pixel_from_grid)
    for (double& entry : row) entry = -entry;
  SweepCase along_x = turned(wall, 0, 1), back = turned(wall, 2, -1), along_y = turned(wall, 1, -1);
  along_x.what = "layers along x";
  back.what = "layers along -z";
  along_y.what = "layers along -y";
  return {wall, no_masks, shared, behind, along_x, back, along_y};
}
// END HIDDEN

}  // namespace inputs
}  // namespace lab_13
