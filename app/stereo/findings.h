// All findings about a pair of eyes in a scene, which `glassbox stereo` reports.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/picture_options.h"

#include <glassbox/base/error.h>
#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/images/stereo/recolour.h>
#include <glassbox/images/stereo/rivalry.h>
#include <glassbox/images/stereo/swapped_eyes.h>
#include <glassbox/images/stereo/visible_depth.h>
#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/pipeline/stereo/parallax_budget.h>
#include <glassbox/render/renderer.h>
#include <glassbox/render/stereo/disparity.h>
#include <glassbox/render/stereo/monocular.h>
#include <glassbox/render/stereo/render_pair.h>
#include <glassbox/render/stereo/window_violations.h>

namespace glassbox::app {

// The limits that the two eyes' pictures should keep.
struct StereoCriteria {
  // the largest parallax in front of the window and behind it, in per cent of the picture's width
  double budget_percent = kComfortablePercent;
  Display display;
  AnaglyphMethod method = AnaglyphMethod::kMask;
  Glasses glasses = Glasses::kRedCyan;
  double target_rivalry = 0.1;  // the largest mean rivalry of both pictures that is accepted
};

// One value for each eye.
template <class T>
struct PerEye {
  T left, right;
};

// The depth that is visible in the pictures.
struct DepthFindings {
  ParallaxTable planes;           // at the near plane, the window and the far plane
  std::optional<DepthSpan> seen;  // by the left or the right eye; none if nothing is drawn
  Parallax nearest, farthest;     // the parallax of the nearest and of the farthest visible depth
  ParallaxBudget budget;
  PerEye<Image<float>> disparity;
  PerEye<DisparitySummary> summary;
  DisparityHistogram histogram;  // of the left eye's pixels
  MonocularMaps monocular;
  PerEye<MonocularCounts> monocular_counts;
  WindowViolations violations;
  DisplayedParallax farthest_displayed, nearest_displayed;

  // The fraction of both pictures' drawn pixels that have more parallax than the budget, in [0, 1].
  double share_beyond_budget() const;
  // The largest visible parallax, in front of the window or behind it, in per cent of the width.
  double largest_percent() const;
};

// Vertical parallax, px.
struct VerticalFindings {
  // The largest vertical difference between the eyes' pictures of a visible point. It is exactly 0
  // px if the eyes' matrices agree on y and w bit for bit.
  double skewed_px = 0;
  // The largest vertical parallax that toed-in cameras would have for a point visible in the
  // picture of the camera between the eyes; (x, y) is the point's pixel.
  double toed_in_px = 0;
  int x = 0, y = 0;
};

// A method of making an anaglyph of the two pictures, with the errors that it would have.
struct MethodFindings {
  AnaglyphMethod method = AnaglyphMethod::kMask;
  double rivalry = 0;  // mean over both pictures
  double ghosts = 0;   // mean over both eyes
};

struct ColourFindings {
  Image<Rgba8> anaglyph;
  PerEye<Image<float>> rivalry;
  double mean_rivalry = 0, worst_rivalry = 0;
  GhostMaps ghosts;                        // positive and negative values
  PerEye<double> mean_ghost, worst_ghost;  // of the absolute values
  Ghosts white_leak;
  bool measured_lenses = false;
  std::vector<MethodFindings> methods;   // all methods for these glasses
  std::optional<Suggestion> suggestion;  // set if the mean rivalry is above the target
};

// What would be lost if triangles were culled by the camera between the eyes (E20).
struct CullingFindings {
  std::uint64_t triangles = 0;         // how many are visible to an eye, but culled
  PerEye<std::uint64_t> pixels{0, 0};  // how many would change
};

struct CostFindings {
  double one_ms = 0, both_ms = 0;  // the time of one run for one eye and for both, on this machine
  double ratio() const { return one_ms > 0 ? both_ms / one_ms : 0; }
};

struct StereoFindings {
  ChosenEyes chosen;
  StereoCriteria criteria;
  StereoRendering rendering;  // with the images of distances and of triangle ids
  DepthFindings depth;
  VerticalFindings vertical;
  ColourFindings colour;
  StereoInformation information;
  Image<std::uint8_t> information_map;  // values of InformationMark
  OrderEvidence pair_order, anaglyph_order;
  CullingFindings culling;
  CostFindings cost;
};

// Draws the scene for the camera between the eyes, for both eyes, and for both eyes with triangles
// culled by the camera between them, then compares the pictures. `renderer` draws the scene.
Result<StereoFindings> find_stereo(const Scene& scene, Renderer& renderer, const ChosenEyes& chosen,
                                   const RenderSettings& settings, const StereoCriteria& criteria);

}  // namespace glassbox::app
