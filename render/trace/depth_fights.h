// Finds z-fighting: pixels in which two surfaces have the same or nearly the same depth codes, so
// that rounding decides which of them is seen.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/raster/depth.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/settings.h>

namespace glassbox {

// By how many codes rounding can exchange two depths. A depth has an error of about 8 u from
// interpolation and as much from its corners (u is the unit roundoff of float, 2^-24, and about one
// code of a float or of 24 bits); a code of 16 bits is coarser than these errors.
inline std::uint32_t doubtful_codes(DepthFormat format) {
  return format == DepthFormat::kUnorm16 ? 1 : 16;
}

// Whether the depth test cannot be trusted to order two depths.
inline bool are_doubtful(DepthFormat format, std::uint32_t code, std::uint32_t other) {
  return (code > other ? code - other : other - code) <= doubtful_codes(format);
}

// Two triangles that fight, and one pixel in which they do.
struct DepthFight {
  std::uint32_t first = 0, second = 0;  // numbers in the scene, in the order of drawing
  std::uint64_t pixels = 0;
  int x = 0, y = 0;
  float first_distance = 0, second_distance = 0;  // along the gaze there, world units
  double snapping = 0;  // by how much snapping to subpixels can change the two depths there
};

// What would separate the two surfaces of a fight.
struct DepthRemedy {
  double step = 0;  // the distance there that one code of the format stands for, world units
  // A format whose doubtful codes are at most half of the distance between the surfaces; nothing if
  // no format is fine enough, or if the picture has the finest one.
  std::optional<DepthFormat> format;
  // A near plane with which the present format is fine enough; nothing if there is none in front of
  // both surfaces.
  std::optional<double> near;
  double offset = 0;  // how far apart the surfaces have to be along the gaze, world units
};
DepthRemedy remedy_of(const View& view, DepthFormat format, const DepthFight& fight);

// Pairs that fight in fewer pixels are left out of reports: where two surfaces cross each other,
// some pixels of the crossing have equal depths.
inline constexpr std::uint64_t kFewestFightingPixels = 8;

// Watches a run. Two depths are doubtful if their codes are, or if they differ by no more than
// snapping can change them: it moves each corner of a triangle by up to half a subpixel along x and
// along y, and keeps the corner's depth. Memory: 24 bytes for each pixel.
class DepthFights : public Observer {
public:
  DepthFights(const View& view, DepthFormat format);

  void piece_ready(const ReadyTriangle& triangle) override;
  void compared(const FragmentSource& source, const Fragment& fragment, std::uint32_t code,
                std::uint32_t stored, bool& in_front) override;
  void fragment_finished(const FragmentSource& source, const Fragment& fragment,
                         FragmentResult result) override;

  // The pairs that fight in at least kFewestFightingPixels, those with most pixels first. Triangles
  // that have a corner in common are left out: they meet there, as neighbours in a surface do.
  std::vector<DepthFight> fights(const Scene& scene) const;

private:
  struct Nearest {
    std::uint32_t number = kNone;
    float distance = 0, depth = 0;
    double snapping = 0;
  };

  Nearest& nearest_at(const Fragment& fragment) {
    return nearest_[std::size_t(fragment.y) * std::size_t(width_) + std::size_t(fragment.x)];
  }

  const View& view_;
  const DepthFormat format_;
  const int width_;
  double snapping_ = 0;  // of the current triangle: by how much it can change a depth
  std::vector<Nearest> nearest_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, DepthFight> fights_;
};

// Runs the staged reference once.
std::vector<DepthFight> depth_fights(const Scene& scene, const View& view,
                                     const RenderSettings& settings);

}  // namespace glassbox
