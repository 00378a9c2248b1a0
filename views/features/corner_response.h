// How much a picture looks like a corner at each pixel.
//
// Let (g_x, g_y) be the gradient of grey. Over a window with the weights w, the matrix
//
//     M = | sum w g_x^2    sum w g_x g_y |
//         | sum w g_x g_y  sum w g_y^2   |
//
// says how much the window changes if it is moved by d: to first order, the weighted sum of squared
// differences is d^T M d. If both eigenvalues l1 >= l2 are large, it changes in every direction.
#pragma once

#include <glassbox/images/image.h>

namespace glassbox::views {

enum class Detector {
  kHarris,     // det M - k (trace M)^2 (Harris and Stephens, A combined corner and edge detector,
               // 1988)
  kShiTomasi,  // the smaller eigenvalue l2 (Shi and Tomasi, Good features to track, CVPR 1994)
};
inline constexpr Detector kDetectors[] = {Detector::kHarris, Detector::kShiTomasi};
const char* name_of(Detector detector);

// k of Harris's response: it is positive only if l2/l1 is more than about 0.04.
inline constexpr double kHarrisTrace = 0.04;

// The standard deviation of the window's Gaussian weights, and its size: kWindowRadius pixels to
// each side. It is 2.5 times the smoothing of a level. In a narrower window the gap that smoothing
// makes in the edges around a crossing weighs so much that the response has no peak there.
inline constexpr double kWindowSigma = 2;  // px
inline constexpr int kWindowRadius = 6;    // px

// The response for the sums of M: a = sum w g_x^2, b = sum w g_x g_y, c = sum w g_y^2. Unit:
// (grey levels/px)^2 for Shi and Tomasi's, and the square of that for Harris's.
double corner_response(Detector detector, double a, double b, double c);

// The response at every pixel. Gradients are half the difference of two neighbours. It is 0 at
// kWindowRadius + 1 pixels along the edges, whose windows are not inside the picture.
Image<float> response_map(const Image<float>& grey, Detector detector);

}  // namespace glassbox::views
