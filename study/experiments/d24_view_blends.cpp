// Compares ways to blend pictures of a shiny object from all around into a view between them
// (D-24).
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/render/renderer.h>

#include "study/experiment/experiment.h"
#include "study/experiments/do_not_optimize.h"
#include "views/rings/draw_ring.h"
#include "views/texture/textured_surface.h"

namespace glassbox::study {
namespace d24 {

using views::Blend;
using views::Vector3d;

constexpr const char *kJump = "jump", *kFiner = "finer";
constexpr double kDegree = std::numbers::pi / 180;
// The pictures are four times finer than the view between them, so their resampling matters little.
constexpr int kSize = 96, kTimesFiner = 4;
constexpr Blend kAll[] = {Blend::kNearest, Blend::kBarycentric, Blend::kNeighbours};

std::string series_of(Blend blend) {
  switch (blend) {
    case Blend::kNearest:
      return "the nearest picture";
    case Blend::kBarycentric:
      return "barycentric weights";
    case Blend::kNeighbours:
      return "four neighbours by their angles";
  }
  return {};
}

// The surface of the object, lit by a fixed light. All objects have the same shape.
enum class Surface {
  kShiny,  // highlights move over it as the eye moves
  kDull,   // a point has the same light for all eyes: only the resampling of the pictures is left
  // resampling changes nothing either: an error could only come from pixels of something else
  kOneColor,
};
const char* name_of(Surface surface) {
  constexpr const char* kNames[] = {"shiny teapot", "dull teapot", "teapot of one colour"};
  return kNames[std::size_t(surface)];
}

Scene make_teapot(Surface surface) {
  Scene scene = *make_builtin("teapot:6");
  const float shine = surface == Surface::kShiny ? 0.5f : 0;
  for (Material& material : scene.materials) {
    material.specular = {shine, shine, shine};
    material.shininess = 8;
    material.unlit = surface == Surface::kOneColor;
  }
  Light light;
  light.intensity = 3;
  const Vector3d way = Vector3d(-0.3, -0.8, -0.5).normalized();
  light.direction = {way.x(), way.y(), way.z()};
  scene.lights = {light};
  return scene;
}

const Scene& teapot(Surface surface) {
  static const Scene all[] = {make_teapot(Surface::kShiny), make_teapot(Surface::kDull),
                              make_teapot(Surface::kOneColor)};
  return all[std::size_t(surface)];
}

views::PictureSet pictures_from(const Scene& scene, double start, double step, int count,
                                int size) {
  views::RingOptions options;
  options.views = count;
  options.arc_degrees = count > 1 ? step * (count - 1) : 1;
  options.start_degrees = start;
  options.elevations = {0};
  options.width = options.height = size;
  RenderSettings settings;
  settings.background = {0, 0, 0, 255};
  return views::draw_ring(scene, views::ring_views(scene, options).value(), settings,
                          views::Matte::kDepth);
}

// Eight pictures at equal angles, and the true view in the middle between the fourth and the fifth.
class Ring {
public:
  Ring(Surface surface, double degrees, int times_finer = kTimesFiner)
      : known_(pictures_from(teapot(surface), kStart - 3.5 * degrees, degrees, 8,
                             times_finer * kSize)),
        between_(pictures_from(teapot(surface), kStart, 0, 1, kSize).pictures.front()),
        surface_(views::TexturedSurface::create(teapot(surface), known_, Blend::kNearest).value()) {
  }

  views::TexturedPicture drawn_by(Blend blend) const {
    return surface_.with_blend(blend).draw(between_.camera, kSize, kSize, {0, 0, 0, 255}).value();
  }
  double rms_of(Blend blend) const {
    return views::textured_picture_errors(drawn_by(blend), between_).rms;
  }

private:
  static constexpr double kStart = 20;

  views::PictureSet known_;
  views::CalibratedPicture between_;
  views::TexturedSurface surface_;  // refers to known_, so a ring must not be moved
};

std::shared_ptr<const Ring> ring_of(Surface surface, double degrees,
                                    int times_finer = kTimesFiner) {
  return std::make_shared<const Ring>(surface, degrees, times_finer);
}

// ---- how weights change at the middle between two views ----

constexpr double kStep = 1e-6;  // in radians

// The largest change of a weight in a step across the middle between two of eight views on a great
// circle.
double jump_of(double degrees, Blend blend) {
  std::vector<Vector3d> directions;
  const auto at = [](double angle) { return Vector3d(std::sin(angle), 0, std::cos(angle)); };
  for (int i = 0; i < 8; ++i) directions.push_back(at((i - 3.5) * degrees * kDegree));
  const views::ViewBlend views(blend, directions);
  std::map<std::size_t, double> change;
  const auto all = [](std::size_t) { return true; };
  for (const auto& each : views.from_direction(at(-kStep / 2)).weights(all))
    change[each.view] -= each.weight;
  for (const auto& each : views.from_direction(at(kStep / 2)).weights(all))
    change[each.view] += each.weight;
  double most = 0;
  for (const auto& [view, weight] : change) most = std::max(most, std::abs(weight));
  return most;
}

// Predicts the change of a weight in a step across the middle; d is the angle between two views.
// Barycentric weights are sin(d - x) and sin x divided by their sum; their derivative at the middle
// is 1/(2 tan(d/2)). The four neighbours are at the angles a = d/2, d/2, 3d/2, 3d/2 and the next
// view is at 5d/2; their weights are w(a) = 1/a - 2/(5d), divided by the sum of all four, (8/3 +
// 16/15)/d = 56/(15 d). By symmetry, only the derivative of the nearest view's 1/a, which is 4/d^2,
// changes the weight across the middle.
double predicted_jump(double degrees, Blend blend) {
  const double d = degrees * kDegree;
  if (blend == Blend::kNearest) return 1;
  if (blend == Blend::kBarycentric) return kStep / (2 * std::tan(d / 2));
  return kStep * 4 * 15 / (56 * d);
}

// The error of a dull surface comes from the resampling of the pictures; a shiny surface has the
// error of its highlights in addition, and the squares add. The error of the highlights is
// proportional to the angle or its square (`power_`); the constant is taken from the widest
// spacing, where it is most of the error.
class PredictedError {
public:
  PredictedError(Blend blend, double widest, const Ring& dull, const Ring& shiny)
      : power_(blend == Blend::kNearest ? 1 : 2),
        widest_(widest),
        light_(std::sqrt(square(shiny.rms_of(blend)) - square(dull.rms_of(blend)))) {}

