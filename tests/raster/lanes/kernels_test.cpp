// The kernels, which work on a few vertices or triangles at once, compared with the scalar stages
// for every instruction set.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/projection.h>
#include <glassbox/raster/coverage.h>
#include <glassbox/raster/interpolate.h>
#include <glassbox/raster/lanes/kernels.h>
#include <glassbox/raster/snap.h>

#include "tests/raster/exact.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

using test::operator<<;
using test::SnappedTriangle;

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::bit_cast<std::array<std::uint32_t, sizeof(T) / 4>>(a) ==
         std::bit_cast<std::array<std::uint32_t, sizeof(T) / 4>>(b);
}

// ---- vertices ----

TEST_CASE("vertices over lanes are where the scalar stages put them, and inside when they say so") {
  Random random(21);
  std::size_t surely_inside = 0;
  for (int round = 0; round < 200; ++round) {
    const bool perspective = round % 4 != 0;
    const bool infinite = round % 3 == 0 && perspective;
    const bool reversed = round % 5 == 0;
    const double near = std::exp2(random.between(-6, 2));
    View view;
    view.viewport = {0, 0, float(random.integer(1, 4096)), float(random.integer(1, 4096))};
    view.depth_range = reversed ? DepthRange::kReversed : DepthRange::kStandard;
    view.perspective = perspective;
    view.near = near;
    view.far = infinite ? std::numeric_limits<double>::infinity()
                        : near + std::exp2(random.between(0, 12));
    Camera camera{"", {}, {}};
    if (perspective) {
      camera.lens = PerspectiveLens{random.between(0.05, 3), near,
                                    infinite ? std::nullopt : std::optional(view.far)};
    } else {
      camera.lens = OrthographicLens{std::exp2(random.between(-3, 8)), near, view.far};
    }
    const auto made = make_view(camera, int(view.viewport.width()), int(view.viewport.height()),
                                view.depth_range);
    REQUIRE(made);
    view = *made;
    const auto planes = render_planes(view);

    VertexJob job;
    job.anchor = {float(random.integer(-4, 4)), 0.0f, float(random.integer(0, 1000))};
    job.clip_from_anchored =
        Transform<Clip, Object, float>(round_to_float(view.clip_from_eye).columns);
    job.viewport = view.viewport;
    job.far_factor = float(std::max(planes[2].d, planes[0].d));
    job.smallest_w = float(-planes[1].e);
    job.band_x = float(kGuardBandPx / double(view.viewport.width()));
    job.band_y = float(kGuardBandPx / double(view.viewport.height()));

    // The number of positions is not always a multiple of the lane count.
    std::vector<Point<Object>> positions;
    for (std::int64_t i = random.integer(1, 70); i > 0; --i) {
      const double size = random.between(-2, 2);
      const double distance = random.integer(0, 3) == 0
                                  ? near * (1 + 1e-7 * double(random.integer(-3, 3)))
                                  : size * std::exp2(random.between(-8, 12));
      const double wide = distance * std::exp2(random.between(-3, 14));
      positions.push_back({float(random.between(-1, 1) * wide + job.anchor.x),
                           float(random.between(-1, 1) * wide), float(-distance + job.anchor.z)});
      if (random.integer(0, 30) == 0) positions.back().x = 3e38f;
    }
    std::vector<SnappedEntry> screen(positions.size());
    job.positions = positions;
    job.screen = screen.data();
    for (const Target target : available_targets()) {
      INFO("target " << name_of(target) << ", round " << round);
      kernels(target).transform_vertices(job);
      std::size_t wrong = 0, unsure = 0;
      for (std::size_t i = 0; i < positions.size(); ++i) {
        const Point<Object> p{positions[i].x - job.anchor.x, positions[i].y - job.anchor.y,
                              positions[i].z - job.anchor.z};
        const Point<Clip> clip = job.clip_from_anchored * p;
        const bool inside = outcode(clip, planes) == 0;
        if (screen[i].x == kNeedsClipping) {
          // It may be inside the frustum, but then it must be outside half of the guard band.
          const bool in_half = std::abs(double(clip.x)) < 0.99 * job.band_x * double(clip.w) &&
                               std::abs(double(clip.y)) < 0.99 * job.band_y * double(clip.w);
          unsure += inside && in_half ? 1 : 0;
          continue;
        }
        ++surely_inside;
        if (!inside) {
          ++wrong;
          continue;
        }
        const ScreenVertex expected = to_screen(divide(clip), view.viewport);
        const SnappedVertex at = snap(expected);
        const SnappedEntry entry{at.x, at.y, expected.position.z, expected.inverse_w};
        wrong += same_bits(entry, screen[i]) ? 0u : 1u;
      }
      CHECK(wrong == 0);
      CHECK(unsure == 0);
    }
  }
  CHECK(surely_inside > 1000);
}

