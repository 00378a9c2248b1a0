// What the lanes read and write: plain tables, one entry for each vertex, triangle or pixel.
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

// A position of the mesh on the screen, snapped. One that clipping has to look at has x = kNeedsClipping.
inline constexpr std::int32_t kNeedsClipping = std::numeric_limits<std::int32_t>::min();
struct SnappedEntry {
  std::int32_t x = 0, y = 0;  // 1/256 pixel
  float z = 0;                // depth of NDC
  float inverse_w = 0;
};

// Object space to the screen, for some of a mesh's positions.
struct VertexJob {
  std::span<const Point<Object>> positions;
  Vector<Object> anchor;
  Transform<Clip, Object, float> clip_from_anchored;
  Viewport viewport;
  // A vertex with 0 <= z <= far_factor w, smallest_w <= w < infinity and |x|, |y| at most half of the guard band is inside of all
  // planes that rendering clips by.
  float far_factor = 1;
  float smallest_w = 0;
  float band_x = 1, band_y = 1;  // |x| <= band_x w
  bool test_planes = true;       // otherwise all of them are known to be inside
  bool divide = true;            // otherwise w is known to be 1
  SnappedEntry* screen = nullptr;

  // The other eye of a pair, whose clip space differs in x alone: its matrix, and its entries. Null: there is none.
  const Transform<Clip, Object, float>* other_clip_from_anchored = nullptr;
  SnappedEntry* other_screen = nullptr;
};

// Unit normals in eye space, and positions there.
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

// Small triangles are at most this many pixels wide and high, so that everything about them fits 32 bits: with s = 64 * 256, an edge
// function within a quad of the box, and a pixel beside it for samples, is below 2 s (s + 5 * 256) < 2^30, and so is twice the area.
inline constexpr int kSmallSide = 64;

struct SelectJob {
  IndexTriples positions;
  const SnappedEntry* screen = nullptr;  // by position
  std::uint32_t first = 0, count = 0;    // triangles
  bool mirrored = false;                 // Draw::mirrored
  bool keep_front = true, keep_back = false;
  bool all_large = false;  // leave every triangle to the staged primitives
  PixelRect window;
  int margin =
      0;  // pixels around those that have their centres in the box: 1 where samples are drawn (sampled_bounds())
  int tile_shift = 6;  // log2 of the tile's side
  // Null, or for each of the `count` triangles whether it goes on: 0 where it does not. kMostLanes more can be read.
  const std::int32_t* keep = nullptr;
};
inline constexpr std::size_t kMostLanes = 64;  // of 32 bits: the widest vectors have 2048 bits

// A tile of the screen: its column, and its row in the upper half.
using TilePlace = std::uint32_t;

// What goes into the bins of rectangles of tiles, of which the first and the last are named. From selection an entry is the index of
// a triangle in its draw; one with kLarge is for the staged primitives to look at, and its tiles say nothing.
struct BinColumns {
  std::uint32_t* entries = nullptr;
  TilePlace* first = nullptr;
  TilePlace* last = nullptr;

  BinColumns from(std::size_t i) const { return {entries + i, first + i, last + i}; }
};
inline constexpr std::uint32_t kLarge = 0x80000000u;

struct SelectCounts {
  std::uint64_t small = 0;  // triangles that were decided on here
  std::uint64_t zero_area = 0, culled = 0;
};

// ---- tiles ----

// Some small triangles of one draw.
struct SmallJob {
  IndexTriples positions;
  const SnappedEntry* screen = nullptr;        // by position
  Reference first_reference = kReferenceStep;  // of triangle 0
};

// A triangle that does not fit the 32 bits of the small ones, or that clipping has made.
struct LargeTriangle {
  TriangleSetup setup;
  std::array<Varyings, 3> vertices;
  TexturePlanes texture;     // of textured ones, be it in their emission
  std::uint32_t draw = 0;    // index into ResolveJob::draws
  std::uint32_t number = 0;  // in the whole scene
  bool one_color = false;    // all its pixels have the same
};

struct FragmentCounts {
  std::uint64_t covered = 0, written = 0;
  std::uint64_t discarded = 0;      // by their alpha
  std::uint64_t blended = 0;        // into the picture; not among the written ones
  std::uint64_t hidden_blocks = 0;  // given up before coverage: everything there is nearer
};