  double at(double degrees, double resampling) const {
    return std::hypot(resampling, light_ * std::pow(degrees / widest_, power_));
  }

private:
  static double square(double x) { return x * x; }

  double power_, widest_, light_;
};

void add_spacing(Blend blend, double degrees, const PredictedError& law,
                 std::vector<Configuration>& all, const std::shared_ptr<const Ring>& shiny,
                 const std::shared_ptr<const Ring>& dull, double resampling_at_widest) {
  const auto add = [&](Surface surface, const std::shared_ptr<const Ring>& ring, double predicted) {
    all.push_back({.series = series_of(blend),
                   .parameter = degrees,
                   .scene = name_of(surface),
                   .error = [=] { return ring->rms_of(blend); },
                   .predicted_error = predicted,
                   .work = [=](int) { do_not_optimize(ring->drawn_by(blend)); }});
  };
  add(Surface::kShiny, shiny, law.at(degrees, dull->rms_of(blend)));
  // A dull surface looks the same from all sides, so the angle makes no difference.
  add(Surface::kDull, dull, resampling_at_widest);
  add(Surface::kOneColor, ring_of(Surface::kOneColor, degrees), 0);
  all.push_back({.series = series_of(blend),
                 .parameter = degrees,
                 .scene = "views on a circle",
                 .measure = kJump,
                 .error = [=] { return jump_of(degrees, blend); },
                 .predicted_error = predicted_jump(degrees, blend)});
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<double> spacings{4, 8, 16, 24};
  if (effort == Effort::kFull) spacings = {3, 4, 6, 8, 12, 16, 24};
  std::vector<Configuration> all;
  std::map<double, std::shared_ptr<const Ring>> shiny, dull;
  for (const double degrees : spacings) {
    shiny[degrees] = ring_of(Surface::kShiny, degrees);
    dull[degrees] = ring_of(Surface::kDull, degrees);
  }
  const double widest = spacings.back();
  for (const Blend blend : kAll) {
    const PredictedError law(blend, widest, *dull[widest], *shiny[widest]);
    for (const double degrees : spacings)
      add_spacing(blend, degrees, law, all, shiny[degrees], dull[degrees],
                  dull[widest]->rms_of(blend));
    for (const int finer : {1, 2, 4, 8}) {
      all.push_back({.series = series_of(blend),
                     .parameter = double(finer),
                     .scene = "dull teapot, 8 degrees apart",
                     .measure = kFiner,
                     .error = [=] { return ring_of(Surface::kDull, 8, finer)->rms_of(blend); }});
    }
  }
  return all;
}

}  // namespace d24

Experiment d24_view_blends() {
  using namespace d24;
  return {
      .id = "D-24",
      .name = "Textures that depend on the view",
      .question =
          "How well can a picture be made from the pictures around it, and how smoothly does it "
          "change with the eye?",
      .axis = "angle between neighbouring pictures",
      .axis_unit = "degrees",
      .error = "RMS difference from the picture half way between two, over the object",
      .error_unit = "levels",
      .reference =
          "the picture drawn from there, 96 px wide; the given pictures are four times as fine, of "
          "a teapot under a fixed light",
      .theory =
          "The nearest picture is wrong by half the angle times the change of a surface's light "
          "with the eye, so its error grows like the angle. Linear interpolation between two "
          "pictures has an error that grows like the square of the angle (S1-40 in "
          "docs/references.md). The square of the error of the same surface without highlights is "
          "added; this error comes from the resampling of pixels and does not depend on the angle. "
          "The constants are measured at the widest spacing. A surface of one colour has no error. "
          "In the middle between two views, the weight of the nearest one jumps by 1; barycentric "
          "weights change by the step divided by 2 tan(d/2), and those of four neighbours by 15/14 "
          "of the step divided by d",
      .item = "picture",
      .measures = {{.name = kJump,
                    .error = "largest change of a weight in a step of 1e-6 across the middle",
                    .error_unit = ""},
                   {.name = kFiner,
                    .error = "RMS difference of a dull surface: the error of resampling alone",
                    .error_unit = "levels",
                    .axis = "times as many pixels as in the picture in between"}},
      .configurations = configurations};
}

}  // namespace glassbox::study
