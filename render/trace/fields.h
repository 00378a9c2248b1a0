// The numbers of a trace's records and their bounds, each with its name, as used by arrays
// (arrays.h) and JSON (app/trace/json.h). `field` is called with every name and number, always in
// the same order. A number has an arithmetic type, or is an array, a vector or a matrix of such
// numbers; a std::optional number may be missing.
#pragma once

#include <array>
#include <optional>

#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

inline std::array<float, 4> numbers_of(const Rgba& c) {
  return {c.r, c.g, c.b, c.a};
}
inline std::array<std::uint8_t, 4> numbers_of(const Rgba8& c) {
  return {c.r, c.g, c.b, c.a};
}

template <class Field>
void each_field(const TracedDraw& draw, const DrawBounds& bounds, Field& field) {
  field("first_number", draw.first_number);
  field("mirrored", draw.mirrored);
  field("world_from_object", draw.world_from_object.columns);
  field("anchor", to_glm(draw.anchor));
  field("clip_from_anchored", draw.clip_from_anchored.columns);
  field("clip_from_anchored_bound", bounds.clip_from_anchored);
  field("eye_from_anchored", draw.eye_from_anchored.columns);
  field("eye_from_anchored_bound", bounds.eye_from_anchored);
}

template <class Field>
void each_field(const TracedCorner& corner, const CornerBounds& bounds, Field& field) {
  field("corner", corner.corner);
  field("position", corner.position);
  field("object", to_glm(corner.object));
  field("world", to_glm(corner.world));
  field("world_bound", bounds.world);
  field("eye", to_glm(corner.eye));
  field("eye_bound", bounds.eye);
  field("clip", to_glm(corner.clip));
  field("clip_bound", bounds.clip);
}

template <class Field>
void each_field(const TracedVertex& vertex, const VertexBounds& bounds, Field& field) {
  std::optional<glm::dvec3> condition;
  if (bounds.condition != glm::dvec3(0)) condition = bounds.condition;
  field("clip", to_glm(vertex.clip.position));
  field("clip_bound", bounds.clip.position);
  field("weights", vertex.clip.weights);
  field("weights_bound", bounds.clip.weights);
  field("ndc", to_glm(vertex.ndc.position));
  field("ndc_bound", bounds.ndc.position);
  field("ndc_condition", condition);
  field("inverse_w", vertex.ndc.inverse_w);
  field("inverse_w_bound", bounds.ndc.inverse_w);
  field("screen", std::array{vertex.screen.position.x, vertex.screen.position.y});
  field("screen_bound", std::array{bounds.screen.x, bounds.screen.y});
  field("snapped", std::array{vertex.snapped.x, vertex.snapped.y});
  field("snap_stable", std::array{bounds.snap_x.stable, bounds.snap_y.stable});
}

template <class Field>
void each_field(const Varyings& at, Field& field) {
  field("normal", at.normal);
  field("position", at.position);
  field("diffuse", at.diffuse);
  field("specular", at.specular);
  field("color", at.color);
  field("texcoord", at.texcoord);
}

template <class Field>
void each_field(const RoundTrips& trips, Field& field) {
  field("corners", trips.corners);
  field("unbounded", trips.unbounded);
  field("largest_error", trips.largest_error);
  field("bound", trips.bound);
  field("triangle", trips.place.triangle);
  field("corner", trips.place.corner);
  field("axis", trips.place.axis);
  field("largest_ratio", trips.largest_ratio);
}

}  // namespace glassbox
