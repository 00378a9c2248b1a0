// Cameras of glTF files: their poses, and those that cannot be used.
#include <cmath>
#include <string>
#include <vector>

#include <glassbox/base/random.h>

#include "tests/mesh/gltf_builder.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

const json kLens = {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}};

// A triangle, and the nodes of a chain from the root down, the last of which has camera 0.
Result<Scene> with_camera(const json& camera, std::vector<json> chain) {
  GltfBuilder b;
  b.triangle();
  // With braces alone, clang++ makes a copy of the camera in place of a list.
  b.document["cameras"] = json::array({camera});
  json& nodes = b.document["nodes"];
  chain.back()["camera"] = 0;
  const std::size_t first = nodes.size();
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (i + 1 < chain.size()) chain[i]["children"] = {first + i + 1};
    nodes.push_back(chain[i]);
  }
  return b.load();
}

Camera only_camera(const Result<Scene>& scene) {
  INFO((scene ? "" : scene.error().message()));
  REQUIRE(scene);
  REQUIRE(scene->cameras.size() == 1);
  return scene->cameras[0];
}

json random_rotation(Random& random) {
  json q = json::array();
  for (int i = 0; i < 4; ++i) q.push_back(random.between(-1, 1));
  return q;
}

TEST_CASE("a camera ignores the scale of its node and of those above, negative and zero as well") {
  Random random(41);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<json> plain, scaled;
    for (std::int64_t depth = random.integer(1, 3); depth > 0; --depth) {
      json node = {{"rotation", random_rotation(random)}};
      plain.push_back(node);
      node["scale"] = json::array();
      for (int i = 0; i < 3; ++i) node["scale"].push_back(random.integer(-2, 2));
      scaled.push_back(node);
    }
    scaled.back()["scale"] = {-1, random.integer(-1, 1), random.integer(0, 2)};
    CAPTURE(trial);
    const Camera expected = only_camera(with_camera(kLens, plain));
    const Camera camera = only_camera(with_camera(kLens, scaled));
    REQUIRE(camera.fault.empty());
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        CHECK(std::abs(camera.world_from_eye.at(row, column) -
                       expected.world_from_eye.at(row, column)) < 1e-12);
      }
    }
  }
}

TEST_CASE("the place of a camera does follow the scale of the nodes above it") {
  const Camera camera = only_camera(with_camera(
      kLens, {{{"scale", {-2, 1, 3}}}, {{"translation", {1, 1, 1}}, {"scale", {0, 0, 0}}}}));
  CHECK(camera.fault.empty());
  CHECK(camera.world_from_eye.at(0, 3) == -2);
  CHECK(camera.world_from_eye.at(1, 3) == 1);
  CHECK(camera.world_from_eye.at(2, 3) == 3);
  CHECK(camera.world_from_eye.at(2, 2) == 1);
}

TEST_CASE("a camera that cannot be used is named and keeps its number, and the file is drawn") {
  struct Case {
    json camera, node;
    const char* fault;
  };
  const auto parallel = [](double xmag, double ymag, double near, double far) {
    return json{{"type", "orthographic"},
                {"orthographic", {{"xmag", xmag}, {"ymag", ymag}, {"znear", near}, {"zfar", far}}}};
  };
  const auto perspective = [](double yfov, double near, double far) {
    return json{{"type", "perspective"},
                {"perspective", {{"yfov", yfov}, {"znear", near}, {"zfar", far}}}};
  };
  const std::vector<Case> cases = {
      {kLens, {{"matrix", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 1}}}, "orientation"},
      {kLens, {{"matrix", {1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}, "orientation"},
      {parallel(1, -1, 0, 1), json::object(), "half height (ymag)"},
      {parallel(0, 1, 0, 1), json::object(), "half width (xmag)"},
      {parallel(1, 1, 1, 1), json::object(), "far plane"},
      {perspective(4, 1, 2), json::object(), "field of view"},
      {perspective(1, 2, 1), json::object(), "far plane"},
      {perspective(1, 0, 1), json::object(), "near plane"}};
  for (const Case& c : cases) {
    GltfBuilder b;
    b.triangle();
    b.document["cameras"] = {c.camera, kLens};
    json node = c.node;
    node["camera"] = 0;
    node["name"] = "bad";
    b.document["nodes"].push_back(node);
    b.document["nodes"].push_back({{"camera", 1}, {"name", "good"}});
    const auto scene = b.load();
    INFO(c.fault << ": " << error_of(scene));
    REQUIRE(scene);
    REQUIRE(scene->cameras.size() == 2);
    CHECK(mentions(scene->cameras[0].fault, c.fault));
    CHECK(scene->cameras[0].name == "bad");
    CHECK(scene->cameras[1].fault.empty());
    REQUIRE(scene->warnings.size() == 1);
    CHECK(mentions(scene->warnings[0], "the camera 'bad' cannot be used: "));
    CHECK(mentions(scene->warnings[0], c.fault));
  }
}

}  // namespace
}  // namespace glassbox::test
