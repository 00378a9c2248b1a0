// The stereo window in pixels: objects at the window, in front of it, and cut by its edges (S0-08,
// S0-09, C-70).
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/images.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/stereo/align_and_crop.h>
#include <glassbox/raster/snap.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/staged/vertex_stage.h>
#include <glassbox/render/stereo/render_pair.h>

#include "tests/render/scenes.h"
#include "tests/render/stereo/pairs.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

template <class Pixel>
Image<Pixel> columns(const Image<Pixel>& image, int first, int width) {
  Image<Pixel> part(width, image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < width; ++x) part.at(x, y) = image.at(first + x, y);
  }
  return part;
}

// The snapped picture positions of all vertices in front of the near plane.
std::vector<SnappedVertex> snapped_vertices(const Scene& scene, const View& view) {
  std::vector<SnappedVertex> all;
  const PreparedScene prepared = prepare_scene(scene, Transfer::kSrgb);
  for (const Draw& draw : make_draw_list(scene, prepared, view).draws) {
    for (const Point<Clip>& p : project_vertices(draw, view).positions) {
      if (p.w < float(view.near)) continue;
      const ScreenVertex screen = to_screen(divide({p}), view.viewport);
      if (std::abs(screen.position.x) < 30000 && std::abs(screen.position.y) < 30000) {
        all.push_back(snap(screen));
      }
    }
  }
  return all;
}

// ---- align and crop ----

struct CutEye {
  Framebuffer skewed, cut;
};

CutEye cut_eye(const Scene& scene, const View& centre, const StereoPair& pair, Side side) {
  const Result<AlignAndCrop> pictures = align_and_crop(centre, pair);
  REQUIRE(pictures);
  const bool left = side == Side::kLeft;
  const View& wide = left ? pictures->left : pictures->right;
  const int first = left ? pictures->left_first : pictures->right_first;
  const int width = int(centre.viewport.width());
  CutEye eye{render_staged(scene, eye_view(centre, pair, side), test::with_ids()).buffers, {}};
  const Framebuffer whole = render_staged(scene, wide, test::with_ids()).buffers;
  eye.cut.color = columns(whole.color, first, width);
  eye.cut.depth = columns(whole.depth, first, width);
  eye.cut.id = columns(whole.id, first, width);
  return eye;
}

// Whether all pixels around this one show the same triangle.
bool is_inside(const Image<std::uint32_t>& ids, int x, int y) {
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, ids.height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, ids.width - 1); ++u) {
      if (ids.at(u, v) != ids.at(x, y)) return false;
    }
  }
  return true;
}

struct CutCount {
  int ids = 0, colors = 0, inside = 0;
};

CutCount count_differences(const CutEye& eye) {
  CutCount count;
  const auto& [a, b] = std::tie(eye.skewed, eye.cut);
  for (int y = 0; y < a.id.height; ++y) {
    for (int x = 0; x < a.id.width; ++x) {
      count.colors += !(a.color.at(x, y) == b.color.at(x, y));
      if (a.id.at(x, y) == b.id.at(x, y)) continue;
      ++count.ids;
      count.inside += is_inside(a.id, x, y) && is_inside(b.id, x, y);
    }
  }
  return count;
}

// The half separation that shifts points at infinity by this many pixels.
double separation_for(const View& centre, double window, double shift_px) {
  return shift_px * window / (centre.clip_from_eye.at(0, 0) * double(centre.viewport.width()));
}

// Triangles whose corners have few bits and are at distances that are powers of two.
Scene dyadic_triangles(Random& random) {
  Mesh mesh;
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 3; ++k) {
      const float z = float(1 << random.integer(0, 4));
      const auto coordinate = [&] { return float(int(random.integer(0, 256)) - 128) / 64 * z; };
      const float x = coordinate(), y = coordinate();
      mesh.positions.push_back({x, y, -z});
    }
    const std::uint32_t first = std::uint32_t(mesh.positions.size()) - 3;
    test::add_face(mesh, {first, first + 1, first + 2});
  }
  Material material;
  material.unlit = true;
  material.double_sided = true;
  return test::scene_of(std::move(mesh), material);
}

}  // namespace

TEST_CASE("where no vertex is rounded, cutting and skewing give the same bytes (S0-08)") {
  // An angle of view of 90 degrees, 64 columns widened to 128, and s/f = 1: entries, scales and
  // vertices are binary fractions of few bits, so both ways put every vertex on the same subpixel.
  // Each picture moves by 32 columns.
  Camera camera;
  camera.lens = PerspectiveLens{kHalfPi, 0.5, 64};
  const auto centre = make_view(camera, 64, 64);
  REQUIRE(centre);
  REQUIRE(centre->clip_from_eye.at(0, 0) == 1);
  const StereoPair pair{4, 4};
  REQUIRE(check_pair(*centre, pair));
  Random random(140);
  int drawn = 0;
  for (int i = 0; i < 50; ++i) {
    const Scene scene = dyadic_triangles(random);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const CutEye eye = cut_eye(scene, *centre, pair, side);
      CAPTURE(i, int(side));
      CHECK(eye.cut.id == eye.skewed.id);
      CHECK(eye.cut.depth == eye.skewed.depth);
      CHECK(eye.cut.color == eye.skewed.color);
      drawn += int(std::ranges::count_if(eye.skewed.id.pixels, [](auto id) { return id != 0; }));
    }
  }
  CHECK(drawn > 10000);
}

