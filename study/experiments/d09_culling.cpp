// Compares where back faces are detected, and whether early detection loses anything (D-9).
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include <glassbox/base/random.h>
#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/mesh/formats/load.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/raster/triangle_setup.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d09_tests.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/memoize.h"
#include "study/scenes/scenes.h"

namespace glassbox::study {

namespace d09 {

constexpr const char* kFallbacks = "exact fallbacks";

// ---- measures ----

double wrongly_culled(const Surface& surface, const Test& test) {
  KeepFlags keep(surface.object_triangles.size());
  test(surface, keep);
  double count = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    count += !keep[i] && shows_front_exactly(surface.screen_triangles[i]);
  return count;
}

// The probability that a back face shows its front after snapping. Snapping adds to each coordinate
// an error of variance q^2/12, q = 1/256 px, so twice the area gets an error of variance sigma^2 =
// q^2/12 times the sum of the squared edges. If the value is `area`, the error changes its sign
// with the probability Phi(-area/sigma), where Phi is the normal distribution function.
double chance_to_turn(const ScreenTriangle& t) {
  const auto edge = [&](std::size_t k) {
    const auto &a = t[k].position, &b = t[(k + 1) % 3].position;
    return std::array{double(b.x) - a.x, double(b.y) - a.y};
  };
  const auto u = edge(0), v = edge(1), w = edge(2);
  const double area = u[0] * v[1] - u[1] * v[0];  // positive: clockwise
  const double squares =
      u[0] * u[0] + u[1] * u[1] + v[0] * v[0] + v[1] * v[1] + w[0] * w[0] + w[1] * w[1];
  const double sigma = std::sqrt(squares / 12) / kSubpixels;
  return sigma > 0 ? 0.5 * std::erfc(area / sigma / std::sqrt(2.0)) : 0;
}

// The expected number of faces that are culled although their snapped triangles show the front.
double predicted_wrong(const Surface& surface, const Test& test) {
  KeepFlags keep(surface.object_triangles.size());
  test(surface, keep);
  double sum = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    sum += keep[i] ? 0 : chance_to_turn(surface.screen_triangles[i]);
  return std::round(sum);  // faces are counted in whole numbers
}

void cull_and_set_up(const Surface& surface, const Test& test, KeepFlags& keep) {
  test(surface, keep);
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    const auto setup = setup_triangle(surface.screen_triangles[i]);
    keep[i] = setup.has_value() && !setup->clockwise;
  }
}

// ---- scenes ----

Configuration configuration(const std::string& series, const std::string& scene,
                            const std::shared_ptr<const Surface>& surface, const Test& test,
                            double predicted) {
  const auto keep = std::make_shared<KeepFlags>(surface->object_triangles.size());
  return {.series = series,
          .parameter = double(surface->object_triangles.size()),
          .scene = scene,
          .error = [=] { return wrongly_culled(*surface, test); },
          .predicted_error = predicted,
          .work = [=](int) { cull_and_set_up(*surface, test, *keep); },
          .items = double(surface->object_triangles.size())};
}

void add_filter(const std::string& series, const std::string& scene,
                const std::shared_ptr<const Surface>& surface, Filter filter, Effort effort,
                std::vector<Configuration>& all) {
  const int eyes = effort == Effort::kFull ? 200'000 : 20'000;
  const auto rate = memoize([=] { return fallbacks(surface->object_triangles, filter, eyes); });
  const auto keep = std::make_shared<KeepFlags>(surface->object_triangles.size());
  all.push_back(
      {.series = series,
       .parameter = double(surface->object_triangles.size()),
       .scene = scene,
       .measure = kFallbacks,
       .error = [=] { return rate().measured; },
       .predicted_error = rate().expected,
       .work =
           [=](int) {
             for (std::size_t i = 0; i < keep->size(); ++i)
               (*keep)[i] = !filter(surface->object_triangles[i], surface->viewer.eye_or_gaze).back;
             do_not_optimize(*keep);
           },
       .items = double(surface->object_triangles.size())});
}

void add_surface(const std::string& scene, const std::shared_ptr<const Surface>& surface,
                 Effort effort, std::vector<Configuration>& all) {
  const auto clusters = std::make_shared<const std::vector<Cluster>>(make_clusters(*surface));
  const Test cones = [clusters](const Surface& s, KeepFlags& keep) {
    keep_by_cones(s, *clusters, keep);
  };
  all.push_back(configuration("none", scene, surface, keep_all, 0));
  all.push_back(configuration("object-space dot product, float", scene, surface, keep_by_dot,
                              predicted_wrong(*surface, keep_by_dot)));
  all.push_back(configuration("snapped area", scene, surface, keep_by_area, 0));
  all.push_back(
      configuration("cluster cones", scene, surface, cones, predicted_wrong(*surface, cones)));
  all.push_back(configuration("filter, exact sum where needed, margin", scene, surface,
                              keep_by_exact_test, 0));
  add_filter("filter in double", scene, surface, filter_in_double, effort, all);
  add_filter("filter in float", scene, surface, filter_in_float, effort, all);
}

std::shared_ptr<const Surface> framed(const Scene& scene) {
  return make_surface(scene, make_view(framing_camera(scene, 1).value(), kSide, kSide).value());
}

// A smooth surface as a scanner measures it: an ellipsoid whose corners are moved by up to a third
// of the distance between neighbours. So a face that is seen almost edge-on shows its front or its
// back at random, and neighbouring normals disagree.
std::shared_ptr<const Surface> scan() {
  BenchScene bench = make_ellipsoid_scene("scan", kScannedGrid, kSide, kSide);
  const double noise = kPi / kScannedGrid.stacks / 3;
  Random random(10);
  for (auto& p : bench.scene.meshes.front().positions) {
    const float factor = float(1 + random.between(-noise, noise));
    p = {p.x * factor, p.y * factor, p.z * factor};
  }
  return make_surface(bench.scene, bench.passes.front().view);
}

// A real mesh of 100,000 faces, used if the assets are beside the working directory; it is never
// required.
std::shared_ptr<const Surface> koala() {
  const char* path = "../shared/assets/meshes/obj/koala/koala.obj";
  if (!std::filesystem::exists(path)) return nullptr;
  const auto scene = load_scene(path);
  return scene ? framed(*scene) : nullptr;
}

std::shared_ptr<const Surface> ellipsoid(const EllipsoidGrid& grid) {
  const BenchScene bench = make_ellipsoid_scene("ellipsoid", grid, kSide, kSide);
  return make_surface(bench.scene, bench.passes.front().view);
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  add_surface("teapot", framed(make_builtin("teapot").value()), effort, all);
  add_surface("ellipsoid", ellipsoid(kScannedGrid), effort, all);
  add_surface("ellipsoid with the triangle sizes of a scan", scan(), effort, all);
  if (const auto file = koala()) add_surface("koala, from a file", file, effort, all);
  if (effort == Effort::kFull)
    add_surface("ellipsoid of a million triangles", ellipsoid(kFineGrid), effort, all);
  return all;
}

}  // namespace d09

Experiment d09_culling() {
  using namespace d09;
  return {
      .id = "D-9",
      .name = "Back faces: where to find and cull them",
      .question = "What is gained by culling back faces early, and is anything lost?",
      .axis = "triangles of the mesh",
      .error = "faces that are culled although their snapped triangle shows its front",
      .error_unit = "faces",
      .reference =
          "the sign of the snapped triangle's area, which decides what is drawn, in 128 bits",
      .theory =
          "An exact test in object space does not know the snap. The snap gives a face with twice "
          "the area -a the opposite sign with probability Phi(-a/sigma), sigma^2 = sum "
          "|edge|^2/(12 256^2), so the expected number is the sum of this over all culled faces. "
          "With a margin for the snap it is 0. Half of the faces of a closed surface are back "
          "faces, so at most half of the set-up is saved. From far away all cosines between gaze "
          "and normal are equally likely, so a filter cannot decide for the fraction "
          "bound/(|normal| distance) of directions.",
      .item = "triangle",
      .measures = {{kFallbacks,
                    "fraction of eyes, in all directions and 64 units away, for which a filter "
                    "cannot decide a face's side, so that exact expansions decide",
                    ""}},
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
