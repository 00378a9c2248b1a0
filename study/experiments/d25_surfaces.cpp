// Compares marching-cubes tables and tetrahedra: which leave holes, how many triangles they make,
// and how much volume they lose (D-25).
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include <glassbox/base/random.h>

#include "study/experiment/experiment.h"
#include "study/experiments/do_not_optimize.h"
#include "study/experiments/memoize.h"
#include "views/polygons/mesh_check.h"
#include "views/polygons/polygonise.h"

namespace glassbox::study {
namespace d25 {

using views::Polygoniser;
using views::ScalarField;
using views::Vector3d;

constexpr const char *kHoles = "holes", *kTriangles = "triangles";
constexpr double kPi = std::numbers::pi;
constexpr Polygoniser kAll[] = {Polygoniser::kNaive, Polygoniser::kConsistent, Polygoniser::kSaddle,
                                Polygoniser::kTetrahedra};

std::string series_of(Polygoniser polygoniser) {
  switch (polygoniser) {
    case Polygoniser::kNaive:
      return "fifteen cases";
    case Polygoniser::kConsistent:
      return "one rule for every ambiguous face";
    case Polygoniser::kSaddle:
      return "the side of the saddle point on each face";
    case Polygoniser::kTetrahedra:
      return "six tetrahedra";
  }
  return {};
}

// ---- solids whose volume is known; depth is the distance from the surface, positive inside ----

struct Solid {
  std::string name;
  double size;          // half of the lattice's width at scale 1
  double volume, area;  // at scale 1; they grow with the third and second power of scale
  double lost;          // (1 - V / V_exact) times the square of the scale
  std::function<double(const Vector3d& p, double scale)> depth;
};

const std::vector<Solid>& solids() {
  // On average over a cell, linear interpolation of a function f along the lattice is too low by
  // h^2/12 times the sum of the second derivatives of f (h: the distance of two lattice points). If
  // f is a distance from a surface, that sum is the sum of the surface's curvatures k1 + k2. So a
  // solid loses h^2/12 times the integral of k1 + k2 over its surface: 8 pi r for a sphere, 4 pi^2
  // R for a torus with any tube.
  static const std::vector<Solid> all{
      {"sphere", 1.0, 4 * kPi / 3, 4 * kPi, 8 * kPi / 12 / (4 * kPi / 3),
       [](const Vector3d& p, double scale) { return scale - p.norm(); }},
      // The unit is the radius of the tube; the radius of the ring is 2.5.
      {"torus", 3.5, 2.5 * 2 * kPi * kPi, 2.5 * 4 * kPi * kPi,
       4 * kPi * kPi * 2.5 / 12 / (2.5 * 2 * kPi * kPi), [](const Vector3d& p, double scale) {
         return scale - std::hypot(std::hypot(p.x(), p.y()) - 2.5 * scale, p.z());
       }}};
  return all;
}

// Makes the lattice of a solid that is turned and whose centre is anywhere in a cell.
ScalarField field_of(const Solid& solid, double scale, const Vector3d& middle) {
  const int count = int(std::ceil(2 * solid.size * scale)) + 4;
  ScalarField field(count, count, count);
  const Vector3d centre = Vector3d::Constant((count - 1) / 2.0) + middle;
  // The rotation with the rows (1, 2, 2)/3, (2, 1, -2)/3, (2, -2, 1)/3, which needs no irrational
  // entries.
  views::Matrix3d turn;
  turn << 1, 2, 2, 2, 1, -2, 2, -2, 1;
  turn /= 3;
  for (int z = 0; z < count; ++z) {
    for (int y = 0; y < count; ++y) {
      for (int x = 0; x < count; ++x)
        field.at(x, y, z) = solid.depth(turn * (Vector3d(x, y, z) - centre), scale);
    }
  }
  return field;
}

struct Surfaces {
  double lost = 0;       // mean fraction of the volume
  double triangles = 0;  // per square lattice unit of the true surface
};

Surfaces surfaces_of(const Solid& solid, double scale, Polygoniser polygoniser, int places) {
  Random random(25);
  Surfaces mean;
  for (int i = 0; i < places; ++i) {
    const Vector3d middle{random.between(-0.5, 0.5), random.between(-0.5, 0.5),
                          random.between(-0.5, 0.5)};
    const views::PolygonMesh mesh =
        views::polygonise(field_of(solid, scale, middle), 0, polygoniser);
    mean.lost +=
        (1 - views::check_mesh(mesh).volume / (solid.volume * std::pow(scale, 3))) / places;
    mean.triangles += double(mesh.polygons.size()) / (solid.area * scale * scale) / places;
  }
  return mean;
}

// Predicts the number of triangles per unit of area. A mesh has as many corners as there are
// crossed lattice edges: a surface of area 1 with normal n crosses |n . e| edges of each direction
// e, whose mean over all n is half of the length of e. It has twice as many triangles as corners.
// Cubes have three directions of length 1; tetrahedra also have three of sqrt(2) and one of
// sqrt(3).
double predicted_triangles(Polygoniser polygoniser) {
  if (polygoniser == Polygoniser::kTetrahedra)
    return 3 + 3 * std::numbers::sqrt2 + std::numbers::sqrt3;
  return 3;
}

void add_solid(const Solid& solid, double scale, Polygoniser polygoniser, int places,
               std::vector<Configuration>& all) {
  const auto surfaces =
      memoize([=, &solid] { return surfaces_of(solid, scale, polygoniser, places); });
  const auto field =
      std::make_shared<const ScalarField>(field_of(solid, scale, Vector3d(0.1, 0.2, 0.3)));
  all.push_back({.series = series_of(polygoniser),
                 .parameter = scale,
                 .scene = solid.name,
                 .error = [=] { return std::abs(surfaces().lost); },
                 .predicted_error = solid.lost / (scale * scale),
                 .work = [=](int) { do_not_optimize(views::polygonise(*field, 0, polygoniser)); },
                 .items = double(field->values.size())});
  all.push_back({.series = series_of(polygoniser),
                 .parameter = scale,
                 .scene = solid.name,
                 .measure = kTriangles,
                 .error = [=] { return surfaces().triangles; },
                 .predicted_error = predicted_triangles(polygoniser)});
}

// ---- random fields ----

constexpr int kSide = 9;  // corners of a random field

// A field in which each corner is inside the solid with the probability `share`.
ScalarField random_field(double share, Random& random) {
  ScalarField field(kSide, kSide, kSide);
  for (double& value : field.values)
    value = random.between(0, 1) < share ? random.between(0.1, 1) : random.between(-1, -0.1);
  return field;
}

// The number of open edges (which only one triangle has) per face of the lattice.
double holes_of(double share, Polygoniser polygoniser, int fields) {
  Random random(250);
  double holes = 0;
  for (int i = 0; i < fields; ++i) {
    const views::MeshCheck check =
        views::check_mesh(views::polygonise(random_field(share, random), 0, polygoniser));
    holes += double(check.holes + check.non_manifold_edges);
  }
  return holes / (3.0 * kSide * (kSide - 1) * (kSide - 1) * fields);
}

// The naive table leaves a hole of four open edges where two cells treat an ambiguous face
// differently. A face is ambiguous with the probability 2 p^2 q^2 (p: a corner is inside; q = 1 -
// p). A cell treats it differently if more than four of its corners are inside: two on this face,
// and three or four of the other four. A hole appears if this is true for one of the two cells at
// the face and not for the other; beyond the lattice it is never true.
double predicted_holes(double p, Polygoniser polygoniser) {
  if (polygoniser != Polygoniser::kNaive) return 0;
  const double q = 1 - p, more = 4 * p * p * p * q + p * p * p * p;
  const double within = double(kSide - 2) / kSide, beside = 2.0 / kSide;
  return 4 * 2 * p * p * q * q * (within * 2 * more * (1 - more) + beside * more);
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<Configuration> all;
  const bool is_full = effort == Effort::kFull;
  for (const Polygoniser polygoniser : kAll) {
    for (const Solid& solid : solids()) {
      for (const double scale : {2.0, 3.0, 4.0, 6.0})
        add_solid(solid, scale, polygoniser, is_full ? 24 : 8, all);
    }
    if (is_full) {
      for (const double scale : {8.0, 12.0, 16.0})
        add_solid(solids()[0], scale, polygoniser, 8, all);
    }
    for (const double share : {0.3, 0.5, 0.7, 0.9}) {
      Random random(251);
      const auto field = std::make_shared<const ScalarField>(random_field(share, random));
      all.push_back(
          {.series = series_of(polygoniser),
           .parameter = share,
           .scene = "random fields",
           .measure = kHoles,
           .error = [=] { return holes_of(share, polygoniser, is_full ? 200 : 40); },
           .predicted_error = predicted_holes(share, polygoniser),
           .work = [=](int) { do_not_optimize(views::polygonise(*field, 0, polygoniser)); },
           .items = double(field->values.size())});
    }
  }
  return all;
}

}  // namespace d25

Experiment d25_surfaces() {
  using namespace d25;
  return {
      .id = "D-25",
      .name = "Marching cubes: which table of cases",
      .question =
          "Which way of making a surface around a solid leaves no holes, and what does it cost?",
      .axis = "radius, in cells",
      .error = "volume that a solid loses, as a fraction of its volume",
      .reference = "the solid's formula; the torus has a ring of 2.5 times its tube's radius",
      .theory =
          "linear interpolation of a distance loses h^2/12 times the integral of k1 + k2 over the "
          "surface (S1-39 in docs/references.md), where h is the size of a cell and k1 and k2 are "
          "the principal curvatures: (h/r)^2/2 of the volume of a sphere of radius r, (h/a)^2/6 of "
          "a torus whose tube has the radius a. There are twice as many triangles as crossed "
          "edges: 3/2 crossed edges for each square of a cell, (3 + 3 sqrt 2 + sqrt 3)/2 with the "
          "diagonals of tetrahedra. The fifteen cases leave four open edges on an ambiguous face "
          "if one of its cells has more than four corners inside and the other has not",
      .item = "corner of the lattice",
      .measures = {{.name = kTriangles,
                    .error = "triangles for each square of a cell's side of the true surface",
                    .error_unit = ""},
                   {.name = kHoles,
                    .error = "edges that are not in two triangles, for each face of the lattice",
                    .error_unit = "",
                    .axis = "fraction of the lattice's corners that are inside",
                    .logarithmic_axis = false}},
      .configurations = configurations};
}

}  // namespace glassbox::study
