#include "study/extremes/common/ray_cast.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "study/extremes/common/drawn_coverage.h"

#include <glassbox/mesh/triangulate.h>

namespace glassbox::study {

namespace {

using Long = long double;
using Long3 = std::array<Long, 3>;

constexpr double kBlur = 0x1p-7;  // in px

Long3 operator-(const Long3& a, const Long3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Long3 cross(const Long3& a, const Long3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Long dot(const Long3& a, const Long3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A line of sight: the points from + w * along, where w is the distance along the gaze.
struct Line {
  Long3 from{}, along{};
};

struct LineOf {
  Long x, y;  // -1 .. 1, y points up
  Long aspect;

  Line operator()(const PerspectiveLens& lens) const {
    const Long t = std::tan(Long(lens.fovy_radians) / 2);
    return {{}, {x * t * aspect, y * t, -1}};
  }
  Line operator()(const OrthographicLens& lens) const {
    const Long h = lens.half_height;
    return {{x * h * aspect, y * h, 0}, {0, 0, -1}};
  }
  Line operator()(const FrustumLens& lens) const {
    const auto between = [](Long low, Long high, Long at) {
      return low + (high - low) * (at + 1) / 2;
    };
    return {{},
            {between(lens.left, lens.right, x) / Long(lens.near),
             between(lens.bottom, lens.top, y) / Long(lens.near), -1}};
  }
};

// The point where a line hits a triangle: its distance, and the weights of the triangle's corners,
// whose sum is 1.
struct Hit {
  Long distance = 0;
  Long3 weights{};
  bool front = false;
};
std::optional<Hit> hit(const Line& line, const ExactEyeTriangle& triangle) {
  std::array<Long3, 3> p;
  for (std::size_t k = 0; k < 3; ++k) p[k] = triangle.corners[k] - line.from;
  Hit found;
  Long sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    found.weights[k] = dot(line.along, cross(p[(k + 1) % 3], p[(k + 2) % 3]));
    sum += found.weights[k];
  }
  if (sum == 0) return std::nullopt;
  found.front = sum < 0;
  for (Long& weight : found.weights) weight /= sum;
  if (std::ranges::any_of(found.weights, [](Long weight) { return weight < 0; })) {
    return std::nullopt;
  }
  for (std::size_t k = 0; k < 3; ++k) found.distance -= found.weights[k] * triangle.corners[k][2];
  return found;
}

bool is_culled(Cull cull, bool front) {
  return (cull == Cull::kBack && !front) || (cull == Cull::kFront && front);
}

// The numerators of the two texture coordinates along a line, and their common denominator. All
// three are linear in the line's direction.
std::array<Long, 3> texture_terms(const Long3& along, const ExactEyeTriangle& triangle) {
  std::array<Long, 3> terms{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Long weight =
        dot(along, cross(triangle.corners[(k + 1) % 3], triangle.corners[(k + 2) % 3]));
    for (std::size_t i = 0; i < 2; ++i) terms[i] += weight * Long(triangle.texcoords[k][i]);
    terms[2] += weight;
  }
  return terms;
}

// log2 of the longer one of two steps in the texture, in texels: the step from this pixel to the
// one on the right, and the step to the one below.
Long level_of_detail(const RayScene& ray_scene, const ExactEyeTriangle& triangle,
                     const Line& line) {
  const auto& lens = std::get<PerspectiveLens>(ray_scene.lens);
  const Long pixel =
      2 * std::tan(Long(lens.fovy_radians) / 2) / Long(ray_scene.view.viewport.height());
  const auto here = texture_terms(line.along, triangle);
  Long longest = 0;
  for (const Long3& step : {Long3{pixel, 0, 0}, Long3{0, -pixel, 0}}) {
    const auto change = texture_terms(step, triangle);
    Long squares = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const Long slope = (change[i] - here[i] / here[2] * change[2]) / here[2];
      squares += slope * slope;
    }
    longest = std::max(longest, std::sqrt(squares));
  }
  return std::log2(longest * Long(ray_scene.scene.images[0].width));
}

// How many kinds of stripes are lost at a mipmap level: red ones from level 1 on, green ones from
// 3, blue ones from 5.
int stripes_lost(Long level) {
  const Long nearest = std::floor(level + 0.5L);
  return nearest < 1 ? 0 : nearest < 3 ? 1 : nearest < 5 ? 2 : 3;
}
int stripes_lost(const Rgba8& color) {
  const auto grey = [](std::uint8_t channel) { return channel > 8 && channel < 247; };
  return int(grey(color.r)) + int(grey(color.g)) + int(grey(color.b));
}

int wrapped(Wrap wrap, Long coordinate, int size) {
  const Long place = std::floor(coordinate * size);
  const auto modulo = [&](int m) { return int(place - std::floor(place / m) * m); };
  switch (wrap) {
    case Wrap::kRepeat:
      return modulo(size);
    case Wrap::kMirroredRepeat:
      return modulo(2 * size) < size ? modulo(2 * size) : 2 * size - 1 - modulo(2 * size);
    case Wrap::kClampToEdge:
      return int(std::clamp(place, Long(0), Long(size - 1)));
  }
  return 0;
}

std::array<int, 2> texel_at(const RayScene& ray_scene, const ExactEyeTriangle& triangle,
                            const Hit& hit) {
  const Image<Rgba8>& image = ray_scene.scene.images[0];
  const Sampler& sampler = ray_scene.scene.textures[0].sampler;
  std::array<Long, 2> at{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 2; ++i) at[i] += hit.weights[k] * Long(triangle.texcoords[k][i]);
  }
  return {wrapped(sampler.wrap_u, at[0], image.width),
          wrapped(sampler.wrap_v, at[1], image.height)};
}

// A colour that encodes the number of a face in its mesh. Pictures without triangle ids are drawn
// in other ways (for example, draws of one mesh are combined), so the visible face must be
// identified by its colour.
Rgba8 color_of_face(std::uint32_t face) {
  return {std::uint8_t(face & 255), std::uint8_t(face >> 8), 255, 255};
}

Scene with_numbered_faces(Scene scene) {
  for (Material& material : scene.materials) {
    const bool double_sided = material.double_sided;
    material = {};
    material.unlit = true;
    material.double_sided = double_sided;
  }
  for (Mesh& mesh : scene.meshes) {
    mesh.colors.clear();
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
      const Rgba8 c = color_of_face(face);
      mesh.colors.push_back({float(c.r) / 255, float(c.g) / 255, float(c.b) / 255, 1});
      const Face& corners = mesh.faces[face];
      for (std::uint32_t k = 0; k < corners.count; ++k) {
        mesh.corners[corners.first + k].color = face;
      }
    }
  }
  return scene;
}

// The face number of each triangle of a scene.
std::vector<std::uint32_t> faces_of(const Scene& scene) {
  std::vector<std::uint32_t> faces;
  for (const Instance& instance : scene.instances) {
    for (const Triangle& triangle : triangulate(scene.meshes[instance.mesh]).triangles) {
      faces.push_back(triangle.face);
    }
  }
  return faces;
}

// Whether a pixel has the colour of the surface that is visible there.
bool shows(RayScene::Texels texels, const RayHits& hits, const Rgba8& color) {
  if (hits.nearest == 0 || texels == RayScene::Texels::kNone) return true;
  if (texels == RayScene::Texels::kLevels) return stripes_lost(color) == hits.stripes;
  return color == color_of_texel(hits.texel[0], hits.texel[1]);
}

}  // namespace

