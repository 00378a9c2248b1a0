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
  bool test_planes = true;       // false: all positions are known to be inside
  bool divide = true;            // false: w is known to be 1
  SnappedEntry* screen = nullptr;

  // The matrix and the entries of the other eye of a stereo pair, whose clip space differs only in
  // x. Null: there is no other eye.
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

// The largest width and height of small triangles, in pixels. It ensures that all numbers of small
// triangles fit in 32 bits: with s = 64 * 256, an edge function within a quad of the box, and at a
// pixel next to it for samples, is below 2 s (s + 5 * 256) < 2^30, and so is twice the area.
inline constexpr int kSmallSide = 64;

struct SelectJob {
  IndexTriples positions;
  const SnappedEntry* screen = nullptr;  // by position
  std::uint32_t first = 0, count = 0;    // the triangles to select from
  bool mirrored = false;                 // as in Draw::mirrored
  bool keep_front = true, keep_back = false;
  bool all_large = false;  // treat every triangle as large (kLarge)
  PixelRect window;
  // By how many pixels the box of covered pixel centres is enlarged on each side: 1 if samples are
  // drawn (sampled_bounds()).
  int margin = 0;
  int tile_shift = 6;  // log2 of the tile's side
  // Null, or for each of the `count` triangles a number that is 0 if the triangle is left out.
  // kMaxLanes further numbers after these must be readable.
  const std::int32_t* keep = nullptr;
};
inline constexpr std::size_t kMaxLanes = 64;  // of 32 bits: the widest vectors have 2048 bits

// A tile of the screen: its column in the lower half, its row in the upper half.
using TilePlace = std::uint32_t;

// Entries for the bins (lists of triangles) of tiles. Each entry belongs into all tiles of a
// rectangle, which is given by its first and last tile. After selection an entry is the index of a
// triangle in its draw. An entry with kLarge is a triangle that is drawn by other code, for single
// triangles, and its tiles have no meaning.
struct BinColumns {
  std::uint32_t* entries = nullptr;
  TilePlace* first = nullptr;
  TilePlace* last = nullptr;

  BinColumns starting_at(std::size_t i) const { return {entries + i, first + i, last + i}; }
};
inline constexpr std::uint32_t kLarge = 0x80000000u;

struct SelectCounts {
  std::uint64_t small = 0;  // small triangles, culled ones included
  std::uint64_t zero_area = 0, culled = 0;
};

// ---- tiles ----

// The data for drawing some small triangles of one draw.
struct SmallJob {
  IndexTriples positions;
  const SnappedEntry* screen = nullptr;        // by position
  Reference first_reference = kReferenceStep;  // the reference of triangle 0
};

// A triangle that is not drawn as a small one, usually because it is larger than kSmallSide, or
// because clipping has made it.
struct LargeTriangle {
  TriangleSetup setup;
  std::array<Varyings, 3> vertices;
  TexturePlanes texture;     // set if the base colour or the emission is textured
  std::uint32_t draw = 0;    // index into ResolveJob::draws
  std::uint32_t number = 0;  // its number in the whole scene
  bool one_color = false;    // all its pixels have the same colour
};

struct FragmentCounts {
  std::uint64_t covered = 0, written = 0;
  std::uint64_t discarded = 0;      // by their alpha
  std::uint64_t blended = 0;        // into the picture; not counted as written
  std::uint64_t hidden_blocks = 0;  // skipped as a whole, because every pixel there is nearer
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
  bool w_is_one = false;     // w is 1 at every vertex, so perspective changes nothing
  const Triangle* triangles = nullptr;
  std::uint32_t first_number = 0;  // of the draw's first triangle, in the whole scene

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
  bool emits = false;       // `emission` is added
  std::array<float, 3> emission{};
  const LazyMipChain* emission_texture = nullptr;
  const Sampler* emission_sampler = nullptr;
};

// For a draw whose alpha decides which fragments are kept.
struct AlphaTest {
  const ShadeDraw* draw = nullptr;
  std::span<const SampleOffset> points;  // as in ResolveJob
};

// For drawing only what is behind given depths (EyePicture::behind_depth).
struct BehindTest {
  const Image<std::uint32_t>* codes = nullptr;  // by pixel of the picture
  AlphaTest alpha;                              // alpha is not tested if alpha.draw is null
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

// The data for computing a tile's colours from what is seen at its pixels.
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
  // The picture already has its background, and perhaps what was drawn before: pixels that show
  // nothing now stay as they are.
  bool keep_picture = false;
  // The other eye draws over the tile's colours next, so they should stay in the cache.
  bool drawn_over = false;
  // If drawn_over, the tile's colours may be stored here, in rows of the tile's side, until the
  // second eye's colours are written to the picture. Null: the colours are stored in the picture.
  std::uint32_t* tile_colors = nullptr;

  // With several samples per pixel: the offsets of the samples from the pixel's centre, in the
  // order of the tile buffers. Empty: only pixel centres are used.
  std::span<const SampleOffset> points;
  // Where the samples are stored; null: their mean goes to the picture.
  SampleRows* samples = nullptr;

  // Images that are not wanted are null. With samples there is only the picture.
  Image<Rgba8>* picture = nullptr;
  Image<std::uint32_t>* depth = nullptr;  // depth_code()
  Image<float>* distance = nullptr;       // along the gaze
  Image<std::uint32_t>* id = nullptr;
  bool perspective = true;
  double near = 0, far = 0;  // planes, used for parallel views only
  bool reversed = false;
};

// For a draw that is blended over what is there.
struct BlendJob {
  const ShadeDraw* draw = nullptr;
  const ResolveJob* resolve = nullptr;   // light, channels, distance and id
  std::span<const SampleOffset> points;  // as in ResolveJob

  // Where the colours are: the picture, or the samples of its pixels. Null: colours are not wanted.
  Rgba8* colors = nullptr;
  SampleRows rows;  // the memory layout of `colors`

  std::size_t at(int x, int y) const { return rows.at(x, y); }
};

}  // namespace glassbox
