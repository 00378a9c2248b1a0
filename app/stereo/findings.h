// Everything that can be said about a pair of eyes in a scene: what `glassbox stereo` reports.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/options/picture_options.h"

#include <glassbox/base/error.h>
#include <glassbox/images/stereo/anaglyph.h>
#include <glassbox/images/stereo/information.h>
#include <glassbox/images/stereo/order.h>
#include <glassbox/images/stereo/recolour.h>
#include <glassbox/images/stereo/rivalry.h>
#include <glassbox/pipeline/stereo/comfort.h>
#include <glassbox/pipeline/stereo/parallax.h>
#include <glassbox/render/renderer.h>
#include <glassbox/render/stereo/disparity.h>
#include <glassbox/render/stereo/monocular.h>
#include <glassbox/render/stereo/render_pair.h>
#include <glassbox/render/stereo/window_violations.h>

namespace glassbox::app {

// What the pair is held against.
struct StereoQuestion {
  double budget_percent = kComfortablePercent;  // of the width, before the window and behind it
  Display display;
  AnaglyphMethod method = AnaglyphMethod::kMask;
  Glasses glasses = Glasses::kRedCyan;
  double target_rivalry = 0.1;  // the mean over both pictures
};

// One value for each eye.
template <class T>
struct BothEyes {
  T left, right;
};

// The depth in the pictures.
struct DepthFindings {
  ParallaxTable planes;           // of the near plane, the window and the far plane
  std::optional<DepthSpan> seen;  // by either eye; none where nothing is drawn
  Parallax nearest, farthest;     // of what is seen
  ParallaxBudget budget;
  BothEyes<Image<float>> disparity;
  BothEyes<DisparitySummary> summary;
  DisparityHistogram histogram;  // of the left eye's pixels
  MonocularMaps monocular;
  BothEyes<MonocularCounts> monocular_counts;
  WindowViolations violations;
  DisplayedParallax farthest_displayed, nearest_displayed;

  // Of both eyes' pixels, in [0, 1].
  double share_beyond_budget() const;
  // The largest parallax seen on either side, per cent of the width.
  double largest_percent() const;
};

// Vertical parallax, px.
struct VerticalFindings {
  // By how much the eyes' matrices disagree on y and w: 0 px exactly where they have the same bits, else the largest
  // difference at the corners of what is seen.
  double skewed_px = 0;
  // What cameras that are toed in would have: the largest of what the centre's picture shows, and where.
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
  BothEyes<Image<float>> rivalry;
  double mean_rivalry = 0, worst_rivalry = 0;
  GhostMaps ghosts;                          // signed
  BothEyes<double> mean_ghost, worst_ghost;  // of their sizes
  Ghosts white_leak;
  bool measured_lenses = false;
  std::vector<MethodFindings> methods;   // all that there are for these glasses
  std::optional<Suggestion> suggestion;  // where the target is missed
};

// What culling by the camera between the eyes would lose (E20).
struct CullingFindings {
  std::uint64_t triangles = 0;           // in the view of an eye
  BothEyes<std::uint64_t> pixels{0, 0};  // that would show something else
};

struct CostFindings {
  double one_ms = 0, both_ms = 0;  // one run each, on this machine, at this time
  double ratio() const { return one_ms > 0 ? both_ms / one_ms : 0; }
};

struct StereoFindings {
  ChosenEyes chosen;
  StereoQuestion question;
  StereoRendering rendering;  // with distance and id
  DepthFindings depth;
  VerticalFindings vertical;
  ColourFindings colour;
  StereoInformation information;
  Image<std::uint8_t> information_map;  // InformationMark
  OrderEvidence pair_order, anaglyph_order;
  CullingFindings culling;
  CostFindings cost;
};

// Runs for the camera between the eyes, for both eyes, and for both with the centre's culling. `renderer` draws the scene.
Result<StereoFindings> find_stereo(const Scene& scene, Renderer& renderer, const ChosenEyes& chosen,
                                   const RenderSettings& settings, const StereoQuestion& question);

}  // namespace glassbox::app