TEST_CASE("normals and eye positions over lanes have the bits of the scalar stages") {
  Random random(22);
  for (int round = 0; round < 50; ++round) {
    NormalJob normal_job;
    EyePositionJob position_job;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        normal_job.eye_from_object.columns[column][row] =
            float(random.between(-1, 1) * (round % 7 == 0 ? 1e-30 : 1.0));
      }
      for (int column = 0; column < 4; ++column) {
        position_job.eye_from_anchored.at(row, column) = float(random.between(-9, 9));
      }
    }
    position_job.anchor = {float(random.integer(-9, 9)), 8, 0};
    std::vector<Normal<Object>> normals;
    std::vector<Point<Object>> positions;
    for (std::int64_t i = random.integer(1, 70); i > 0; --i) {
      const auto any = [&] { return float(random.between(-1, 1)); };
      normals.push_back({any(), any(), any()});
      if (random.integer(0, 8) == 0) normals.back() = {0, 0, 0};
      if (random.integer(0, 8) == 0) normals.back() = {any() * 1e-38f, 0, any() * 1e-38f};
      positions.push_back({any() * 100, any(), any() * 1e10f});
    }
    std::vector<Normal<Eye>> eye_normals(normals.size());
    std::vector<Point<Eye>> eye_positions(positions.size());
    normal_job.normals = normals;
    normal_job.eye = eye_normals.data();
    position_job.positions = positions;
    position_job.eye = eye_positions.data();
    for (const Target target : available_targets()) {
      INFO("target " << name_of(target));
      kernels(target).transform_normals(normal_job);
      kernels(target).transform_positions(position_job);
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < normals.size(); ++i) {
        wrong += same_bits(eye_normals[i], normalized(normal_job.eye_from_object * normals[i]))
                     ? 0u
                     : 1u;
        const Vector<Object>& anchor = position_job.anchor;
        const Point<Object> p{positions[i].x - anchor.x, positions[i].y - anchor.y,
                              positions[i].z - anchor.z};
        wrong += same_bits(eye_positions[i], position_job.eye_from_anchored * p) ? 0u : 1u;
      }
      CHECK(wrong == 0);
    }
  }
}

// ---- triangles ----

struct Shape {
  SnappedTriangle at;
  std::array<float, 3> depth{};
  std::array<ScreenVertex, 3> on_screen() const {
    std::array<ScreenVertex, 3> v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = test::screen_vertex(at[k].x, at[k].y, depth[k]);
    return v;
  }
};

// A triangle near `window`, of any size; depths are often equal, and corners are often at pixel
// centres.
Shape any_shape(Random& random, const PixelRect& window, double largest_px) {
  Shape shape;
  const double size = std::min(largest_px, std::exp2(random.between(-3, 16)));
  const double x = random.between(window.x0 - 20, window.x1 + 20);
  const double y = random.between(window.y0 - 20, window.y1 + 20);
  const std::int64_t grid = random.integer(0, 2) == 0 ? 128 : 1;
  const float tie = float(random.integer(0, 4)) / 4;
  for (std::size_t k = 0; k < 3; ++k) {
    // At most `size` wide and high.
    const double px = x + random.between(-0.5, 0.5) * size,
                 py = y + random.between(-0.5, 0.5) * size;
    shape.at[k] = {std::int32_t(std::int64_t(px * 256) / grid * grid),
                   std::int32_t(std::int64_t(py * 256) / grid * grid)};
    shape.depth[k] = random.integer(0, 1) == 0 ? tie : float(random.unit());
  }
  return shape;
}

bool is_small(const Shape& shape) {
  const auto [left, right] = std::minmax({shape.at[0].x, shape.at[1].x, shape.at[2].x});
  const auto [top, bottom] = std::minmax({shape.at[0].y, shape.at[1].y, shape.at[2].y});
  return right - left <= kSmallSide * kSubpixels && bottom - top <= kSmallSide * kSubpixels;
}

std::string in_words(const Shape& shape) {
  std::ostringstream text;
  text.precision(9);
  text << shape.at << ", depths " << shape.depth[0] << " " << shape.depth[1] << " "
       << shape.depth[2];
  return text.str();
}

