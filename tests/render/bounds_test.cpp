// The error bounds of a trace, compared with arithmetic of 320 bits: every error is within its
// bound, and no bound is more than 100 times the largest error seen. 10^6 vertices altogether, from
// object space to the screen, and the fragments of their triangles. The ratios are printed.
#include <glassbox/render/trace/bounds.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>
#include <vector>

#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/render/trace/tracer.h>

#include <glassbox/base/random.h>
#include "tests/render/exact_polygon.h"
#include "tests/render/scenes.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

namespace mp = boost::multiprecision;
using namespace test;

// The largest error in units of its bound; where the bound is 0, the error must be 0.
class ErrorRatio {
public:
  explicit ErrorRatio(const char* name) : name_(name) {}
  void add(const Big& error, double bound) {
    ++count_;
    if (!std::isfinite(bound)) {
      ++unbounded_;
      return;
    }
    const double size = double(mp::abs(error));
    // The error is rounded to double, by 2^-53 of its size, and the oracle rounds numbers below
    // 2^40 by 2^-320 of them.
    if (!(size <= bound * (1 + 0x1p-50) + 0x1p-250)) ++broken_;
    if (bound > 0) ratio_ = std::max(ratio_, size / bound);
  }
  // Fails if an error exceeded its bound, or if the largest error was below a hundredth of the
  // bound.
  void check() const {
    std::printf("  %-36s %8d numbers, %5d without bound, largest error / bound = %.3f\n", name_,
                count_, unbounded_, ratio_);
    CAPTURE(name_, count_, broken_, ratio_);
    CHECK(count_ > 500);
    CHECK(broken_ == 0);
    CHECK(ratio_ >= 0.01);
    CHECK(unbounded_ < count_ / 100);
  }

private:
  const char* name_;
  int count_ = 0, broken_ = 0, unbounded_ = 0;
  double ratio_ = 0;
};

struct Ratios {
  ErrorRatio world{"world, in double"}, eye{"eye, in double"}, clip{"clip, of corners"},
      crossing{"clip, of crossings"}, weights{"weights of crossings"}, ndc{"NDC"}, inverse_w{"1/w"},
      screen{"screen x, y"}, round_trip{"back in object space"},
      area{"twice the area, after the snap"}, lambda{"lambda"}, depth{"depth"},
      fragment_inverse_w{"1/w of fragments"}, fragment_weights{"weights of fragments"},
      distance{"distance along the gaze"}, texcoord{"texture coordinates"};
  int wrongly_stable = 0;

  void check() const {
    for (const ErrorRatio* one :
         {&world, &eye, &clip, &crossing, &weights, &ndc, &inverse_w, &screen, &round_trip, &area,
          &lambda, &depth, &fragment_inverse_w, &fragment_weights, &distance, &texcoord}) {
      one->check();
    }
    CHECK(wrongly_stable == 0);
  }
};

// ---- the same, computed exactly ----

struct ExactMatrices {
  BigMatrix world, eye, clip;  // from object space
};

std::array<Big, 2> exact_screen(const BigVector& clip, const Viewport& viewport) {
  const auto place = [](const Big& ndc, float from, float to) {
    return ndc * (Big(to) - Big(from)) / 2 + (Big(to) + Big(from)) / 2;
  };
  return {place(clip[0] / clip[3], viewport.left, viewport.right),
          place(clip[1] / clip[3], viewport.bottom, viewport.top)};
}

std::int32_t snapped(const Big& pixels) {
  return std::int32_t(mp::floor(pixels * kSubpixels + Big(0.5)));
}

// ---- comparisons ----

void compare_corner(const TracedCorner& corner, const CornerBounds& bounds,
                    const ExactMatrices& exact, const BigVector& clip, Ratios& ratios) {
  const BigVector world = exact.world * corner.object, eye = exact.eye * corner.object;
  const glm::dvec3 in_world = to_glm(corner.world), in_eye = to_glm(corner.eye);
  const glm::vec4 in_clip = to_glm(corner.clip);
  const std::optional<RoundTrip>& trip = bounds.round_trip;
  for (int i = 0; i < 4; ++i) {
    const std::size_t k = std::size_t(i);
    ratios.clip.add(Big(in_clip[i]) - clip[k], bounds.clip[i]);
    if (i == 3) break;
    ratios.world.add(Big(in_world[i]) - world[k], bounds.world[i]);
    ratios.eye.add(Big(in_eye[i]) - eye[k], bounds.eye[i]);
    if (trip) ratios.round_trip.add(trip->error[i], trip->bound[i]);
  }
}

