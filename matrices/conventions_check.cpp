#include <glassbox/matrices/conventions_check.h>

#include <algorithm>
#include <cmath>

#include <glassbox/matrices/projection_factors.h>

namespace glassbox {
namespace {

// ---- where the points go ----

struct ProjectedPoints {
  int visible = 0, behind = 0, in_front = 0;
  int before_near = 0;               // on the eye's side of the near plane
  std::optional<glm::dvec2> window;  // of the first visible point
};

ProjectedPoints project_points(const MatrixSetup& s, const Viewport& viewport,
                               std::span<const CheckedPoint> points) {
  const glm::dmat4 clip_from_object = s.projection.m * s.view.m * s.model.m;
  ProjectedPoints projected;
  for (const CheckedPoint& point : points) {
    const glm::dvec4 c = clip_from_object * point.object;
    projected.behind += c.w < 0;
    projected.in_front += c.w > 0;
    const double low = s.dialect.z_from_minus_w ? -c.w : 0;
    projected.before_near += c.z < low;
    const bool inside = c.w > 0 && std::abs(c.x) <= c.w && std::abs(c.y) <= c.w && c.z >= low &&
                        c.z <= c.w;  // false if one of them is NaN
    if (!inside) continue;
    const glm::dvec2 window{c.x / c.w * (double(viewport.right) - double(viewport.left)) / 2 +
                                (double(viewport.right) + double(viewport.left)) / 2,
                            c.y / c.w * (double(viewport.top) - double(viewport.bottom)) / 2 +
                                (double(viewport.top) + double(viewport.bottom)) / 2};
    if (point.expected && !(std::abs(window.x - point.expected->x) <= kExpectedWithinPx &&
                            std::abs(window.y - point.expected->y) <= kExpectedWithinPx)) {
      continue;
    }
    ++projected.visible;
    if (!projected.window) projected.window = window;
  }
  return projected;
}

// ---- evidence for a change ----

struct SetupFacts {
  MatrixFacts model, view;
  ProjectionFacts projection;
  bool projection_sound = false;
  std::optional<Eyepoint> eye;

  explicit SetupFacts(const MatrixSetup& s)
      : model(matrix_facts(s.model.m)),
        view(matrix_facts(s.view.m)),
        projection(projection_facts(projection_part(s.projection), s.dialect.depth)),
        projection_sound(projection.kind != ProjectionKind::kNone && !projection.depth_lost &&
                         !projection.looks_transposed && matrix_facts(s.projection.m).rank == 4),
        eye(view.affine ? eyepoint_of(s.view) : std::nullopt) {}