TEST_CASE("a tile holds the nearest depths of the triangles drawn into it, small or large") {
  Random random(23);
  const DepthFormat formats[] = {DepthFormat::kFloat32, DepthFormat::kFloat32Reversed,
                                 DepthFormat::kUnorm24, DepthFormat::kUnorm16};
  for (int round = 0; round < 1500; ++round) {
    const int side = 16 << random.integer(0, 3);
    const int x0 = int(random.integer(0, 3)) * side, y0 = int(random.integer(0, 3)) * side;
    PixelRect window{x0, y0, x0 + side, y0 + side};
    if (random.integer(0, 1) == 0) {  // at the edge of the picture
      window.x1 = x0 + int(random.integer(1, side));
      window.y1 = y0 + int(random.integer(1, side));
    }
    const DepthFormat format = formats[random.integer(0, 3)];
    std::vector<Shape> shapes;
    for (std::int64_t i = random.integer(1, 40); i > 0; --i) {
      shapes.push_back(any_shape(random, window, random.integer(0, 1) == 0 ? 60 : 60000));
      if (random.integer(0, 3) == 0) shapes.push_back(shapes.back());  // the same triangle again
    }
    std::erase_if(shapes, [](const Shape& s) { return !setup_triangle(s.on_screen()); });
    if (shapes.empty()) continue;
    std::vector<bool> as_small;
    // Bins contain small triangles whose bounding box meets the tile.
    for (const Shape& s : shapes) {
      const PixelRect box = intersect(setup_triangle(s.on_screen())->bounds, window);
      as_small.push_back(is_small(s) && !box.empty() && random.integer(0, 3) > 0);
    }

    Image<std::uint32_t> expected(window.x1, window.y1, kEmptyDepth);
    std::vector<TriangleSetup> setups;
    std::vector<SnappedEntry> screen;
    std::vector<std::uint32_t> positions;
    for (const Shape& s : shapes) {
      setups.push_back(*setup_triangle(s.on_screen()));
      for (std::size_t k = 0; k < 3; ++k) {
        positions.push_back(std::uint32_t(screen.size()));
        screen.push_back({s.at[k].x, s.at[k].y, s.depth[k], 1.0f});
      }
      for_each_covered(setups.back(), window, [&](const Coverage& pixel) {
        const std::uint32_t code = depth_code(format, interpolate(setups.back(), pixel).depth);
        std::uint32_t& stored = expected.at(pixel.x, pixel.y);
        if (in_front(code, stored)) stored = code;
      });
    }

    for (const Target target : available_targets()) {
      const Kernels& k = kernels(target);
      TileBuffer tile(side);
      tile.clear(window, format);
      FragmentCounts counts;
      SmallJob job;
      job.positions = positions.data();
      job.screen = screen.data();
      for (std::uint32_t i = 0; i < shapes.size();) {
        if (!as_small[i]) {
          k.draw_large(setups[i], kLargeReference | i, tile, counts);
          ++i;
          continue;
        }
        std::vector<std::uint32_t> batch;
        for (; i < shapes.size() && as_small[i]; ++i) batch.push_back(i);
        k.draw_small(job, batch, {&tile, 1}, counts);
      }
      Image<std::uint32_t> actual(window.x1, window.y1, kEmptyDepth);
      ResolveJob resolve;
      resolve.depth = &actual;
      k.resolve_tile(resolve, {&tile, 1});
      if (actual == expected) continue;
      std::string words;
      for (std::size_t i = 0; i < shapes.size(); ++i) {
        words += (as_small[i] ? "\nsmall, " : "\nlarge, ") + in_words(shapes[i]);
      }
      FAIL_CHECK("target " << name_of(target) << ", round " << round << ", window " << window.x0
                           << " " << window.y0 << " " << window.x1 << " " << window.y1
                           << ", format " << int(format) << words);
    }
  }
}

