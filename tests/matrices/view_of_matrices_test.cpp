// The view of somebody else's matrices gives their clip coordinates, whatever their conventions. A
// scene drawn with the matrices of our own camera, converted to any of them, has the same bytes.
#include <glassbox/matrices/view_of_matrices.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/affine.h>
#include <glassbox/render/staged/staged.h>
#include "tests/matrices/textbook.h"
#include "tests/support/catch.h"

namespace glassbox {
namespace {

namespace book = test::textbook;
using book::Rows;

constexpr int kWidth = 96, kHeight = 64;
constexpr double kAspect = double(kWidth) / kHeight;

// The rows in double, as they are.
GivenMatrix exactly(const Rows& rows) {
  GivenMatrix matrix;
  matrix.given = true;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      matrix.m[column][row] = rows[std::size_t(row)][std::size_t(column)];
    }
  }
  return matrix;
}

MatrixSetup setup_for(const char* dialect, const GivenMatrix& view, const GivenMatrix& projection) {
  OwnMatrices own;
  own.dialect = find_dialect(dialect);
  own.view = view;
  own.projection = projection;
  return setup_of(own).setup;
}

MatrixView made(const MatrixSetup& setup, DepthRange range = DepthRange::kStandard) {
  const auto view = view_of_matrices(setup, kWidth, kHeight, range);
  REQUIRE(view);
  return *view;
}

struct BookCamera {
  book::Vector3 eye, at;
  double fovy = 1, near = 0.5, far = 40;
};

BookCamera random_camera(Random& random) {
  BookCamera camera;
  camera.eye = {random.between(3, 6), random.between(-3, 3), random.between(-6, 6)};
  camera.at = book::random_place(random, 0.5);
  camera.fovy = random.between(0.4, 1.2);
  return camera;
}

// The matrices of one camera in every convention of the textbook, and some that are used wrongly
// but draw something.
std::vector<MatrixSetup> conventions_of(const BookCamera& c) {
  const book::Vector3 up{0, 1, 0};
  const Rows right = book::look_at_right(c.eye, c.at, up),
             left = book::look_at_left(c.eye, c.at, up);
  const Rows gl = book::perspective_gl(c.fovy, kAspect, c.near, c.far);
  const auto setup = [](const char* dialect, const Rows& view, const Rows& projection) {
    return setup_for(dialect, exactly(view), exactly(projection));
  };
  return {
      setup("opengl", right, gl),
      setup("d3d", right, book::perspective_d3d_right(c.fovy, kAspect, c.near, c.far)),
      setup("d3d", left, book::perspective_d3d_left(c.fovy, kAspect, c.near, c.far)),
      setup("vulkan", right, book::perspective_vulkan(c.fovy, kAspect, c.near, c.far)),
      setup("reversed", right, book::perspective_reversed_infinite(c.fovy, kAspect, c.near)),
      setup("opengl", right, book::frustum_gl(-1, 2, -1, 0.5, 1, 50)),
      setup("opengl", right, book::ortho_gl(-4, 4, -3, 3, 0, 20)),
      setup("d3d", left, book::ortho_d3d(-4, 4, -3, 3, 0, 20, true)),
      setup("vulkan", right, book::ortho_vulkan(-4, 4, -3, 3, 0, 20)),
      setup("opengl", book::identity(), book::product(gl, right)),
      setup("opengl", book::product(book::scaling(2, 2, 2), right), gl),
      setup("opengl", book::product(book::scaling(1, 3, 2), right), gl),
      setup("opengl",
            book::product(book::turn_x(20), book::product(book::scaling(1, 1, -1), right)), gl),
      setup("opengl", right, book::product(book::scaling(-3, 3, 3), gl)),
  };
}

glm::dvec4 clip_of(const MatrixView& view, const glm::dvec4& world) {
  return view.view.clip_from_eye.columns * (view.view.eye_from_world.columns * world);
}

// The clip position that the given matrices compute, in our clip space.
glm::dvec4 expected_clip(const MatrixSetup& s, const glm::dvec4& world, DepthRange range) {
  glm::dvec4 clip = s.projection.m * (s.view.m * world);
  if (s.dialect.z_from_minus_w) clip.z = (clip.z + clip.w) / 2;
  if (s.dialect.depth != range) clip.z = clip.w - clip.z;
  if (s.dialect.ndc_y_down) clip.y = -clip.y;
  return clip;
}

// The numbers of the triangles that a picture shows.
std::set<std::uint32_t> visible_triangles(const Scene& scene, const View& view, Cull cull) {
  RenderSettings settings;
  settings.want_id = true;
  settings.cull = cull;
  const Rendering drawn = render_staged(scene, view, settings);
  std::set<std::uint32_t> found(drawn.buffers.id.pixels.begin(), drawn.buffers.id.pixels.end());
  found.erase(0);
  return found;
}