void compare_vertex(const TracedVertex& vertex, const VertexBounds& bounds,
                    const ExactVertex& exact, const Viewport& viewport, Ratios& ratios) {
  const bool is_corner =
      std::count(vertex.clip.weights.begin(), vertex.clip.weights.end(), 1.0) == 1;
  const glm::vec4 clip = to_glm(vertex.clip.position);
  const glm::vec3 ndc = to_glm(vertex.ndc.position);
  for (int i = 0; i < 4; ++i) {
    const std::size_t k = std::size_t(i);
    if (!is_corner) ratios.crossing.add(Big(clip[i]) - exact.clip[k], bounds.clip.position[i]);
    if (i == 3) break;
    if (!is_corner)
      ratios.weights.add(Big(vertex.clip.weights[k]) - exact.weights[k], bounds.clip.weights[i]);
    ratios.ndc.add(Big(ndc[i]) - exact.clip[k] / exact.clip[3], bounds.ndc.position[i]);
  }
  ratios.inverse_w.add(Big(vertex.ndc.inverse_w) - 1 / exact.clip[3], bounds.ndc.inverse_w);
  const auto screen = exact_screen(exact.clip, viewport);
  ratios.screen.add(Big(vertex.screen.position.x) - screen[0], bounds.screen.x);
  ratios.screen.add(Big(vertex.screen.position.y) - screen[1], bounds.screen.y);
  ratios.wrongly_stable += int(bounds.snap_x.stable && snapped(screen[0]) != vertex.snapped.x);
  ratios.wrongly_stable += int(bounds.snap_y.stable && snapped(screen[1]) != vertex.snapped.y);
}

void compare_area(const TracedPiece& piece, double bound, const std::vector<ExactVertex>& polygon,
                  const Viewport& viewport, Ratios& ratios) {
  std::array<std::array<Big, 2>, 3> p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = exact_screen(polygon[piece.polygon[k]].clip, viewport);
  const Big exact =
      (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
  const std::int64_t area = piece.setup ? piece.setup->double_area : 0;
  const bool clockwise = piece.setup && piece.setup->clockwise;
  ratios.area.add(Big(clockwise ? area : -area) / (kSubpixels * kSubpixels) - exact, bound);
}

struct ExactFragment {
  std::array<Big, 3> lambda, weights;
  Big depth, inverse_w;
};

// A fragment of the snapped triangle, whose corners are exact, with the exact depth and w of its
// vertices.
ExactFragment exact_fragment(const TracedFragment& traced, const TriangleSetup& setup,
                             const std::array<const ExactVertex*, 3>& vertices) {
  ExactFragment exact;
  exact.depth = exact.inverse_w = 0;
  std::array<Big, 3> share;
  for (std::size_t k = 0; k < 3; ++k) {
    const BigVector& clip = vertices[k]->clip;
    exact.lambda[k] = Big(traced.coverage.edges[k]) / Big(setup.double_area);
    exact.depth += exact.lambda[k] * clip[2] / clip[3];
    share[k] = exact.lambda[k] / clip[3];
    exact.inverse_w += share[k];
  }
  for (std::size_t k = 0; k < 3; ++k) exact.weights[k] = share[k] / exact.inverse_w;
  return exact;
}

void compare_fragment(const TracedFragment& traced, const TracedTriangle& triangle,
                      const TriangleBounds& bounds, const std::vector<ExactVertex>& polygon,
                      const Mesh& mesh, Ratios& ratios) {
  const TracedPiece& piece = triangle.pieces[traced.source.piece];
  const TriangleSetup& setup = *piece.setup;
  std::array<const ExactVertex*, 3> vertices{};
  std::array<std::size_t, 3> at{};
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = piece.polygon[std::size_t(setup.order[k])];
    vertices[k] = &polygon[at[k]];
  }
  const SetupBounds inherited = setup_bounds(piece, bounds);
  const FragmentBounds bound = fragment_bounds(setup, traced.fragment, inherited);
  const ExactFragment exact = exact_fragment(traced, setup, vertices);
  for (std::size_t k = 0; k < 3; ++k) {
    ratios.lambda.add(Big(traced.fragment.lambda[k]) - exact.lambda[k], bound.lambda[k]);
    ratios.fragment_weights.add(Big(traced.fragment.weights[k]) - exact.weights[k],
                                bound.weights[k]);
  }
  ratios.depth.add(Big(traced.fragment.depth) - exact.depth, bound.depth);
  ratios.fragment_inverse_w.add(Big(traced.fragment.inverse_w) - exact.inverse_w, bound.inverse_w);
  ratios.distance.add(1 / Big(traced.fragment.inverse_w) - 1 / exact.inverse_w, bound.distance);

  if (traced.result == FragmentResult::kHidden) return;
  std::array<float, 3> values{};
  std::array<double, 3> value_bounds{};
  Big texcoord = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    Big here = 0;
    double computed = 0, open = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const float u = mesh.texcoords[mesh.corners[triangle.corners[c].corner].texcoord].u;
      here += vertices[k]->weights[c] * Big(u);
      computed += triangle.polygon[at[k]].clip.weights[c] * double(u);
      open += bounds.polygon[at[k]].clip.weights[int(c)] * std::abs(double(u));
    }
    values[k] = float(computed);
    const bool is_corner = triangle.clipping.empty();
    value_bounds[k] = is_corner ? 0 : open + 0x1p-24 * std::abs(computed) + 0x1p-50;
    texcoord += exact.weights[k] * here;
  }
  ratios.texcoord.add(Big(traced.at.texcoord[0]) - texcoord,
                      attribute_bound(values, value_bounds, setup, traced.fragment, inherited));
}

