#include <glassbox/render/trace/scene_verdict.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
#include <string>

#include <glm/matrix.hpp>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/bounding_box.h>
#include <glassbox/mesh/orientation.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/back_face.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/numbering.h>
#include <glassbox/render/trace/result_counter.h>

namespace glassbox {

namespace {

// ---- where the scene is ----

// The distance along the gaze.
double along_gaze(const ViewConventions& conventions, const Point<Eye, double>& p) {
  return conventions.gaze_is_minus_z ? -p.z : p.z;
}

// Half of the picture's width (axis 0) or height (axis 1): an angle in degrees, or, in a parallel
// view, a length.
double half_of_picture(const View& view, int axis) {
  const double scale = std::abs(view.clip_from_eye.at(axis, axis));
  return view.perspective ? degrees_from_radians(arctan2(1, scale)) : 1 / scale;
}

void find_direction(const View& view, const ViewConventions& conventions, SceneExtent& extent) {
  const Point<Eye, double> middle = view.eye_from_world * extent.middle;
  const double along = along_gaze(conventions, middle);
  extent.to_the_right = middle.x;
  extent.up = middle.y;
  if (view.perspective) {
    const double level = std::sqrt(middle.x * middle.x + along * along);
    extent.to_the_right = degrees_from_radians(arctan2(middle.x, along));
    extent.up = degrees_from_radians(arctan2(middle.y, level));
  }
  extent.half_width = half_of_picture(view, 0);
  extent.half_height = half_of_picture(view, 1);
}

void find_pose(const View& view, const ViewConventions& conventions, SceneExtent& extent) {
  const auto world_from_eye = inverse_affine(view.eye_from_world);
  if (!world_from_eye) return;
  extent.eye = *world_from_eye * Point<Eye, double>(0, 0, 0);
  const double along = conventions.gaze_is_minus_z ? -1 : 1;
  const Vector<World, double> gaze = *world_from_eye * Vector<Eye, double>(0, 0, along);
  extent.gaze = gaze * (1 / std::sqrt(dot(gaze, gaze)));
}

SceneExtent extent_of(const Scene& scene, const View& view, const ViewConventions& conventions) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  SceneExtent extent;
  const Box<World> box = bounds(scene);
  if (box.empty()) return extent;
  extent.middle = box.center();
  extent.size = box.high - box.low;
  extent.nearest = kInfinity;
  extent.farthest = -kInfinity;
  double left = kInfinity, right = -kInfinity, bottom = kInfinity, top = -kInfinity;
  for_each_drawn_position(scene, [&](const Point<World, double>& p) {
    const Point<Eye, double> at = view.eye_from_world * p;
    const double along = along_gaze(conventions, at);
    extent.nearest = std::min(extent.nearest, along);
    extent.farthest = std::max(extent.farthest, along);
    const Point<Clip, double> clip = view.clip_from_eye * at;
    if (!(clip.w > 0)) return;
    left = std::min(left, clip.x / clip.w), right = std::max(right, clip.x / clip.w);
    bottom = std::min(bottom, clip.y / clip.w), top = std::max(top, clip.y / clip.w);
  });
  if (left <= right) {
    extent.width_px = (right - left) / 2 * std::abs(double(view.viewport.width()));
    extent.height_px = (top - bottom) / 2 * std::abs(double(view.viewport.height()));
  }
  find_pose(view, conventions, extent);
  find_direction(view, conventions, extent);
  return extent;
}

// ---- the instances ----

// What there is to know about an instance in order to judge its triangles.
struct InstanceFacts {
  bool flat = false;             // its model matrix has no inverse
  bool mirrored = false;         // its model matrix mirrors
  bool has_fragments = false;    // of at least one triangle
  bool surrounds_eye = false;    // the eye is inside it, and its fronts are outside
  bool closed_outwards = false;  // its surface is closed, and its fronts are outside
};

bool surrounds_eye(const Mesh& mesh, const Transform<Eye, Object>& eye_from_object,
                   bool perspective) {
  constexpr double kHalf = 0.5;  // halfway between outside, 0, and inside, 1
  const auto viewer = viewer_in_object_space(eye_from_object, perspective);
  if (!perspective || !viewer) return false;
  return winding_number(mesh, Point<Object, double>(to_glm(viewer->eye_or_gaze))) > kHalf;
}

InstanceFacts facts_of(const Scene& scene, const View& view, const Instance& instance,
                       std::span<const ResultCounter::Entry> triangles) {
  const Mesh& mesh = scene.meshes[instance.mesh];
  const Transform<World, Object>& world_from_object = scene.nodes[instance.node].world_from_node;
  InstanceFacts facts;
  facts.flat = !inverse_affine(world_from_object);
  facts.mirrored = glm::determinant(glm::dmat3(world_from_object.columns)) < 0;
  facts.has_fragments = std::ranges::any_of(
      triangles, [](const ResultCounter::Entry& entry) { return entry.fragments.covered > 0; });
  facts.surrounds_eye =
      surrounds_eye(mesh, view.eye_from_world * world_from_object, view.perspective);
  const bool shows_backs = std::ranges::any_of(triangles, [](const ResultCounter::Entry& entry) {
    return entry.result() == TriangleResult::kTurnedAway;
  });
  if (shows_backs && !facts.has_fragments) {
    facts.closed_outwards = signed_volume(mesh).value_or(0) > 0;
  }
  return facts;
}

// ---- the causes ----

bool is_singular(const glm::dmat4& m) {
  double size = 1;
  for (int column = 0; column < 4; ++column) size *= glm::length(m[column]);
  return !(std::abs(glm::determinant(m)) > 0x1p-40 * size);
}

// Gives lost triangles to causes.
class Judge {
public:
  Judge(const View& view, const SceneVerdict& found, std::span<const ClipPlane> planes)
      : singular_(!inverse_affine(view.eye_from_world) || is_singular(view.clip_from_eye.columns)),
        hands_mixed_(found.conventions.hands_mixed),
        all_behind_(found.extent.farthest <= 0),
        planes_(planes) {}

