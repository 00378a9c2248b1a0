// Plans which work of a picture can be left out, and in which order its draws are drawn. The proofs
// are cheap: they use boxes, matrices, materials, and which images are wanted. The bytes are those
// of the staged reference, with or without a plan.
//
// The engine reads the flags of the plan; decisions.h puts them into words, each decision with its
// proof.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/engine/engine.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/plan/box_bounds.h>
#include <glassbox/render/plan/draw_method.h>

namespace glassbox {

// What the plan for one eye's picture is made from.
struct PlannedEye {
  const DrawList& list;
  const View& view;
  const RenderSettings& settings;
  // EyePicture::behind_depth is set: surfaces in front of it are not drawn, so they hide nothing.
  bool has_behind_depth = false;
};

struct Plan {
  bool leaves_out = true;
  std::vector<DrawMethod> methods;   // one for each draw
  std::vector<std::uint32_t> order;  // the draws that are drawn, in the order of drawing
  // The range of depth codes of each draw within the view, or that of its group of instances. Empty
  // if there is nothing to order.
  std::vector<DepthCodes> codes;
  std::size_t moved = 0;  // how many draws were moved before earlier draws of the list

  bool colors = true;  // the colours are visible
  ColorMask channels;  // the channels that are encoded
  // The picture's pixels are read before they are written, even if their values are not needed.
  bool read_back = false;
  bool keep_depth = false;  // in the framebuffer, because depth is wanted
};

// Makes one plan for each eye of a picture: one eye, or the two of a pair, whose views differ in x
// alone. The plans agree in the order, and in what is computed for both eyes. `leave_out` = false:
// everything runs that a proof would leave out.
using Planner = std::vector<Plan> (*)(std::span<const PlannedEye> eyes, bool leave_out);
std::vector<Plan> make_plans(std::span<const PlannedEye> eyes, bool leave_out);

// The draw lists and plans of a picture, one for each eye. The members of `eyes` refer to `lists`.
// Memory is reused for the next picture.
struct PlannedPicture {
  std::vector<DrawList> lists;
  std::vector<PlannedEye> eyes;
  std::vector<Plan> plans;
};

void plan_picture(const Scene& scene, const PreparedScene& prepared,
                  std::span<const EyePicture> eyes, Planner planner, bool leave_out,
                  PlannedPicture& picture);

}  // namespace glassbox
