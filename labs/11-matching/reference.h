// Dense matching, written exactly as its definitions say, one number after the other, for lab 11's
// judges.
#pragma once

#include <vector>

#include "labs/11-matching/student.h"

namespace glassbox::labs::matching {

// The two pictures that a cost compares: pixel (x, y) of the first one and (x + step d, y) of the
// second one.
struct Sides {
  const lab_11::Picture* first = nullptr;
  const lab_11::Picture* second = nullptr;
  int step = -1;
};
int sad(const Sides& sides, int x, int y, int d, int radius);

std::uint32_t census(const lab_11::Picture& picture, int x, int y);
int hamming(std::uint32_t a, std::uint32_t b);

// The least cost of all paths to (p, d), found from one pixel to the next, minus the least cost of
// a path to the pixel before.
std::vector<int> along_path(const std::vector<int>& costs, int disparities, int p1, int p2);

double winner(const std::vector<int>& costs);
inline constexpr double kWinnerBound = 8 * 0x1p-53;  // times 1 + d

// `step` -1: left pixel x is at x - d on the right; 1: it is at x + d.
std::vector<double> right_winners(const std::vector<int>& costs, int width, int disparities,
                                  int step = -1);
std::vector<double> left_right_check(const std::vector<double>& left,
                                     const std::vector<double>& right, double tolerance,
                                     int step = -1);

double depth(double disparity, const lab_11::Calibration& calibration);
inline constexpr double kDepthBound = 4 * 0x1p-53;  // times Z

}  // namespace glassbox::labs::matching
