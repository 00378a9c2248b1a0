// D-9: where back faces are found out, and whether anything is lost by finding them early.
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/raster/triangle_setup.h>

#include "study/experiment/experiment.h"
#include "study/experiments/d09_tests.h"
#include "study/scenes/scenes.h"

namespace glassbox::study {

namespace {

using namespace d09;

// ---- measures ----

double wrongly_culled(const Surface& surface, const Test& test) {
  Keep keep(surface.modelled.size());
  test(surface, keep);
  double count = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    count += !keep[i] && shows_front_exactly(surface.placed[i]);
  return count;
}

// The snap moves each coordinate by an error of variance q^2/12, q = 1/256 px, so that twice the area gets one of variance
// q^2/12 times the sum of the squared edges. A face whose area is -a shows its front then with probability Phi(-a/sigma).
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

// The number of faces to expect.
double predicted_wrong(const Surface& surface, const Test& test) {
  Keep keep(surface.modelled.size());
  test(surface, keep);
  double sum = 0;
  for (std::size_t i = 0; i < keep.size(); ++i)
    sum += keep[i] ? 0 : chance_to_turn(surface.placed[i]);
  return std::round(sum);  // faces are whole
}

void cull_and_set_up(const Surface& surface, const Test& test, Keep& keep) {
  test(surface, keep);
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    const auto setup = setup_triangle(surface.placed[i]);
    keep[i] = setup.has_value() && !setup->clockwise;
  }
}

// ---- scenes ----

Configuration configuration(const std::string& series, const std::string& scene,
                            const std::shared_ptr<const Surface>& surface, const Test& test,
                            double predicted) {
  const auto keep = std::make_shared<Keep>(surface->modelled.size());
  return {.series = series,
          .parameter = double(surface->modelled.size()),
          .scene = scene,
          .error = [=] { return wrongly_culled(*surface, test); },
          .predicted_error = predicted,
          .work = [=](int) { cull_and_set_up(*surface, test, *keep); },
          .items = double(surface->modelled.size())};
}

void add_surface(const std::string& scene, const std::shared_ptr<const Surface>& surface,
                 std::vector<Configuration>& all) {
  const auto clusters = std::make_shared<const std::vector<Cluster>>(make_clusters(*surface));
  const Test cones = [clusters](const Surface& s, Keep& keep) {
    keep_by_cones(s, *clusters, keep);
  };
  all.push_back(configuration("none", scene, surface, keep_all, 0));
  all.push_back(configuration("object-space dot product, float", scene, surface, keep_by_dot,
                              predicted_wrong(*surface, keep_by_dot)));
  all.push_back(configuration("snapped area", scene, surface, keep_by_area, 0));
  all.push_back(
      configuration("cluster cones", scene, surface, cones, predicted_wrong(*surface, cones)));
  all.push_back(
      configuration("filter, exact fallback, margin", scene, surface, keep_by_exact_test, 0));
}

std::shared_ptr<const Surface> ellipsoid(const Grid& grid) {
  const BenchScene bench = make_ellipsoid_scene("ellipsoid", grid, kSide, kSide);
  return make_surface(bench.scene, bench.passes.front().view);
}

std::shared_ptr<const Surface> teapot() {
  const Scene scene = make_builtin("teapot").value();
  return make_surface(scene, make_view(frame(scene, 1).value(), kSide, kSide).value());
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  add_surface("teapot", teapot(), all);
  add_surface("ellipsoid of a scan's size", ellipsoid(kScannedGrid), all);
  if (effort == Effort::kFull)
    add_surface("ellipsoid of a million triangles", ellipsoid(kFineGrid), all);
  return all;
}

}  // namespace

Experiment d09_culling() {
  return {
      .id = "D-9",
      .name = "Back faces: where they are found out",
      .question = "What is gained by throwing back faces away early, and is anything lost?",
      .axis = "triangles of the mesh",
      .error = "faces thrown away although their snapped triangle shows its front",
      .error_unit = "faces",
      .reference =
          "the sign of the snapped triangle's area, which decides what is drawn, in 128 bits",
      .theory =
          "An exact test in object space does not see the snap, which turns a face of twice the "
          "area -a with probability Phi(-a/sigma), sigma^2 = sum |edge|^2/(12 256^2): the sum over "
          "all that are thrown away. With a margin for the snap: 0. Half the faces of a closed "
          "surface are backs, so at most half of the set-up is saved.",
      .item = "triangle",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
