// The report as one HTML page that needs no other file, as text and as JSON; and its pictures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/stereo/findings.h"
#include "app/stereo/verdicts.h"

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

namespace glassbox::app {

struct StereoPageOrigin {
  std::string program;  // "glassbox 0.1.0"
  std::string command;  // the command line that made the page
};

// A page has about ten pictures. An error if they would be too large for a browser.
Result<void> check_page_size(int width, int height);

// `report` has the scene's name, the picture's size and the members of stereo_json; the page's
// script reads it.
Result<std::string> make_stereo_page(const StereoFindings& found,
                                     const nlohmann::ordered_json& report,
                                     const StereoPageOrigin& origin);

// The parallax at a distance, and the name of what is there.
struct ParallaxRow {
  std::string name;
  Parallax parallax;
  DisplayedParallax displayed;
};
// The rows from near to far: the planes, the window, and the visible depths.
std::vector<ParallaxRow> parallax_rows(const StereoFindings& found);

// The parts of a report that are sentences.
struct StereoWords {
  std::vector<Verdict> verdicts;
  std::vector<Advice> advice;
};

std::string stereo_text(const StereoFindings& found, const StereoWords& words);

// The report as JSON, which is also the data for the page's script.
nlohmann::ordered_json stereo_json(const Scene& scene, const StereoFindings& found,
                                   const StereoWords& words);

// The findings as pictures.

// A picture with a colour for each disparity from -limit_px (orange, in front) over 0 (near white)
// to limit_px (blue, behind). Disparities beyond the budget have stripes. Pixels where nothing is
// drawn are dark grey.
Image<Rgba8> disparity_picture(const Image<float>& disparity, const ParallaxBudget& budget,
                               double limit_px);
Rgba8 disparity_colour(double px, double limit_px);

// The absolute values as a heat map from 0 (black) to `limit` (white).
Image<Rgba8> heat_of(const Image<float>& values, double limit);

// For each pixel, the larger one of the two images' absolute values.
Image<float> larger_of(const Image<float>& a, const Image<float>& b);

// Shows edges that the eyes see at different positions in orange and other edges in blue, over the
// picture in dark grey.
Image<Rgba8> information_picture(const Image<Rgba8>& left, const Image<std::uint8_t>& marks);

// Shows the pixels of surfaces that the picture's edge cuts in red, over the picture in grey.
Image<Rgba8> violation_picture(const Image<Rgba8>& eye, const Image<std::uint8_t>& marks);

// Shows pixels that only this eye sees: those hidden from the other eye in orange, those outside
// the other eye's picture in blue, those missing there in magenta.
Image<Rgba8> monocular_picture(const Image<Rgba8>& eye, const Image<OtherEyeVisibility>& map);

}  // namespace glassbox::app
