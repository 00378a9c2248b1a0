// Makes scenes with views and settings from a source of numbers: a Random, or the bytes of a
// fuzzer. The scenes are small and often contain what is difficult for a rasterizer: slivers,
// triangles smaller than a pixel or reaching far beyond the screen, equal depths, coordinates
// behind the eye, attributes that only some corners have.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

#include <glassbox/base/trig.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/tile/tile_engine.h>

#include "tests/render/scenes.h"

namespace glassbox::test {

// Tests divide their number of cases by this. Without optimization each lane operation is a
// function call, and instrumented calls cost more still, so that a sample of the cases is enough
// there.
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
inline constexpr int kCaseDivisor = 1;
#else
inline constexpr int kCaseDivisor = 10;
#endif

struct GeneratedCase {
  Scene scene;
  View view;
  RenderSettings settings;
  TileOptions options;
};

// Source has integer(low, high), both ends included, and unit() in [0, 1).
template <class Source>
class CaseGenerator {
public:
  CaseGenerator(Source& source, int most_faces, int largest_side)
      : source_(source), most_faces_(most_faces), largest_side_(largest_side) {}

  GeneratedCase make() {
    GeneratedCase made;
    made.settings = settings();
    const auto [width, height] = size();
    const Camera camera = any_camera();
    const bool reversed = made.settings.depth == DepthFormat::kFloat32Reversed;
    const auto view =
        make_view(camera, width, height, reversed ? DepthRange::kReversed : DepthRange::kStandard);
    made.view = view.value();
    view_ = &made.view;
    world_from_eye_ = camera.world_from_eye;
    nearest_ = std::max(1e-3, made.view.near);
    made.scene = scene();
    made.options = options();
    if (one_in(4)) made.settings.samples = one_of({2, 4, 8, 16});
    if (one_in(4)) made.settings.cull_stage = CullStage::kObject;
    return made;
  }

private:
  // ---- numbers ----

  int integer(int low, int high) { return int(source_.integer(low, high)); }
  bool one_in(int n) { return integer(1, n) == n; }
  double between(double low, double high) { return low + (high - low) * source_.unit(); }
  // Evenly distributed over the powers of two; without functions of the C++ library, so the same on
  // every machine.
  double magnitude(double low, double high) {
    int first = 0, last = 0;
    std::frexp(low, &first);
    std::frexp(high, &last);
    const int exponent = integer(first, last);
    return std::clamp(std::ldexp(between(0.5, 1), exponent), low, high);
  }
  Vector<World, double> direction() {
    const SinCos turn = sin_cos(between(0, 2 * kPi));
    const double z = between(-1, 1);
    const double r = std::sqrt(1 - z * z);
    return {r * turn.cos, r * turn.sin, z};
  }
  double sign() { return one_in(2) ? -1.0 : 1.0; }
  template <class T>
  T one_of(std::initializer_list<T> values) {
    return values.begin()[integer(0, int(values.size()) - 1)];
  }

  // ---- settings ----

  RenderSettings settings() {
    RenderSettings s;
    s.shading = one_of({Shading::kPhong, Shading::kUnlit, Shading::kFlat, Shading::kGouraud});
    if (one_in(4)) {
      s.show = one_of({Show::kDepth, Show::kNormal, Show::kUv, Show::kId, Show::kOverdraw});
    }
    if (one_in(3)) s.cull = one_of({Cull::kBack, Cull::kFront, Cull::kNone});
    s.wireframe = one_in(16);
    s.depth = one_of({DepthFormat::kFloat32, DepthFormat::kFloat32Reversed, DepthFormat::kUnorm24,
                      DepthFormat::kUnorm16});
    if (one_in(3)) s.transfer = Transfer::kNone;
    if (one_in(4)) s.mask = {one_in(2), one_in(2), one_in(2), one_in(2)};
    s.background = {std::uint8_t(integer(0, 255)), 7, 200, std::uint8_t(integer(0, 255))};
    s.want_depth = one_in(2);
    s.want_distance = one_in(2);
    s.want_id = one_in(2);
    return s;
  }

  std::array<int, 2> size() {
    const int most = largest_side_;
    switch (integer(0, 9)) {
      case 0:
        return {1, 1};
      case 1:
        return {integer(1, most), 1};
      case 2:
        return {1, integer(1, most)};
      case 3:
        return {7, 5};
      case 4:
        return {std::min(65, most), std::min(63, most)};
      case 5:
        return {std::min(64, most), std::min(64, most)};
      default:
        return {integer(1, most), integer(1, most)};
    }
  }

