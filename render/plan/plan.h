// What of a picture's work can be left out, and in which order the rest is done, from cheap proofs: boxes, matrices, materials,
// and what was asked for (DESIGN 4). The bytes are those of the staged reference, with a plan or without.
//
// The engine reads the flags; decisions.h says the same in words, each with its proof.
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

// One eye's picture.
struct PlannedEye {
  const DrawList& list;
  const View& view;
  const RenderSettings& settings;
  bool sees_through = false;  // EyePicture::behind: what is in front hides nothing
};

struct Plan {
  bool leaves_out = true;
  std::vector<DrawMethod> methods;   // by draw
  std::vector<std::uint32_t> order;  // of drawing: those draws that are drawn
  // By draw, of those within the view: its own, or those of a group that it is in. Empty where there is nothing to order.
  std::vector<DepthCodes> codes;
  std::size_t moved = 0;  // that many of them before others which the list has earlier

  bool colors = true;       // somebody sees them
  ColorMask channels;       // that are encoded
  bool read_back = false;   // the picture's pixels are read before they are written, needed or not
  bool keep_depth = false;  // in a plane of the framebuffer, for somebody who asked
};

// One for each eye of a picture: one eye, or the two of a pair, whose views differ in x alone. They agree in the order, and in
// what is computed for both. `leave_out` = false: everything runs that a proof would leave out.
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
