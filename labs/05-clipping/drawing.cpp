// Lab 5 in a picture: the student's functions clip triangles by the frustum's six planes and cull
// back faces. They replace the pipeline's clipping, which cuts at the near plane and the guard
// band, and its culling by the snapped area.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "labs/05-clipping/outlines.h"
#include "labs/drawing/drawing.h"
#include "labs/framework/compare.h"

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/back_face.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/primitives.h>

namespace glassbox::labs {

namespace lab_05_drawing {

// The index of the first vertex in an answer of "clip": three outcodes and the verdict come before.
constexpr std::size_t kVertices = 4;

// ---- the reference ----

Numbers clipped(RecordReader& in) {
  static const std::vector<ClipPlane> planes = pipeline_frustum();
  std::array<ClipVertex, 3> corners;
  for (ClipVertex& corner : corners) corner.position = in.point<Point<Clip>>();
  std::array<Outcode, 3> codes;
  for (std::size_t k = 0; k < 3; ++k) codes[k] = outcode(corners[k].position, planes);
  const ClipVerdict verdict = trivial_verdict(codes);
  Numbers out{double(codes[0]), double(codes[1]), double(codes[2]), double(int(verdict))};
  ClipPolygon polygon;
  if (verdict == ClipVerdict::kAccept) polygon = {{corners[0], corners[1], corners[2]}, 3};
  if (verdict == ClipVerdict::kClip) polygon = clip_triangle(corners, planes);
  for (int i = 0; i < polygon.count; ++i)
    append_point(out, polygon.vertices[std::size_t(i)].position);
  return out;
}

std::vector<Point<Object>> corners_of(RecordReader& in, Point<Object>& eye) {
  eye = in.point<Point<Object>>();
  std::vector<Point<Object>> corners;
  while (in.more()) corners.push_back(in.point<Point<Object>>());
  return corners;
}

BackFaceTest test_face(RecordReader& in) {
  Point<Object> eye;
  const std::vector<Point<Object>> corners = corners_of(in, eye);
  return test_back_face(corners, {true, {eye.x, eye.y, eye.z}, {0, 0, 0}});
}

Numbers faced(RecordReader& in) {
  return {test_face(in).facing == Facing::kBack ? 1.0 : 0.0};
}

// ---- judgement ----

std::optional<WrongNumber> judge_clip(const Numbers& in, const Numbers& yours,
                                      const Numbers& reference) {
  static const char* const kNames[] = {"outcode of corner 0", "outcode of corner 1",
                                       "outcode of corner 2", "verdict"};
  const std::span<const double> codes(yours.data(), std::min(yours.size(), kVertices));
  const auto wrong = first_wrong(
      codes, std::span(reference).first(kVertices), [](std::size_t) { return 0; }, "",
      [](std::size_t i) { return std::string(kNames[i]); });
  if (wrong || yours == reference) return wrong;
  std::array<Point<Clip>, 3> corners;
  RecordReader reader(in.data(), in.size());
  for (Point<Clip>& p : corners) p = reader.point<Point<Clip>>();
  const ExactOutline outline = exact_clip(corners, pipeline_frustum());
  Answer answer;
  answer.emit(outline.expected.field,
              Numbers(yours.begin() + std::ptrdiff_t(kVertices), yours.end()));
  const auto found = compare_outlines(outline, answer);
  if (!found) return std::nullopt;
  return WrongNumber{found->element, found->actual, found->expected,
                     found->bound,   found->unit,   found->explanation};
}

// For the inputs of the contract every product is exact; for those of a scene it is not. So the
// sign of a value (P - eye) . m that is within its own rounding error may be wrong. The value is a
// sum of a few dozen products of three differences, each of up to twice the largest coordinate.
std::optional<WrongNumber> judge_facing(const Numbers& in, const Numbers& yours,
                                        const Numbers& reference) {
  if (yours == reference) return std::nullopt;
  double largest = 0;
  for (const double x : in) largest = std::max(largest, std::abs(x));
  RecordReader reader(in.data(), in.size());
  const double value = test_face(reader).value;
  const double bound = 512 * unit_roundoff<double> * largest * largest * largest;
  if (std::abs(value) <= bound) return std::nullopt;
  return WrongNumber{"back face",  yours.empty() ? 0 : yours[0],
                     reference[0], 0,
                     "",           fmt::format("(P - eye) . m = {:.6g}", value)};
}

// ---- in the pipeline ----

bool all_finite(const Point<Clip>& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

// A point of the triangle as a weighted sum of its corners: the weights add up to 1, and are found
// by least squares over the four coordinates.
std::array<double, 3> weights_of(const std::array<ClipVertex, 3>& corners, const Point<Clip>& p) {
  for (const ClipVertex& corner : corners) {
    if (corner.position == p) return corner.weights;
  }
  using Four = std::array<double, 4>;
  const auto from_first = [&](const Point<Clip>& q) {
    const Point<Clip>& o = corners[0].position;
    return Four{double(q.x) - o.x, double(q.y) - o.y, double(q.z) - o.z, double(q.w) - o.w};
  };
  const auto dot = [](const Four& a, const Four& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  };
  const Four a = from_first(corners[1].position), b = from_first(corners[2].position),
             c = from_first(p);
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), ac = dot(a, c), bc = dot(b, c);
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > 0)) return {1, 0, 0};
  const double of_a = (ac * bb - bc * ab) / determinant, of_b = (bc * aa - ac * ab) / determinant;
  return {1 - of_a - of_b, of_a, of_b};
}