// ---- scenes ----

constexpr int kWidth = 80, kHeight = 60;

// Triangles all around the eye, a tenth of them much larger than the view, so that every plane cuts
// some.
Scene soup(int triangles, Random& random) {
  Mesh mesh;
  mesh.name = "soup";
  // Far from the mesh's origin, so that an anchor is used.
  const double offset = random.unit() < 0.3 ? 1e4 : 0;
  for (int i = 0; i < triangles; ++i) {
    const double size = random.unit() < 0.1 ? 20 : 0.4;
    const std::array<double, 3> centre{random.between(-4, 4), random.between(-4, 4),
                                       random.between(-4, 4)};
    for (int k = 0; k < 3; ++k) {
      mesh.positions.push_back({float(centre[0] + offset + random.between(-size, size)),
                                float(centre[1] + random.between(-size, size)),
                                float(centre[2] - offset + random.between(-size, size))});
      mesh.texcoords.push_back({float(random.between(-2, 2)), float(random.between(0, 1))});
      mesh.corners.push_back({std::uint32_t(mesh.positions.size() - 1), kNone,
                              std::uint32_t(mesh.texcoords.size() - 1), kNone});
    }
    mesh.faces.push_back({std::uint32_t(3 * i), 3});
  }
  Scene scene = test::scene_of(std::move(mesh));
  const Vector<Object, double> axis{random.between(-1, 1), random.between(-1, 1), 0.5};
  const auto turn = rotate_degrees<World>(axis, random.between(-180, 180));
  REQUIRE(turn);
  scene.nodes[0].world_from_node =
      *turn * translate<Object, Object>(Vector<Object, double>{-offset, 0, offset});
  return scene;
}

View random_view(Random& random) {
  const Point<World, double> eye{random.between(-3, 3), random.between(-3, 3),
                                 random.between(-3, 3)};
  const double near = std::pow(10, random.between(-3, 0));
  PerspectiveLens lens{random.between(0.3, 2), near, {}};
  const bool infinite = random.unit() < 0.3;
  if (!infinite) lens.far = near + random.between(2, 1000);
  const Camera camera = test::random_gaze(eye, lens, random);
  const auto view = make_view(camera, kWidth, kHeight,
                              random.unit() < 0.3 ? DepthRange::kReversed : DepthRange::kStandard);
  REQUIRE(view);
  return *view;
}

void compare_scene(const Scene& scene, const View& view, Ratios& ratios) {
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  settings.cull = Cull::kNone;
  if (view.depth_range == DepthRange::kReversed) settings.depth = DepthFormat::kFloat32Reversed;
  const Trace recorded = trace(scene, view, settings, {}).trace;
  REQUIRE(recorded.complete);
  const TracedDraw& draw = recorded.draws.front();
  const DrawBounds draw_bounds = bounds_of(draw, view);
  const BigMatrix world = exactly(draw.world_from_object.columns);
  const BigMatrix eye = exactly(view.eye_from_world.columns) * world;
  const ExactMatrices exact{world, eye, exactly(view.clip_from_eye.columns) * eye};

  std::vector<std::vector<const TracedFragment*>> fragments(recorded.triangles.size());
  for (std::size_t i = 0; i < recorded.fragments.size(); i += 97) {  // one in 97
    fragments[recorded.fragments[i].source.number].push_back(&recorded.fragments[i]);
  }
  for (const TracedTriangle& triangle : recorded.triangles) {
    const TriangleBounds bounds = bounds_of(recorded, triangle, draw, draw_bounds);
    std::array<BigVector, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = exact.clip * triangle.corners[k].object;
      compare_corner(triangle.corners[k], bounds.corners[k], exact, corners[k], ratios);
    }
    if (triangle.polygon.empty()) continue;
    const std::vector<ExactVertex> polygon = exact_polygon(recorded, triangle, corners);
    REQUIRE(polygon.size() == triangle.polygon.size());
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      compare_vertex(triangle.polygon[i], bounds.polygon[i], polygon[i], view.viewport, ratios);
    }
    for (std::size_t i = 0; i < triangle.pieces.size(); ++i) {
      compare_area(triangle.pieces[i], bounds.double_area[i], polygon, view.viewport, ratios);
    }
    for (const TracedFragment* fragment : fragments[triangle.number]) {
      compare_fragment(*fragment, triangle, bounds, polygon, scene.meshes.front(), ratios);
    }
  }
}

#ifdef __OPTIMIZE__
constexpr int kScenes = 170;
#else
// An unoptimized build takes ten times as long: this checks the code, not the bounds.
constexpr int kScenes = 12;
#endif
constexpr int kTriangles = 1961;  // in 170 scenes, with three corners each: 1,000,110 corners

TEST_CASE("every number of a trace lies within its bound, and no bound is idle: 10^6 vertices") {
  Random random(20260407);
  Ratios ratios;
  for (int i = 0; i < kScenes; ++i) {
    CAPTURE(i);
    const Scene scene = soup(kTriangles, random);
    compare_scene(scene, random_view(random), ratios);
  }
  ratios.check();
}

}  // namespace
}  // namespace glassbox
