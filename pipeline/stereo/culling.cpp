#include <glassbox/pipeline/stereo/culling.h>

#include <cmath>
#include <limits>

namespace glassbox {
namespace {

constexpr Outcode kShared = 0x0f, kLeftSides = 0x30, kRightSides = 0xc0;
constexpr Outcode kLeftNotFinite = 0x100, kRightNotFinite = 0x200;

Outcode bit(int i, bool outside) {
  return outside ? Outcode{1} << i : 0;
}

}  // namespace

StereoPlanes stereo_planes(const View& centre) {
  const auto frustum = frustum_planes(centre.depth_range);
  const auto drawn = render_planes(centre);
  return {{drawn[0], drawn[2], frustum[4], frustum[5]}, {frustum[2], frustum[3]}};
}

Outcode stereo_outcode(const StereoClipPoint& p, const View& centre) {
  const bool shared_finite = std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
  const bool left_finite = shared_finite && std::isfinite(p.left_x);
  const bool right_finite = shared_finite && std::isfinite(p.right_x);
  // As in render_planes, z <= 2 w replaces an infinite far plane, z <= w. It is computed in double,
  // where the product cannot overflow.
  const bool noise_only = centre.depth_range == DepthRange::kStandard && std::isinf(centre.far);
  const double end = noise_only ? 2 * double(p.w) : double(p.w);
  return bit(0, p.z < 0) | bit(1, double(p.z) > end) | bit(2, p.y < -p.w) | bit(3, p.y > p.w) |
         bit(4, p.left_x < -p.w) | bit(5, p.left_x > p.w) | bit(6, p.right_x < -p.w) |
         bit(7, p.right_x > p.w) | bit(8, !left_finite) | bit(9, !right_finite);
}

bool is_outside_both_views(std::span<const Outcode> outcodes) {
  Outcode all = ~Outcode{0}, any = 0;
  for (const Outcode code : outcodes) {
    all &= code;
    any |= code;
  }
  const bool left = (all & (kShared | kLeftSides)) != 0 || (any & kLeftNotFinite) != 0;
  const bool right = (all & (kShared | kRightSides)) != 0 || (any & kRightNotFinite) != 0;
  return left && right;
}

bool is_box_outside_both_views(const Box<Object>& box,
                               const Transform<Clip, Object, float>& left_clip_from_object,
                               const Transform<Clip, Object, float>& right_clip_from_object,
                               const StereoPlanes& planes) {
  const auto outside = [&](const auto& clip_from_object, std::span<const ClipPlane> some) {
    return classify_box(box, clip_from_object, some) == ClipVerdict::kReject;
  };
  return outside(left_clip_from_object, planes.shared) ||
         (outside(left_clip_from_object, planes.sides) &&
          outside(right_clip_from_object, planes.sides));
}

}  // namespace glassbox
