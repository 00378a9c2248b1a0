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
#include <glassbox/images/stereo/information.h>
#include <glassbox/images/stereo/order.h>
#include <glassbox/images/stereo/recolour.h>
#include <glassbox/images/stereo/rivalry.h>
#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/pipeline/stereo/parallax_budget.h>
#include <glassbox/render/renderer.h>
#include <glassbox/render/stereo/disparity.h>
#include <glassbox/render/stereo/monocular.h>
#include <glassbox/render/stereo/render_pair.h>
#include <glassbox/render/stereo/window_violations.h>

namespace glassbox::app {

// The requirements that the pair is compared with.
struct StereoCriteria {
  // of the width, in front of the window and behind it
  double budget_percent = kComfortablePercent;
  Display display;
  AnaglyphMethod method = AnaglyphMethod::kMask;
  Glasses glasses = Glasses::kRedCyan;
  double target_rivalry = 0.1;  // for the mean over both pictures
};

// One value for each eye.
template <class T>
struct PerEye {
  T left, right;
};

// The depth that is visible in the pictures.
struct DepthFindings {
  ParallaxTable planes;           // at the near plane, the window and the far plane
  std::optional<DepthSpan> seen;  // by either eye; none if nothing is drawn
  Parallax nearest, farthest;     // of the visible depths
  ParallaxBudget budget;
  PerEye<Image<float>> disparity;
  PerEye<DisparitySummary> summary;
  DisparityHistogram histogram;  // of the left eye's pixels
  MonocularMaps monocular;
  PerEye<MonocularCounts> monocular_counts;
  WindowViolations violations;
  DisplayedParallax farthest_displayed, nearest_displayed;

  // The share of both eyes' pixels, in [0, 1].
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
  // centre's picture; (x, y) is the point's pixel.
  double toed_in_px = 0;
  int x = 0, y = 0;
};

// One way to make an anaglyph of the two pictures.
struct MethodFindings {
  AnaglyphMethod method = AnaglyphMethod::kMask;
  double rivalry = 0;  // mean
  double ghosts = 0;   // mean of both eyes
};

struct ColourFindings {
  Image<Rgba8> anaglyph;
  PerEye<Image<float>> rivalry;
  double mean_rivalry = 0, worst_rivalry = 0;
  GhostMaps ghosts;                        // with signs
  PerEye<double> mean_ghost, worst_ghost;  // of the absolute values
  Ghosts white_leak;
  bool measured_lenses = false;
  std::vector<MethodFindings> methods;   // all methods for these glasses
  std::optional<Suggestion> suggestion;  // if the target is missed
};

// What would be lost if triangles were culled by the camera between the eyes (E20).
struct CullingFindings {
  std::uint64_t triangles = 0;         // visible to an eye, but culled
  PerEye<std::uint64_t> pixels{0, 0};  // that would change
};

struct CostFindings {
  double one_ms = 0, both_ms = 0;  // one run each, on this machine
  double ratio() const { return one_ms > 0 ? both_ms / one_ms : 0; }
};

struct StereoFindings {
  ChosenEyes chosen;
  StereoCriteria criteria;
  StereoRendering rendering;  // with the distance and id planes
  DepthFindings depth;
  VerticalFindings vertical;
  ColourFindings colour;
  StereoInformation information;
  Image<std::uint8_t> information_map;  // values of InformationMark
  OrderEvidence pair_order, anaglyph_order;
  CullingFindings culling;
  CostFindings cost;
};

// Draws for the camera between the eyes, for both eyes, and for both with culling by the centre.
// `renderer` draws the scene.
Result<StereoFindings> find_stereo(const Scene& scene, Renderer& renderer, const ChosenEyes& chosen,
                                   const RenderSettings& settings, const StereoCriteria& criteria);

}  // namespace glassbox::app