RayHits cast_ray(const RayScene& ray_scene, std::span<const std::size_t> candidates, double x,
                 double y) {
  const Long width = ray_scene.view.viewport.width(), height = ray_scene.view.viewport.height();
  const Line line = std::visit(
      LineOf{2 * Long(x) / width - 1, 1 - 2 * Long(y) / height, width / height}, ray_scene.lens);
  RayHits hits;
  Long nearest = std::numeric_limits<Long>::infinity(), next = nearest;
  for (const std::size_t i : candidates) {
    const ExactEyeTriangle& triangle = ray_scene.triangles[i];
    const std::optional<Hit> found = hit(line, triangle);
    if (!found || is_culled(ray_scene.settings.cull, found->front)) continue;
    if (found->distance < Long(ray_scene.view.near) || found->distance > Long(ray_scene.view.far))
      continue;
    ++hits.layers;
    if (found->distance < nearest) {
      next = nearest;
      nearest = found->distance;
      hits.nearest = int(i) + 1;
      if (ray_scene.texels == RayScene::Texels::kEach)
        hits.texel = texel_at(ray_scene, triangle, *found);
      if (ray_scene.texels == RayScene::Texels::kLevels) {
        hits.stripes = stripes_lost(level_of_detail(ray_scene, triangle, line));
      }
    } else {
      next = std::min(next, found->distance);
    }
  }
  hits.unambiguous = !(next - nearest <= Long(ray_scene.separation) * nearest);
  hits.layers = std::min(hits.layers, kMaxLayers);
  return hits;
}

