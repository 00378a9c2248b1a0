#include <glassbox/render/staged/culling_list.h>

#include <array>
#include <cmath>

namespace glassbox {

namespace {

bool unseen(const Draw& draw, const Triangle& triangle, const std::vector<Outcode>& outcodes) {
  std::array<Outcode, 3> codes;
  for (std::size_t k = 0; k < 3; ++k) {
    codes[k] = outcodes[draw.mesh->corners[triangle.corners[k]].position];
  }
  return unseen_by_both(codes);
}

// Lines colour samples half a pixel beside them and, where they run between two pixels, those of either; snap, divide and viewport
// move them by less than 0.01 px.
constexpr double kLineMarginPx = 1;

// How much farther out than the edge of the picture something ends of which lines are drawn.
double margin_share(float side_px) {
  return 1 + 2 * kLineMarginPx / std::abs(double(side_px));
}

}  // namespace

CullingList::CullingList(StereoCulling how, const View& centre, const std::vector<Draw>& left_draws,
                         bool as_lines)
    : centre_(centre), draws_(left_draws) {
  if (as_lines) {
    share_x_ = margin_share(centre.viewport.width());
    share_y_ = margin_share(centre.viewport.height());
  }
  if (how == StereoCulling::kCentre) centre_draws_ = draws_of_other_eye(draws_, centre);
}

std::span<const Triangle> CullingList::triangles_of(std::size_t draw, const DrawTables& tables) {
  const std::vector<Outcode> pair = outcodes_of_pair(tables);
  const std::vector<Outcode> centre =
      centre_draws_.empty() ? std::vector<Outcode>{} : outcodes_of_centre(centre_draws_[draw]);
  kept_.clear();
  for (const Triangle& triangle : draws_[draw].triangulation->triangles) {
    const bool unseen_by_pair = unseen(draws_[draw], triangle, pair);
    const bool culled = centre.empty() ? unseen_by_pair : unseen(draws_[draw], triangle, centre);
    if (!culled) kept_.push_back(triangle);
    left_out_.culled += culled;
    left_out_.lost += culled && !unseen_by_pair;
  }
  return kept_;
}

Outcode CullingList::outcode_within(StereoClipPoint point) const {
  for (float* x : {&point.left_x, &point.right_x}) *x = float(double(*x) / share_x_);
  point.y = float(double(point.y) / share_y_);
  return stereo_outcode(point, centre_);
}

std::vector<Outcode> CullingList::outcodes_of_pair(const DrawTables& tables) const {
  const std::vector<Point<Clip>>& left = tables.clip[0].positions;
  const std::vector<Point<Clip>>& right = tables.clip[1].positions;
  std::vector<Outcode> outcodes;
  outcodes.reserve(left.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    outcodes.push_back(outcode_within(stereo_clip_point(left[i], right[i])));
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
