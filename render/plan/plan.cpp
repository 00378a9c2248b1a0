#include <glassbox/render/plan/plan.h>

#include <algorithm>

#include <glassbox/render/plan/draw_order.h>
#include <glassbox/render/plan/hidden_draws.h>

namespace glassbox {

namespace {

bool is_empty(const ColorMask& mask) {
  return !mask.r && !mask.g && !mask.b && !mask.a;
}

// Pictures of depth and of numbers are painted from other planes, after the run.
bool sees_colors(const RenderSettings& settings) {
  return settings.show != Show::kDepth && settings.show != Show::kId && !is_empty(settings.mask);
}

Plan plan_draws(const PlannedEye& eye, bool leave_out) {
  Plan plan;
  plan.leaves_out = leave_out;
  plan.colors = !leave_out || sees_colors(eye.settings);
  if (leave_out) plan.channels = eye.settings.mask;
  plan.read_back = !leave_out;
  plan.keep_depth = !leave_out || eye.settings.want_depth;
  for (const Draw& draw : eye.list.draws) {
    plan.methods.push_back(
        choose_method(draw, eye.list.lighting, eye.view, eye.settings, plan.colors, leave_out));
  }
  return plan;
}

// What is computed for one eye is computed for all.
void make_agree(std::span<Plan> plans) {
  for (std::size_t draw = 0; draw < plans.front().methods.size(); ++draw) {
    DrawMethod any = plans.front().methods[draw];
    for (const Plan& plan : plans) {
      const DrawMethod& one = plan.methods[draw];
      any.drawn = any.drawn || one.drawn;
      any.normals = any.normals || one.normals;
      any.face_normals = any.face_normals || one.face_normals;
      any.eye_positions = any.eye_positions || one.eye_positions;
    }
    for (Plan& plan : plans) {
      DrawMethod& one = plan.methods[draw];
      one.drawn = any.drawn;
      one.normals = any.normals;
      one.face_normals = any.face_normals;
      one.eye_positions = any.eye_positions;
    }
  }
}

// What is blended lies over what came before it. The staged stages write to the framebuffer, and to move them among the others
// would make tiles change over more often. Lines and points are left where they are, too.
bool may_be_moved(const Draw& draw, const DrawMethod& method) {
  return method.staged_because == nullptr && draw.material->alpha_mode != AlphaMode::kBlend &&
         draw.mesh->lines.empty() && draw.mesh->points.empty();
}

// Depth does not depend on the eye: z and w are the same for both.
void order_draws(const PlannedEye& eye, Plan& plan) {
  const std::vector<Draw>& draws = eye.list.draws;
  for (std::uint32_t i = 0; i < draws.size(); ++i) {
    if (plan.methods[i].drawn) plan.order.push_back(i);
  }
  if (!plan.leaves_out || plan.order.size() < 2) return;
  std::vector<DepthCodes> codes(draws.size());
  for (const std::uint32_t i : plan.order) {
    codes[i] = depth_codes(draws[i], eye.view, eye.settings.depth);
  }
  const auto stays = [&](std::uint32_t i) { return !may_be_moved(draws[i], plan.methods[i]); };
  for (auto first = plan.order.begin(); first != plan.order.end();) {
    first = std::find_if_not(first, plan.order.end(), stays);
    const auto end = std::find_if(first, plan.order.end(), stays);
    plan.moved += order_front_to_back({first, end}, codes);
    first = end;
  }
}

// What one of the eyes sees is drawn for all.
void leave_out_hidden(std::span<const PlannedEye> eyes, std::span<Plan> plans) {
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    if (!plans[i].leaves_out) return;
    const std::vector<bool> hidden = find_hidden(eyes[i], plans[i]);
    for (std::size_t draw = 0; draw < hidden.size(); ++draw) {
      plans[i].methods[draw].hidden = hidden[draw];
    }
  }
  const auto no_eye_sees = [&](std::uint32_t draw) {
    return std::ranges::all_of(plans, [&](const Plan& p) { return p.methods[draw].hidden; });
  };
  for (const std::uint32_t draw : plans.front().order) {
    if (!no_eye_sees(draw)) continue;
    for (Plan& plan : plans) plan.methods[draw].drawn = false;
  }
  for (Plan& plan : plans) {
    std::erase_if(plan.order, [&](std::uint32_t draw) { return !plan.methods[draw].drawn; });
  }
}

}  // namespace

std::vector<Plan> make_plans(std::span<const PlannedEye> eyes, bool leave_out) {
  std::vector<Plan> plans;
  for (const PlannedEye& eye : eyes) plans.push_back(plan_draws(eye, leave_out));
  make_agree(plans);
  order_draws(eyes.front(), plans.front());
  for (Plan& plan : plans) {
    plan.order = plans.front().order;
    plan.moved = plans.front().moved;
  }
  leave_out_hidden(eyes, plans);
  return plans;
}

}  // namespace glassbox
