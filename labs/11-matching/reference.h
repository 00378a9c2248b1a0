// Dense matching written out as its definitions say it, one number at a time, for lab 11's judges.
#pragma once

#include <vector>

#include "labs/11-matching/student.h"

namespace glassbox::labs::matching {

// The pixels that a cost compares: (x, y) of the first picture and (x + step d, y) of the second one.
struct Sides {
  const lab_11::Picture* first = nullptr;
  const lab_11::Picture* second = nullptr;
  int step = -1;
};
int sad(const Sides& sides, int x, int y, int d, int radius);

std::uint32_t census(const lab_11::Picture& picture, int x, int y);
int hamming(std::uint32_t a, std::uint32_t b);

// As the cheapest of all ways to come to (p, d), found from one pixel to the next, less the cheapest to come to the pixel before.
std::vector<int> along_path(const std::vector<int>& costs, int disparities, int p1, int p2);

double winner(const std::vector<int>& costs);
inline constexpr double kWinnerBound = 8 * 0x1p-53;  // times 1 + d

// `step` -1: left pixel x lies at x - d on the right; 1: at x + d.
std::vector<double> right_winners(const std::vector<int>& costs, int width, int disparities,
                                  int step = -1);
std::vector<double> left_right_check(const std::vector<double>& left,
                                     const std::vector<double>& right, double tolerance,
                                     int step = -1);

double depth(double disparity, const lab_11::Calibration& calibration);
inline constexpr double kDepthBound = 4 * 0x1p-53;  // times Z

}  // namespace glassbox::labs::matching
