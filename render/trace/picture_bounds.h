// How accurate a picture is, stage by stage: a summary of the running error bounds of a whole run
// (bounds.h, color_bounds.h). It is made during the run, and no records are kept. For each kind of
// number it has the largest bound and its place, a typical bound (the median), and how many numbers
// have no bound.
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

// The place of a bound: a vertex after clipping of a triangle, line or point, or a pixel.
struct BoundPlace {
  // A triangle's number in the whole scene; for a line or point, the index in its mesh.
  std::uint32_t number = 0;
  std::optional<std::uint32_t> corner;  // of the triangle or line, if clipping did not change it
  int x = -1, y = -1;                   // the pixel, for bounds of fragments and pixels
  std::optional<LineKind> line = {};    // the kind of primitive, if it is not a triangle
};

// A summary of the bounds of one kind of number.
class BoundSummary {
public:
  void add(double bound, const BoundPlace& place);

  std::uint64_t count() const { return count_; }
  std::uint64_t unbounded() const { return unbounded_; }  // how many bounds are infinite
  // The largest of the finite bounds; 0 if there are none.
  double largest() const { return largest_; }
  const BoundPlace& place() const { return place_; }
  // A number that at least half of all bounds (infinite ones included) do not exceed; it is at most
  // 1/16 above their median. Infinite if most bounds are.
  double typical() const;

private:
  // The bin of a bound is given by the exponent and 4 bits of the mantissa of its value as a float,
  // so a bin is at most 1/16 wide, relative to its value.
  static constexpr int kShift = 19;
  std::vector<std::uint64_t> bins_ = std::vector<std::uint64_t>(std::size_t(1) << (31 - kShift));
  std::uint64_t count_ = 0, unbounded_ = 0;
  double largest_ = 0;
  BoundPlace place_;
};

struct PictureErrors {
  // For vertices of triangles that have an area on the screen, the larger of the bounds of x and y,
  // in pixels: `screen` before the snap, `snapped` after it. `cut`: after the snap, for vertices
  // that clipping made, which may be thousands of pixels outside the picture.
  BoundSummary screen, snapped, cut;
  // For fragments: the error of NDC depth as the buffer stores it; and for perspective views the
  // error of the distance along the gaze that follows from it, as a fraction of the distance.
  BoundSummary depth, distance;
  // For fragments that passed the depth test: texture coordinates in texels of level 0, the larger
  // of both axes; and the length of the normal's error over the length of the normal, if there is a
  // normal.
  BoundSummary texcoord, normal;
  // For fragments that passed the depth test, in linear light (full light is 1), the largest bound
  // over the channels: of the texture sample, and of the colour after lighting.
  BoundSummary texture, light;
  // In steps of a byte (0 .. 255): the bounds of what fragments store, and of the final picture.
  BoundSummary stored, picture;

  // ---- decisions that might differ if the numbers were exact ----
  // Vertices that may be snapped to another point of the grid.
  std::uint64_t vertices_snapped_elsewhere = 0;
  std::uint64_t fragments_near_edge = 0;  // the exact triangle may not cover them
  std::uint64_t fragments_as_deep = 0;    // the depth test may have the other result
  std::uint64_t fragments_at_cutoff = 0;  // the alpha test may have the other result
  // Pixels that show a fragment that is near an edge, as deep as another, or at the cutoff.
  std::uint64_t pixels_undecided = 0;

  std::uint64_t fragments_of_lines_and_points = 0;
  // Pixels with a stored byte that has no finite bound.
  std::uint64_t pixels_unbounded = 0;
};

// Receives a run's records. It needs memory for a few numbers per pixel.
class PictureBounds : public TraceSink {
public:
  // The scene must outlive the object.
  PictureBounds(const Scene& scene, const View& view, const RenderSettings& settings);

  void draw(const TracedDraw& draw) override;
  void triangle(const TracedTriangle& triangle) override;
  void fragment(const TracedFragment& fragment) override;

  // Called after the run.
  PictureErrors finish();

private:
  // The bounds and the state of a pixel of the picture.
  struct Pixel {
    std::array<float, 4> bytes_off{};  // the bound of each stored channel
    float depth = 2, depth_bound = 0;  // depth 2 is behind everything
    std::uint32_t number = 0;
    std::optional<LineKind> line = {};
    bool is_drawn = false, is_undecided = false;
  };

  // Adds the bound of the fragment's depth. Returns whether the exact depth may be on the other
  // side of the pixel's depth.
  bool add_depth(const TracedFragment& fragment, const FragmentBounds& bounds, Pixel& pixel);
  void add_attributes(const TracedFragment& fragment, const ColorBounds& colors);
  void store(const TracedFragment& fragment, const ColorBounds& colors, Pixel& pixel);
  void add_line_fragment(const TracedFragment& fragment, Pixel& pixel);
  const LineBounds& line_of(const TracedFragment& fragment);
  // Adds a fragment of a triangle, line or point, from the depth test on. `may_miss` is called only
  // if the fragment passed the test, `colors` only if colours are shown as well.
  template <class MayMiss, class Colors>
  void follow(const TracedFragment& fragment, const FragmentBounds& bounds, Pixel& pixel,
              const MayMiss& may_miss, const Colors& colors);
  const PieceColors& piece_of(const TracedFragment& fragment,
                              const BoundsOfRun::KnownTriangle& known);
  bool is_near_edge(const TracedFragment& fragment, const BoundsOfRun::KnownTriangle& known) const;

  View view_;
  RenderSettings settings_;
  PreparedScene prepared_;
  DrawList list_;
  std::map<std::uint32_t, const Draw*> draws_;  // by instance
  BoundsOfRun bounds_;
  PictureErrors errors_;
  Image<Pixel> pixels_;
  // The triangle of a fan whose fragments are being added.
  std::optional<PieceColors> piece_;
  std::uint32_t piece_triangle_ = 0, piece_number_ = 0;
  // The line or point whose fragments are being added.
  std::optional<LineBounds> line_;
  FragmentSource line_source_;
  std::uint32_t line_instance_ = 0;
};

// Returns the bounds of a picture, from a run of the staged reference. Only pixel centres are
// examined, for any number of samples.
PictureErrors picture_errors(const Scene& scene, const View& view, const RenderSettings& settings);

}  // namespace glassbox