TEST_CASE("in float, cutting and skewing differ at the edges of triangles alone (S0-08)") {
  for (const double shift : {16.0, 5.0, 4.5}) {
    CutCount sum;
    int pixels = 0;
    for (PairCase& c : pair_cases()) {
      if (!c.centre.perspective) continue;
      c.pair.half_separation = separation_for(c.centre, c.pair.window, shift);
      REQUIRE(check_pair(c.centre, c.pair));
      for (const Side side : {Side::kLeft, Side::kRight}) {
        const CutCount count = count_differences(cut_eye(c.scene, c.centre, c.pair, side));
        INFO(c.name << ", shift " << shift);
        CHECK(count.inside == 0);
        sum.ids += count.ids;
        sum.colors += count.colors;
        pixels += c.width * c.height;
      }
    }
    WARN("S0-08, shift " << shift << " px: other triangles in " << sum.ids << ", other colours in "
                         << sum.colors << " of " << pixels << " pixels");
  }
}

// ---- at the window ----

TEST_CASE("a textured quad at the window is the same picture in both eyes (S0-09, C-70)") {
  Camera camera;
  camera.lens = PerspectiveLens{0.8, 0.1, 100};
  const auto centre = make_view(camera, 120, 80);
  REQUIRE(centre);
  const StereoPair pair{0.03, 10};
  const View left = eye_view(*centre, pair, Side::kLeft);
  const View right = eye_view(*centre, pair, Side::kRight);
  Random random(141);
  int flipped = 0;
  for (int i = 0; i < 200; ++i) {
    Mesh mesh;
    for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      mesh.positions.push_back(
          {float(u * random.between(0.5, 6)), float(v * random.between(0.5, 4)), -10});
      mesh.texcoords.push_back({float(u + 1) / 2, float(1 - v) / 2});
      const std::uint32_t at = std::uint32_t(mesh.positions.size()) - 1;
      mesh.corners.push_back({at, kNone, at});
    }
    mesh.faces.push_back({0, 4});
    Scene scene = test::scene_of(std::move(mesh));
    scene.images = {make_noise(64, {90, 140, 60, 255}, 60, 7)};
    scene.textures = {Texture{0, {}}};
    scene.materials[0].texture = 0;
    scene.materials[0].unlit = true;

    const auto a = snapped_vertices(scene, left), b = snapped_vertices(scene, right);
    REQUIRE(a.size() == 4);
    bool same = true;
    for (std::size_t k = 0; k < 4; ++k) {
      same = same && a[k].x == b[k].x;
      CHECK(std::abs(a[k].x - b[k].x) <= 1);  // subpixels
      CHECK(a[k].y == b[k].y);
      // In double, s (1 - z/f) is zero within a few u of s, so snapping cannot differ.
      const Point<World, double> p{double(scene.meshes[0].positions[k].x),
                                   double(scene.meshes[0].positions[k].y), -10};
      const auto x_of = [&](const View& view) {
        const auto clip = view.clip_from_eye * (view.eye_from_world * p);
        return std::floor((clip.x / clip.w + 1) * 60 * 256 + 0.5);
      };
      CHECK(x_of(left) == x_of(right));
    }
    flipped += !same;
    if (!same) continue;
    const StereoRendering both = render_pair(scene, *centre, pair, {test::with_ids()});
    CAPTURE(i);
    CHECK(both.left.color == both.right.color);
    CHECK(both.left.id == both.right.id);
    CHECK(both.left.depth == both.right.depth);
  }
  WARN("C-70: of 200 quads at the window, " << flipped << " have a vertex one subpixel off");
  CHECK(flipped < 20);
}

TEST_CASE("off the window the quad's pictures differ") {
  const PairCase c = pair_case("checker", 0.03);
  StereoPair nearer = c.pair;
  nearer.window = c.pair.window / 2;
  REQUIRE(check_pair(c.centre, nearer));
  const StereoRendering both = render_pair(c.scene, c.centre, nearer, {});
  CHECK(both.left.color != both.right.color);
}

TEST_CASE("a naive pair has parallax above zero nowhere; with a window there is some (S0-08)") {
  for (const PairCase& c : pair_cases()) {
    if (!c.centre.perspective) continue;
    INFO(c.name);
    const auto parallaxes = [&](const StereoPair& pair) {
      const auto left = snapped_vertices(c.scene, eye_view(c.centre, pair, Side::kLeft));
      const auto right = snapped_vertices(c.scene, eye_view(c.centre, pair, Side::kRight));
      REQUIRE(left.size() == right.size());
      REQUIRE_FALSE(left.empty());
      std::vector<int> all;
      for (std::size_t i = 0; i < left.size(); ++i) all.push_back(right[i].x - left[i].x);
      return all;
    };
    const StereoPair naive{c.pair.half_separation, std::numeric_limits<double>::infinity()};
    REQUIRE(check_pair(c.centre, naive));
    const std::vector<int> in_front = parallaxes(naive);
    CHECK(*std::ranges::max_element(in_front) <= 0);
    CHECK(*std::ranges::min_element(in_front) < 0);
    const std::vector<int> around = parallaxes(c.pair);
    CHECK(*std::ranges::max_element(around) > *std::ranges::max_element(in_front));
  }
}

}  // namespace glassbox
