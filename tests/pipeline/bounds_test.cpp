// The error bounds of pipeline/bounds.h, compared with exact arithmetic: every error is within its
// bound, and no bound is more than 100 times the largest error seen. 10^6 vertices altogether. The
// ratios are printed, and docs/step.md lists them.
#include <glassbox/pipeline/bounds.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/divide.h>
#include <glassbox/pipeline/vertex_chain.h>

#include <glassbox/base/random.h>
#include "tests/pipeline/dyadic.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

using test::Dyadic;

std::string page_of_docs() {
  std::ifstream page(GLASSBOX_SOURCE_DIR "/docs/step.md");
  return {std::istreambuf_iterator<char>(page), {}};
}

// The largest error in units of its bound; where the bound is 0, the error must be 0.
class Worst {
public:
  explicit Worst(const char* name) : name_(name) {}
  void record(double error, double bound) {
    ++count_;
    if (!(error <= bound)) ++broken_;
    if (bound > 0) ratio_ = std::max(ratio_, error / bound);
  }
  // Fails if an error exceeded its bound, or if the largest error was below a hundredth of the
  // bound.
  void check() const {
    char line[160];
    std::snprintf(line, sizeof line, "  %-40s %8d numbers, largest error / bound = %.3f\n", name_,
                  count_, ratio_);
    std::fputs(line, stdout);
    CAPTURE(name_, count_, broken_, ratio_);
    CHECK(broken_ == 0);
    CHECK(ratio_ >= 0.01);
    CHECK(page_of_docs().find(line) != std::string::npos);
  }

private:
  const char* name_;
  int count_ = 0, broken_ = 0;
  double ratio_ = 0;
};

using Exact = std::array<Dyadic, 4>;

Exact exactly(const glm::vec4& v) {
  return {Dyadic(v.x), Dyadic(v.y), Dyadic(v.z), Dyadic(v.w)};
}

Exact exact_product(const glm::mat4& m, const Exact& v) {
  Exact product;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const float entry = m[int(column)][int(row)];
      if (entry != 0) product[row] = product[row] + Dyadic(entry) * v[column];
    }
  }
  return product;
}

double error_of(float value, const Dyadic& exact) {
  return (Dyadic(value) - exact).size();
}

// |value - x/w|. The two roundings to double are negligible beside those of float.
double error_of_quotient(double value, const Dyadic& x, const Dyadic& w) {
  return (Dyadic(value) * w - x).size() / w.size();
}

// One random number per statement, because compilers evaluate the arguments of a call in different
// orders.
glm::vec4 random_point(Random& random, double size) {
  glm::vec4 point(1);
  for (const int k : {2, 1, 0}) point[k] = float(random.between(-size, size));
  return point;
}

float random_of_any_size(Random& random, int least_exponent) {
  const int exponent = int(random.integer(least_exponent, 30));
  return float(std::ldexp(random.between(-1, 1), exponent));
}

glm::mat4 random_affine(Random& random, double offset) {
  glm::mat4 m(1);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) m[column][row] = float(random.between(-1, 1));
    m[3][row] = float(random.between(-offset, offset));
  }
  return m;
}

glm::mat4 random_perspective(Random& random) {
  glm::mat4 m(0);
  m[0][0] = float(random.between(0.2, 5));
  m[1][1] = float(random.between(0.2, 5));
  m[2][0] = float(random.between(-0.5, 0.5));
  m[2][2] = -float(random.between(1, 1.1));
  m[3][2] = -float(random.between(0.01, 1));
  m[2][3] = -1;
  return m;
}

glm::mat4 random_parallel(Random& random) {
  glm::mat4 m(1);
  for (int i = 0; i < 3; ++i) {
    m[i][i] = float(random.between(-0.5, 0.5));
    m[3][i] = float(random.between(-1, 1));
  }
  return m;
}

struct Ratios {
  Worst world{"world"}, eye{"eye, bounds handed on"}, clip{"clip x, y, z, bounds handed on"},
      clip_w{"clip w"}, ndc{"NDC, after the divide"}, inverse_w{"1/w"}, x{"window x"},
      y{"window y"};
  int stable = 0, unstable = 0, wrongly_stable = 0;
};

