// A compact record of a run: for every triangle its result, for every fragment its source and the
// bytes that it wrote. All numbers between them can be recomputed bit for bit from the scene's
// positions and the matrices.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

// The result of a triangle, as bits, because the triangles of the fan that clipping leaves of it
// may have different results.
enum TriangleMark : std::uint8_t {
  kMarkRejected = 1,     // all corners outside one plane
  kMarkClippedAway = 2,  // nothing is left after clipping
  kMarkCut = 4,          // clipping changed it, and a polygon remains
  kMarkZeroArea = 8,     // a triangle of its fan has no area after snapping
  kMarkCulled = 16,      // a triangle of its fan faces the wrong way
  kMarkSetUp = 32,       // a triangle of its fan went on to be rasterised
};

// The triangles that reached the clipper, in drawing order. The triangles of a draw are
// consecutive.
struct TriangleColumns {
  std::vector<std::uint32_t> number;                   // in the whole scene
  std::vector<std::uint32_t> face;                     // index into Mesh::faces
  std::array<std::vector<std::uint32_t>, 3> position;  // indices into Mesh::positions
  std::vector<std::uint8_t> marks;                     // bits of TriangleMark
};

// The polygon that clipping left of a triangle that it cut.
struct CutTriangle {
  std::uint32_t number = 0;
  ClipPolygon polygon;
};

inline constexpr std::uint32_t kNoTriangle = 0xffffffffu;

// The fragments in the order in which they were drawn.
struct FragmentColumns {
  // The number of the fragment's triangle in the whole scene; kNoTriangle for lines and points.
  std::vector<std::uint32_t> triangle;
  std::vector<std::uint8_t> piece;
  std::vector<std::uint16_t> x, y;
  std::vector<std::uint8_t> result;  // FragmentResult
  // r, g, b, a: the pixel after each fragment written or blended.
  std::array<std::vector<std::uint8_t>, 4> written;
  std::vector<std::uint32_t> code;  // depth code; only for fragments of lines and points
};

struct ColumnFilter {
  // If set, only fragments of these pixels are recorded, and only triangles whose box on the screen
  // reaches into them, or that would reach into them if nothing clipped them.
  std::optional<PixelRect> pixels;
  std::uint64_t max_triangles = 1'000'000;
  std::uint64_t max_fragments = 4'000'000;
};

struct ColumnRun {
  Rendering rendering;  // the same bytes as those of a run without an observer
  std::array<ClipPlane, kMaxClipPlanes> planes{};
  std::vector<TracedDraw> draws;
  // For each draw, how many of the triangles in `triangles` are its own.
  std::vector<std::uint32_t> triangles_of_draw;
  TriangleColumns triangles;
  std::vector<CutTriangle> cut;
  FragmentColumns fragments;
  // How many triangles and fragments there were to record; more than the columns contain if the
  // filter's limits were reached.
  std::uint64_t triangle_count = 0;
  std::uint64_t fragment_count = 0;
};

// `stages`: an observer that takes part in the run and may change it; null: none.
ColumnRun record_columns(const Scene& scene, const View& view, const RenderSettings& settings,
                         const ColumnFilter& filter, Observer* stages = nullptr);

}  // namespace glassbox
