#include "study/stiffness/stiffness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/base/rounding.h>
#include <glassbox/mesh/bounding_box.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/tracer.h>

#include "study/stiffness/condition_formulas.h"
#include "study/stiffness/condition_kinds.h"

namespace glassbox::study {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The worst value of one kind of condition number so far.
struct WorstCondition {
  double condition = 0, bound = 0;
  std::optional<double> pixels;
  std::optional<ScenePlace> place;

  // Keeps the value with the larger bound, or with the larger condition if the bounds are equal; if
  // both are equal, the first one stays.
  void add(double bound_here, double condition_here, std::optional<double> pixels_here,
           const ScenePlace& where) {
    const bool worse = bound_here > bound || (bound_here == bound && condition_here > condition);
    if (place && !worse) return;
    *this = {condition_here, bound_here, pixels_here, where};
  }
};

// The depth that a pixel holds and its error bound `off`; the start value is farther than every
// depth.
struct StoredDepth {
  double depth = 2, off = 0;
};

double size_of(const Mesh& mesh) {
  double size = 0;
  const Box<Object> box = bounds(mesh);
  if (!box.empty()) {
    size = std::max({box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z});
  }
  return size;
}

double largest_coordinate(const Point<Object>& p) {
  return std::max({std::abs(double(p.x)), std::abs(double(p.y)), std::abs(double(p.z))});
}

class ConditionSink : public TraceSink {
public:
  ConditionSink(const Scene& scene, const View& view, const RenderSettings& settings)
      : scene_(scene),
        view_(view),
        settings_(settings),
        bounds_(view),
        stored_(int(std::abs(view.viewport.right - view.viewport.left)),
                int(std::abs(view.viewport.bottom - view.viewport.top))) {
    for (const Mesh& mesh : scene.meshes) sizes_.push_back(size_of(mesh));
  }

  void draw(const TracedDraw& draw) override {
    bounds_.draw(draw);
    clip_from_object_ = view_.clip_from_eye * view_.eye_from_world * draw.world_from_object;
  }

  void triangle(const TracedTriangle& triangle) override {
    const BoundsOfRun::KnownTriangle& known = bounds_.triangle(triangle);
    const bool is_seen = std::ranges::any_of(
        triangle.pieces, [](const TracedPiece& piece) { return piece.setup && !piece.culled; });
    if (!is_seen) return;
    for (std::size_t i = 0; i < triangle.polygon.size(); ++i) add_vertex(triangle, known.bounds, i);
    for (const TracedPiece& piece : triangle.pieces) {
      if (piece.setup && !piece.culled) add_piece(triangle, known.bounds, piece);
    }
  }

  void fragment(const TracedFragment& fragment) override {
    const BoundsOfRun::KnownTriangle* const known = bounds_.of_fragment(fragment);
    if (known == nullptr) {
      ++without_bounds_;
      return;
    }
    const Fragment& place = fragment.fragment;
    const FragmentBounds bounds = bounds_of(*known, fragment);
    add_depth_test(fragment, bounds.depth);
    if (fragment.result == FragmentResult::kHidden) return;
    if (!view_.perspective) return;
    const ScenePlace where{fragment.instance, fragment.source.number, {}, {}, place.x, place.y};
    const double w = 1 / double(place.inverse_w);
    nearest_ = std::min(nearest_, w);
    farthest_ = std::max(farthest_, w);
    inverse_w_.add(bounds.inverse_w * w, 0, {}, where);
    const double own = 8 * unit_roundoff<float> * std::abs(double(place.depth));
    const double share =
        depth_share(view_, settings_.depth, place.depth, w, std::max(0.0, bounds.depth - own));
    depth_.add(share, view_.far / view_.near, share * pixels_per_unit(view_), where);
  }

  Stiffness finish(const std::optional<Vector<World, double>>& up) const {
    Stiffness found;
    WorstCondition inverse_w = inverse_w_;
    inverse_w.condition = farthest_ / nearest_;
    add(ConditionKind::kDepth, depth_, found, tests_in_doubt_);
    add(ConditionKind::kInverseW, inverse_w, found);
    add(ConditionKind::kDivide, divide_, found);
    add(ConditionKind::kOffset, offset_, found);
    add(ConditionKind::kSliver, sliver_, found);
    add(ConditionKind::kTexcoord, texcoord_, found);
    if (up) add_up(*up, found);
    add_not_computed(up.has_value(), found);
    return found;
  }

private:
  // ---- what the run shows ----

  bool is_in_picture(const ScreenVertex& screen) const {
    const Viewport& v = view_.viewport;
    return screen.position.x >= v.left && screen.position.x <= v.right &&
           screen.position.y >= v.top && screen.position.y <= v.bottom;
  }

  // Counts a depth test as doubtful if the error bounds of the two depths overlap: the order of
  // their codes may then differ from the order of the exact depths.
  void add_depth_test(const TracedFragment& fragment, double bound) {
    const DepthFormat format = settings_.depth;
    const bool whole = format == DepthFormat::kUnorm24 || format == DepthFormat::kUnorm16;
    const double off = bound + (whole ? 0.5 / unorm_depth_steps(format) : 0);
    StoredDepth& stored = stored_.at(fragment.fragment.x, fragment.fragment.y);
    const double depth = double(fragment.fragment.depth);
    tests_in_doubt_ += std::abs(depth - stored.depth) <= off + stored.off;
    if (fragment.result == FragmentResult::kWritten) stored = {depth, off};
  }

