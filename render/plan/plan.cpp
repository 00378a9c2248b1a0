#include <glassbox/render/plan/plan.h>

#include <algorithm>
#include <optional>

#include <glassbox/render/plan/draw_order.h>
#include <glassbox/render/plan/group_classifier.h>
#include <glassbox/render/plan/hidden_draws.h>

namespace glassbox {

namespace {

bool is_empty(const ColorMask& mask) {
  return !mask.r && !mask.g && !mask.b && !mask.a;
}

// Whether a picture of triangle numbers needs this draw's colours. Lines and points have no number:
// where one is seen, such a picture shows its colour, and if it is blended also the colours behind
// it.
bool keeps_colors(const Draw& draw) {
  return draw.material->alpha_mode == AlphaMode::kBlend &&
         !(draw.mesh->lines.empty() && draw.mesh->points.empty());
}

// Whether the colours of fragments are visible. Pictures of depth and of triangle numbers are made
// after the run from other images of the framebuffer.
bool sees_colors(const PlannedEye& eye) {
  if (is_empty(eye.settings.mask) || eye.settings.show == Show::kDepth) return false;
  return eye.settings.show != Show::kId || std::ranges::any_of(eye.list.draws, keeps_colors);
}

// The decisions that are the same for all draws of a group of instances; made when first needed.
struct GroupPlan {
  bool is_classified = false;
  std::optional<BoxClassification> classification;  // none: each draw has to be tested
  std::optional<DepthCodes> codes;
  const Mesh* mesh = nullptr;  // the mesh that `method` is for
  DrawMethod method;
};

// The groups of a scene of many instances, as one eye sees them.
class PlannedGroups {
public:
  explicit PlannedGroups(const PlannedEye& eye)
      : eye_(eye),
        classifier_(eye.view),
        plans_(eye.list.groups != nullptr ? eye.list.groups->groups.size() : 0) {}

  // Returns the method for a draw of the group; null if the draw has to be tested by itself.
  const DrawMethod* method_of(const Draw& draw, const MethodInputs& inputs) {
    if (plans_.empty()) return nullptr;
    GroupPlan& plan = plan_of(draw);
    if (!plan.is_classified) plan.classification = classifier_.classify(group_of(draw));
    plan.is_classified = true;
    if (!plan.classification) return nullptr;
    if (plan.mesh != draw.mesh) {
      plan.mesh = draw.mesh;
      plan.method = choose_method(draw, *plan.classification, inputs);
    }
    // Whether w is 1 also depends on the matrix of each draw; in a perspective view it is never
    // known to be 1.
    plan.method.divide = inputs.view.perspective || needs_divide(draw);
    return &plan.method;
  }

  DepthCodes codes_of(const Draw& draw) {
    const DepthFormat format = eye_.settings.depth;
    if (plans_.empty() || !plan_of(draw).classification)
      return depth_codes(draw, eye_.view, format);
    GroupPlan& plan = plan_of(draw);
    if (!plan.codes) plan.codes = classifier_.codes(group_of(draw), format);
    return *plan.codes;
  }

private:
  std::uint32_t index_of(const Draw& draw) const {
    return eye_.list.groups->of_instance[draw.instance];
  }
  const InstanceGroup& group_of(const Draw& draw) const {
    return eye_.list.groups->groups[index_of(draw)];
  }
  GroupPlan& plan_of(const Draw& draw) { return plans_[index_of(draw)]; }

  const PlannedEye& eye_;
  GroupClassifier classifier_;
  std::vector<GroupPlan> plans_;
};

Plan plan_draws(const PlannedEye& eye, bool leave_out) {
  PlannedGroups groups(eye);
  Plan plan;
  plan.leaves_out = leave_out;
  plan.colors = !leave_out || sees_colors(eye);
  if (leave_out) plan.channels = eye.settings.mask;
  plan.read_back = !leave_out;
  plan.keep_depth = !leave_out || eye.settings.want_depth;
  const MethodInputs inputs{eye.list.lighting, eye.view, eye.settings, plan.colors, leave_out};
  const std::vector<Draw>& draws = eye.list.draws;
  const bool ordered = leave_out && draws.size() > 1;
  plan.methods.reserve(draws.size());
  if (ordered) plan.codes.reserve(draws.size());
  for (const Draw& draw : draws) {
    const DrawMethod* const of_group = leave_out ? groups.method_of(draw, inputs) : nullptr;
    plan.methods.push_back(of_group != nullptr
                               ? *of_group
                               : choose_method(draw, classify_draw_box(draw, eye.view), inputs));
    if (ordered) {
      plan.codes.push_back(plan.methods.back().drawn ? groups.codes_of(draw) : DepthCodes{});
    }
  }
  return plan;
}

// Makes the plans of all eyes agree: what is computed for one eye is computed for all.
void unify_plans(std::span<Plan> plans) {
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

// Moves nearer draws before farther ones; draws into the framebuffer keep their place. The order is
// the same for both eyes of a pair, because their z and w are equal.
void order_draws(Plan& plan) {
  plan.order.reserve(plan.methods.size());
  for (std::uint32_t i = 0; i < plan.methods.size(); ++i) {
    if (plan.methods[i].drawn) plan.order.push_back(i);
  }
  if (plan.codes.empty()) return;
  const auto stays = [&](std::uint32_t i) { return plan.methods[i].into_framebuffer; };
  for (auto first = plan.order.begin(); first != plan.order.end();) {
    first = std::find_if_not(first, plan.order.end(), stays);
    const auto end = std::find_if(first, plan.order.end(), stays);
    plan.moved += order_front_to_back({first, end}, plan.codes);
    first = end;
  }
}

// Leaves out the draws that are hidden from all eyes: a draw that one of the eyes sees is drawn for
// all.
void leave_out_hidden(std::span<const PlannedEye> eyes, std::span<Plan> plans) {
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    if (!plans[i].leaves_out || eyes[i].has_behind_depth) return;
    const std::vector<bool> hidden = find_hidden_draws(eyes[i], plans[i]);
    if (std::ranges::find(hidden, true) == hidden.end()) return;  // this eye sees all of its draws
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
  if (plans.size() > 1) unify_plans(plans);
  order_draws(plans.front());
  for (Plan& plan : std::span(plans).subspan(1)) {
    plan.order = plans.front().order;
    plan.moved = plans.front().moved;
  }
  leave_out_hidden(eyes, plans);
  return plans;
}

void plan_picture(const Scene& scene, const PreparedScene& prepared,
                  std::span<const EyePicture> eyes, Planner planner, bool leave_out,
                  PlannedPicture& picture) {
  fill_draw_lists(scene, prepared, views_of(eyes), picture.lists);
  picture.eyes.clear();
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    picture.eyes.push_back(
        {picture.lists[i], eyes[i].view, eyes[i].settings, eyes[i].behind_depth != nullptr});
  }
  picture.plans = planner(picture.eyes, leave_out);
}

}  // namespace glassbox
