// CIEDE2000: how different two colours look, in units of a just noticeable difference (about 1).
//
// CIE 142-2001; Sharma, Wu, Dalal: The CIEDE2000 Color-Difference Formula: Implementation Notes,
// Supplementary Test Data, and Mathematical Observations. Color Research and Application 30(1),
// 2005.
#pragma once

namespace glassbox {

// A CIELAB colour, relative to the white of sRGB (D65).
struct Lab {
  double l = 0, a = 0, b = 0;
};

// Converts linear sRGB, each in [0, 1]. White gives (100, 0, 0), and greys have a = b = 0 within
// 1e-13.
Lab lab_of_linear(double red, double green, double blue);

// The CIEDE2000 difference with k_L = k_C = k_H = 1. It is symmetric, 0 for the same colour, and at
// most about 120 for two colours of sRGB. Cube roots and the exponential come from the C library:
// the last bits may differ between machines, but no printed digit should.
double ciede2000(const Lab& one, const Lab& other);

}  // namespace glassbox
