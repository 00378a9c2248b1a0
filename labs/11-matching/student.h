// Lab 11: which pixel of the right picture corresponds to a pixel of the left one. The contracts of
// the eight functions that you write in student.cpp.
//
// Both pictures have the same size and are rectified: a point is on the same row of both. Pixel
// (x, y) of the left picture and pixel (x - d, y) of the right one are a match of *disparity*
// d >= 0: the larger d, the nearer the point. Columns count from the left, rows from the top.
// u = 2^-53 is the unit roundoff of double.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace lab_11 {

// Grey values, 0 to 255, row by row from the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<int> grey;

  // The grey value of pixel (x, y). Beyond the edge of the picture its last row or column is
  // repeated.
  int at(int x, int y) const {
    const int column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
    return grey[std::size_t(row) * std::size_t(width) + std::size_t(column)];
  }
};

// The cost of an impossible match. Every other cost is below it, and no cost is below 0.
constexpr int kNever = 65536;
constexpr double kNone = INFINITY;  // a pixel without disparity, or without depth

// Task 11.1. The sum of absolute differences |left (x + i, y + j) - right (x + i - d, y + j)| over
// i, j = -radius .. radius, by at() of both pictures. kNever where the right pixel (x - d, y)
// itself is not in the right picture, which may be narrower or wider than the left one; the left
// pixel (x, y) always is in the left one. 0 <= radius <= 7, so sums stay below kNever. Exact.
int sad(const Picture& left, const Picture& right, int x, int y, int d, int radius);

// Task 11.2. The census word of a pixel (x, y) of the picture: one bit for each of the 24 pixels
// around it in a square of 5 x 5, read by at(), row by row from the top left; the first one is bit
// 0. A bit is 1 if its pixel is darker than (x, y) itself; all others are 0. Exact.
std::uint32_t census(const Picture& picture, int x, int y);

// Task 11.2. The number of bits, of all 32, in which two words differ. Exact.
int hamming(std::uint32_t a, std::uint32_t b);

// Task 11.3. Costs summed along a path of pixels. costs[p D + d] is the cost C(p, d) of pixel p and
// disparity d, where D is the number of disparities; the answer has the sums L(p, d) in the same
// order. For the first pixel L = C. For a later pixel p, where q is the pixel before p,
//   L(p, d) = C(p, d) + min(L(q, d), L(q, d - 1) + P1, L(q, d + 1) + P1, min_k L(q, k) + P2)
//                     - min_k L(q, k)
// where disparities below 0 and from D on are left out. There is at least one pixel, D >= 1, and
// 0 <= P1 <= P2 <= kNever; sums may be above kNever. Exact.
std::vector<int> along_path(const std::vector<int>& costs, int disparities, int p1, int p2);

// Task 11.4. The disparity d of the least of the costs c[0], c[1], ...; the smallest d among equal
// costs. Where both neighbours of d exist and cost less than kNever, the answer is the minimum of
// the parabola through the three costs,
//   d + (c[d - 1] - c[d + 1]) / (2 (c[d - 1] - 2 c[d] + c[d + 1])),
// and elsewhere it is d itself. kNone where no cost is below kNever, also if there are no costs at
// all. Error bound: 8 u (1 + d).
double winner(const std::vector<int>& costs);

// Task 11.5. The disparities that the right pixels of the row choose. costs[x D + d] is the cost of
// left pixel x at disparity d, where D is `disparities`; this match is at column x - d on the
// right; where this column is below 0 there is no match, whatever the cost. For each right pixel:
// the d with the least of all costs at its column, the smallest d among equal costs; kNone if no
// cost is below kNever. width and D are at least 1. Exact.
std::vector<double> right_winners(const std::vector<int>& costs, int width, int disparities);

// Task 11.5. A row of left disparities, in which each disparity that the right row does not confirm
// becomes kNone. Left pixel x of disparity d is at column x - d on the right, rounded to the
// nearest column, halves to the right. Exact: a d that is one ulp from a half belongs to the column
// on its side, so x - d must not be rounded to a double before. The disparity is confirmed if
// |d - r| <= tolerance, where r is the right disparity in this column and the difference is rounded
// to double. A column without a right disparity, or outside of the right picture, confirms nothing.
// Both rows are equally long; disparities are at least 0 or kNone; `tolerance` is finite and at
// least 0.
std::vector<double> left_right_check(const std::vector<double>& left,
                                     const std::vector<double>& right, double tolerance);

// The focal length f is in pixels; the baseline B (the distance between the cameras) and depths are
// in world units. `offset` is the column of the left principal point minus that of the right one.
struct Calibration {
  double focal = 0, baseline = 0, offset = 0;
};

// Task 11.6. Z = f B / (d + offset), also for a d below 0. kNone where there is no disparity, and
// where d + offset <= 0: such rays do not meet in front of the cameras. f, B and (unless it is 0)
// |d + offset| are between 2^-300 and 2^300. Error bound: 4 u Z.
double depth(double disparity, const Calibration& calibration);

}  // namespace lab_11