bool share_a_triangle(const std::set<std::uint32_t>& a, const std::set<std::uint32_t>& b) {
  return std::ranges::any_of(a, [&](std::uint32_t triangle) { return b.contains(triangle); });
}

Image<Rgba8> picture(const Scene& scene, const View& view) {
  Rendering drawn = render_staged(scene, view, RenderSettings{});
  return std::move(drawn.buffers.color);
}

GivenMatrix given_matrix(const glm::dmat4& m) {
  GivenMatrix matrix;
  matrix.m = m;
  matrix.given = true;
  return matrix;
}

}  // namespace

TEST_CASE("a view of any matrices gives their clip coordinates, from an eye that looks down -z") {
  Random random(1);
  for (int repeat = 0; repeat < 50; ++repeat) {
    const auto conventions = conventions_of(random_camera(random));
    for (std::size_t i = 0; i < conventions.size(); ++i) {
      for (const DepthRange range : {DepthRange::kStandard, DepthRange::kReversed}) {
        CAPTURE(repeat, i);
        const MatrixView view = made(conventions[i], range);
        const glm::dmat4& e = view.view.eye_from_world.columns;
        const glm::dmat4& p = view.view.clip_from_eye.columns;
        CHECK(orthogonality_error(glm::dmat3(e)) < 1e-12);
        const double along = view.view.perspective ? -1 : 0;
        CHECK(p[0][3] == 0);
        CHECK(p[1][3] == 0);
        CHECK(std::abs(p[2][3] - along) < 1e-12);
        CHECK(std::abs(p[3][3] - (1 + along)) < 1e-12);
        const glm::dvec4 somewhere(book::random_place(random, 3)[0], 1, -2, 1);
        const double factor =
            clip_of(view, somewhere).w / expected_clip(conventions[i], somewhere, range).w;
        CHECK(factor > 0);
        for (int k = 0; k < 8; ++k) {
          const book::Vector3 place = book::random_place(random, 5);
          const glm::dvec4 world(place[0], place[1], place[2], 1);
          const glm::dvec4 ours = clip_of(view, world);
          const glm::dvec4 theirs = factor * expected_clip(conventions[i], world, range);
          // Some twenty roundings in double, of coordinates below 1000.
          for (int j = 0; j < 4; ++j) CHECK(std::abs(ours[j] - theirs[j]) < 1e-10);
        }
      }
    }
  }
}

TEST_CASE("our own matrices, converted to any API, draw the same bytes") {
  Random random(2);
  const Scene scene = make_builtin("teapot:4").value();
  for (int repeat = 0; repeat < 6; ++repeat) {
    const BookCamera c = random_camera(random);
    const MatrixView first =
        made(setup_for("glassbox", exactly(book::look_at_right(c.eye, c.at, {0, 1, 0})),
                       // Entries of floats: then 2z - w and (z + w)/2 are exact in double.
                       book::given(book::perspective_d3d_right(c.fovy, kAspect, c.near, c.far))));
    const GivenMatrix view = given_matrix(first.view.eye_from_world.columns);
    const glm::dmat4 p = first.view.clip_from_eye.columns;
    const Image<Rgba8> expected = picture(scene, first.view);
    for (const ApiDialect& dialect : api_dialects()) {
      for (const bool looks_along_plus_z : {false, true}) {
        CAPTURE(dialect.name, looks_along_plus_z, repeat);
        glm::dmat4 theirs = p;
        for (int column = 0; column < 4; ++column) {
          glm::dvec4& entry = theirs[column];
          if (dialect.ndc_y_down) entry.y = -entry.y;
          if (dialect.depth == DepthRange::kReversed) entry.z = entry.w - entry.z;
          if (dialect.z_from_minus_w) entry.z = 2 * entry.z - entry.w;
        }
        GivenMatrix their_view = view;
        if (looks_along_plus_z) {
          theirs[2] = -theirs[2];
          for (int column = 0; column < 4; ++column) their_view.m[column].z *= -1;
        }
        const MatrixView again = made(setup_for(dialect.name, their_view, given_matrix(theirs)));
        CHECK(again.looks_along_plus_z == looks_along_plus_z);
        CHECK(again.eye_space_is_given);
        CHECK_FALSE(again.mirrors);
        // (w - z) is rounded, and its error is that of a float's depth; colours do not depend on it
        // where nothing intersects.
        CHECK(picture(scene, again.view) == expected);
      }
    }
  }
}