  // How sound the view matrix is: 2 rigid, 1 affine with an inverse, 0 no view matrix.
  int soundness_of_view() const { return view.rigid() ? 2 : view.invertible() ? 1 : 0; }
  int soundness() const {
    return int(model.invertible()) + soundness_of_view() + int(projection_sound);
  }
  bool spoils(const SetupFacts& before) const {
    return int(model.invertible()) < int(before.model.invertible()) ||
           soundness_of_view() < before.soundness_of_view() ||
           projection_sound < before.projection_sound;
  }
};

// Adds evidence for a change (positive weight) or against it (negative weight), with a sentence for
// the report if there is one.
void add_reason(Alternative& found, double weight, std::string reason = "") {
  found.score += weight;
  if (!reason.empty()) found.reasons.push_back(std::move(reason));
}

void weigh_soundness(const SetupFacts& before, const SetupFacts& after, Alternative& found) {
  if (after.model.invertible() && !before.model.invertible()) {
    add_reason(found, 8, "the model matrix is then affine, and as given it is not");
  }
  if (after.soundness_of_view() > before.soundness_of_view()) {
    add_reason(found, 8,
               after.view.rigid() ? "the view is then rigid, and as given it is not"
                                  : "the view is then affine, and as given it is not");
  }
  if (after.projection_sound && !before.projection_sound) {
    add_reason(found, 8,
               std::string("the projection is then ") +
                   (after.projection.kind == ProjectionKind::kPerspective ? "a perspective one"
                                                                          : "a parallel one") +
                   ", and as given it is not");
  }
}

void weigh_eyepoint(const SetupFacts& before, const SetupFacts& after, Alternative& found) {
  if (!before.eye || !after.eye) return;
  if (after.eye->level != before.eye->level) {
    add_reason(found, after.eye->level ? 4 : -4,
               after.eye->level ? "the camera is then upright, but as given it is rolled" : "");
  }
  const int saved = before.eye->digits - after.eye->digits;
  if (saved >= 3) {
    add_reason(found, 2,
               "the eye is then at " + position_text(*after.eye) +
                   ", which has rounder numbers than " + position_text(*before.eye));
  } else if (saved <= -3) {
    add_reason(found, -2);
  }
}

void weigh_hand(const MatrixSetup& changed, const ProjectedPoints& before,
                const ProjectedPoints& after, Alternative& found) {
  const int points = before.behind + before.in_front;
  const bool parallel = projection_facts(changed.projection).kind == ProjectionKind::kParallel;
  if (parallel && before.before_near == points && after.visible == points) {
    add_reason(found, 3,
               "as given " + std::string(points == 1 ? "the point is" : "all points are") +
                   " on the near side of the near plane: the projection looks the other way");
  }
  if (before.behind == points && after.in_front == points) {
    add_reason(found, 3,
               points == 1 ? "as given w is negative: the projection looks the other way"
                           : "as given every w is negative (" + std::to_string(points) + " of " +
                                 std::to_string(points) + "): the projection looks the other way");
  }
  const auto drawn = drawn_handedness(changed);
  if (!drawn) return;
  if (changed.world) {
    add_reason(found, *changed.world == *drawn ? 4 : -4,
               *changed.world == *drawn ? "the handedness of your world then fits" : "");
  } else if (changed.dialect.window_y_up || changed.dialect.ndc_y_down) {  // OpenGL or Vulkan
    add_reason(found, *drawn == Handedness::kRight ? 1 : -1);
  }
}

void weigh_range(const SetupFacts& before, const MatrixSetup& changed, Alternative& found) {
  const DepthReading* likely = before.projection.likely_range();
  if (likely == nullptr || likely->from_minus_one != changed.dialect.z_from_minus_w) return;
  add_reason(found, 4,
             "for depth " + std::string(likely->from_minus_one ? "-1" : "0") + " .. 1 it has " +
                 planes_text(*likely) + ", which are round numbers");
}

// Adds the evidence for one change. `facts` are those of the setup that the change was made to.
void weigh(SetupChange change, const MatrixSetup& changed, const SetupFacts& facts,
           const ProjectedPoints& before, const ProjectedPoints& after, Alternative& found) {
  switch (change) {
    case SetupChange::kEyeHand:
    case SetupChange::kTurnRound:
      return weigh_hand(changed, before, after, found);
    case SetupChange::kDepthRange:
      return weigh_range(facts, changed, found);
    case SetupChange::kDegrees:
      return add_reason(found, 6,
                        "[1][1] is the cotangent of half of " +
                            std::to_string(*facts.projection.degrees_taken_as_radians) +
                            " radians");
    case SetupChange::kRadians:
      return add_reason(found, 6,
                        "the angle of view is " +
                            std::to_string(*facts.projection.radians_taken_as_degrees) +
                            " degrees in radians");
    case SetupChange::kClearCorner:
      return add_reason(found, 6, "[3][3] is 1, as in the identity");
    default:
      return;
  }
}

// The map from points to clip space that a setup makes. Different setups can make the same map,
// which is tried only once.
struct Map {
  glm::dmat4 clip_from_object;
  bool z_from_minus_w;

  explicit Map(const MatrixSetup& s)
      : clip_from_object(s.projection.m * s.view.m * s.model.m),
        z_from_minus_w(s.dialect.z_from_minus_w) {}
  friend bool operator==(const Map&, const Map&) = default;
};

class Search {
public:
  Search(const MatrixSetup& setup, const Viewport& viewport, std::span<const CheckedPoint> points)
      : setup_(setup),
        viewport_(viewport),
        points_(points),
        given_facts_(setup),
        before_(project_points(setup, viewport, points)),
        tried_{Map(setup)} {
    for (const CheckedPoint& point : points) {
      expects_ = expects_ || point.expected;
      places_.push_back(point.object);
    }
  }