  // Nothing if the triangle is seen, or lost in an ordinary way.
  std::optional<Cause> cause_of(const ResultCounter::Entry& entry,
                                const InstanceFacts& object) const {
    const TriangleResult result = entry.result();
    if (is_seen(result)) return std::nullopt;
    if (result == TriangleResult::kNoArea) return Cause::kNoArea;
    if (singular_ || object.flat) return Cause::kDegenerateMatrix;
    if (result == TriangleResult::kNotFinite) return Cause::kNotFinite;
    if (result < TriangleResult::kNoScreenArea && hands_mixed_) return Cause::kMixedHands;
    if (result < TriangleResult::kHidden && object.surrounds_eye) return Cause::kInside;
    return result < TriangleResult::kHidden ? of_geometry(entry, object) : of_fragments(entry);
  }

private:
  Cause beside() const { return all_behind_ ? Cause::kBehind : Cause::kLooksAway; }

  Cause of_plane(const std::string& plane) const {
    if (plane == "near" || plane == "eye") return Cause::kNearPlane;
    return plane == "far" ? Cause::kFarPlane : beside();
  }

  std::optional<Cause> of_geometry(const ResultCounter::Entry& entry,
                                   const InstanceFacts& object) const {
    switch (entry.before) {
      case TriangleResult::kBehindEye:
      case TriangleResult::kClippedAway:
      case TriangleResult::kOutsidePicture:
        return beside();
      case TriangleResult::kOutsidePlane:
        return of_plane(planes_[entry.plane].name);
      case TriangleResult::kNoScreenArea:
      case TriangleResult::kBetweenCentres:
        if (object.has_fragments) return std::nullopt;
        return Cause::kTooSmall;
      case TriangleResult::kTurnedAway:
        if (object.has_fragments || object.closed_outwards) return std::nullopt;
        return object.mirrored ? Cause::kMirroredNode : Cause::kInsideOut;
      default:
        return std::nullopt;
    }
  }

  static std::optional<Cause> of_fragments(const ResultCounter::Entry& entry) {
    switch (entry.result()) {
      case TriangleResult::kDiscarded:
        return Cause::kAlphaTest;
      case TriangleResult::kMasked:
        return Cause::kMasked;
      case TriangleResult::kUnchanged:
        return entry.fragments.transparent > 0 ? Cause::kTransparent : Cause::kSameColor;
      default:
        return std::nullopt;
    }
  }

  const bool singular_, hands_mixed_, all_behind_;
  const std::span<const ClipPlane> planes_;
};

bool draws_nothing(const Scene& scene) {
  return std::ranges::all_of(scene.instances, [&](const Instance& instance) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    return mesh.faces.empty() && mesh.lines.empty() && mesh.points.empty();
  });
}