TEST_CASE("matrices that mirror still show the outside, unless the API's front faces are given") {
  Random random(3);
  const Scene scene = make_builtin("sphere").value();
  for (int repeat = 0; repeat < 10; ++repeat) {
    const BookCamera c = random_camera(random);
    const Rows view = book::look_at_right(c.eye, c.at, {0, 1, 0});
    const Rows projection = book::perspective_gl(c.fovy, kAspect, c.near, c.far);
    const Rows mirrored = book::product(book::scaling(-1, 1, 1), projection);
    const MatrixView usual = made(setup_for("opengl", exactly(view), exactly(projection)));
    const auto inside = visible_triangles(scene, usual.view, Cull::kFront);
    const auto outside = visible_triangles(scene, usual.view, Cull::kBack);
    REQUIRE_FALSE(share_a_triangle(inside, outside));

    MatrixSetup setup = setup_for("opengl", exactly(view), exactly(mirrored));
    CHECK(made(setup).mirrors);
    const auto seen = visible_triangles(scene, made(setup).view, Cull::kBack);
    CHECK(seen.size() > 20);
    CHECK_FALSE(share_a_triangle(seen, inside));

    // A model matrix that mirrors does not change what an API takes for front faces.
    for (const bool mirrors_model : {false, true}) {
      setup.model = exactly(book::scaling(mirrors_model ? -1 : 1, 1, 1));
      Scene placed = scene;
      for (Node& node : placed.nodes) {
        node.world_from_node = Transform<World, World>(setup.model.m) * node.world_from_node;
      }
      setup.front = FrontFaces::kCounterClockwise;
      const auto counter = visible_triangles(placed, made(setup).view, Cull::kBack);
      setup.front = FrontFaces::kClockwise;
      const auto clockwise = visible_triangles(placed, made(setup).view, Cull::kBack);
      CHECK(counter.size() > 20);
      CHECK(clockwise.size() > 20);
      CHECK_FALSE(share_a_triangle(counter, clockwise));
      // The projection mirrors: the outside of an unmirrored model runs clockwise.
      if (!mirrors_model) CHECK_FALSE(share_a_triangle(clockwise, inside));
    }
  }
}

TEST_CASE("the planes of a projection are its view's near and far distances") {
  const Rows view = book::look_at_right({0, 0, 5}, {0, 0, 0}, {0, 1, 0});
  const auto planes = [&](const char* dialect, const Rows& projection) {
    const View v = made(setup_for(dialect, exactly(view), exactly(projection))).view;
    return std::pair(v.near, v.far);
  };
  const auto [n1, f1] = planes("opengl", book::perspective_gl(1, 1.5, 0.25, 64));
  CHECK(std::abs(n1 - 0.25) < 1e-12);
  CHECK(std::abs(f1 - 64) < 1e-9);
  const auto [n2, f2] = planes("reversed", book::perspective_reversed_infinite(1, 1.5, 0.25));
  CHECK(std::abs(n2 - 0.25) < 1e-12);
  CHECK(std::isinf(f2));
  const auto [n3, f3] = planes("vulkan", book::ortho_vulkan(-1, 1, -1, 1, -2, 8));
  CHECK(std::abs(n3 + 2) < 1e-12);
  CHECK(std::abs(f3 - 8) < 1e-12);
}

TEST_CASE("matrices from which no picture follows are refused, and say why") {
  const GivenMatrix view = exactly(book::look_at_right({0, 0, 5}, {0, 0, 0}, {0, 1, 0}));
  const Rows projection = book::perspective_gl(1, 1.5, 0.25, 64);
  const auto error = [&](const Rows& rows, int width = kWidth) {
    const auto v = view_of_matrices(setup_for("opengl", view, exactly(rows)), width, kHeight,
                                    DepthRange::kStandard);
    REQUIRE_FALSE(v);
    return v.error().message();
  };
  Rows nan = projection;
  nan[1][2] = std::numeric_limits<double>::quiet_NaN();
  CHECK(error(nan).find("row 1, column 2 is not a finite number") != std::string::npos);
  CHECK(error(book::scaling(0, 0, 0)).find("no eye") != std::string::npos);
  CHECK(error(book::product(book::scaling(1, 0, 1), projection)).find("no eye") !=
        std::string::npos);
  CHECK(error(book::scaling(1e39, 1, 1)).find("too large for a float") != std::string::npos);
  CHECK(error(projection, 0).find("0 pixels") != std::string::npos);
}

TEST_CASE("a projection knows the shape of its window") {
  const auto aspect = [](const Rows& rows) { return aspect_of_projection(exactly(rows)); };
  CHECK(std::abs(aspect(book::perspective_gl(1, 1.6, 0.1, 9)).value() - 1.6) < 1e-12);
  CHECK(std::abs(aspect(book::perspective_vulkan(1, 0.5, 0.1, 9)).value() - 0.5) < 1e-12);
  CHECK(std::abs(aspect(book::ortho_gl(0, 640, 0, 480, -1, 1)).value() - 640.0 / 480) < 1e-12);
  const Rows view = book::look_at_right({1, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const Rows both = book::product(book::perspective_gl(1, 1.6, 0.1, 9), view);
  CHECK(std::abs(aspect(both).value() - 1.6) < 1e-9);
  CHECK_FALSE(aspect(book::scaling(0, 1, 1)));
}

}  // namespace glassbox