  TileOptions options() {
    TileOptions o;
    o.threads = integer(1, 8);
    o.tile_side = 1 << integer(4, 8);
    const std::vector<Target> targets = available_targets();
    o.target = targets[std::size_t(integer(0, int(targets.size()) - 1))];
    o.plan = !one_in(4);
    if (one_in(3)) o.round_size = std::size_t(integer(1, 64));
    return o;
  }

  Camera any_camera() {
    Camera camera{"any", PerspectiveLens{}, {}};
    std::optional<double> far;
    if (one_in(2)) far = magnitude(10, 1e5);
    const double near = magnitude(0.01, 1);
    switch (integer(0, 3)) {
      case 0:
        camera.lens =
            OrthographicLens{magnitude(0.1, 100), one_in(2) ? 0.0 : -3.0, magnitude(10, 1000)};
        break;
      case 1:
        camera.lens = FrustumLens{-near * between(0.1, 1),
                                  near * between(0.1, 1),
                                  -near * between(0.1, 1),
                                  near * between(0.1, 1),
                                  near,
                                  far};
        break;
      default:
        camera.lens = PerspectiveLens{between(0.1, 2.8), near, far};
    }
    if (one_in(2)) {
      const Vector<Eye, double> axis{between(-1, 1), between(-1, 1), between(0.1, 1)};
      const auto turned = rotate_degrees<World, Eye>(axis, between(0, 360));
      if (turned) camera.world_from_eye = *turned;
      for (int row = 0; row < 3; ++row) {
        camera.world_from_eye.at(row, 3) = between(-10, 10);
      }
    }
    return camera;
  }

  // ---- surfaces ----

  Rgba any_color() {
    const auto channel = [&] { return float(one_in(8) ? between(0, 3) : between(0, 1)); };
    return {channel(), channel(), channel(), channel()};
  }

  Material material(std::size_t textures) {
    Material m;
    m.base_color = one_in(3) ? Rgba{} : any_color();
    if (textures > 0 && !one_in(3)) m.texture = std::uint32_t(integer(0, int(textures) - 1));
    if (one_in(2)) m.specular = {float(between(0, 1)), 0.0f, float(between(0, 1))};
    m.shininess = one_in(4) ? integer(1, 1024) : 16;
    if (one_in(3)) m.alpha_mode = one_of({AlphaMode::kMask, AlphaMode::kBlend});
    m.alpha_cutoff = float(between(0, 1));
    m.double_sided = one_in(2);
    m.unlit = one_in(4);
    if (one_in(4)) m.emission = {float(between(0, 1)), 0.0f, float(between(0, 3))};
    if (textures > 0 && one_in(2)) {
      m.emission_texture = std::uint32_t(integer(0, int(textures) - 1));
    }
    return m;
  }

  Texture texture(std::size_t images) {
    const auto wrap = [&] { return Wrap(integer(0, 2)); };
    const auto filter = [&] { return Filter(integer(0, 1)); };
    Texture made;
    made.image = std::uint32_t(integer(0, int(images) - 1));
    made.sampler.wrap_u = wrap();
    made.sampler.wrap_v = wrap();
    made.sampler.magnify = filter();
    made.sampler.minify = filter();
    made.sampler.mip = MipFilter(integer(0, 2));
    return made;
  }

  Image<Rgba8> image() {
    const int width = integer(1, 9), height = integer(1, 9);
    Image<Rgba8> made(width, height);
    const int kind = integer(0, 2);
    for (std::size_t i = 0; i < made.pixels.size(); ++i) {
      const auto byte = [&](std::size_t salt) {
        return std::uint8_t((i * 2654435761u + salt * 40503u) >> (8 + kind));
      };
      made.pixels[i] = {byte(0), byte(1), byte(2), byte(3)};
    }
    return made;
  }

  Light light() {
    Light l;
    l.kind = one_of({LightKind::kDirectional, LightKind::kPoint, LightKind::kSpot});
    l.color = {float(between(0, 1)), float(between(0, 1)), 1.0f};
    l.intensity = magnitude(0.1, 100);
    if (one_in(2)) l.range = magnitude(1, 100);
    l.outer_cone_radians = between(0.1, 1.5);
    l.inner_cone_radians = one_in(3) ? 0 : l.outer_cone_radians * between(0, 1);
    l.position = {between(-10, 10), between(-10, 10), between(-10, 10)};
    l.direction = direction();
    return l;
  }

