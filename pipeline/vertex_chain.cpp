#include <glassbox/pipeline/vertex_chain.h>

#include <cmath>

#include <glassbox/pipeline/divide.h>

namespace glassbox {
namespace {

TransformStep first_step(const glm::mat4& m, const glm::dmat4& m_bound, const glm::vec4& object) {
  return {m, object, transform_by_rows(m, object),
          transform_bound(m, object, glm::dvec4(0), m_bound), magnitude(m, object)};
}

TransformStep next_step(const glm::mat4& m, const glm::dmat4& m_bound,
                        const TransformStep& previous) {
  return {m, previous.after, transform_by_rows(m, previous.after),
          transform_bound(m, previous.after, previous.bound, m_bound),
          magnitude(m, previous.magnitude)};
}

PlaneStep test_plane(const ClipPlane& plane, const Point<Clip>& clip, const glm::dvec4& bound) {
  const auto part = [](double coefficient, double b) {
    return coefficient == 0 ? 0 : std::abs(coefficient) * b;
  };
  return {plane, signed_distance(plane, clip),
          part(plane.a, bound.x) + part(plane.b, bound.y) + part(plane.c, bound.z) +
              part(plane.d, bound.w)};
}

template <class Target, class Source>
Transform<Target, Source> in_double(const Transform<Target, Source, float>& m) {
  return Transform<Target, Source>(glm::dmat4(m.columns));
}

void add_round_trip(VertexChain& chain, const ChainMatrices& m, const Viewport& viewport) {
  const glm::vec4& p = chain.object;
  if (p.w != 1) return;
  const auto eye_from_object = in_double(m.eye_from_world) * in_double(m.world_from_object);
  const auto clip_from_eye = in_double(m.clip_from_eye);
  const glm::dmat4 eye_from_object_bound =
      product_bound(glm::dmat4(m.eye_from_world.columns), glm::dmat4(m.world_from_object.columns),
                    m.eye_from_world_bound, m.world_from_object_bound);
  const ForwardTransform forward{(clip_from_eye * eye_from_object).columns,
                                 product_bound(clip_from_eye.columns, eye_from_object.columns,
                                               m.clip_from_eye_bound, eye_from_object_bound)};
  chain.round_trip =
      round_trip(Point<Object>(p.x, p.y, p.z), chain.clip, chain.to_clip.bound, forward, viewport);
}

bool is_finite(const Point<Clip>& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

void set_verdict(VertexChain& chain) {
  if (!is_finite(chain.clip)) {
    chain.verdict = VertexVerdict::kNotFinite;
  } else if (chain.clip.w < 0) {
    chain.verdict = VertexVerdict::kBehindEye;
  } else if (chain.clip.w == 0) {
    chain.verdict = VertexVerdict::kInEyePlane;
  } else {
    double deepest = 0;
    for (std::size_t i = 0; i < chain.planes.size(); ++i) {
      if (chain.planes[i].distance >= deepest) continue;
      deepest = chain.planes[i].distance;
      chain.verdict = VertexVerdict::kOutside;
      chain.deciding_plane = int(i);
    }
  }
}

}  // namespace

glm::vec4 transform_by_rows(const glm::mat4& m, const glm::vec4& v) {
  glm::vec4 product;
  for (int row = 0; row < 4; ++row) {
    product[row] = m[0][row] * v.x + m[1][row] * v.y + m[2][row] * v.z + m[3][row] * v.w;
  }
  return product;
}

VertexChain make_vertex_chain(const glm::vec4& object, const ChainMatrices& matrices,
                              const ApiDialect& dialect, const Viewport& viewport) {
  VertexChain chain;
  chain.object = object;
  chain.to_world =
      first_step(matrices.world_from_object.columns, matrices.world_from_object_bound, object);
  chain.to_eye =
      next_step(matrices.eye_from_world.columns, matrices.eye_from_world_bound, chain.to_world);
  chain.to_clip =
      next_step(matrices.clip_from_eye.columns, matrices.clip_from_eye_bound, chain.to_eye);
  chain.clip = Point<Clip>(chain.to_clip.after);
  const Transform<Clip, Object> composed = in_double(matrices.clip_from_eye) *
                                           in_double(matrices.eye_from_world) *
                                           in_double(matrices.world_from_object);
  chain.clip_by_composed_matrix =
      Point<Clip>(transform_by_rows(round_to_float(composed).columns, object));

  const std::array<ClipPlane, 6> planes = clip_planes(dialect);
  if (is_finite(chain.clip)) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      chain.planes[i] = test_plane(planes[i], chain.clip, chain.to_clip.bound);
    }
  }
  set_verdict(chain);
  if (chain.verdict == VertexVerdict::kNotFinite || chain.verdict == VertexVerdict::kInEyePlane)
    return chain;

  DivideStep& divided = chain.divide.emplace();
  divided.ndc = divide(chain.clip);
  divided.bound = divide_bound(chain.clip, chain.to_clip.bound);
  divided.condition = divide_condition(chain.clip, chain.to_clip.magnitude);
  ScreenStep& shown = chain.screen.emplace();
  shown.screen = to_screen(divided.ndc, viewport);
  shown.bound = screen_bound(divided.ndc.position, divided.bound.position, viewport);
  shown.depth = window_depth(dialect, double(divided.ndc.position.z));
  shown.snap_x = snap_stability(shown.screen.position.x, shown.bound.x);
  shown.snap_y = snap_stability(shown.screen.position.y, shown.bound.y);
  add_round_trip(chain, matrices, viewport);
  return chain;
}

}  // namespace glassbox