// ---- colours ----

// Where light is computed.
enum class LightAt : std::uint8_t { kNowhere, kVertices, kFragments };

// What the small triangles of a draw need to be shaded, and the large ones of the same draw.
struct ShadeDraw {
  // The references of the small triangles.
  Reference first_reference = kReferenceStep, end_reference = kReferenceStep;
  IndexTriples positions = nullptr;
  const SnappedEntry* screen = nullptr;  // by position
  bool mirrored = false;
  bool shows_backs = false;  // some triangles may be seen from behind
  bool w_is_one = false;     // at every vertex: perspective changes nothing
  const Triangle* triangles = nullptr;
  std::uint32_t first_number = 0;  // of the draw's triangles, in the whole scene

  // Tables of attributes with the indices of each triangle's corners; null where the draw has none, or needs none.
  IndexTriples normal_indices = nullptr, texcoord_indices = nullptr, color_indices = nullptr;
  const Normal<Eye>* normals = nullptr;
  // Of draws that are lit flat: their triangles' faces, with the normals by face; null otherwise.
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
  bool highlights = false;  // the material has any, and the light arrives
  bool emits = false;       // light of its own is added:
  std::array<float, 3> emission{};
  const LazyMipChain* emission_texture = nullptr;
  const Sampler* emission_sampler = nullptr;
};

// Of a draw whose alpha decides which fragments there are.
struct AlphaTest {
  const ShadeDraw* draw = nullptr;
  std::span<const SampleOffset> points;  // as ResolveJob has them
};

// What is seen behind depths that are given (EyePicture::behind).
struct BehindTest {
  const Image<std::uint32_t>* codes = nullptr;  // by pixel of the picture
  AlphaTest alpha;                              // without a draw: it keeps all
};

// Memory of a pixel's samples, which are neighbours in it.
struct SampleRows {
  PixelRect window;  // whose pixels have samples here, row by row
  Rgba8* colors = nullptr;
  std::uint32_t* depths = nullptr;  // depth_code()
  int count = 0;

  std::size_t at(int x, int y) const {
    return (std::size_t(y - window.y0) * std::size_t(window.x1 - window.x0) +
            std::size_t(x - window.x0)) *
           std::size_t(count);
  }
};

// A tile's colours, from what is seen at its pixels.
struct ResolveJob {
  std::span<const ShadeDraw> draws;
  // Draws with small triangles, in the order of their references.
  std::span<const std::uint32_t> by_reference;
  const LargeTriangle* const* large = nullptr;  // by reference without the top bit
  const Lighting* lighting = nullptr;
  Transfer transfer = Transfer::kSrgb;
  ColorMask mask;
  ColorMask channels;  // that are encoded: those of the mask at least
  Rgba8 background;
  // The picture has its background, and perhaps an earlier part of the run: pixels with nothing on them stay as they are.
  bool keep_picture = false;
  // The other eye draws over the tile's colours next: they had better stay in the cache.
  bool drawn_over = false;
  // Then they may be here, row by row of the tile's side, until the second eye's leave for the picture; null: they are in the picture.
  std::uint32_t* tile_colors = nullptr;

  // Of several samples to a pixel: where they are in it, as the buffers have them. Empty: pixel centres alone.
  std::span<const SampleOffset> points;
  // Where the samples go; null: their mean goes to the picture.
  SampleRows* samples = nullptr;

  // Planes that are not wanted are null. Samples have no others than the picture.
  Image<Rgba8>* picture = nullptr;
  Image<std::uint32_t>* depth = nullptr;  // depth_code()
  Image<float>* distance = nullptr;       // along the gaze
  Image<std::uint32_t>* id = nullptr;
  bool perspective = true;
  double near = 0, far = 0;  // of a parallel view
  bool reversed = false;
};

// Of a draw that is laid over what is there.
struct BlendJob {
  const ShadeDraw* draw = nullptr;
  const ResolveJob* resolve = nullptr;   // light, channels, and the planes of pixel centres
  std::span<const SampleOffset> points;  // as ResolveJob has them

  // Where the colours are: the picture, or one of its pixels' samples. Null: nobody sees them.
  Rgba8* colors = nullptr;
  SampleRows rows;  // where in it a pixel is

  std::size_t at(int x, int y) const { return rows.at(x, y); }
};

}  // namespace glassbox