// Compares a vertex in all spaces with its exact positions.
void compare(const glm::vec4& object, const ChainMatrices& matrices, const Viewport& viewport,
             Ratios& ratios) {
  const VertexChain chain = make_vertex_chain(object, matrices, api_dialects().front(), viewport);
  const Exact world = exact_product(matrices.world_from_object.columns, exactly(object));
  const Exact eye = exact_product(matrices.eye_from_world.columns, world);
  const Exact clip = exact_product(matrices.clip_from_eye.columns, eye);
  for (std::size_t i = 0; i < 3; ++i) {
    const int k = int(i);
    ratios.world.record(error_of(chain.to_world.after[k], world[i]), chain.to_world.bound[k]);
    ratios.eye.record(error_of(chain.to_eye.after[k], eye[i]), chain.to_eye.bound[k]);
    ratios.clip.record(error_of(chain.to_clip.after[k], clip[i]), chain.to_clip.bound[k]);
  }
  ratios.clip_w.record(error_of(chain.clip.w, clip[3]), chain.to_clip.bound.w);
  if (!chain.divide || clip[3].is_zero() || !std::isfinite(chain.divide->bound.inverse_w)) return;

  const DivideStep& d = *chain.divide;
  const float ndc[] = {d.ndc.position.x, d.ndc.position.y, d.ndc.position.z};
  for (std::size_t i = 0; i < 3; ++i) {
    ratios.ndc.record(error_of_quotient(double(ndc[i]), clip[i], clip[3]),
                      d.bound.position[int(i)]);
  }
  ratios.inverse_w.record(error_of_quotient(double(d.ndc.inverse_w), Dyadic(1), clip[3]),
                          d.bound.inverse_w);

  // Twice the window coordinate, times w: x (to - from) + w (to + from).
  const auto twice_window = [&](const Dyadic& x, float from, float to) {
    return x * (Dyadic(to) - Dyadic(from)) + clip[3] * (Dyadic(to) + Dyadic(from));
  };
  const Dyadic twice_w = clip[3] * Dyadic(2);
  const Dyadic exact_x = twice_window(clip[0], viewport.left, viewport.right);
  const Dyadic exact_y = twice_window(clip[1], viewport.bottom, viewport.top);
  const ScreenStep& s = *chain.screen;
  ratios.x.record(error_of_quotient(double(s.screen.position.x), exact_x, twice_w), s.bound.x);
  ratios.y.record(error_of_quotient(double(s.screen.position.y), exact_y, twice_w), s.bound.y);

  // Snapping is floor(256 X + 1/2) / 256: the exact X is in [snapped - 1/512, snapped + 1/512).
  const auto snaps_there = [&](const SnapStability& snap, const Dyadic& exact) {
    const double sign = twice_w.value() > 0 ? 1 : -1;
    const double low = (exact - Dyadic(snap.snapped - 0x1p-9) * twice_w).value() * sign;
    const double high = (exact - Dyadic(snap.snapped + 0x1p-9) * twice_w).value() * sign;
    return low >= 0 && high < 0;
  };
  for (const auto& [snap, exact] : {std::pair{s.snap_x, exact_x}, std::pair{s.snap_y, exact_y}}) {
    ++(snap.stable ? ratios.stable : ratios.unstable);
    ratios.wrongly_stable += snap.stable && !snaps_there(snap, exact);
  }
}

TEST_CASE("every number on a vertex's way lies within its bound, and no bound is idle") {
  const std::uint64_t seed = 401;
  INFO("seed " << seed);
  Random random(seed);
  Ratios ratios;
  const Viewport viewports[] = {{0, 0, 1366, 768}, {0, 480, 640, 0}, {0.1f, 0.7f, 1000.3f, 33.3f}};
  ChainMatrices matrices;
  constexpr int kVertices = 700000;
  for (int i = 0; i < kVertices; ++i) {
    if (i % 16 == 0) {
      const double offset = i % 32 == 0 ? 1 : 1000;
      matrices.world_from_object.columns = random_affine(random, offset);
      matrices.eye_from_world.columns = random_affine(random, offset);
      matrices.clip_from_eye.columns =
          i % 48 == 0 ? random_parallel(random) : random_perspective(random);
    }
    const double size = i % 3 == 0 ? 1000 : 1;
    compare(random_point(random, size), matrices, viewports[i % 3], ratios);
  }
  std::printf("bounds 1 to 3 over %d vertices, seed %d:\n", kVertices, int(seed));
  for (const Worst* worst : {&ratios.world, &ratios.eye, &ratios.clip, &ratios.clip_w, &ratios.ndc,
                             &ratios.inverse_w, &ratios.x, &ratios.y}) {
    worst->check();
  }
  CAPTURE(ratios.stable, ratios.unstable);
  CHECK(ratios.wrongly_stable == 0);
  CHECK(ratios.stable > kVertices / 10);
  CHECK(ratios.unstable > 1000);
}

