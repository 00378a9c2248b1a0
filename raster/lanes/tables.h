// The tables that the vectorised stages read and write: one entry for each vertex, triangle or
// pixel.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include <glassbox/base/spaces.h>
#include <glassbox/images/image.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/mesh/triangulate.h>
#include <glassbox/pipeline/normal_transform.h>
#include <glassbox/pipeline/viewport.h>
#include <glassbox/raster/color_mask.h>
#include <glassbox/raster/depth.h>
#include <glassbox/raster/lanes/tile_buffer.h>
#include <glassbox/raster/shading.h>
#include <glassbox/raster/stages.h>
#include <glassbox/raster/texture.h>
#include <glassbox/raster/transfer.h>

namespace glassbox {

// ---- vertices ----

// A position of the mesh on the screen, snapped. If it may need clipping, x is kNeedsClipping.
inline constexpr std::int32_t kNeedsClipping = std::numeric_limits<std::int32_t>::min();
struct SnappedEntry {
  std::int32_t x = 0, y = 0;  // 1/256 pixel
  float z = 0;                // depth in NDC
  float inverse_w = 0;
};

// The transform from object space to the screen, for some of a mesh's positions.
struct VertexJob {
  std::span<const Point<Object>> positions;
  Vector<Object> anchor;
  Transform<Clip, Object, float> clip_from_anchored;
  Viewport viewport;
  // A vertex with 0 <= z <= far_factor w, smallest_w <= w < infinity and |x|, |y| at most half of
  // the guard band is inside all planes that rendering clips by.
  float far_factor = 1;
  float smallest_w = 0;
  float band_x = 1, band_y = 1;  // |x| <= band_x w
  bool test_planes = true;       // otherwise all positions are known to be inside
  bool divide = true;            // otherwise w is known to be 1
  SnappedEntry* screen = nullptr;

  // The other eye of a pair, whose clip space differs in x alone: its matrix and its entries. Null:
  // there is none.
  const Transform<Clip, Object, float>* other_clip_from_anchored = nullptr;
  SnappedEntry* other_screen = nullptr;
};

// The transforms of normals (to unit length) and of positions to eye space.
struct NormalJob {
  std::span<const Normal<Object>> normals;
  NormalTransform<Eye, Object> eye_from_object;
  Normal<Eye>* eye = nullptr;
};
struct EyePositionJob {
  std::span<const Point<Object>> positions;
  Vector<Object> anchor;
  Transform<Eye, Object, float> eye_from_anchored;
  Point<Eye>* eye = nullptr;
};

// ---- triangles ----

// Three indices for each triangle, one after the other.
using IndexTriples = const std::uint32_t*;

// The largest width and height of small triangles, in pixels. It ensures that all their numbers fit
// in 32 bits: with s = 64 * 256, an edge function within a quad of the box, and at a pixel next to
// it for samples, is below 2 s (s + 5 * 256) < 2^30, and so is twice the area.
inline constexpr int kSmallSide = 64;

struct SelectJob {
  IndexTriples positions;
  const SnappedEntry* screen = nullptr;  // by position
  std::uint32_t first = 0, count = 0;    // triangles
  bool mirrored = false;                 // Draw::mirrored
  bool keep_front = true, keep_back = false;
  bool all_large = false;  // leave every triangle to the staged primitives
  PixelRect window;
  // Pixels around those whose centres are in the box: 1 where samples are drawn (sampled_bounds()).
  int margin = 0;
  int tile_shift = 6;  // log2 of the tile's side
  // Null, or for each of the `count` triangles a number that is 0 if the triangle is left out.
  // kMostLanes more must be readable.
  const std::int32_t* keep = nullptr;
};
inline constexpr std::size_t kMostLanes = 64;  // of 32 bits: the widest vectors have 2048 bits

// A tile of the screen: its column in the lower half, its row in the upper half.
using TilePlace = std::uint32_t;

// The entries for the bins of rectangles of tiles; a rectangle is given by its first and last tile.
// After selection an entry is the index of a triangle in its draw. An entry with kLarge is left to
// the staged primitives, and its tiles have no meaning.
struct BinColumns {
  std::uint32_t* entries = nullptr;
  TilePlace* first = nullptr;
  TilePlace* last = nullptr;

