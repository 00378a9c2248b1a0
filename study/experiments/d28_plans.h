// The plans of the elision experiment (D-28): each leaves out only what one decision allows.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <glassbox/render/plan/plan.h>

namespace glassbox::study::d28 {

// ---- plans with one decision: `take` copies it from the plan that leaves out all it can ----

using Take = void (*)(const Plan& with, Plan& plan);

template <Take take>
std::vector<Plan> plan_only(std::span<const PlannedEye> eyes, bool) {
  std::vector<Plan> plans = make_plans(eyes, false);
  const std::vector<Plan> with = make_plans(eyes, true);
  for (std::size_t i = 0; i < plans.size(); ++i) take(with[i], plans[i]);
  return plans;
}

inline std::vector<Plan> plan_nothing(std::span<const PlannedEye> eyes, bool) {
  return make_plans(eyes, false);
}
// Copies no decision. plan_only() still makes two plans, so that both sides of a comparison include
// the same time of planning.
inline void take_none(const Plan&, Plan&) {}

template <class Copy>
void for_methods(const Plan& with, Plan& plan, Copy&& copy) {
  for (std::size_t i = 0; i < plan.methods.size(); ++i) copy(with.methods[i], plan.methods[i]);
}

inline void take_outside(const Plan& with, Plan& plan) {
  for_methods(with, plan,
              [](const DrawMethod& from, DrawMethod& to) { to.drawn = from.drawn || from.hidden; });
  std::erase_if(plan.order, [&](std::uint32_t draw) { return !plan.methods[draw].drawn; });
}
inline void take_clusters(const Plan& with, Plan& plan) {
  for_methods(with, plan, [](const DrawMethod& from, DrawMethod& to) {
    to.no_clusters_because = from.no_clusters_because;
  });
}
inline void take_runs(const Plan& with, Plan& plan) {
  for_methods(with, plan, [](const DrawMethod& from, DrawMethod& to) {
    to.alone_because = from.alone_because;
  });
}
inline void take_plane_tests(const Plan& with, Plan& plan) {
  for_methods(with, plan,
              [](const DrawMethod& from, DrawMethod& to) { to.test_planes = from.test_planes; });
}
inline void take_divide(const Plan& with, Plan& plan) {
  for_methods(with, plan, [](const DrawMethod& from, DrawMethod& to) { to.divide = from.divide; });
}
inline void take_normals(const Plan& with, Plan& plan) {
  for_methods(with, plan, [](const DrawMethod& from, DrawMethod& to) {
    to.normals = from.normals;
    to.face_normals = from.face_normals;
  });
}
// Without highlights, the position of the surface is not needed, so the two decisions are one.
inline void take_highlights(const Plan& with, Plan& plan) {
  for_methods(with, plan, [](const DrawMethod& from, DrawMethod& to) {
    to.highlights = from.highlights;
    to.eye_positions = from.eye_positions;
  });
}
// Copies the order of drawing. A draw outside the picture is not in the other plan's order; here it
// is kept, and drawn last.
inline void take_order(const Plan& with, Plan& plan) {
  std::vector<std::uint32_t> order = with.order;
  for (const std::uint32_t draw : plan.order) {
    if (std::ranges::find(with.order, draw) == with.order.end()) order.push_back(draw);
  }
  plan.order = std::move(order);
  plan.moved = with.moved;
}
// Copies which draws are hidden. The draws that hide them must come first, so this also copies the
// order.
inline void take_hidden(const Plan& with, Plan& plan) {
  take_order(with, plan);
  for_methods(with, plan, [](const DrawMethod& from, DrawMethod& to) { to.drawn = !from.hidden; });
  std::erase_if(plan.order, [&](std::uint32_t draw) { return !plan.methods[draw].drawn; });
}
inline void take_colors(const Plan& with, Plan& plan) {
  plan.colors = with.colors;
  for_methods(with, plan, [](const DrawMethod& from, DrawMethod& to) {
    to.light = from.light;
    to.texture = from.texture;
    to.vertex_colors = from.vertex_colors;
  });
}
inline void take_channels(const Plan& with, Plan& plan) {
  plan.channels = with.channels;
}
inline void take_read_back(const Plan& with, Plan& plan) {
  plan.read_back = with.read_back;
}
inline void take_depth(const Plan& with, Plan& plan) {
  plan.keep_depth = with.keep_depth;
}

}  // namespace glassbox::study::d28