TEST_CASE(
    "a single matrix, as `render` applies it: composed in double, rounded once, both bounds") {
  const std::uint64_t seed = 402;
  INFO("seed " << seed);
  Random random(seed);
  Worst transform("M x, M as it is"), composed("M x, M a rounded product of doubles");
  constexpr int kVertices = 200000;
  glm::dmat4 a(1), b(1), product(1), product_error(0);
  for (int i = 0; i < kVertices; ++i) {
    if (i % 16 == 0) {
      a = glm::dmat4(random_perspective(random));
      b = glm::dmat4(random_affine(random, 1000));
      product = (Transform<Clip, Eye>(a) * Transform<Eye, Object>(b)).columns;
      product_error = product_bound(a, b) + rounding_bound(product);
    }
    const glm::mat4 m(product);
    const glm::vec4 v = random_point(random, 9);
    const glm::vec4 computed = transform_by_rows(m, v);
    const glm::dvec4 bound = transform_bound(m, v);
    const glm::dvec4 with_product = transform_bound(m, v, glm::dvec4(0), product_error);
    const Exact exact = exact_product(m, exactly(v));
    // The factors are floats, so their exact product is the intended matrix.
    const Exact meant = exact_product(glm::mat4(a), exact_product(glm::mat4(b), exactly(v)));
    for (std::size_t row = 0; row < 4; ++row) {
      const float value = computed[int(row)];
      transform.record(error_of(value, exact[row]), bound[int(row)]);
      composed.record(error_of(value, meant[row]), with_product[int(row)]);
    }
  }
  std::printf("one matrix over %d vertices, seed %d:\n", kVertices, int(seed));
  transform.check();
  composed.check();
}

TEST_CASE("bounds hold for vertices in extreme places: near the eye's plane, tiny, huge") {
  const std::uint64_t seed = 403;
  INFO("seed " << seed);
  Random random(seed);
  Worst transform("M x"), divided("x/w, w as close to 0 as its bound");
  constexpr int kVertices = 100000;
  int unknown = 0;
  for (int i = 0; i < kVertices; ++i) {
    glm::mat4 m(0);
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        m[column][row] = random_of_any_size(random, -70);
      }
    }
    glm::vec4 v;
    for (int k = 0; k < 4; ++k) {
      v[k] = random_of_any_size(random, -80);
    }
    // The terms of w cancel up to a few units of rounding.
    if (i % 2 == 0) m[3][3] = -(m[0][3] * v.x + m[1][3] * v.y + m[2][3] * v.z) / v.w;
    const Point<Clip> clip(transform_by_rows(m, v));
    // The bounds do not cover overflow.
    if (!std::isfinite(m[3][3]) || !std::isfinite(clip.x + clip.y + clip.z + clip.w)) continue;
    const glm::dvec4 bound = transform_bound(m, v);
    const Exact exact = exact_product(m, exactly(v));
    const float values[] = {clip.x, clip.y, clip.z, clip.w};
    for (std::size_t row = 0; row < 4; ++row) {
      transform.record(error_of(values[row], exact[row]), bound[int(row)]);
    }
    const DivideBound quotient = divide_bound(clip, bound);
    if (clip.w == 0 || !std::isfinite(quotient.inverse_w)) {
      ++unknown;
      continue;
    }
    REQUIRE_FALSE(exact[3].is_zero());
    const NdcVertex ndc = divide(clip);
    if (!std::isfinite(ndc.position.x)) continue;
    divided.record(error_of_quotient(double(ndc.position.x), exact[0], exact[3]),
                   quotient.position.x);
  }
  std::printf("extreme places over %d vertices, seed %d:\n", kVertices, int(seed));
  transform.check();
  divided.check();
  CHECK(unknown > 1000);
}