  // ---- shapes ----

  // A position on the screen in pixels, and a distance along the gaze.
  struct Seen {
    double x = 0, y = 0, distance = 1;
  };

  Point<Eye, double> in_eye_space(const Seen& seen) const {
    const Transform<Clip, Eye>& m = view_->clip_from_eye;
    const Viewport& port = view_->viewport;
    const double z = -seen.distance;
    const double w = view_->perspective ? seen.distance : 1;
    const double x = (seen.x / port.width() * 2 - 1) * w;
    const double y = (1 - seen.y / port.height() * 2) * w;
    return {(x - m.at(0, 2) * z - m.at(0, 3)) / m.at(0, 0),
            (y - m.at(1, 2) * z - m.at(1, 3)) / m.at(1, 1), z};
  }

  double any_distance() {
    switch (integer(0, 15)) {
      case 0:
        return nearest_;
      case 1:
        return nearest_ * between(0.3, 1.5);
      case 2:
        return -magnitude(1e-6, 10);
      case 3:
        return sign() * magnitude(1e-30, 1e-3);
      case 4:
      case 5:
      case 6:
        // A few values, so that several places have the same.
        return nearest_ * (2 + integer(0, 3));
      default:
        return nearest_ * magnitude(1, 1e4);
    }
  }

  double any_pixel(float side) {
    switch (integer(0, 7)) {
      case 0:
        return double(integer(-2, int(side) + 2));
      case 1:
        return integer(-2, int(side) + 2) + 0.5;
      case 2:
        return integer(-8, int(side) * 256 + 8) / 256.0;
      case 3:
        return between(-100, side + 100);
      default:
        return between(0, side);
    }
  }
  Seen any_place() {
    return {any_pixel(view_->viewport.width()), any_pixel(view_->viewport.height()),
            any_distance()};
  }

  std::uint32_t add_position(const Seen& seen, Mesh& mesh) {
    const Point<Eye, double> eye = in_eye_space(seen);
    const Point<Object, double> object = object_from_eye_ * eye;
    mesh.positions.push_back({float(object.x), float(object.y), float(object.z)});
    return std::uint32_t(mesh.positions.size() - 1);
  }

  // The positions of a face, counter-clockwise or clockwise.
  std::vector<std::uint32_t> any_face(Mesh& mesh) {
    const int kind = integer(0, 11);
    const auto old = [&] { return std::uint32_t(integer(0, int(mesh.positions.size()) - 1)); };
    const auto around = [&](double size) {
      const Seen first = any_place();
      std::vector<std::uint32_t> face{add_position(first, mesh)};
      const bool flat = one_in(2);
      for (int i = 0; i < 2; ++i) {
        const double distance = flat ? first.distance : first.distance * between(0.5, 2);
        face.push_back(add_position(
            {first.x + between(-size, size), first.y + between(-size, size), distance}, mesh));
      }
      return face;
    };
    if (mesh.positions.size() >= 3) {
      if (kind == 0) {  // the previous face again, from another corner or from the other side
        const auto last = std::uint32_t(mesh.positions.size());
        if (one_in(2)) return {last - 2, last - 1, last - 3};
        return {last - 1, last - 2, last - 3};
      }
      if (kind == 1) return {old(), old(), add_position(any_place(), mesh)};
      if (kind == 2) return {old(), old(), old()};
    }
    switch (kind) {
      case 3:  // a sliver
      {
        const Seen a = any_place();
        const Seen b{any_place().x, any_place().y, a.distance};
        const double t = between(-1, 2), off = magnitude(1e-3, 1);
        const Seen c{a.x + t * (b.x - a.x) + off, a.y + t * (b.y - a.y) - off, a.distance};
        return {add_position(a, mesh), add_position(b, mesh), add_position(c, mesh)};
      }
      case 4:
        return around(magnitude(1e3, 1e7));
      case 5:
        return around(magnitude(100, 1e3));
      case 6:
        return {add_position(any_place(), mesh), add_position(any_place(), mesh),
                add_position(any_place(), mesh)};
      case 7:  // four or five corners
      {
        const Seen middle = any_place();
        std::vector<std::uint32_t> face;
        const int count = integer(4, 5);
        const double size = magnitude(0.5, 100);
        for (int i = 0; i < count; ++i) {
          const SinCos turn = sin_cos(2 * kPi * i / count);
          face.push_back(add_position(
              {middle.x + size * turn.cos, middle.y - size * turn.sin, middle.distance}, mesh));
        }
        return face;
      }
      default:
        return around(magnitude(0.02, 60));
    }
  }

