#include "study/extremes/kit/sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "study/extremes/kit/drawn_coverage.h"

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

// A line of sight: from + w along, where w is the distance along the gaze.
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

// The point where a line meets a triangle's plane: its distance, and the weights of the triangle's
// corners, whose sum is 1.
struct Hit {
  Long distance = 0;
  Long3 weights{};
  bool front = false;
};
std::optional<Hit> hit(const Line& line, const SeenTriangle& triangle) {
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

// The numerators and the denominator of the texture coordinates along a line; all are linear in the
// line's direction.
std::array<Long, 3> texture_terms(const Long3& along, const SeenTriangle& triangle) {
  std::array<Long, 3> terms{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Long weight =
        dot(along, cross(triangle.corners[(k + 1) % 3], triangle.corners[(k + 2) % 3]));
    for (std::size_t i = 0; i < 2; ++i) terms[i] += weight * Long(triangle.texcoords[k][i]);
    terms[2] += weight;
  }
  return terms;
}

// log2 of the longer one of the two steps in the texture, in texels, to the pixel on the right and
// to the pixel below.
Long level_of_detail(const Vista& vista, const SeenTriangle& triangle, const Line& line) {
  const auto& lens = std::get<PerspectiveLens>(vista.lens);
  const Long pixel = 2 * std::tan(Long(lens.fovy_radians) / 2) / Long(vista.view.viewport.height());
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
  return std::log2(longest * Long(vista.scene.images[0].width));
}

// Red stripes disappear from level 1 on, green ones from 3, blue ones from 5.
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

std::array<int, 2> texel_at(const Vista& vista, const SeenTriangle& triangle, const Hit& hit) {
  const Image<Rgba8>& image = vista.scene.images[0];
  const Sampler& sampler = vista.scene.textures[0].sampler;
  std::array<Long, 2> at{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < 2; ++i) at[i] += hit.weights[k] * Long(triangle.texcoords[k][i]);
  }
  return {wrapped(sampler.wrap_u, at[0], image.width),
          wrapped(sampler.wrap_v, at[1], image.height)};
}

// Without triangle ids, pictures are drawn in other ways; for example, draws of one mesh are
// combined. The visible face is then identified by a colour, which encodes its number in the mesh.
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
bool shows(Vista::Texels texels, const Sight& sight, const Rgba8& color) {
  if (sight.nearest == 0 || texels == Vista::Texels::kNone) return true;
  if (texels == Vista::Texels::kLevels) return stripes_lost(color) == sight.stripes;
  return color == color_of_texel(sight.texel[0], sight.texel[1]);
}

}  // namespace

Sight sight_at(const Vista& vista, std::span<const std::size_t> candidates, double x, double y) {
  const Long width = vista.view.viewport.width(), height = vista.view.viewport.height();
  const Line line = std::visit(
      LineOf{2 * Long(x) / width - 1, 1 - 2 * Long(y) / height, width / height}, vista.lens);
  Sight sight;
  Long nearest = std::numeric_limits<Long>::infinity(), next = nearest;
  for (const std::size_t i : candidates) {
    const SeenTriangle& triangle = vista.triangles[i];
    const std::optional<Hit> found = hit(line, triangle);
    if (!found || is_culled(vista.settings.cull, found->front)) continue;
    if (found->distance < Long(vista.view.near) || found->distance > Long(vista.view.far)) continue;
    ++sight.layers;
    if (found->distance < nearest) {
      next = nearest;
      nearest = found->distance;
      sight.nearest = int(i) + 1;
      if (vista.texels == Vista::Texels::kEach) sight.texel = texel_at(vista, triangle, *found);
      if (vista.texels == Vista::Texels::kLevels) {
        sight.stripes = stripes_lost(level_of_detail(vista, triangle, line));
      }
    } else {
      next = std::min(next, found->distance);
    }
  }
  sight.told_apart = !(next - nearest <= Long(vista.separation) * nearest);
  sight.layers = std::min(sight.layers, kMostLayers);
  return sight;
}

