// D-24: a shiny thing in pictures from all around, and what is in between.
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/render/renderer.h>

#include "study/experiment/experiment.h"
#include "study/experiments/consume.h"
#include "study/experiments/once.h"
#include "views/rings/draw_ring.h"
#include "views/texture/textured_surface.h"

namespace glassbox::study {
namespace {

using views::Blend;
using views::Vector3d;

constexpr const char* kJump = "jump";
constexpr double kDegree = std::numbers::pi / 180;
constexpr int kSize = 96;
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

// The teapot, shiny, under a light that stands still: its highlights go over it as the eye goes round.
const Scene& shiny_teapot() {
  static const Scene made = [] {
    Scene scene = *make_builtin("teapot:6");
    for (Material& material : scene.materials) {
      material.specular = {0.5f, 0.5f, 0.5f};
      material.shininess = 8;
    }
    Light light;
    light.intensity = 3;
    const Vector3d way = Vector3d(-0.3, -0.8, -0.5).normalized();
    light.direction = {way.x(), way.y(), way.z()};
    scene.lights = {light};
    return scene;
  }();
  return made;
}

views::PictureSet pictures_from(double start, double step, int count) {
  views::RingOptions options;
  options.views = count;
  options.arc_degrees = count > 1 ? step * (count - 1) : 1;
  options.start_degrees = start;
  options.elevations = {0};
  options.width = options.height = kSize;
  RenderSettings settings;
  settings.background = {0, 0, 0, 255};
  return views::draw_ring(shiny_teapot(), views::ring_views(shiny_teapot(), options).value(),
                          settings, views::Matte::kDepth);
}

// Eight pictures so many degrees apart, and what is seen in the middle between the fourth and the fifth.
struct Ring {
  views::PictureSet known;
  views::CalibratedPicture between;
};

std::shared_ptr<const Ring> ring_of(double degrees) {
  const double start = 20;
  return std::make_shared<const Ring>(Ring{pictures_from(start - 3.5 * degrees, degrees, 8),
                                           pictures_from(start, 0, 1).pictures.front()});
}

double rms_of(const Ring& ring, Blend blend) {
  const auto surface = views::TexturedSurface::of(shiny_teapot(), ring.known, blend);
  const auto drawn = surface->draw(ring.between.camera, kSize, kSize, {0, 0, 0, 255});
  return views::compare(*drawn, ring.between).rms;
}

// ---- weights over the middle between two views ----

constexpr double kStep = 1e-6;  // radian

// The largest change of a weight by a step over the middle between two of eight views on a great circle.
double jump_of(double degrees, Blend blend) {
  std::vector<Vector3d> directions;
  const auto at = [](double angle) { return Vector3d(std::sin(angle), 0, std::cos(angle)); };
  for (int i = 0; i < 8; ++i) directions.push_back(at((i - 3.5) * degrees * kDegree));
  const views::ViewBlend views(blend, directions);
  std::map<std::size_t, double> change;
  const auto all = [](std::size_t) { return true; };
  for (const auto& each : views.from(at(-kStep / 2)).weights(all)) change[each.view] -= each.weight;
  for (const auto& each : views.from(at(kStep / 2)).weights(all)) change[each.view] += each.weight;
  double most = 0;
  for (const auto& [view, weight] : change) most = std::max(most, std::abs(weight));
  return most;
}

// Of weights sin(d - x) and sin x over their sum, the derivative at the middle. Of neighbours at d/2, d/2, 3d/2, 3d/2 with the next at
// 5d/2, w(a) = 1/a - 2/5d: the odd part of the nearest one's, 4/d^2, over the sum of all four, (8/3 + 16/15)/d = 56/15 d.
double predicted_jump(double degrees, Blend blend) {
  const double d = degrees * kDegree;
  if (blend == Blend::kNearest) return 1;
  if (blend == Blend::kBarycentric) return kStep / (2 * std::tan(d / 2));
  return kStep * 4 * 15 / (56 * d);
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<double> spacings{4, 8, 16, 24};
  if (effort == Effort::kFull) spacings = {3, 4, 6, 8, 12, 16, 24};
  std::vector<Configuration> all;
  std::map<double, std::shared_ptr<const Ring>> rings;
  for (const double degrees : spacings) rings[degrees] = ring_of(degrees);
  const double least = spacings.front();
  for (const Blend blend : kAll) {
    const auto finest = once([ring = rings[least], blend] { return rms_of(*ring, blend); });
    for (const double degrees : spacings) {
      const auto ring = rings[degrees];
      // The law's constant is that of the finest spacing.
      const double power = blend == Blend::kNearest ? 1 : 2;
      all.push_back(
          {.series = series_of(blend),
           .parameter = degrees,
           .scene = "shiny teapot",
           .error = [=] { return rms_of(*ring, blend); },
           .predicted_error = finest() * std::pow(degrees / least, power),
           // At the finest spacings barycentric weights leave the same error whatever the angle.
           .finding =
               Finding{"at the finest spacing most of the error is the resampling of pixels, "
                       "which does not grow with the angle",
                       blend == Blend::kNearest ? 0.25 : 0.02, 1},
           .work =
               [=](int) {
                 const auto surface =
                     views::TexturedSurface::of(shiny_teapot(), ring->known, blend);
                 consume(surface->draw(ring->between.camera, kSize, kSize, {0, 0, 0, 255}));
               }});
      all.push_back({.series = series_of(blend),
                     .parameter = degrees,
                     .scene = "views on a circle",
                     .measure = kJump,
                     .error = [=] { return jump_of(degrees, blend); },
                     .predicted_error = predicted_jump(degrees, blend)});
    }
  }
  return all;
}

}  // namespace

Experiment d24_view_blends() {
  return {
      .id = "D-24",
      .name = "Textures that depend on the view",
      .question = "How well do pictures from all around make the one in between, and how smoothly?",
      .axis = "angle between neighbouring pictures",
      .axis_unit = "degrees",
      .error = "RMS difference from the picture half way between two, over the object",
      .error_unit = "levels",
      .reference = "the picture drawn from there: a shiny teapot under a light that stands still",
      .theory =
          "the nearest picture is wrong by half the angle times the change of a surface's light "
          "with the eye, and goes with the angle; what is linear between two goes with its square "
          "(D-24, S1-40), the constant being that of the finest spacing. Over the middle between "
          "two views the nearest one's weight jumps by 1; barycentric weights change by the step "
          "over 2 tan(d/2), those of four neighbours by 15/14 of the step over d",
      .item = "picture",
      .measures = {{.name = kJump,
                    .error = "largest change of a weight by a step of 1e-6 over the middle",
                    .error_unit = ""}},
      .configurations = configurations};
}

}  // namespace glassbox::study