  enum class Has { kNothing, kWithPositions, kItsOwn, kSometimes };

  // An index into a table of `count` entries, or kNone, depending on which corners have the
  // attribute.
  std::uint32_t attribute(Has has, std::uint32_t position, std::size_t count) {
    if (has == Has::kNothing || count == 0) return kNone;
    if (has == Has::kWithPositions) return position;
    if (has == Has::kSometimes && one_in(2)) return kNone;
    return std::uint32_t(integer(0, int(count) - 1));
  }

  float any_texcoord() {
    switch (integer(0, 9)) {
      case 0:
        return float(sign() * magnitude(1e-12, 1e30));
      case 1:
        return float(integer(-2, 2));
      case 2:
        return float(integer(-9, 9)) / 9.0f;
      default:
        return float(between(-3, 3));
    }
  }
  Normal<Object> any_normal() {
    if (one_in(16)) return {0, 0, 0};
    const Vector<World, double> d = direction();
    return {float(d.x), float(d.y), float(d.z)};
  }

  Mesh mesh(std::size_t materials) {
    Mesh made;
    const int faces = integer(0, most_faces_);
    for (int i = 0; i < faces; ++i) add_face(made, any_face(made));
    if (one_in(6)) {
      for (int i = integer(1, 8); i > 0; --i) {
        made.lines.push_back(
            {Corner{add_position(any_place(), made)}, Corner{add_position(any_place(), made)}});
        made.points.push_back(Corner{add_position(any_place(), made)});
      }
    }
    const std::size_t positions = made.positions.size();
    const auto how = [&] {
      return one_of({Has::kNothing, Has::kWithPositions, Has::kItsOwn, Has::kSometimes});
    };
    const Has normals = how(), texcoords = how(), colors = how();
    const auto table = [&](Has has, auto& entries, auto&& entry) {
      if (has == Has::kNothing && !one_in(4)) return;  // else a table that no corner uses
      for (std::size_t i = 0; i < positions; ++i) entries.push_back(entry());
    };
    table(normals, made.normals, [&] { return any_normal(); });
    table(texcoords, made.texcoords, [&] { return TexCoord{any_texcoord(), any_texcoord()}; });
    table(colors, made.colors, [&] { return any_color(); });
    const auto dress = [&](Corner& c) {
      c.normal = attribute(normals, c.position, made.normals.size());
      c.texcoord = attribute(texcoords, c.position, made.texcoords.size());
      c.color = attribute(colors, c.position, made.colors.size());
    };
    for (Corner& corner : made.corners) dress(corner);
    for (auto& line : made.lines) {
      for (Corner& corner : line) dress(corner);
    }
    for (Corner& corner : made.points) dress(corner);
    made.material = std::uint32_t(integer(0, int(materials) - 1));
    return made;
  }

  // A random transform of a mesh. Positions are chosen in eye space and mapped back through it, so
  // what should be visible is visible in any object space.
  Transform<World, Object> placement() {
    Transform<Eye, Object> eye_from_object;
    if (one_in(2)) {
      const double s = magnitude(0.01, 100);
      const double x = one_in(3) ? -s : s, y = s * between(0.5, 2);
      eye_from_object = scale<Eye, Object>(x, y, s);
    }
    if (one_in(4)) {  // modelled far from its origin
      const Vector<Eye, double> offset{magnitude(1, 1e5), magnitude(1, 1e5), magnitude(1, 1e5)};
      eye_from_object = translate<Eye, Eye>(offset) * eye_from_object;
    }
    if (one_in(4)) {  // with axes that are not perpendicular
      Transform<Object, Object> shear;
      shear.at(0, 1) = between(-2, 2);
      shear.at(2, 0) = between(-1, 1);
      eye_from_object = eye_from_object * shear;
    }
    object_from_eye_ = inverse_affine(eye_from_object).value();
    return world_from_eye_ * eye_from_object;
  }

  Scene scene() {
    Scene made;
    made.name = "any";
    for (int i = integer(0, 2); i > 0; --i) made.images.push_back(image());
    if (!made.images.empty()) {
      for (int i = integer(1, 3); i > 0; --i) made.textures.push_back(texture(made.images.size()));
    }
    for (int i = integer(1, 3); i > 0; --i)
      made.materials.push_back(material(made.textures.size()));
    for (int i = integer(0, 2); i > 0; --i) made.lights.push_back(light());
    for (int i = integer(0, 3); i > 0; --i) {
      const auto node = std::uint32_t(made.nodes.size());
      const Transform<World, Object> place = placement();
      made.nodes.push_back({"node", kNone, place, place});
      made.meshes.push_back(mesh(made.materials.size()));
      made.instances.push_back({std::uint32_t(made.meshes.size() - 1), node});
      // The same instance again: all depths are equal.
      if (one_in(4)) made.instances.push_back(made.instances.back());
    }
    return made;
  }

