#include <glassbox/render/plan/hidden_draws.h>

#include <algorithm>
#include <optional>

#include <glassbox/render/plan/box_bounds.h>
#include <glassbox/render/plan/occlusion_buffer.h>
#include <glassbox/render/staged/reference.h>

namespace glassbox {

namespace {

// How many draws are tested, in the order of drawing; the draws after them are always drawn.
constexpr std::size_t kMaxDraws = 4096;

// Work is counted in units of the time in which the vectorised code draws one triangle, about 20 ns
// (S5 of the benchmark: 22 ms for a million). kMaxWork is the most that the test may cost for each
// sample point of a pixel, kMinWork the cost that is always allowed. kWorkOfTriangle is the cost
// of setting up a triangle by the stages of the reference, about 500 ns.
constexpr std::size_t kMaxWork = std::size_t{1} << 17, kMinWork = 1024;
constexpr std::size_t kWorkOfTriangle = 24;

bool is_filled(const Draw& draw) {
  return draw.mesh->lines.empty() && draw.mesh->points.empty();
}

// Returns the sample points of a pixel and, if there are several, also its centre, whose depth is
// stored separately.
std::vector<SampleOffset> points_of(const RenderSettings& settings) {
  const std::span<const SampleOffset> samples = sample_offsets(samples_drawn(settings));
  std::vector<SampleOffset> points(samples.begin(), samples.end());
  if (points.size() > 1) points.push_back({});
  return points;
}

// Returns the triangles of a draw, set up as they will be drawn.
std::vector<ReadyTriangle> prepare_triangles(const PlannedEye& eye, const Draw& draw) {
  const PrimitiveStage stage{.draw = draw,
                             .clip = nullptr,
                             .eye_space = {},
                             .view = eye.view,
                             .settings = eye.settings,
                             .lighting = eye.list.lighting,
                             .planes = render_planes(eye.view),
                             .object_cull = object_culling(draw, eye.view, eye.settings).test};
  std::vector<ReadyTriangle> ready;
  std::vector<ReadyLine> no_lines;
  for (const Triangle& triangle : draw.triangulation->triangles) {
    prepare_triangle(stage, NullWatch{}, triangle, ready, no_lines);
  }
  return ready;
}

class HiddenDraws {
public:
  // `triangles`: the number of triangles of all draws.
  HiddenDraws(const PlannedEye& eye, std::size_t triangles)
      : eye_(eye),
        window_{0, 0, int(eye.view.viewport.width()), int(eye.view.viewport.height())},
        points_(points_of(eye.settings)),
        most_work_(points_.size() * std::clamp(triangles / 4, kMinWork, kMaxWork)) {}

  // Whether the triangles added so far hide the whole draw. `pixels`: the pixels that the draw's
  // box reaches; nothing if the box reaches the eye.
  bool occludes(const Draw& draw, const DepthCodes& codes,
                const std::optional<PixelRect>& pixels) const {
    return occlusion_ && !occlusion_->covers_nothing() && is_filled(draw) && pixels &&
           occlusion_->occludes(*pixels, codes.nearest);
  }

  void add(const Draw& draw, const std::optional<PixelRect>& pixels) {
    const std::size_t triangles = draw.triangulation->triangles.size();
    const std::size_t set_up = kWorkOfTriangle * triangles;
    if (triangles == 0 || draw.material->alpha_mode != AlphaMode::kOpaque ||
        work() + set_up > most_work_ || triangles > 2 * most_cells(pixels.value_or(window_))) {
      return;
    }
    if (!occlusion_) occlusion_.emplace(window_, points_);
    work_ += set_up;
    for (const ReadyTriangle& triangle : prepare_triangles(eye_, draw)) {
      if (work() > most_work_) return;
      occlusion_->add(triangle.setup, depth_codes(triangle.setup, eye_.settings.depth).farthest);
    }
  }

private:
  std::size_t work() const { return work_ + (occlusion_ ? occlusion_->work() : 0); }

  // Returns the largest number of cells that something within `pixels` may cover completely.
  std::size_t most_cells(const PixelRect& pixels) const {
    const PixelRect seen = intersect(pixels, window_);
    if (seen.empty()) return 0;
    return std::size_t((seen.x1 - seen.x0) / OcclusionBuffer::kCell) *
           std::size_t((seen.y1 - seen.y0) / OcclusionBuffer::kCell);
  }

  const PlannedEye& eye_;
  PixelRect window_;
  std::vector<SampleOffset> points_;
  std::optional<OcclusionBuffer> occlusion_;  // made when the first draw is added
  std::size_t work_ = 0;                      // the work of setting up triangles
  std::size_t most_work_;
};

}  // namespace

std::vector<bool> find_hidden_draws(const PlannedEye& eye, const Plan& plan, double margin_px) {
  const std::vector<Draw>& draws = eye.list.draws;
  std::vector<bool> hidden(draws.size(), false);
  if (plan.order.size() < 2) return hidden;
  std::size_t triangles = 0;
  for (const std::uint32_t i : plan.order) triangles += draws[i].triangulation->triangles.size();
  HiddenDraws found(eye, triangles);
  for (std::size_t at = 0; at < std::min(plan.order.size(), kMaxDraws); ++at) {
    const std::uint32_t i = plan.order[at];
    // A staged draw (drawn by the stages of the reference) may draw lines (wireframe) instead of
    // surfaces.
    if (plan.methods[i].staged_because != nullptr) break;
    const std::optional<PixelRect> pixels = pixels_of_box(draws[i], eye.view, margin_px);
    hidden[i] = found.occludes(draws[i], plan.codes[i], pixels);
    if (!hidden[i]) found.add(draws[i], pixels);
  }
  return hidden;
}

}  // namespace glassbox