  BinColumns starting_at(std::size_t i) const { return {entries + i, first + i, last + i}; }
};
inline constexpr std::uint32_t kLarge = 0x80000000u;

struct SelectCounts {
  std::uint64_t small = 0;  // triangles that were handled here
  std::uint64_t zero_area = 0, culled = 0;
};

// ---- tiles ----

// A job of drawing some small triangles of one draw.
struct SmallJob {
  IndexTriples positions;
  const SnappedEntry* screen = nullptr;        // by position
  Reference first_reference = kReferenceStep;  // of triangle 0
};

// A triangle that does not fit in the 32 bits of the small ones, or that clipping has made.
struct LargeTriangle {
  TriangleSetup setup;
  std::array<Varyings, 3> vertices;
  TexturePlanes texture;     // set if the base colour or the emission is textured
  std::uint32_t draw = 0;    // index into ResolveJob::draws
  std::uint32_t number = 0;  // number in the whole scene
  bool one_color = false;    // all its pixels have the same colour
};

struct FragmentCounts {
  std::uint64_t covered = 0, written = 0;
  std::uint64_t discarded = 0;      // by their alpha
  std::uint64_t blended = 0;        // into the picture; not counted as written
  std::uint64_t hidden_blocks = 0;  // skipped before coverage, because everything there is nearer
};

// ---- colours ----

// Where light is computed.
enum class LightAt : std::uint8_t { kNowhere, kVertices, kFragments };

// The data for shading the triangles of a draw, small and large.
struct ShadeDraw {
  // The range of the small triangles' references.
  Reference first_reference = kReferenceStep, end_reference = kReferenceStep;
  IndexTriples positions = nullptr;
  const SnappedEntry* screen = nullptr;  // by position
  bool mirrored = false;
  bool shows_backs = false;  // some triangles may be seen from behind
  bool w_is_one = false;     // at every vertex, so perspective changes nothing
  const Triangle* triangles = nullptr;
  std::uint32_t first_number = 0;  // of the draw's triangles, in the whole scene

  // Tables of attributes, and the indices of each triangle's corners; null where the draw has none
  // or needs none.
  IndexTriples normal_indices = nullptr, texcoord_indices = nullptr, color_indices = nullptr;
  const Normal<Eye>* normals = nullptr;
  // For draws with flat lighting: the triangles' faces, and their normals by face; otherwise null.
  const Face* faces = nullptr;
  const Corner* corners = nullptr;
  const Normal<Eye>* face_normals = nullptr;
  const Point<Eye>* eye_positions = nullptr;
  const TexCoord* texcoords = nullptr;
  const Rgba* colors = nullptr;

  const Material* material = nullptr;
  const LazyMipChain* texture = nullptr;
  const Sampler* sampler = nullptr;
  LightAt light = LightAt::kNowhere;
  bool highlights = false;  // the material has specular highlights, and light reaches it
  bool emits = false;       // the material's own light is added:
  std::array<float, 3> emission{};
  const LazyMipChain* emission_texture = nullptr;
  const Sampler* emission_sampler = nullptr;
};

// For a draw whose alpha decides which fragments are kept.
struct AlphaTest {
  const ShadeDraw* draw = nullptr;
  std::span<const SampleOffset> points;  // as in ResolveJob
};

// For drawing what is behind given depths (EyePicture::behind_depth).
struct BehindTest {
  const Image<std::uint32_t>* codes = nullptr;  // by pixel of the picture
  AlphaTest alpha;                              // without a draw: no alpha test
};

// The memory of the samples. A pixel's samples are next to each other.
struct SampleRows {
  PixelRect window;  // the pixels that have samples here, row by row
  Rgba8* colors = nullptr;
  std::uint32_t* depths = nullptr;  // depth_code()
  int count = 0;

  std::size_t at(int x, int y) const {
    return (std::size_t(y - window.y0) * std::size_t(window.x1 - window.x0) +
            std::size_t(x - window.x0)) *
           std::size_t(count);
  }
};

// A job of computing a tile's colours from what is seen at its pixels.
struct ResolveJob {
  std::span<const ShadeDraw> draws;
  // Draws with small triangles, in the order of their references.
  std::span<const std::uint32_t> by_reference;
  const LargeTriangle* const* large = nullptr;  // indexed by reference without the top bit
  const Lighting* lighting = nullptr;
  Transfer transfer = Transfer::kSrgb;
  ColorMask mask;
  ColorMask channels;  // the channels that are encoded: at least those of the mask
  Rgba8 background;
  // The picture already has its background, and perhaps an earlier part of the run: pixels that
  // show nothing stay as they are.
  bool keep_picture = false;
  // The other eye draws over the tile's colours next, so they should stay in the cache.
  bool drawn_over = false;
  // Then the colours may be kept here, row by row of the tile's side, until the second eye's
  // colours are written to the picture. Null: they are in the picture.
  std::uint32_t* tile_colors = nullptr;

  // With several samples per pixel: their places in the pixel, in the order of the tile buffers.
  // Empty: only pixel centres.
  std::span<const SampleOffset> points;
  // Where the samples are stored; null: their mean goes to the picture.
  SampleRows* samples = nullptr;

  // Planes that are not wanted are null. With samples there is only the picture.
  Image<Rgba8>* picture = nullptr;
  Image<std::uint32_t>* depth = nullptr;  // depth_code()
  Image<float>* distance = nullptr;       // along the gaze
  Image<std::uint32_t>* id = nullptr;
  bool perspective = true;
  double near = 0, far = 0;  // of a parallel view
  bool reversed = false;
};

// For a draw that is blended over what is there.
struct BlendJob {
  const ShadeDraw* draw = nullptr;
  const ResolveJob* resolve = nullptr;   // light, channels, and the planes of pixel centres
  std::span<const SampleOffset> points;  // as in ResolveJob

  // Where the colours are: the picture, or the samples of its pixels. Null: colours are not wanted.
  Rgba8* colors = nullptr;
  SampleRows rows;  // the place of a pixel's samples

  std::size_t at(int x, int y) const { return rows.at(x, y); }
};

}  // namespace glassbox
