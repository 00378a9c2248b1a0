// Dense matching for the checks and the drawing of lab 11, written word for word as its definitions
// say, without shortcuts.
#pragma once

#include <vector>

#include "labs/11-matching/student.h"

namespace glassbox::labs::matching {

// The two pictures that a cost compares: pixel (x, y) of the first one with pixel (x + step d, y)
// of the second one.
struct Sides {
  const lab_11::Picture* first = nullptr;
  const lab_11::Picture* second = nullptr;
  int step = -1;
};
int sad(const Sides& sides, int x, int y, int d, int radius);

std::uint32_t census(const lab_11::Picture& picture, int x, int y);
int hamming(std::uint32_t a, std::uint32_t b);

// For each pixel and disparity of a path: the least cost of all choices of disparities from the
// first pixel to this one, minus the least cost of a choice that ends at the pixel before. The
// least costs are found from one pixel to the next.
std::vector<int> along_path(const std::vector<int>& costs, int disparities, int p1, int p2);

double winner(const std::vector<int>& costs);
inline constexpr double kWinnerBound = 8 * 0x1p-53;  // multiplied by 1 + d for a disparity d

// If `step` is -1, as it should be, left pixel x is at column x - d of the right picture. If it is
// 1, pixel x is at x + d: a mistake that the checks look for.
std::vector<double> right_winners(const std::vector<int>& costs, int width, int disparities,
                                  int step = -1);
std::vector<double> left_right_check(const std::vector<double>& left,
                                     const std::vector<double>& right, double tolerance,
                                     int step = -1);

double depth(double disparity, const lab_11::Calibration& calibration);
// Multiplied by the depth Z: 4 u as the contract says, and u (2^-53, the unit roundoff) because the
// expected depth is itself rounded to double.
inline constexpr double kDepthBound = 5 * 0x1p-53;

}  // namespace glassbox::labs::matching
