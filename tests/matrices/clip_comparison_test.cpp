// A program's clip positions agree with the matrices that it used, up to float, and a planted
// misuse of the matrices is named.
#include <glassbox/matrices/clip_comparison.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include "tests/matrices/textbook.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

namespace book = test::textbook;
using book::given;

MatrixSetup random_setup(Random& random) {
  MatrixSetup setup;
  setup.dialect = api_dialects().front();
  const book::Vector3 at = book::random_place(random, 3);
  setup.model = given(
      book::product(book::translation(at[0], at[1], at[2]),
                    book::product(book::turn_y(random.between(5, 80)), book::scaling(1, 2, 1.5))));
  const book::Vector3 eye = book::random_place(random, 9), target = book::random_place(random, 1);
  setup.view = given(book::look_at_right(eye, target, {0, 1, 0}));
  setup.projection = given(book::perspective_gl(random.between(0.5, 1.5), 1.5, 0.1, 100));
  return setup;
}

TableVertex vertex_at(const glm::dvec4& position, double uncertainty) {
  return {position, glm::dvec4(uncertainty), 0};
}

std::vector<TableVertex> random_vertices(Random& random) {
  std::vector<TableVertex> vertices;
  for (int i = 0; i < 12; ++i) {
    const book::Vector3 p = book::random_place(random, 2);
    vertices.push_back(vertex_at({float(p[0]), float(p[1]), float(p[2]), 1}, 0));
  }
  return vertices;
}

// What a shader computes in float, printed with five decimals.
std::vector<TableVertex> shader_output(const MatrixSetup& setup,
                                       const std::vector<TableVertex>& object) {
  const glm::mat4 mvp =
      glm::mat4(setup.projection.m) * glm::mat4(setup.view.m) * glm::mat4(setup.model.m);
  std::vector<TableVertex> clip;
  for (const TableVertex& vertex : object) {
    const glm::dvec4 position(mvp * glm::vec4(vertex.position));
    clip.push_back(vertex_at(glm::round(position * 1e5) / 1e5, 0.5e-5));
  }
  return clip;
}

bool explains(const ClipComparison& found, const std::string& id) {
  return std::ranges::any_of(found.explanations,
                             [&](const ClipExplanation& e) { return e.id == id; });
}

}  // namespace

TEST_CASE("clip positions that a shader computes agree with its matrices") {
  Random random(1);
  for (int repeat = 0; repeat < 200; ++repeat) {
    const MatrixSetup setup = random_setup(random);
    const auto object = random_vertices(random);
    const ClipComparison found =
        compare_clip_positions(setup, object, shader_output(setup, object));
    CHECK(found.compared == 12);
    CHECK(found.different == 0);
  }
}

TEST_CASE("one vertex that differs is the first difference") {
  Random random(2);
  const MatrixSetup setup = random_setup(random);
  const auto object = random_vertices(random);
  auto clip = shader_output(setup, object);
  clip[7].position.y += 0.01;
  const ClipComparison found = compare_clip_positions(setup, object, clip);
  CHECK(found.different == 1);
  REQUIRE(found.first);
  CHECK(found.first->vertex == 7);
  CHECK(found.explanations.empty());
  CHECK_FALSE(found.clip_from_object);  // no matrix gives these positions
}

TEST_CASE("a misuse of the matrices is named") {
  using Misuse = void (*)(MatrixSetup&);
  const std::pair<const char*, Misuse> misuses[] = {
      {"no-model", [](MatrixSetup& s) { s.model = {}; }},
      {"no-view", [](MatrixSetup& s) { s.view = {}; }},
      {"model-twice", [](MatrixSetup& s) { s.model.m = s.model.m * s.model.m; }},
      {"view-twice", [](MatrixSetup& s) { s.view.m = s.view.m * s.view.m; }},
      {"transpose-model", [](MatrixSetup& s) { s.model = transposed(s.model); }},
      {"transpose-view", [](MatrixSetup& s) { s.view = transposed(s.view); }},
      {"transpose-projection", [](MatrixSetup& s) { s.projection = transposed(s.projection); }},
      {"exchange-model-view", [](MatrixSetup& s) { std::swap(s.model, s.view); }},
      {"invert-view", [](MatrixSetup& s) { s.view.m = glm::inverse(s.view.m); }},
      {"reversed-order", [](MatrixSetup& s) { std::swap(s.model, s.projection); }},
      {"flip-y",
       [](MatrixSetup& s) {
         for (int c = 0; c < 4; ++c) s.projection.m[c].y *= -1;
       }},
      {"depth-to-zero-one",
       [](MatrixSetup& s) {
         for (int c = 0; c < 4; ++c) {
           s.projection.m[c].z = (s.projection.m[c].z + s.projection.m[c].w) / 2;
         }
       }},
  };
  Random random(3);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const MatrixSetup setup = random_setup(random);
    const auto object = random_vertices(random);
    for (const auto& [id, misuse] : misuses) {
      CAPTURE(id, repeat);
      MatrixSetup used = setup;
      misuse(used);
      const ClipComparison found =
          compare_clip_positions(setup, object, shader_output(used, object));
      CHECK(found.different > 0);
      CHECK(explains(found, id));
    }
  }
}

TEST_CASE("another matrix than the given ones is found from the positions") {
  Random random(4);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const MatrixSetup setup = random_setup(random), other = random_setup(random);
    const auto object = random_vertices(random);
    const ClipComparison found =
        compare_clip_positions(setup, object, shader_output(other, object));
    CHECK(found.explanations.empty());
    REQUIRE(found.clip_from_object);
    const glm::dmat4 expected = other.projection.m * other.view.m * other.model.m;
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 4; ++row) {
        // Positions have half a unit of the fifth decimal, and vertices lie within 2 of the origin.
        CHECK(std::abs((*found.clip_from_object)[column][row] - expected[column][row]) < 1e-4);
      }
    }
  }
}

}  // namespace glassbox