// What is seen is small, and nothing else is wrong.
void add_small(const SceneVerdict& found, std::vector<SceneCause>& causes) {
  for (const TriangleResult seen : {TriangleResult::kVisible, TriangleResult::kPartlyVisible}) {
    const SceneVerdict::Group& group = found.at(seen);
    if (group.triangles == 0 || !causes.empty()) continue;
    causes.push_back({Cause::kTooSmall, group.triangles, group.example, 0});
  }
}

std::vector<SceneCause> find_causes(const Scene& scene, const View& view, const SceneVerdict& found,
                                    const ResultCounter& counter) {
  std::vector<SceneCause> causes;
  if (draws_nothing(scene)) return {SceneCause{}};
  const Judge judge(view, found, counter.planes());
  std::array<SceneCause, kCauses> sums;
  std::uint32_t number = 0;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const std::uint64_t count = count_triangles(scene, i);
    const auto triangles = std::span(counter.entries()).subspan(number, count);
    const InstanceFacts facts = facts_of(scene, view, scene.instances[i], triangles);
    for (const ResultCounter::Entry& entry : triangles) {
      if (const auto cause = judge.cause_of(entry, facts)) {
        SceneCause& sum = sums[std::size_t(*cause)];
        if (sum.triangles++ == 0) sum = {*cause, 1, number, i};
      }
      ++number;
    }
  }
  std::ranges::copy_if(sums, std::back_inserter(causes),
                       [](const SceneCause& sum) { return sum.triangles > 0; });
  std::ranges::stable_sort(causes, std::ranges::greater(), &SceneCause::triangles);
  add_small(found, causes);
  return causes;
}

void count_results(const ResultCounter& counter, SceneVerdict& found) {
  found.triangles = counter.entries().size();
  for (std::uint32_t number = 0; number < counter.entries().size(); ++number) {
    const ResultCounter::Entry& entry = counter.entries()[number];
    SceneVerdict::Group& group = found.groups[std::size_t(entry.result())];
    if (group.triangles == 0 || entry.fragments.visible > group.example_pixels) {
      group.example = number;
      group.example_pixels = entry.fragments.visible;
    }
    ++group.triangles;
  }
}

}  // namespace

const char* name_of(Cause cause) {
  constexpr const char* kNames[kCauses] = {
      "empty-scene",   "no-area",    "degenerate-matrix", "mixed-hands", "not-finite", "inside",
      "behind",        "looks-away", "near-plane",        "far-plane",   "too-small",  "inside-out",
      "mirrored-node", "alpha-test", "transparent",       "masked",      "same-color"};
  return kNames[std::size_t(cause)];
}

std::optional<TriangleResult> SceneVerdict::most_frequent_loss() const {
  std::optional<TriangleResult> commonest;
  for (std::size_t i = 0; i < kTriangleResults; ++i) {
    if (is_seen(TriangleResult(i)) || groups[i].triangles == 0) continue;
    if (!commonest || groups[i].triangles > at(*commonest).triangles) commonest = TriangleResult(i);
  }
  return commonest;
}

bool SceneVerdict::all_lost() const {
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < kTriangleResults; ++i)
    seen += is_seen(TriangleResult(i)) ? groups[i].triangles : 0;
  return triangles > 0 && seen == 0;
}

SceneVerdict scene_verdict(const Scene& scene, const View& view, const RenderSettings& settings) {
  ResultCounter counter(view, settings, std::nullopt);
  DepthFights fights(view, settings.depth);
  render_staged(scene, view, with_one_sample(settings), {&counter, &fights});
  counter.finish();
  SceneVerdict found;
  found.fights = fights.fights(scene);
  count_results(counter, found);
  found.pixels = std::uint64_t(std::abs(view.viewport.width())) *
                 std::uint64_t(std::abs(view.viewport.height()));
  found.shown_pixels = counter.shown_pixels();
  found.highest_discarded_alpha = counter.highest_discarded_alpha();
  found.conventions = conventions_of(view);
  found.extent = extent_of(scene, view, found.conventions);
  if (found.is_little_seen()) found.causes = find_causes(scene, view, found, counter);
  return found;
}

}  // namespace glassbox