  void add_vertex(const TracedTriangle& triangle, const TriangleBounds& bounds, std::size_t i) {
    const TracedVertex& vertex = triangle.polygon[i];
    const auto corner = std::ranges::find(vertex.clip.weights, 1.0);
    if (corner == vertex.clip.weights.end() || !is_in_picture(vertex.screen)) return;
    const auto k = std::uint32_t(corner - vertex.clip.weights.begin());
    const TracedCorner& traced = triangle.corners[k];
    const ScenePlace where{triangle.instance, triangle.number, k, traced.position, -1, -1};
    const VertexBounds& of = bounds.polygon[i];
    const double pixels = std::max(of.screen.x, of.screen.y);
    divide_.add(pixels, std::max(of.condition.x, of.condition.y), pixels, where);
    const std::uint32_t mesh = scene_.instances[triangle.instance].mesh;
    const double moved = half_ulp_on_screen(clip_from_object_, traced.object, view_.viewport);
    offset_.add(moved, largest_coordinate(traced.object) / sizes_[mesh], moved, where);
    add_texcoord(scene_.meshes[mesh], scene_.meshes[mesh].corners[traced.corner], where);
  }

  void add_texcoord(const Mesh& mesh, const Corner& corner, const ScenePlace& where) {
    const Material& material = scene_.materials[mesh.material];
    if (!material.texture || corner.texcoord == kNone) return;
    const Image<Rgba8>& image = scene_.images[scene_.textures[*material.texture].image];
    const auto& [u, v] = mesh.texcoords[corner.texcoord];
    const double off =
        std::max(half_ulp_in_texels(u, image.width), half_ulp_in_texels(v, image.height));
    texcoord_.add(off, std::max(std::abs(double(u)), std::abs(double(v))), {}, where);
  }

  void add_piece(const TracedTriangle& triangle, const TriangleBounds& bounds,
                 const TracedPiece& piece) {
    std::array<std::array<double, 2>, 3> exact;
    double moved = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const ScreenVertex& screen = piece.vertices[k];
      const glm::dvec3& bound = bounds.polygon[piece.polygon[k]].screen;
      if (!is_in_picture(screen)) return;
      exact[k] = {double(screen.position.x), double(screen.position.y)};
      moved = std::max({moved, bound.x, bound.y});
    }
    // Snapping moves a vertex by up to half a snapping step, and before that its float position is
    // up to `moved` away from the exact one.
    constexpr double kHalfStep = 0.5 / kSubpixels;
    sliver_.add(sliver_share(exact, moved + kHalfStep), sliver_factor(exact), {},
                {triangle.instance, triangle.number, {}, {}, -1, -1});
  }

  // ---- the result ----

  // Adds the condition number to `found`, if the run has shown something of this kind.
  static void add(ConditionKind kind, const WorstCondition& worst, Stiffness& found,
                  std::optional<std::uint64_t> tests_in_doubt = {}) {
    if (!worst.place) return;
    ConditionNumber number = condition_number_of(kind);
    number.condition = worst.condition;
    number.bound = worst.bound;
    number.pixels = worst.pixels;
    number.place = worst.place;
    number.tests_in_doubt = tests_in_doubt;
    found.numbers.push_back(std::move(number));
  }

  void add_up(const Vector<World, double>& up, Stiffness& found) const {
    const Transform<Eye, World>& m = view_.eye_from_world;
    const UpAngle angle = up_angle({-m.at(2, 0), -m.at(2, 1), -m.at(2, 2)}, up, view_);
    ConditionNumber number = condition_number_of(ConditionKind::kUp);
    number.condition = 1 / angle.sine;
    number.bound = angle.pixels;
    number.pixels = angle.pixels;
    found.numbers.push_back(std::move(number));
  }

  void add_not_computed(bool has_up, Stiffness& found) const {
    found.not_computed.push_back(
        "Corners outside of the picture and vertices made by clipping: their effect on pixels is "
        "part of the numbers of fragments.");
    if (!has_up)
      found.not_computed.push_back(
          "The angle between gaze and up: the file gives the camera as a pose, without an up "
          "vector.");
    if (!view_.perspective) {
      found.not_computed.push_back(
          "Depth and w: a parallel view has the same error at every distance.");
    }
    if (without_bounds_ > 0) {
      found.not_computed.push_back(
          fmt::format("{} of lines and points: no bounds are computed for them.",
                      counted(without_bounds_, "fragment")));
    }
  }

  const Scene& scene_;
  const View& view_;
  const RenderSettings& settings_;
  BoundsOfRun bounds_;
  std::vector<double> sizes_;  // the size of each mesh
  Transform<Clip, Object> clip_from_object_;
  WorstCondition depth_, inverse_w_, divide_, offset_, sliver_, texcoord_;
  double nearest_ = kInfinity, farthest_ = 0;
  std::uint64_t without_bounds_ = 0, tests_in_doubt_ = 0;
  Image<StoredDepth> stored_;
};

}  // namespace

Stiffness stiffness_of(const Scene& scene, const View& view, const RenderSettings& settings,
                       const std::optional<Vector<World, double>>& up) {
  ConditionSink sink(scene, view, settings);
  TraceFilter filter;
  filter.colors = false;
  filter.max_bytes = std::numeric_limits<std::uint64_t>::max();
  RenderSettings without_light = settings;
  without_light.shading = Shading::kUnlit;
  trace(scene, view, without_light, filter, sink);
  return sink.finish(up);
}

}  // namespace glassbox::study