TEST_CASE("of small triangles at a pixel the nearest is seen, and of equally near ones the first") {
  Random random(27);
  std::uint64_t ties = 0;
  for (int round = 0; round < 400; ++round) {
    const int side = 16 << random.integer(0, 2);
    PixelRect window{side, 2 * side, 2 * side, 3 * side};
    if (random.integer(0, 2) == 0) window.y1 -= int(random.integer(1, side - 1));
    // Triangles of a few quads each, or of more quads than one mask covers (kMaskSide), or both
    // kinds.
    const double largest_px = std::exp2(random.between(0, 6));
    std::vector<SnappedEntry> screen;
    std::vector<std::uint32_t> positions, batch;
    Image<std::uint32_t> nearest(window.x1, window.y1, kEmptyDepth);
    Image<std::uint32_t> seen(window.x1, window.y1, 0);  // 1 + the index of the triangle
    std::uint64_t covered = 0, written = 0;
    Shape shape;
    for (std::int64_t i = random.integer(1, 150); i > 0; --i) {
      // Often the same triangle again.
      if (batch.empty() || random.integer(0, 3) > 0) shape = any_shape(random, window, largest_px);
      const auto setup = setup_triangle(shape.on_screen());
      if (!setup || intersect(setup->bounds, window).empty()) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        positions.push_back(std::uint32_t(screen.size()));
        screen.push_back({shape.at[k].x, shape.at[k].y, shape.depth[k], 1.0f});
      }
      batch.push_back(std::uint32_t(batch.size()));
      for_each_covered(*setup, window, [&](const Coverage& pixel) {
        const std::uint32_t code =
            depth_code(DepthFormat::kUnorm16, interpolate(*setup, pixel).depth);
        std::uint32_t& stored = nearest.at(pixel.x, pixel.y);
        ++covered;
        ties += code == stored ? 1 : 0;
        if (!in_front(code, stored)) return;
        ++written;
        stored = code;
        seen.at(pixel.x, pixel.y) = std::uint32_t(batch.size());
      });
    }
    for (const Target target : available_targets()) {
      INFO("target " << name_of(target) << ", round " << round);
      TileBuffer tile(side);
      tile.clear(window, DepthFormat::kUnorm16);
      FragmentCounts counts;
      SmallJob job;
      job.positions = positions.data();
      job.screen = screen.data();
      kernels(target).draw_small(job, batch, {&tile, 1}, counts);
      CHECK(counts.covered == covered);
      CHECK(counts.written == written);
      std::size_t wrong = 0;
      for (int y = window.y0; y < window.y1; ++y) {
        for (int x = window.x0; x < window.x1; ++x) {
          const std::size_t i = tile.pixel_index(x, y);
          const TileBlock& block = tile.block(i / kBlockPixels);
          const Reference reference = block.plain ? block.reference : tile.reference()[i];
          wrong += reference / kReferenceStep == seen.at(x, y) ? 0u : 1u;
        }
      }
      CHECK(wrong == 0);
    }
  }
  CHECK(ties > 1000);
}

TEST_CASE("a depth that rounding carries beyond the corners' is not taken for hidden") {
  Random random(25);
  const PixelRect window{0, 0, 16, 16};
  std::size_t carried = 0;
  for (int round = 0; round < 4000; ++round) {
    const DepthFormat format =
        round % 2 == 0 ? DepthFormat::kFloat32 : DepthFormat::kFloat32Reversed;
    // The farther edge, on the left, passes through the centres of the tile's first pixels, where
    // the third corner has weight 0; a flat triangle has the same depth there. Half of the rounds
    // use subnormal depths.
    const float scale = round % 4 < 2 ? 1.0f : 0x1p-146f;
    const float near = float(random.unit()) * scale;
    const float far = near + float(random.unit()) * (scale - near);
    const auto away = [&] { return std::int32_t(random.integer(50, 5000)) * kSubpixels; };
    // Often the ends of the edge are as far above a pixel as below it, so that both corners have
    // the same weight there.
    const std::int32_t middle = 8 * kSubpixels + kPixelCentre, above = away();
    const std::int32_t below = round % 8 < 4 ? above : away();
    const Shape first{{{{away(), std::int32_t(random.integer(0, 16)) * kSubpixels},
                        {kPixelCentre, middle - above},
                        {kPixelCentre, middle + below}}},
                      {near, far, far}};
    const Shape flat{{{{-16 * kSubpixels, -16 * kSubpixels},
                       {64 * kSubpixels, -16 * kSubpixels},
                       {-16 * kSubpixels, 64 * kSubpixels}}},
                     {far, far, far}};
    std::vector<TriangleSetup> setups;
    Image<std::uint32_t> expected(16, 16, kEmptyDepth);
    const bool nearer_is_larger = format == DepthFormat::kFloat32Reversed;
    for (const Shape* s : {nearer_is_larger ? &flat : &first, nearer_is_larger ? &first : &flat}) {
      const auto setup = setup_triangle(s->on_screen());
      if (!setup) continue;
      setups.push_back(*setup);
      for_each_covered(*setup, window, [&](const Coverage& pixel) {
        const float depth = interpolate(*setup, pixel).depth;
        carried += depth > far ? 1 : 0;
        const std::uint32_t code = depth_code(format, depth);
        std::uint32_t& stored = expected.at(pixel.x, pixel.y);
        if (in_front(code, stored)) stored = code;
      });
    }
    for (const Target target : available_targets()) {
      TileBuffer tile(16);
      tile.clear(window, format);
      FragmentCounts counts;
      for (std::uint32_t i = 0; i < setups.size(); ++i) {
        kernels(target).draw_large(setups[i], kLargeReference | i, tile, counts);
      }
      Image<std::uint32_t> actual(16, 16, kEmptyDepth);
      ResolveJob resolve;
      resolve.depth = &actual;
      kernels(target).resolve_tile(resolve, {&tile, 1});
      if (actual == expected) continue;
      FAIL_CHECK("target " << name_of(target) << ", format " << int(format) << "\n"
                           << in_words(first) << "\n"
                           << in_words(flat));
    }
  }
  CHECK(carried > 100);
}