namespace {

struct Reach {
  double left = -HUGE_VAL, right = HUGE_VAL, top = -HUGE_VAL, bottom = HUGE_VAL;
};

// The part of the plane at distance 1 that the picture shows, for a lens whose lines of sight start
// at the eye.
struct Window {
  Long left = 0, right = 0, bottom = 0, top = 0;
};
std::optional<Window> window_of(const Vista& vista) {
  if (const auto* lens = std::get_if<FrustumLens>(&vista.lens)) {
    const Long near = lens->near;
    return Window{lens->left / near, lens->right / near, lens->bottom / near, lens->top / near};
  }
  const auto* lens = std::get_if<PerspectiveLens>(&vista.lens);
  if (lens == nullptr) return std::nullopt;
  const Long height = std::tan(Long(lens->fovy_radians) / 2);
  const Viewport& viewport = vista.view.viewport;
  const Long width = height * Long(viewport.width()) / Long(viewport.height());
  return Window{-width, width, -height, height};
}

// The part of the screen where a triangle in front of the eye may be, with one pixel of margin; the
// whole screen if the triangle extends behind the eye.
Reach reach_of(const Vista& vista, const SeenTriangle& triangle) {
  const auto window = window_of(vista);
  if (!window) return {};
  const auto& [left, right, bottom, top] = *window;
  const Long width = vista.view.viewport.width(), height = vista.view.viewport.height();
  Reach reach{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  for (const Long3& p : triangle.corners) {
    if (!(-p[2] > Long(vista.view.near) / 2)) return {};
    const double x = double((p[0] / -p[2] - left) / (right - left) * width);
    const double y = double((top - p[1] / -p[2]) / (top - bottom) * height);
    reach = {std::min(reach.left, x - 1), std::max(reach.right, x + 1), std::min(reach.top, y - 1),
             std::max(reach.bottom, y + 1)};
  }
  return reach;
}

}  // namespace

SightDrawn::SightDrawn(Vista vista) : vista_(std::move(vista)) {
  if (vista_.texels == Vista::Texels::kNone) {
    numbered_ = with_numbered_faces(vista_.scene);
    faces_ = faces_of(vista_.scene);
  }
  const Viewport& viewport = vista_.view.viewport;
  std::vector<Reach> reaches;
  for (const SeenTriangle& each : vista_.triangles) reaches.push_back(reach_of(vista_, each));
  std::vector<std::size_t> candidates;
  for (int y = 0; y < int(viewport.height()); ++y) {
    for (int x = 0; x < int(viewport.width()); ++x) {
      candidates.clear();
      for (std::size_t i = 0; i < reaches.size(); ++i) {
        const Reach& r = reaches[i];
        const bool may_be_hit = x + 1 >= r.left && x <= r.right && y + 1 >= r.top && y <= r.bottom;
        if (may_be_hit) candidates.push_back(i);
      }
      const Sight centre = sight_at(vista_, candidates, x + 0.5, y + 0.5);
      bool same = true, as_deep = true;
      for (int k = 0; k < 9 && (same || as_deep); ++k) {
        const double dx = (k % 3 - 1) * kBlur, dy = (k / 3 - 1) * kBlur;
        const Sight beside = sight_at(vista_, candidates, x + 0.5 + dx, y + 0.5 + dy);
        same = same && beside == centre;
        as_deep = as_deep && beside.layers == centre.layers;
      }
      pixels_.push_back({same ? std::optional(centre) : std::nullopt,
                         as_deep ? std::optional(centre.layers) : std::nullopt});
    }
  }
}

bool SightDrawn::shows_face(const Sight& sight, const Rgba8& color) const {
  if (sight.nearest == 0) return color == vista_.settings.background;
  return color == color_of_face(faces_[std::size_t(sight.nearest - 1)]);
}

std::optional<Sight> SightDrawn::sight(std::size_t pixel) const {
  const std::optional<Sight>& sight = pixels_[pixel].sight;
  return sight && sight->told_apart ? sight : std::nullopt;
}

Outcome SightDrawn::judge(const Drawer& drawer) const {
  const Framebuffer shown = drawer.draw(vista_.scene, vista_.view, vista_.settings).buffers;
  RenderSettings colors = vista_.settings;
  colors.want_id = false;  // some ways of drawing are used only without ids
  const bool by_face = vista_.texels == Vista::Texels::kNone;
  const Framebuffer colored =
      drawer.draw(by_face ? numbered_ : vista_.scene, vista_.view, colors).buffers;
  Scene layers = vista_.scene;
  std::ranges::fill(layers.materials, layer_material());
  const Framebuffer counted = drawer.draw(layers, vista_.view, colors).buffers;
  std::int64_t judged = 0, wrong = 0, times = 0;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const auto& [sight, layers] = pixels_[i];
    if (layers) times += layers_of(counted.color.pixels[i]) != *layers;
    if (!sight || !sight->told_apart) continue;
    ++judged;
    wrong += int(shown.id.pixels[i]) != sight->nearest ||
             !shows(vista_.texels, *sight, shown.color.pixels[i]) ||
             !(by_face ? shows_face(*sight, colored.color.pixels[i])
                       : shows(vista_.texels, *sight, colored.color.pixels[i]));
  }
  Outcome outcome = must_be_zero(
      double(wrong + times),
      fmt::format("{} of {} pixels show something else, {} are covered too often or not often "
                  "enough",
                  wrong, judged, times));
  if (2 * judged < std::int64_t(pixels_.size())) outcome.error = HUGE_VAL;
  return outcome;
}

Outcome worst_of(const std::vector<SightDrawn>& pictures, const Drawer& drawer) {
  Outcome worst;
  for (const SightDrawn& each : pictures) worst = worse_of(each.judge(drawer), worst);
  return worst;
}

}  // namespace glassbox::study
