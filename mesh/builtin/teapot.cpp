#include <glassbox/mesh/builtin/teapot.h>

#include <map>

#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>
#include <glassbox/mesh/builtin/teapot_data.h>

namespace glassbox {
namespace {

using Vec = Vector<Object, double>;

// ---- cubic Bezier curves at the fractions i/n ----

// The Bernstein polynomials (1-t)^3, 3t(1-t)^2, 3t^2(1-t) and t^3 at t = i/n. They are computed
// from integers, so that they are exactly (1, 0, 0, 0) at t = 0, and so that t and 1 - t give the
// same four numbers in opposite order.
std::array<double, 4> bernstein(int i, int n) {
  const double a = n - i, b = i, whole = double(n) * n * n;
  return {a * a * a / whole, 3 * (a * a * b) / whole, 3 * (a * b * b) / whole, b * b * b / whole};
}

// The outer two terms are added first, then the inner two. A curve that is run through backwards
// only exchanges the terms within each of these sums, so two patches with a common border get the
// same positions on it.
Vec weighted(const std::array<double, 4>& weight, const std::array<Vec, 4>& p) {
  return (p[0] * weight[0] + p[3] * weight[3]) + (p[1] * weight[1] + p[2] * weight[2]);
}

// A third of the curve's derivative at i/n: a quadratic curve whose control points are the
// differences of neighbouring control points.
Vec tangent(int i, int n, const std::array<Vec, 4>& p) {
  const double a = n - i, b = i, whole = double(n) * n;
  return (p[1] - p[0]) * (a * a / whole) + (p[2] - p[1]) * (2 * (a * b) / whole) +
         (p[3] - p[2]) * (b * b / whole);
}

// ---- one patch ----

struct Patch {
  std::array<std::array<Vec, 4>, 4> rows;  // in a space with y up

  explicit Patch(const TeapotPatch& indices) {
    for (std::size_t i = 0; i < 16; ++i) {
      const auto& p = kTeapotPoints[indices[i]];
      rows[i / 4][i % 4] = Vec(p[0], p[2], 0 - p[1]);  // from z up to y up: a quarter turn about x
    }
  }

  bool starts_at_pole() const {
    return rows[0][0] == rows[0][1] && rows[0][1] == rows[0][2] && rows[0][2] == rows[0][3];
  }

  // Evaluates each row of control points at u = i/n. The results are the four control points of the
  // curve along v.
  std::array<Vec, 4> across(int i, int n) const {
    const auto weight = bernstein(i, n);
    return {weighted(weight, rows[0]), weighted(weight, rows[1]), weighted(weight, rows[2]),
            weighted(weight, rows[3])};
  }
  std::array<Vec, 4> tangents_across(int i, int n) const {
    return {tangent(i, n, rows[0]), tangent(i, n, rows[1]), tangent(i, n, rows[2]),
            tangent(i, n, rows[3])};
  }

  Vec position(int i, int j, int n) const {
    if (j == 0 && starts_at_pole()) return rows[0][0];
    return weighted(bernstein(j, n), across(i, n));
  }

  // The normal dS/du x dS/dv of the surface S(u, v). At a pole (v = 0), dS/du is zero, and d2S/dudv
  // is used instead: near the pole dS/du is, to first order, v times that derivative.
  Vec normal(int i, int j, int n) const {
    const std::array<Vec, 4> du = tangents_across(i, n);
    const Vec along_v = tangent(j, n, across(i, n));
    if (j == 0 && starts_at_pole()) return cross(du[1] - du[0], along_v);
    return cross(weighted(bernstein(j, n), du), along_v);
  }
};

// ---- the whole ----

class Tessellator {
public:
  explicit Tessellator(int level)
      : n_(level), corner_(std::size_t(level + 1) * std::size_t(level + 1)) {
    mesh_.name = "teapot";
  }

  Mesh run() {
    for (const TeapotPatch& indices : kTeapotPatches) add_patch(Patch(indices));
    return std::move(mesh_);
  }

private:
  void add_patch(const Patch& patch) {
    for (int j = 0; j <= n_; ++j) {
      for (int i = 0; i <= n_; ++i) corner_[index(i, j)] = add_corner(patch, i, j);
    }
    for (int j = 0; j < n_; ++j) {
      for (int i = 0; i < n_; ++i) {
        add_triangle(corner_[index(i, j)], corner_[index(i + 1, j + 1)], corner_[index(i, j + 1)]);
        const bool at_pole = j == 0 && patch.starts_at_pole();
        if (!at_pole)
          add_triangle(corner_[index(i, j)], corner_[index(i + 1, j)],
                       corner_[index(i + 1, j + 1)]);
      }
    }
  }

  Corner add_corner(const Patch& patch, int i, int j) {
    const Vec p = patch.position(i, j, n_);
    const bool inner = i > 0 && i < n_ && j > 0 && j < n_;
    return {inner ? add_position(mesh_, p.x, p.y, p.z) : border_position(p),
            add_normal(mesh_, patch.normal(i, j, n_)),
            add_texcoord(mesh_, double(i) / n_, double(j) / n_), kNone};
  }

  // Returns the index of the position p on the border of a patch. Neighbouring patches share it.
  std::uint32_t border_position(const Vec& p) {
    const std::array<float, 3> key = {float(p.x), float(p.y), float(p.z)};
    const auto [entry, is_first] = border_.try_emplace(key, 0);
    if (is_first) entry->second = add_position(mesh_, p.x, p.y, p.z);
    return entry->second;
  }

  void add_triangle(const Corner& a, const Corner& b, const Corner& c) {
    const std::array<Corner, 3> corners = {a, b, c};
    add_face(mesh_, corners);
  }

  std::size_t index(int i, int j) const {
    return std::size_t(j) * std::size_t(n_ + 1) + std::size_t(i);
  }

  int n_;
  Mesh mesh_;
  std::vector<Corner> corner_;  // the corners of the current patch
  std::map<std::array<float, 3>, std::uint32_t> border_;
};

}  // namespace

Mesh tessellate_teapot(int level) {
  return Tessellator(level).run();
}

Scene make_teapot(int level) {
  Scene scene;
  scene.name = "teapot";
  const std::uint32_t glaze = add_material(scene, "glaze", {0.56f, 0.13f, 0.05f, 1});
  scene.materials[glaze].specular = {0.45f, 0.45f, 0.45f};
  scene.materials[glaze].shininess = 64;
  scene.materials[glaze].double_sided = true;  // the open rim and spout show the inside
  Mesh mesh = tessellate_teapot(level);
  mesh.material = glaze;
  add_object(scene, std::move(mesh));
  add_directional(scene, "key", {-0.6, -1, -0.7}, 2.4);
  add_directional(scene, "fill", {1, -0.25, -0.5}, 0.7, {0.75f, 0.85f, 1});
  return scene;
}

}  // namespace glassbox
