// Makes one record of each stage for gdb to print; records.md lists what gdb prints of them.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include <glassbox/base/spaces.h>
#include <glassbox/images/image.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/normal_transform.h>
#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/stages.h>

namespace {

using namespace glassbox;

void in_spaces() {}
void at_planes() {}
void in_pipeline() {}
void in_raster() {}

template <class... Records>
void keep(const Records&...) {}

void make_spaces() {
  const Point<Object> p_object{1, 2, 3};
  const Point<World, double> p_world{0.1, -1e300, 1.0 / 3};
  const Point<Eye> p_eye{0.5f, -1, -3};
  const Point<Eye>& the_same_point = p_eye;
  const Point<Clip> p_clip{0.1f, 16777217.0f, 1.0f / 3, 5};
  const Point<Ndc> p_odd{-0.0f, std::numeric_limits<float>::infinity(), std::nanf("")};
  const Point<Screen> p_tiny{1e-45f, 3.4028235e38f, 1.1754944e-38f};
  const Vector<World> vector{0, 1, -2};
  const Normal<Eye> normal{0, 0.6f, 0.8f};

  Transform<Clip, Eye> clip_from_eye;
  clip_from_eye.at(0, 0) = 1.5;
  clip_from_eye.at(1, 1) = 24.25;
  clip_from_eye.at(2, 2) = -1.0 / 3;
  clip_from_eye.at(2, 3) = -0.1;
  clip_from_eye.at(3, 2) = -1;
  clip_from_eye.at(3, 3) = 0;
  const Transform<Clip, Eye, float> in_float = round_to_float(clip_from_eye);
  NormalTransform<Eye, Object> eye_normal_from_object;
  eye_normal_from_object.columns[2][0] = -0.5f;
  const std::array<Point<Clip>, 2> points{p_clip, Point<Clip>{}};
  in_spaces();
  keep(p_object, p_world, the_same_point, p_odd, p_tiny, vector, normal, in_float,
       eye_normal_from_object, points);
}

void look_at_planes(std::span<const ClipPlane> planes) {
  const Outcode none = 0;
  const Outcode two = 0b110;
  const Outcode unnamed = 1u << 7;
  const Outcode not_finite = ~Outcode{0};
  at_planes();
  keep(planes, none, two, unnamed, not_finite);
}

void make_planes() {
  const std::array<ClipPlane, 3> some_planes{
      {{0, 0, 1, 0, 0, "near"}, {-1, 0.5, 0, 1, 0, "slanted"}, {0, 0, 0, 1, -0.25, "eye"}}};
  look_at_planes(some_planes);
}

void make_pipeline() {
  ClipPolygon polygon;
  polygon.vertices[0] = {{0, 0, 0, 1}, {1, 0, 0}};
  polygon.vertices[1] = {{1, 0, 0, 1}, {0, 1, 0}};
  polygon.vertices[2] = {{1, 1, 0, 2}, {0, 0.1, 0.9}};
  polygon.count = 3;
  const ClipPolygon nothing;
  const ClipVertex vertex = polygon.vertices[2];
  const Outcode far_from_planes = 0b101;
  const NdcVertex ndc{{0.5f, 0.5f, 0}, 0.5f};
  const ScreenVertex screen{{48.5f, 16, 0}, 0.5f};
  in_pipeline();
  keep(polygon, nothing, vertex, far_from_planes, ndc, screen);
}

void make_raster() {
  const SnappedVertex snapped{12 * 256 + 37, 8 * 256};
  const SnappedVertex left_of_zero{-1, -256};
  const PixelRect rectangle{3, 4, 17, 20};
  const EdgeFunction top{0, 1, -128, true};
  const EdgeFunction right{-3840, -1280, 1966080, false};
  const EdgeFunction zero{0, 0, 0, false};
  TriangleSetup setup;
  setup.edges = {top, right, zero};
  setup.double_area = 3 * 65536;
  setup.clockwise = true;
  setup.order = {2, 0, 1};
  setup.depth = {0.1f, 0.5f, 1};
  setup.inverse_w = {1, 0.5f, 0.25f};
  setup.inverse_area = 1.0f / 3;
  setup.bounds = rectangle;
  const Coverage coverage{12, 8, {1, 20, 300}};
  const Fragment fragment{12, 8, {0.25f, 0.25f, 0.5f}, {0.1f, 0.3f, 0.6f}, 0.7f, 0.2f};
  Varyings varyings;
  varyings.normal = {0, 0, 1};
  varyings.color = {0.1f, 0.2f, 0.3f, 1};
  varyings.texcoord = {0.5f, 0.75f};
  const Rgba linear{0.05f, 0.12f, 0.8f, 1};
  const Rgba8 stored{39, 62, 154, 255};
  const Image<Rgba8> image(640, 480);
  const Image<float> empty;
  in_raster();
  keep(snapped, left_of_zero, setup, coverage, fragment, varyings, linear, stored, image, empty);
}

}  // namespace

int main() {
  make_spaces();
  make_planes();
  make_pipeline();
  make_raster();
}