  Source& source_;
  int most_faces_, largest_side_;
  const View* view_ = nullptr;
  double nearest_ = 0.1;
  Transform<World, Eye> world_from_eye_;
  Transform<Object, Eye> object_from_eye_;
};

template <class Source>
GeneratedCase generate_case(Source& source, int most_faces, int largest_side) {
  return CaseGenerator<Source>(source, most_faces, largest_side).make();
}

// ---- small cases ----

// Removes faces, lines, points, instances and lights from the case as long as `still_fails` returns
// true.
template <class Fails>
void shrink(GeneratedCase& failing, const Fails& still_fails) {
  const auto shorten = [&](auto get) {
    for (std::size_t part = get(failing)->size(); part > 0; part /= 2) {
      for (std::size_t at = 0; at < get(failing)->size();) {
        GeneratedCase smaller = failing;
        auto& list = *get(smaller);
        const auto first = list.begin() + std::ptrdiff_t(at);
        list.erase(first, first + std::ptrdiff_t(std::min(part, list.size() - at)));
        if (still_fails(smaller)) {
          failing = std::move(smaller);
        } else {
          at += part;
        }
      }
    }
  };
  shorten([](auto& c) { return &c.scene.instances; });
  for (std::size_t i = 0; i < failing.scene.meshes.size(); ++i) {
    shorten([i](auto& c) { return &c.scene.meshes[i].faces; });
    shorten([i](auto& c) { return &c.scene.meshes[i].lines; });
    shorten([i](auto& c) { return &c.scene.meshes[i].points; });
  }
  shorten([](auto& c) { return &c.scene.lights; });
}

// The case in words, with enough detail to build it by hand.
inline std::string in_words(const GeneratedCase& c) {
  std::ostringstream text;
  text.precision(9);
  const RenderSettings& s = c.settings;
  text << c.view.viewport.width() << " x " << c.view.viewport.height() << " px, "
       << (c.view.perspective ? "perspective" : "parallel") << ", near " << c.view.near << ", far "
       << c.view.far << "; shading " << int(s.shading) << ", show " << int(s.show) << ", cull "
       << int(s.cull) << ", in object space " << (s.cull_stage == CullStage::kObject)
       << ", wireframe " << s.wireframe << ", samples " << s.samples << ", depth format "
       << int(s.depth) << ", transfer " << int(s.transfer) << ", mask " << s.mask.r << s.mask.g
       << s.mask.b << s.mask.a << ", wants depth " << s.want_depth << " distance "
       << s.want_distance << " id " << s.want_id << "; target " << name_of(c.options.target)
       << ", threads " << c.options.threads << ", tiles of " << c.options.tile_side << ", plan "
       << c.options.plan << ", round " << c.options.round_size << "\n";
  for (const Instance& instance : c.scene.instances) {
    const Mesh& mesh = c.scene.meshes[instance.mesh];
    const Material& material = c.scene.materials[mesh.material];
    text << "instance: alpha mode " << int(material.alpha_mode) << ", double-sided "
         << material.double_sided << ", unlit " << material.unlit << ", textured "
         << material.texture.has_value() << ", lines " << mesh.lines.size() << ", points "
         << mesh.points.size() << "\n";
    const Transform<Eye, Object> eye_from_object =
        c.view.eye_from_world * c.scene.nodes[instance.node].world_from_node;
    for (const Face& face : mesh.faces) {
      text << "  face in eye space:";
      for (std::uint32_t i = 0; i < face.count; ++i) {
        const Corner& corner = mesh.corners[face.first + i];
        const Point<Object>& p = mesh.positions[corner.position];
        const Point<Eye, double> e = eye_from_object * Point<Object, double>(p.x, p.y, p.z);
        text << " (" << e.x << ", " << e.y << ", " << e.z << ")"
             << (corner.normal != kNone ? "n" : "") << (corner.texcoord != kNone ? "t" : "")
             << (corner.color != kNone ? "c" : "");
      }
      text << "\n";
    }
  }
  return text.str();
}

}  // namespace glassbox::test