// The part of an answer that the later stages can handle: the polygon is left out if it has a
// vertex that cannot be divided or put on the screen, or if it has too many vertices.
ClipPolygon polygon_of(const Numbers& answer, const std::array<ClipVertex, 3>& corners,
                       std::span<const ClipPlane> carried_by) {
  ClipPolygon polygon;
  const std::size_t count = answer.size() > kVertices ? (answer.size() - kVertices) / 4 : 0;
  if (count < 3 || count > std::size_t(kMaxClipVertices)) return {};
  RecordReader reader(answer.data() + kVertices, answer.size() - kVertices);
  for (std::size_t i = 0; i < count; ++i) {
    const auto p = reader.point<Point<Clip>>();
    if (!all_finite(p) || outcode(p, carried_by) != 0) return {};
    polygon.vertices[std::size_t(polygon.count++)] = {p, weights_of(corners, p)};
  }
  return polygon;
}

class StageObserver : public Observer {
public:
  StageObserver(const Scene& scene, const View& view, Cull cull)
      : scene_(scene), view_(view), planes_(render_planes(view)), cull_(cull) {}

  void draw(const Draw& draw) override { draw_ = &draw; }

  void clipped(const PrimitiveStage&, const Triangle& triangle,
               const std::array<ClipVertex, 3>& corners, ClipPolygon& polygon) override {
    number_ = draw_->first_number + triangle.number;
    if (gathering_) return gather(triangle, corners);
    polygon =
        number_ < clips_.size() ? polygon_of(clips_[number_], corners, planes_) : ClipPolygon{};
  }

  // A triangle is culled if the student's function says so, and also if its clipped polygon shows
  // its back on the screen, as one does whose vertices are in the wrong order.
  void facing_tested(const TriangleSetup&, bool, bool& culled) override {
    if (gathering_ || number_ >= faces_.size() || faces_[number_].empty()) return;
    culled = culled || is_culled(*draw_, cull_, faces_[number_][0] == 0);
  }

  // Stores the answers to the questions, indexed by the triangle's number.
  void take(std::vector<Numbers> clips, std::vector<Numbers> faces) {
    clips_ = by_triangle(clip_questions, std::move(clips));
    faces_ = by_triangle(face_questions, std::move(faces));
    gathering_ = false;
  }

  std::vector<Question> clip_questions, face_questions;

private:
  void gather(const Triangle& triangle, const std::array<ClipVertex, 3>& corners) {
    Question clip{{}, number_};
    for (const ClipVertex& corner : corners) append_point(clip.numbers, corner.position);
    clip_questions.push_back(std::move(clip));
    if (!view_.perspective) return;  // a parallel view has no eye point
    Question face{{}, number_};
    append_point(face.numbers, eye());
    const Node& node = scene_.nodes[scene_.instances[draw_->instance].node];
    for (const std::uint32_t corner : triangle.corners) {
      const Point<Object>& p = draw_->mesh->positions[draw_->mesh->corners[corner].position];
      const auto world = node.world_from_node * Point<Object, double>(p.x, p.y, p.z);
      append_point(face.numbers, Point<World>(float(world.x), float(world.y), float(world.z)));
    }
    // A mirror among the transforms reverses the order of the corners, so two corners are
    // exchanged.
    if (draw_->mirrored) std::swap_ranges(&face.numbers[3], &face.numbers[6], &face.numbers[6]);
    face_questions.push_back(std::move(face));
  }

  // The eye is the point that eye_from_world, p -> R p + t, maps to the origin: -R^T t.
  Point<World> eye() const {
    const Transform<Eye, World>& m = view_.eye_from_world;
    const auto at = [&](int k) {
      return float(-(m.at(0, k) * m.at(0, 3) + m.at(1, k) * m.at(1, 3) + m.at(2, k) * m.at(2, 3)));
    };
    return {at(0), at(1), at(2)};
  }

  static std::vector<Numbers> by_triangle(const std::vector<Question>& questions,
                                          std::vector<Numbers> answers) {
    std::vector<Numbers> placed;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      placed.resize(std::max(placed.size(), std::size_t(questions[i].triangle) + 1));
      placed[questions[i].triangle] = std::move(answers[i]);
    }
    return placed;
  }

  const Scene& scene_;
  const View view_;
  const std::array<ClipPlane, kMaxClipPlanes> planes_;
  const Cull cull_;
  const Draw* draw_ = nullptr;
  std::uint32_t number_ = 0;
  bool gathering_ = true;
  std::vector<Numbers> clips_, faces_;
};

const std::vector<DrawnStage>& stages() {
  static const std::vector<DrawnStage> all{
      {"clip", "clip", "outcode, trivial_verdict, clip_to_frustum", clipped, judge_clip,
       in_words({{"corner", 4, 3}})},
      {"facing", "world", "is_back_face", faced, judge_facing,
       in_words({{"eye", 3}, {"corner", 3, kAllThatFollow}})}};
  return all;
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  PictureSetup made{input.scene, input.view, input.settings, nullptr, {}};
  made.settings.cull_stage = CullStage::kScreen;
  auto stage_observer =
      std::make_shared<StageObserver>(input.scene, input.view, made.settings.cull);
  observe_run(made, *stage_observer);
  auto clips = answer_source.ask(stages()[0], stage_observer->clip_questions);
  if (!clips) return tl::unexpected(clips.error());
  auto faces = answer_source.ask(stages()[1], stage_observer->face_questions);
  if (!faces) return tl::unexpected(faces.error());
  stage_observer->take(std::move(*clips), std::move(*faces));
  made.stages = stage_observer;
  return made;
}

}  // namespace lab_05_drawing

LabDrawing drawing_05() {
  using namespace lab_05_drawing;
  return {stages(), draw, "crossing and clip_by_plane, unless clip_to_frustum calls them"};
}

}  // namespace glassbox::labs
