// How exact a picture is, stage by stage: the running error bounds of a whole run (bounds.h, color_bounds.h) taken together as its
// records come, without keeping them. Of each number the largest bound and where, one that half of them keep below, and how many
// nothing can be said of.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/color_bounds.h>
#include <glassbox/render/trace/line_bounds.h>
#include <glassbox/render/trace/tracer.h>

namespace glassbox {

// Where a bound is: a vertex of what clipping left of a triangle, line or point, or a pixel.
struct BoundPlace {
  std::uint32_t number = 0;  // of the triangle in the whole scene; of a line or point in its mesh
  std::optional<std::uint32_t> corner;  // of the triangle or line, where clipping left it alone
  int x = -1, y = -1;                   // of fragments and pixels
  std::optional<LineKind> line = {};    // what it is of, where that is no triangle
};

// Bounds of one kind of number.
class BoundSummary {
public:
  void see(double bound, const BoundPlace& place);

  std::uint64_t count() const { return count_; }
  std::uint64_t unbounded() const { return unbounded_; }  // of these, how many are infinite
  // Of the others; 0 where there are none.
  double largest() const { return largest_; }
  const BoundPlace& place() const { return place_; }
  // At least half of all bounds, infinite ones counted, are no larger; at most 1/16 above their median. Infinite where most are.
  double typical() const;

private:
  // By exponent and 4 bits of the mantissa of the bound as a float: steps of 1/16.
  static constexpr int kShift = 19;
  std::vector<std::uint64_t> bins_ = std::vector<std::uint64_t>(std::size_t(1) << (31 - kShift));
  std::uint64_t count_ = 0, unbounded_ = 0;
  double largest_ = 0;
  BoundPlace place_;
};

struct PictureErrors {
  // Of vertices of triangles that have an area on the screen, in pixels: the larger of x and y, before and after the snap; and
  // after the snap of those that clipping made, which may lie thousands of pixels beside the picture.
  BoundSummary screen, snapped, cut;
  // Of fragments: NDC depth as the buffer stores it; of perspective views, as a share of the distance along the gaze.
  BoundSummary depth, distance;
  // Of fragments in front: texels of level 0, the larger of both axes; the length of the normal's error over the normal's, where
  // there is a normal.
  BoundSummary texcoord, normal;
  // The same, linear: the largest of the channels. Of the sample, and of the colour in the light; full light is 1.
  BoundSummary texture, light;
  // In bytes: of what fragments store, and of what the picture shows in the end.
  BoundSummary stored, picture;

  // ---- what numbers within their bounds would decide otherwise, or might ----
  std::uint64_t vertices_snapped_elsewhere =
      0;                                  // the exact vertex may go to another place of the grid
  std::uint64_t fragments_near_edge = 0;  // their triangle may not cover them, as it really lies
  std::uint64_t fragments_as_deep = 0;    // the depth test may go the other way
  std::uint64_t fragments_at_cutoff = 0;  // the alpha mask may
  std::uint64_t pixels_undecided = 0;     // that show the outcome of one of the last three

  std::uint64_t fragments_of_lines_and_points = 0;
  // Whose bytes nothing can be said of: what they show passes all bounds.
  std::uint64_t pixels_unbounded = 0;
};

// Where a run's records go. What it needs of memory is a few numbers for each pixel.
class PictureBounds : public TraceSink {
public:
  // The scene must outlive it.
  PictureBounds(const Scene& scene, const View& view, const RenderSettings& settings);

  void draw(const TracedDraw& draw) override;
  void triangle(const TracedTriangle& triangle) override;
  void fragment(const TracedFragment& fragment) override;

  // After the run.
  PictureErrors finish();

private:
  // What a pixel of the picture holds.
  struct Pixel {
    std::array<float, 4> bytes_off{};  // bound of each stored channel
    float depth = 2, depth_bound = 0;  // behind everything
    std::uint32_t number = 0;
    std::optional<LineKind> line = {};
    bool is_drawn = false, is_undecided = false;
  };

  // Whether its exact depth may be on the other side of what the pixel holds.
  bool see_depth(const TracedFragment& fragment, const FragmentBounds& bounds, Pixel& pixel);
  void see_attributes(const TracedFragment& fragment, const ColorBounds& colors);
  void store(const TracedFragment& fragment, const ColorBounds& colors, Pixel& pixel);
  void see_line(const TracedFragment& fragment, Pixel& pixel);
  const LineBounds& line_of(const TracedFragment& fragment);
  // What is the same for triangles and lines, from the depth test on: `may_miss` only where it has passed.
  template <class MayMiss, class Colors>
  void follow(const TracedFragment& fragment, const FragmentBounds& bounds, Pixel& pixel,
              const MayMiss& may_miss, const Colors& colors);
  const PieceColors& piece_of(const TracedFragment& fragment, const BoundsOfRun::Known& known);
  bool is_near_edge(const TracedFragment& fragment, const BoundsOfRun::Known& known) const;

  View view_;
  RenderSettings settings_;
  PreparedScene prepared_;
  DrawList list_;
  std::map<std::uint32_t, const Draw*> draws_;  // by instance
  BoundsOfRun bounds_;
  PictureErrors errors_;
  Image<Pixel> pixels_;
  // Of the piece whose fragments are coming.
  std::optional<PieceColors> piece_;
  std::uint32_t piece_triangle_ = 0, piece_number_ = 0;
  // Of the line or point whose fragments are coming.
  std::optional<LineBounds> line_;
  FragmentSource line_source_;
  std::uint32_t line_instance_ = 0;
};

// The bounds of a picture, by a run of the staged reference. Pixel centres are looked at, whatever the samples.
PictureErrors picture_errors(const Scene& scene, const View& view, const RenderSettings& settings);

}  // namespace glassbox