TEST_CASE("selecting keeps every triangle that covers a pixel, for the tiles where it does") {
  Random random(24);
  for (int round = 0; round < 300; ++round) {
    SelectJob job;
    job.window = {0, 0, int(random.integer(1, 300)), int(random.integer(1, 300))};
    job.tile_shift = int(random.integer(4, 8));
    job.mirrored = random.integer(0, 1) == 0;
    job.keep_front = random.integer(0, 2) > 0;
    job.keep_back = random.integer(0, 2) > 0;
    std::vector<Shape> shapes;
    std::vector<SnappedEntry> screen;
    std::vector<std::uint32_t> positions;
    for (std::int64_t i = random.integer(1, 60); i > 0; --i) {
      Shape shape = any_shape(random, job.window, 60000);
      // As wide as a small triangle may be, or 1/256 of a pixel wider.
      if (random.integer(0, 5) == 0) {
        shape.at[1].x = shape.at[0].x + kSmallSide * kSubpixels + int(random.integer(0, 1));
      }
      for (std::size_t k = 0; k < 3; ++k) {
        positions.push_back(std::uint32_t(screen.size()));
        screen.push_back({shape.at[k].x, shape.at[k].y, shape.depth[k], 1.0f});
      }
      if (random.integer(0, 9) == 0) {
        screen[screen.size() - 1 - std::size_t(random.integer(0, 2))].x = kNeedsClipping;
      }
      shapes.push_back(shape);
    }
    job.positions = positions.data();
    job.screen = screen.data();
    job.first = std::uint32_t(random.integer(0, std::int64_t(shapes.size()) - 1));
    job.count = std::uint32_t(shapes.size()) - job.first;

    for (const Target target : available_targets()) {
      INFO("target " << name_of(target) << ", round " << round);
      std::vector<std::uint32_t> entries(job.count + kMaxLanes);
      std::vector<TilePlace> first(entries.size()), last(entries.size());
      SelectCounts counts;
      const std::size_t selected = kernels(target).select_triangles(
          job, {entries.data(), first.data(), last.data()}, counts);
      std::size_t next = 0, wrong = 0;
      std::uint64_t small = 0, flat = 0, culled = 0;
      for (std::uint32_t i = job.first; i < shapes.size(); ++i) {
        const std::size_t at = next;
        const bool is_selected = at < selected && (entries[at] & ~kLarge) == i;
        const bool is_large = is_selected && (entries[at] & kLarge) != 0;
        if (is_selected) ++next;
        const bool clips = std::any_of(&screen[3 * i], &screen[3 * i] + 3,
                                       [](const SnappedEntry& e) { return e.x == kNeedsClipping; });
        if (clips || !is_small(shapes[i])) {
          wrong += is_large ? 0 : 1;
          continue;
        }
        ++small;
        const auto setup = setup_triangle(shapes[i].on_screen());
        if (!setup) {
          ++flat;
          wrong += is_selected ? 1 : 0;
          continue;
        }
        const bool front = setup->clockwise == job.mirrored;
        if (!(front ? job.keep_front : job.keep_back)) {
          ++culled;
          wrong += is_selected ? 1 : 0;
          continue;
        }
        for_each_covered(*setup, job.window, [&](const Coverage& pixel) {
          const auto x = TilePlace(pixel.x >> job.tile_shift);
          const auto y = TilePlace(pixel.y >> job.tile_shift);
          const bool there = is_selected && !is_large && x >= (first[at] & 0xffff) &&
                             x <= (last[at] & 0xffff) && y >= first[at] >> 16 &&
                             y <= last[at] >> 16;
          wrong += there ? 0 : 1;
        });
      }
      CHECK(wrong == 0);
      CHECK(next == selected);  // in order, and none twice
      CHECK(counts.small == small);
      CHECK(counts.zero_area == flat);
      CHECK(counts.culled == culled);
    }
  }
}

}  // namespace
}  // namespace glassbox
