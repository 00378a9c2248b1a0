#include <glassbox/images/stereo/swapped_eyes.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>

#include <glassbox/images/out_of_memory.h>
#include <glassbox/images/stereo/check_eyes.h>

namespace glassbox {
namespace {

constexpr int kRadius = 3;                                      // px, of a window around its centre
constexpr int kWindow = (2 * kRadius + 1) * (2 * kRadius + 1);  // pixels
constexpr int kStep = 2;                                        // px, from one window to the next
// The standard deviation from which a window counts as texture, in thousandths of a byte.
constexpr double kMinDeviation = 2000;
constexpr double kClearlyBetter = 0.1;
constexpr std::uint64_t kMinVotes = 32;

// The luma of one eye, from the channels that its picture uses, in thousandths of a byte.
using Plane = Image<int>;

Plane plane_of(const Image<Rgba8>& picture, const EyeChannels& channels) {
  const int red = channels.r ? 299 : 0, green = channels.g ? 587 : 0, blue = channels.b ? 114 : 0;
  Plane plane(picture.width, picture.height);
  for (std::size_t i = 0; i < plane.pixels.size(); ++i) {
    const Rgba8& pixel = picture.pixels[i];
    const int sum = red * pixel.r + green * pixel.g + blue * pixel.b;
    plane.pixels[i] = sum * 1000 / (red + green + blue);
  }
  return plane;
}

// The normalised correlation of the windows around two pixels, in [-1, 1]. It is computed from sums
// of whole numbers, which are exact.
struct Fit {
  bool has_texture = false;
  double correlation = 0;
};

Fit fit(const Plane& a, int ax, const Plane& b, int bx, int y) {
  std::int64_t sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
  for (int dy = -kRadius; dy <= kRadius; ++dy) {
    for (int dx = -kRadius; dx <= kRadius; ++dx) {
      const std::int64_t va = a.at(ax + dx, y + dy), vb = b.at(bx + dx, y + dy);
      sum_a += va;
      sum_b += vb;
      sum_aa += va * va;
      sum_bb += vb * vb;
      sum_ab += va * vb;
    }
  }
  const double spread_a = double(kWindow * sum_aa - sum_a * sum_a);
  const double spread_b = double(kWindow * sum_bb - sum_b * sum_b);
  const double least = kMinDeviation * kWindow;
  if (spread_a < least * least || spread_b < least * least) return {};
  return {true, double(kWindow * sum_ab - sum_a * sum_b) / std::sqrt(spread_a * spread_b)};
}

struct Planes {
  Plane left, right;
  bool sign_counts = true;  // false: what is light in one picture may be dark in the other
};

OrderEvidence collect_order_evidence(const Planes& eyes, const Image<float>& disparity) {
  OrderEvidence evidence;
  const auto inside = [&](int x) { return x >= kRadius && x < disparity.width - kRadius; };
  for (int y = kRadius; y < disparity.height - kRadius; y += kStep) {
    for (int x = kRadius; x < disparity.width - kRadius; x += kStep) {
      const double shift = double(disparity.at(x, y));
      if (!(std::abs(shift) < disparity.width)) continue;  // also NaN and infinity
      const int there = x + int(std::lround(shift));
      if (there == x || !inside(there)) continue;
      const Fit in_order = fit(eyes.left, x, eyes.right, there, y);
      const Fit swapped = fit(eyes.right, x, eyes.left, there, y);
      if (!in_order.has_texture || !swapped.has_texture) continue;
      const auto strength = [&](const Fit& fit) {
        return eyes.sign_counts ? fit.correlation : std::abs(fit.correlation);
      };
      const double better = strength(in_order) - strength(swapped);
      ++evidence.windows;
      evidence.in_order += better > kClearlyBetter;
      evidence.swapped += better < -kClearlyBetter;
      evidence.in_order_fit += strength(in_order);
      evidence.swapped_fit += strength(swapped);
    }
  }
  if (evidence.windows > 0) {
    evidence.in_order_fit /= double(evidence.windows);
    evidence.swapped_fit /= double(evidence.windows);
  }
  const std::uint64_t votes = evidence.in_order + evidence.swapped;
  if (votes >= kMinVotes) {
    if (3 * evidence.in_order >= 2 * votes) evidence.order = EyeOrder::kInOrder;
    if (3 * evidence.swapped >= 2 * votes) evidence.order = EyeOrder::kSwapped;
  }
  return evidence;
}

}  // namespace

Result<OrderEvidence> pair_order(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                 const Image<float>& disparity) {
  if (const auto checked = check_eyes("order of the eyes", left, right); !checked) {
    return tl::unexpected(checked.error());
  }
  if (const auto checked = check_disparity(left, disparity); !checked) {
    return tl::unexpected(checked.error());
  }
  return unless_out_of_memory([&]() -> Result<OrderEvidence> {
    constexpr EyeChannels kAll{true, true, true};
    return collect_order_evidence({plane_of(left, kAll), plane_of(right, kAll), true}, disparity);
  });
}

Result<OrderEvidence> anaglyph_order(const Image<Rgba8>& anaglyph, Glasses glasses,
                                     const Image<float>& disparity) {
  if (const auto checked = check_disparity(anaglyph, disparity); !checked) {
    return tl::unexpected(checked.error());
  }
  return unless_out_of_memory([&]() -> Result<OrderEvidence> {
    const EyeMasks masks = eye_masks(glasses);
    return collect_order_evidence(
        {plane_of(anaglyph, masks.left), plane_of(anaglyph, masks.right), false}, disparity);
  });
}

}  // namespace glassbox