  ConventionsReport run() {
    report_.points = int(points_.size());
    report_.visible = before_.visible;
    report_.behind_eye = before_.behind;
    if (before_.visible == report_.points) return report_;
    for (const ConventionMistake& mistake : convention_mistakes()) {
      if (is_tried(mistake)) try_changes(mistake, nullptr);
    }
    for (const Alternative& one : report_.alternatives) most_ = std::max(most_, one.points);
    if (before_.visible == 0 && most_ < report_.points) try_pairs();
    std::stable_sort(report_.alternatives.begin(), report_.alternatives.end(),
                     [](const Alternative& a, const Alternative& b) {
                       return a.points != b.points ? a.points > b.points : a.score > b.score;
                     });
    return report_;
  }

private:
  bool is_tried(const ConventionMistake& mistake) const {
    return expects_ ||
           (mistake.change != SetupChange::kFlipX && mistake.change != SetupChange::kFlipY);
  }

  void try_pairs() {
    for (std::size_t i = 0; i < convention_mistakes().size(); ++i) {
      for (std::size_t j = i + 1; j < convention_mistakes().size(); ++j) {
        if (is_tried(convention_mistakes()[i]) && is_tried(convention_mistakes()[j]))
          try_changes(convention_mistakes()[i], &convention_mistakes()[j]);
      }
    }
  }

  // With two changes a single point can be moved nearly anywhere. So a pair of changes is reported
  // only if the matrices show evidence for it, or if it makes all points visible and there are at
  // least three.
  bool is_credible(const Alternative& pair) const {
    constexpr double kSomethingInTheMatrices = 4;
    return pair.score >= kSomethingInTheMatrices ||
           (pair.points >= 3 && pair.points == report_.points);
  }

  void try_changes(const ConventionMistake& mistake, const ConventionMistake* second) {
    MatrixSetup changed = setup_;
    if (!mistake.undo(changed, places_)) return;
    const MatrixSetup between = changed;
    if (second != nullptr && !second->undo(changed, places_)) return;
    const Map map(changed);
    if (std::find(tried_.begin(), tried_.end(), map) != tried_.end()) return;
    tried_.push_back(map);
    const ProjectedPoints after = project_points(changed, viewport_, points_);
    if (after.visible <= (second == nullptr ? before_.visible : most_)) return;
    const SetupFacts judged(changed);
    if (judged.spoils(given_facts_)) {
      ++report_.spoiling;
      return;
    }
    Alternative found;
    found.change = mistake.change;
    found.id = mistake.id;
    found.what = mistake.what;
    found.remedy = mistake.remedy;
    if (second != nullptr) {
      found.second = second->change;
      found.second_id = second->id;
      found.what += std::string(", and ") + second->what;
      found.remedy += std::string("; ") + second->remedy;
    }
    found.points = after.visible;
    found.window = after.window;
    weigh_soundness(given_facts_, judged, found);
    // The distance of this eye from the points is a guess, so its position says nothing.
    if (mistake.change != SetupChange::kSwapLookAt) weigh_eyepoint(given_facts_, judged, found);
    weigh(mistake.change, changed, given_facts_, before_, after, found);
    // The evidence of the second mistake shows only when the first one is undone.
    if (second != nullptr)
      weigh(second->change, changed, SetupFacts(between), before_, after, found);
    if (second != nullptr && !is_credible(found)) return;
    report_.alternatives.push_back(std::move(found));
  }

  const MatrixSetup& setup_;
  const Viewport& viewport_;
  const std::span<const CheckedPoint> points_;
  std::vector<glm::dvec4> places_;  // of the points, in object space
  const SetupFacts given_facts_;
  const ProjectedPoints before_;
  bool expects_ = false;
  int most_ = 0;  // the largest number of points that a single change makes visible
  std::vector<Map> tried_;
  ConventionsReport report_;
};

}  // namespace

ConventionsReport check_conventions(const MatrixSetup& setup, const Viewport& viewport,
                                    std::span<const CheckedPoint> points) {
  return Search(setup, viewport, points).run();
}

}  // namespace glassbox