TEST_CASE("what is exact has the bound 0") {
  // w of a perspective matrix is -z, that of a parallel one is 1; the products with 0 and 1 add no
  // rounding. z is a sum, which may round.
  const glm::mat4 perspective = [] {
    glm::mat4 m(0);
    m[0][0] = 1, m[1][1] = 1, m[2][2] = -1, m[3][2] = -0.2f, m[2][3] = -1;
    return m;
  }();
  const glm::vec4 v(0.3f, 0.7f, -3.1f, 1);
  CHECK(transform_bound(perspective, v).w == 0);
  CHECK(transform_bound(perspective, v).x == 0);
  CHECK(transform_bound(perspective, v).z > 0);
  CHECK(transform_bound(glm::mat4(1), v) == glm::dvec4(0));
  const DivideBound parallel = divide_bound({0.3f, 0.7f, 0.1f, 1}, glm::dvec4(0));
  CHECK(parallel.position == glm::dvec3(0));
  CHECK(parallel.inverse_w == 0);
}

TEST_CASE("what is not known has no finite bound") {
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(divide_bound({1, 1, 1, 0.5f}, {0, 0, 0, 0.5}).position.x == inf);
  CHECK(divide_bound({1, 1, 1, 0}, glm::dvec4(0)).inverse_w == inf);
  CHECK(divide_condition({1, 1, 1, 0}, glm::dvec4(1)).x == inf);
  // An unknown input has no effect where it is multiplied by 0.
  CHECK(transform_bound(glm::mat4(1), {1, 2, 3, 1}, {inf, 0, 0, 0}) == glm::dvec4(inf, 0, 0, 0));
  CHECK(!snap_stability(std::numeric_limits<float>::quiet_NaN(), 0).stable);
  CHECK(!snap_stability(1.5f, inf).stable);
}

TEST_CASE("the divide's condition is what a small relative change of the entries does") {
  // x/w = (m_x . v)/(m_w . v): scaling every entry of m_x up and of m_w down by (1 +- e) changes it
  // by about condition * e.
  const glm::mat4 m = [] {
    glm::mat4 entries(0);
    entries[0][0] = 2, entries[2][0] = 0.5f, entries[3][0] = -1;
    entries[2][3] = -1, entries[3][3] = 0.25f;
    entries[2][2] = 1;
    return entries;
  }();
  const glm::vec4 v(0.7f, 0, -2.5f, 1);
  const Point<Clip> clip(transform_by_rows(m, v));
  const double condition = divide_condition(clip, magnitude(glm::dmat4(m), glm::dvec4(v))).x;
  const double e = 0x1p-30, ndc = double(clip.x) / double(clip.w);
  // Every entry is changed so that its term changes x/w in the same direction.
  double x = 0, w = 0;
  for (int k = 0; k < 4; ++k) {
    const double in_x = double(m[k][0]) * double(v[k]), in_w = double(m[k][3]) * double(v[k]);
    x += in_x + std::abs(in_x) * e;
    w += in_w - std::abs(in_w) * e * (ndc > 0 ? 1 : -1);
  }
  CHECK(std::abs(x / w - ndc) == Approx(condition * e).epsilon(1e-6));
}

TEST_CASE("snapping is stable exactly when the bound does not reach a boundary") {
  // Cells have their boundaries at (k - 1/2)/256.
  CHECK(snap_stability(10, 0.001).snapped == 10);
  CHECK(snap_stability(10, 0.0019).stable);
  CHECK_FALSE(snap_stability(10, 0.002).stable);
  CHECK(snap_stability(10, 0).to_boundary == 0.5 / 256);
  // On a boundary a half is rounded up, and the result is not stable.
  const float boundary = 10 + 0.5f / 256;
  CHECK(snap_stability(boundary, 0).snapped == 10 + 1.0 / 256);
  CHECK_FALSE(snap_stability(boundary, 0).stable);
  CHECK(snap_stability(-0.001f, 0).snapped == 0);
  CHECK(snap_stability(-0.003f, 0).snapped == -1.0 / 256);
}

}  // namespace
}  // namespace glassbox
