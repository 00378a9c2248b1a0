// Compares our matrices with those of Mesa's GLU, the reference implementation of the functions
// that S4 names. gluLookAt and gluPerspective work on the current OpenGL context; OSMesa gives one
// without a display.
#include <tests/pipeline/cameras.h>
#include <tests/pipeline/roundoff.h>
#include <tests/support/catch.h>
#include <tests/support/mesa_leaks.h>

#include <GL/osmesa.h>

#include <GL/glu.h>

#include <array>
#include <cmath>
#include <vector>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/projection.h>

namespace glassbox {
namespace {

using test::LensCase;
using test::LookAtCase;

using test::ud, test::uf;

class Context {
public:
  Context() : context_(OSMesaCreateContext(OSMESA_RGBA, nullptr)), pixels_(16 * 16 * 4) {
    REQUIRE(context_ != nullptr);
    REQUIRE(OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, 16, 16) == GL_TRUE);
    glMatrixMode(GL_MODELVIEW);
  }
  ~Context() { OSMesaDestroyContext(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

private:
  OSMesaContext context_;
  std::vector<unsigned char> pixels_;
};

template <class Call>
std::array<GLfloat, 16> matrix_after(const Call& call) {
  std::array<GLfloat, 16> m{};
  glLoadIdentity();
  call();
  glGetFloatv(GL_MODELVIEW_MATRIX, m.data());
  return m;
}

TEST_CASE(
    "10 000 random cameras agree with gluLookAt to what its float arithmetic leaves (S4-12)") {
  const Context context;
  Random random(120);
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const LookAtCase c = test::random_look_at(random);
    const auto theirs = matrix_after([&] {
      gluLookAt(c.eye.x, c.eye.y, c.eye.z, c.target.x, c.target.y, c.target.z, c.up.x, c.up.y,
                c.up.z);
    });
    const auto ours = look_at(c.eye, c.target, c.up);
    REQUIRE(ours);
    // Mesa computes in float: the gaze is rounded and normalized (5 u), up is rounded (1 u), their
    // cross product is rounded and normalized (8 u over the sine, by which it is divided), and one
    // more cross product follows. The translation multiplies these errors by -eye and adds four
    // roundings of its own.
    const double bound = (16 + 16 / c.up_sine) * uf;
    const double eye_size = std::abs(c.eye.x) + std::abs(c.eye.y) + std::abs(c.eye.z);
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        const double error =
            std::abs(double(theirs[std::size_t(4 * column + row)]) - ours->at(row, column));
        const double limit = column < 3 ? bound : (bound + 5 * uf) * eye_size;
        worst = std::max(worst, error / limit);
        CAPTURE(i, row, column, c.up_sine);
        CHECK(error <= limit);
      }
    }
  }
  CAPTURE(worst);
  CHECK(worst > 0.02);  // the tolerance is not far too large
}

TEST_CASE(
    "10 000 random lenses give gluPerspective's, glFrustum's and glOrtho's matrices to one float "
    "ulp (S4-12)") {
  const Context context;
  Random random(121);
  for (int i = 0; i < 10000; ++i) {
    const LensCase c = test::random_lens(random);
    const Window w{random.between(-2, -1), random.between(0, 1), random.between(-3, 1),
                   random.between(2, 5)};
    const DepthPlanes planes{c.near, c.far};
    const Transform<Clip, Eye> ours[] = {
        perspective_degrees(c.fovy_degrees, c.aspect, planes).value(), frustum(w, planes).value(),
        orthographic(w, planes).value()};
    const std::array<GLfloat, 16> theirs[] = {
        matrix_after([&] { gluPerspective(c.fovy_degrees, c.aspect, c.near, c.far); }),
        matrix_after([&] { glFrustum(w.left, w.right, w.bottom, w.top, c.near, c.far); }),
        matrix_after([&] { glOrtho(w.left, w.right, w.bottom, w.top, c.near, c.far); })};
    for (int kind = 0; kind < 3; ++kind) {
      const Transform<ClipGl, Eye> gl = clip_gl_from_clip() * ours[kind];
      for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
          const double exact = gl.at(row, column);
          const float value = theirs[kind][std::size_t(4 * column + row)];
          CAPTURE(i, kind, row, column, exact, value);
          if (kind == 0) {
            // Computed in double and stored in float: either both are rounded alike or one is the
            // neighbour of the other.
            CHECK(ulp_distance(float(exact), value) <= 1);
          } else {
            // Mesa first rounds the arguments to float: sums and differences err by u of their
            // terms, which `across` relates to the window's size; a few float operations follow.
            const double across =
                row == 0   ? (std::abs(w.left) + std::abs(w.right)) / (w.right - w.left)
                : row == 1 ? (std::abs(w.bottom) + std::abs(w.top)) / (w.top - w.bottom)
                           : (c.far + c.near) / (c.far - c.near);
            CHECK(std::abs(exact - double(value)) <=
                  8 * uf * across * std::max(1.0, std::abs(exact)));
          }
        }
      }
    }
  }
}

TEST_CASE(
    "10 000 random points land where gluProject puts them, y turned over and depth in 0 .. 1 "
    "(S4-12, S3-17)") {
  Random random(122);
  const int viewport[4] = {0, 0, 1280, 720};
  int compared = 0;
  for (int i = 0; i < 10000; ++i) {
    const LookAtCase c = test::random_look_at(random);
    const LensCase lens = test::random_lens(random);
    const auto view = look_at(c.eye, c.target, c.up);
    const auto projection =
        perspective_degrees(lens.fovy_degrees, lens.aspect, {lens.near, lens.far});
    REQUIRE(view);
    REQUIRE(projection);
    const Transform<ClipGl, Eye> gl = clip_gl_from_clip() * *projection;
    const Point<World, double> p =
        c.target +
        Vector<World, double>{random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)};
    const Point<Clip, double> clip = *projection * (*view * p);
    if (!(clip.w > lens.near)) continue;
    ++compared;
    GLdouble x = 0, y = 0, z = 0;
    REQUIRE(gluProject(p.x, p.y, p.z, column_major(*view).data(), column_major(gl).data(), viewport,
                       &x, &y, &z) == GL_TRUE);
    // Both matrix products in double: gamma_8 of the absolute terms each, then the division (bound
    // 2) and the viewport.
    const glm::dvec4 eye_terms = [&] {
      glm::dvec4 sum(0);
      for (int column = 0; column < 4; ++column) {
        const double size[] = {std::abs(p.x), std::abs(p.y), std::abs(p.z), 1};
        sum += glm::abs(view->columns[column]) * size[column];
      }
      return sum;
    }();
    glm::dvec4 terms(0);
    for (int column = 0; column < 4; ++column)
      terms += glm::abs(gl.columns[column]) * eye_terms[column];
    const auto ndc_bound = [&](double ndc, double term) {
      return 2 * gamma<double>(8) * (term + std::abs(ndc) * terms.w) / clip.w +
             4 * ud * (1 + std::abs(ndc));
    };
    const double ndc_x = clip.x / clip.w, ndc_y = clip.y / clip.w, depth = clip.z / clip.w;
    CAPTURE(i, ndc_x, ndc_y, depth);
    CHECK(std::abs(x - (ndc_x + 1) * 640) <= 640 * ndc_bound(ndc_x, terms.x));
    CHECK(std::abs((720 - y) - (1 - ndc_y) * 360) <= 360 * ndc_bound(ndc_y, terms.y) + 720 * ud);
    CHECK(std::abs(z - depth) <= ndc_bound(gl_depth_from_depth(depth), terms.z));
  }
  CHECK(compared > 5000);
}

}  // namespace
}  // namespace glassbox
