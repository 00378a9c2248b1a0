#include <glassbox/render/staged/culling_list.h>

#include <array>
#include <cmath>

namespace glassbox {

namespace {

bool is_unseen(const Draw& draw, const Triangle& triangle, const std::vector<Outcode>& outcodes) {
  std::array<Outcode, 3> codes;
  for (std::size_t k = 0; k < 3; ++k) {
    codes[k] = outcodes[draw.mesh->corners[triangle.corners[k]].position];
  }
  return is_outside_both_views(codes);
}

// How many pixels outside the picture a line may be and still reach into it. A line colours samples
// at most half a pixel away from it. The other half pixel is far more than the rounding errors, as
// follows.
//
// A culled primitive has, for example, x > s w at all its corners, with w > 0 (outcode_within) and
// s = 1 + 2 px/W, where W is the picture's width. Where an edge crosses a clip plane, x and w are
// interpolated between its ends and rounded to float. All terms are positive, so x/w loses at most
// 2^-23 of itself at each of at most 7 planes. The divide rounds twice, the viewport rounds a
// product and a sum, by 2^-24 each, and the snap moves by 1/512 px. With W = 16384 the errors add
// up to at most 17 * 2^-24 * 8193 + 2^-24 * 16385 + 1/512 < 0.012 px (17 = 2 * 7 + 2 + 1).
constexpr double kLineMarginPx = 1;

// Returns how far from the picture's centre the margin for lines ends, relative to the picture's
// edge.
double margin_share(float side_px) {
  return 1 + 2 * kLineMarginPx / std::abs(double(side_px));
}

}  // namespace

CullingList::CullingList(StereoCulling how, const View& centre, const std::vector<Draw>& left_draws,
                         const std::vector<Draw>& right_draws, bool as_lines)
    : centre_(centre),
      left_draws_(left_draws),
      right_draws_(right_draws),
      kept_(left_draws.size()) {
  if (as_lines) {
    share_x_ = margin_share(centre.viewport.width());
    share_y_ = margin_share(centre.viewport.height());
  }
  if (how == StereoCulling::kCentre) centre_draws_ = draws_of_other_eye(left_draws, centre);
}

void CullingList::cull_draw(std::size_t index, const ClipTable& left) {
  const Draw& draw = left_draws_[index];
  const std::vector<Outcode> pair = outcodes_of_pair(right_draws_[index], left);
  const std::vector<Outcode> centre =
      centre_draws_.empty() ? std::vector<Outcode>{} : outcodes_of_centre(centre_draws_[index]);
  for (const Triangle& triangle : draw.triangulation->triangles) {
    const bool unseen_by_pair = is_unseen(draw, triangle, pair);
    const bool culled = centre.empty() ? unseen_by_pair : is_unseen(draw, triangle, centre);
    if (!culled) kept_[index].push_back(triangle);
    counts_.culled += culled;
    counts_.lost += culled && !unseen_by_pair;
  }
}

Outcode CullingList::outcode_within(StereoClipPoint point) const {
  const bool as_lines = share_x_ != 1;
  for (float* x : {&point.left_x, &point.right_x}) *x = float(double(*x) / share_x_);
  point.y = float(double(point.y) / share_y_);
  const Outcode code = stereo_outcode(point, centre_);
  // For lines, the tests with the sides of the picture hold only in front of the eye, where w > 0
  // (see kLineMarginPx).
  return as_lines && !(point.w > 0) ? code & ~kStereoSides : code;
}

std::vector<Outcode> CullingList::outcodes_of_pair(const Draw& right_draw,
                                                   const ClipTable& left) const {
  std::vector<Outcode> outcodes;
  outcodes.reserve(left.positions.size());
  for (std::uint32_t i = 0; i < left.positions.size(); ++i) {
    Point<Clip> right = left.positions[i];
    right.x = project_x(right_draw, i);
    outcodes.push_back(outcode_within(stereo_clip_point(left.positions[i], right)));
  }
  return outcodes;
}

std::vector<Outcode> CullingList::outcodes_of_centre(const Draw& centre_draw) const {
  std::vector<Outcode> outcodes;
  for (const Point<Clip>& position : project_vertices(centre_draw, centre_).positions) {
    outcodes.push_back(outcode_within(centre_clip_point(position)));
  }
  return outcodes;
}

}  // namespace glassbox
