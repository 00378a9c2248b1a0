// A feature as histograms of the gradients around it (SIFT: Lowe, Distinctive image features from
// scale-invariant keypoints, IJCV 60, 2004, sections 5 and 6).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glassbox/images/image.h>

namespace glassbox::views {

// 4 x 4 cells by rows, each with 8 directions.
inline constexpr int kCells = 4, kDirections = 8;
inline constexpr double kCellSide = 4;  // px
using GradientDescriptor = std::array<std::uint8_t, std::size_t(kCells* kCells* kDirections)>;

// The directions of the gradients that prevail, radians. A histogram of 36 directions has the
// gradients within 8 px, weighted by their length and by a Gaussian of 2.5 px. Its peaks of at
// least kSecondPeak of the highest, at most two of them, are refined by the parabola through three
// neighbours; the highest is first. One angle of 0 if there is no gradient.
inline constexpr double kSecondPeak = 0.8;
std::vector<double> gradient_angles(const Image<float>& grey, double x, double y);

// The cells turn with the feature, and so do the directions. Each gradient is divided between the 8
// nearest bins by trilinear interpolation, with a Gaussian weight of half the cells' width. The
// vector is scaled to length 1, its elements are cut off at 0.2, and it is scaled to length 512
// again; elements above 255 are cut off. (x, y) is in px of `grey`, and at least kFeatureMargin
// from its edges.
GradientDescriptor gradient_descriptor(const Image<float>& grey, double x, double y, double angle);

// The length of the difference; descriptors have about the length 512.
double distance(const GradientDescriptor& a, const GradientDescriptor& b);

}  // namespace glassbox::views
