// Counts the results of every triangle of a run. For one triangle it also records which other
// triangles were the cause.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include <glassbox/images/image.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/settings.h>
#include <glassbox/render/trace/records.h>
#include <glassbox/render/trace/triangle_result.h>

namespace glassbox {

// The first plane that all corners are outside of; nothing if there is none.
std::optional<std::size_t> first_outside_plane(const TracedTriangle& triangle,
                                               std::span<const ClipPlane> planes);

// Returns where a triangle ends that has no fragments. `triangle` and `planes` are as a trace
// records them.
TriangleResult result_before_fragments(const TracedTriangle& triangle,
                                       std::span<const ClipPlane> planes,
                                       const RenderSettings& settings, const PixelRect& picture);

// The fragments of a triangle. covered = hidden + discarded + masked + overwritten + visible.
struct TriangleFragmentCounts {
  std::uint32_t covered = 0;
  std::uint32_t hidden = 0;             // failed the depth test
  std::uint32_t discarded = 0;          // alpha below the cutoff
  std::uint32_t masked = 0;             // no channel may be written
  std::uint32_t overwritten = 0;        // by something opaque that came later
  std::uint32_t visible = 0;            // part of the final picture
  std::uint32_t unchanged = 0;          // visible ones that left the bytes as they were
  std::uint32_t under_translucent = 0;  // visible ones with something translucent over them
  std::uint32_t transparent = 0;        // blended with an alpha too small to change a byte
};

// Returns where a triangle with these fragments ends; this is `before` if it has none.
TriangleResult result_of(const TriangleFragmentCounts& fragments, TriangleResult before);

// A triangle that hid or overwrote another one, and at how many pixels. Lines and points have no
// number.
struct Occluder {
  std::optional<std::uint32_t> number;
  std::uint32_t pixels = 0;
};

// The results of one triangle's fragments, and which triangles were the cause.
struct FragmentDetails {
  std::vector<Occluder> hidden_by, overwritten_by;  // triangles with most pixels first

  // The fragment that came closest to passing the depth test.
  struct Hidden {
    int x = 0, y = 0;
    std::uint32_t code = 0, stored = 0;       // depth_code: the smaller is nearer
    float distance = 0, stored_distance = 0;  // along the gaze, world units
    std::optional<std::uint32_t> by;
  };
  std::optional<Hidden> closest_hidden;

  // The fragment that came closest to passing the alpha test.
  struct Discarded {
    int x = 0, y = 0;
    float alpha = 0, cutoff = 0;
  };
  std::optional<Discarded> closest_discarded;

  // A fragment that left the bytes as they were.
  struct Unchanged {
    int x = 0, y = 0;
    bool blended = false;
    float alpha = 0;
    Rgba8 bytes;
  };
  std::optional<Unchanged> unchanged;

  std::optional<std::array<int, 2>> overwritten_at;  // a pixel where it was overwritten
  PixelRect visible_box;                             // the bounding box of its visible pixels
  std::optional<std::array<int, 2>> example;  // the visible pixel nearest to the middle of the box
};

class ResultCounter : public Observer {
public:
  // `subject` is the triangle that details() describes. Memory: 12 bytes for each pixel and for
  // each write that is still visible, and 44 for each triangle.
  ResultCounter(const View& view, const RenderSettings& settings,
                std::optional<std::uint32_t> subject);

  void draw(const Draw& draw) override;
  void clipped(const PrimitiveStage&, const Triangle& triangle,
               const std::array<ClipVertex, 3>& corners, ClipPolygon& polygon) override;
  void set_up(std::uint32_t piece, const std::array<ScreenVertex, 3>& vertices,
              std::optional<TriangleSetup>& setup) override;
  void facing_tested(const TriangleSetup& setup, bool front, bool& culled) override;
  void triangle_finished(const Triangle& triangle) override;
  void compared(const FragmentSource& source, const Fragment& fragment, std::uint32_t code,
                std::uint32_t stored, bool& in_front) override;
  void textured(const Varyings& at, Rgba& surface) override;
  void encoded(const Fragment& fragment, const Rgba8& before, Rgba8& after) override;
  void fragment_finished(const FragmentSource& source, const Fragment& fragment,
                         FragmentResult result) override;

  // Must be called once after the run: counts what is visible.
  void finish();

  struct Entry {
    TriangleResult before = TriangleResult::kNoArea;  // where it ends if it has no fragments
    std::uint8_t plane = 0;  // for kOutsidePlane: the first plane that it is outside of
    TriangleFragmentCounts fragments;
    TriangleResult result() const { return result_of(fragments, before); }
  };
  const std::vector<Entry>& entries() const { return entries_; }  // by triangle number
  const FragmentDetails& details() const { return details_; }
  // The clip planes of the view, in the order of Entry::plane.
  std::span<const ClipPlane> planes() const { return planes_; }
  // The number of pixels in which something is seen that changed their bytes.
  std::uint64_t shown_pixels() const { return shown_pixels_; }
  // The highest alpha among all discarded fragments; below 0 if there are none.
  float highest_discarded_alpha() const { return highest_discarded_alpha_; }

private:
  // A write to a pixel that nothing opaque has covered since.
  struct Layer {
    std::uint32_t number = 0;
    std::uint32_t next = 0;  // the layer below; kNone: the background
    bool unchanged = false;
  };
  struct Nearest {
    std::uint32_t number = 0;
    float distance = 0;
  };
  using Counts = std::unordered_map<std::uint32_t, std::uint32_t>;

  void count_hidden(const FragmentSource& source, const Fragment& fragment);
  void count_discarded(const FragmentSource& source, const Fragment& fragment);
  void count_written(const FragmentSource& source, const Fragment& fragment, FragmentResult result);
  void cover_layers(std::size_t pixel, std::uint32_t by);
  void add_layer(std::size_t pixel, std::uint32_t number, bool unchanged);
  bool shows_subject(int x, int y) const;
  void find_visible();
  std::size_t pixel_of(const Fragment& fragment) const {
    return std::size_t(fragment.y) * std::size_t(width_) + std::size_t(fragment.x);
  }

  const View& view_;
  const RenderSettings& settings_;
  const std::optional<std::uint32_t> subject_;
  const std::array<ClipPlane, kMaxClipPlanes> planes_;
  const int width_, height_;

  const Draw* draw_ = nullptr;
  TracedTriangle current_;  // its memory is reused for the next triangle
  std::vector<Entry> entries_;

  std::uint32_t code_ = 0, stored_ = 0;  // of the current fragment
  float alpha_ = 1;
  Rgba8 before_, after_;

  std::vector<Nearest> nearest_;     // by pixel: the triangle that wrote the depth
  std::vector<std::uint32_t> tops_;  // by pixel: index of its uppermost layer
  std::vector<Layer> layers_;
  std::uint32_t free_ = 0;  // the first of a list of unused layers
  std::uint64_t shown_pixels_ = 0;
  float highest_discarded_alpha_ = -1;

  Counts hidden_by_, overwritten_by_;
  FragmentDetails details_;
};

}  // namespace glassbox