namespace {

struct ScreenBounds {
  double left = -HUGE_VAL, right = HUGE_VAL, top = -HUGE_VAL, bottom = HUGE_VAL;
};

// The part of the plane at distance 1 that the picture shows, for a lens whose lines of sight start
// at the eye.
struct Window {
  Long left = 0, right = 0, bottom = 0, top = 0;
};
std::optional<Window> window_of(const RayScene& ray_scene) {
  if (const auto* lens = std::get_if<FrustumLens>(&ray_scene.lens)) {
    const Long near = lens->near;
    return Window{lens->left / near, lens->right / near, lens->bottom / near, lens->top / near};
  }
  const auto* lens = std::get_if<PerspectiveLens>(&ray_scene.lens);
  if (lens == nullptr) return std::nullopt;
  const Long height = std::tan(Long(lens->fovy_radians) / 2);
  const Viewport& viewport = ray_scene.view.viewport;
  const Long width = height * Long(viewport.width()) / Long(viewport.height());
  return Window{-width, width, -height, height};
}

// The part of the screen where a triangle in front of the eye may be, with one pixel of margin; the
// whole screen if the triangle extends behind the eye.
ScreenBounds screen_bounds_of(const RayScene& ray_scene, const ExactEyeTriangle& triangle) {
  const auto window = window_of(ray_scene);
  if (!window) return {};
  const auto& [left, right, bottom, top] = *window;
  const Long width = ray_scene.view.viewport.width(), height = ray_scene.view.viewport.height();
  ScreenBounds bounds{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  for (const Long3& p : triangle.corners) {
    if (!(-p[2] > Long(ray_scene.view.near) / 2)) return {};
    const double x = double((p[0] / -p[2] - left) / (right - left) * width);
    const double y = double((top - p[1] / -p[2]) / (top - bottom) * height);
    bounds = {std::min(bounds.left, x - 1), std::max(bounds.right, x + 1),
              std::min(bounds.top, y - 1), std::max(bounds.bottom, y + 1)};
  }
  return bounds;
}

}  // namespace

RayCastReference::RayCastReference(RayScene ray_scene) : ray_scene_(std::move(ray_scene)) {
  if (ray_scene_.texels == RayScene::Texels::kNone) {
    numbered_ = with_numbered_faces(ray_scene_.scene);
    faces_ = faces_of(ray_scene_.scene);
  }
  const Viewport& viewport = ray_scene_.view.viewport;
  std::vector<ScreenBounds> bounds;
  for (const ExactEyeTriangle& each : ray_scene_.triangles)
    bounds.push_back(screen_bounds_of(ray_scene_, each));
  std::vector<std::size_t> candidates;
  for (int y = 0; y < int(viewport.height()); ++y) {
    for (int x = 0; x < int(viewport.width()); ++x) {
      candidates.clear();
      for (std::size_t i = 0; i < bounds.size(); ++i) {
        const ScreenBounds& r = bounds[i];
        const bool may_be_hit = x + 1 >= r.left && x <= r.right && y + 1 >= r.top && y <= r.bottom;
        if (may_be_hit) candidates.push_back(i);
      }
      const RayHits centre = cast_ray(ray_scene_, candidates, x + 0.5, y + 0.5);
      bool same = true, as_deep = true;
      for (int k = 0; k < 9 && (same || as_deep); ++k) {
        const double dx = (k % 3 - 1) * kBlur, dy = (k / 3 - 1) * kBlur;
        const RayHits beside = cast_ray(ray_scene_, candidates, x + 0.5 + dx, y + 0.5 + dy);
        same = same && beside == centre;
        as_deep = as_deep && beside.layers == centre.layers;
      }
      pixels_.push_back({same ? std::optional(centre) : std::nullopt,
                         as_deep ? std::optional(centre.layers) : std::nullopt});
    }
  }
}

bool RayCastReference::shows_face(const RayHits& hits, const Rgba8& color) const {
  if (hits.nearest == 0) return color == ray_scene_.settings.background;
  return color == color_of_face(faces_[std::size_t(hits.nearest - 1)]);
}

std::optional<RayHits> RayCastReference::hits(std::size_t pixel) const {
  const std::optional<RayHits>& hits = pixels_[pixel].hits;
  return hits && hits->unambiguous ? hits : std::nullopt;
}

Outcome RayCastReference::measure_error(const TestedEngine& engine) const {
  const Framebuffer shown =
      engine.draw(ray_scene_.scene, ray_scene_.view, ray_scene_.settings).buffers;
  RenderSettings colors = ray_scene_.settings;
  colors.want_id = false;  // because some ways of drawing are used only without ids
  const bool by_face = ray_scene_.texels == RayScene::Texels::kNone;
  const Framebuffer colored =
      engine.draw(by_face ? numbered_ : ray_scene_.scene, ray_scene_.view, colors).buffers;
  Scene layers = ray_scene_.scene;
  std::ranges::fill(layers.materials, layer_material());
  const Framebuffer counted = engine.draw(layers, ray_scene_.view, colors).buffers;
  std::int64_t judged = 0, wrong = 0, times = 0;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const auto& [hits, layers] = pixels_[i];
    if (layers) times += layers_of(counted.color.pixels[i]) != *layers;
    if (!hits || !hits->unambiguous) continue;
    ++judged;
    wrong += int(shown.id.pixels[i]) != hits->nearest ||
             !shows(ray_scene_.texels, *hits, shown.color.pixels[i]) ||
             !(by_face ? shows_face(*hits, colored.color.pixels[i])
                       : shows(ray_scene_.texels, *hits, colored.color.pixels[i]));
  }
  Outcome outcome = must_be_zero(
      double(wrong + times),
      fmt::format("{} of {} pixels show something else, {} are covered too often or not often "
                  "enough",
                  wrong, judged, times));
  if (2 * judged < std::int64_t(pixels_.size())) outcome.error = HUGE_VAL;
  return outcome;
}

Outcome worst_of(const std::vector<RayCastReference>& pictures, const TestedEngine& engine) {
  Outcome worst;
  for (const RayCastReference& each : pictures) worst = worse_of(each.measure_error(engine), worst);
  return worst;
}

}  // namespace glassbox::study
