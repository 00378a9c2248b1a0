// Plans which of a picture's work can be left out, and the order of the rest. It uses cheap proofs:
// boxes, matrices, materials, and the wanted planes. The bytes are those of the staged reference,
// with or without a plan.
//
// The engine reads the flags; decisions.h puts the same into words, each decision with its proof.
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

// The inputs of one eye's picture.
struct PlannedEye {
  const DrawList& list;
  const View& view;
  const RenderSettings& settings;
  bool has_behind_depth = false;  // EyePicture::behind_depth is set: what is in front hides nothing
};

struct Plan {
  bool leaves_out = true;
  std::vector<DrawMethod> methods;   // by draw
  std::vector<std::uint32_t> order;  // the order of drawing, of the draws that are drawn
  // The depth codes of each draw within the view, or those of its group of instances. Empty where
  // there is nothing to order.
  std::vector<DepthCodes> codes;
  std::size_t moved = 0;  // how many draws were moved before earlier draws of the list

  bool colors = true;  // the colours are visible
  ColorMask channels;  // the channels that are encoded
  // The picture's pixels are read before they are written, even if they are not needed.
  bool read_back = false;
  bool keep_depth = false;  // in a plane of the framebuffer, because it is wanted
};

// Makes one plan for each eye of a picture: one eye, or the two of a pair, whose views differ in x
// alone. The plans agree in the order, and in what is computed for both eyes. `leave_out` = false:
// everything runs that a proof would leave out.
using Planner = std::vector<Plan> (*)(std::span<const PlannedEye> eyes, bool leave_out);
std::vector<Plan> make_plans(std::span<const PlannedEye> eyes, bool leave_out);

// The draws of a picture's eyes, and what is planned for them. By eye. The eyes refer to the lists;
// memory is used again for the next picture.
struct PlannedPicture {
  std::vector<DrawList> lists;
  std::vector<PlannedEye> eyes;
  std::vector<Plan> plans;
};

void plan_picture(const Scene& scene, const PreparedScene& prepared,
                  std::span<const EyePicture> eyes, Planner planner, bool leave_out,
                  PlannedPicture& picture);

}  // namespace glassbox
