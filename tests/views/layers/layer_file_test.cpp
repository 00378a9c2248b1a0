// Files of layered depth images (S1-06).
#include <cstddef>
#include <span>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/render/renderer.h>

#include "tests/support/catch.h"
#include "views/layers/layer_builder.h"
#include "views/layers/layer_file.h"
#include "views/layers/triangle_normals.h"

using namespace glassbox;
using namespace glassbox::views;

TEST_CASE(
    "S1-06: layers are the same from a file, and a file that is anything else is refused at its "
    "byte") {
  const Scene scene = make_builtin("room").value();
  const View view = make_view(scene.cameras.at(0), 24, 16).value();
  RenderSettings settings;
  settings.want_distance = true;
  const StoredLayers layers{scene.cameras[0], {1, 2, 3, 4}, build_layers(scene, view, settings, 3)};
  const std::vector<std::byte> bytes = encode_layers(layers);
  const auto again = decode_layers(bytes, "a.ldi");
  REQUIRE(again);
  CHECK(encode_layers(*again) == bytes);
  CHECK(again->image.first == layers.image.first);
  CHECK(again->image.depth == layers.image.depth);
  CHECK(again->image.color == layers.image.color);
  CHECK(again->background == layers.background);
  CHECK(again->image.camera.screen_from_world == layers.image.camera.screen_from_world);

  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 7) {
    CHECK_FALSE(decode_layers(std::span(bytes).first(size), "cut.ldi"));
  }
  const auto refused = [&](std::size_t at, std::byte value) {
    std::vector<std::byte> other = bytes;
    other.at(at) = value;
    const auto read = decode_layers(other, "bad.ldi");
    return !read && read.error().message().find("bad.ldi") != std::string::npos;
  };
  CHECK(refused(16, std::byte{'2'}));                       // a later version
  CHECK(refused(18 + 3, std::byte{1}));                     // 16 million columns
  CHECK(refused(18 + 8, std::byte{3}));                     // an unknown kind of lens
  CHECK(refused(18 + 8 + 4 + 6 * 8 + 7, std::byte{0x7f}));  // an invalid pose
  const std::size_t offsets = bytes.size() - 8 * layers.image.samples() - 4 * (24 * 16 + 1);
  // The number of samples does not match.
  CHECK(refused(offsets - 4, std::byte(bytes[offsets - 4] ^ std::byte{1})));
  CHECK(refused(offsets, std::byte{1}));
  const std::size_t depths = bytes.size() - 8 * layers.image.samples();
  CHECK(refused(depths + 3, std::byte{0xbf}));  // negative

  // The optional sections that may follow the colours.
  StoredLayers more = layers;
  more.image.normal.assign(more.image.samples(), stored_normal(1, -2, 3));
  more.image.triangle.assign(more.image.samples(), 5);
  const std::vector<std::byte> with_both = encode_layers(more);
  const auto both = decode_layers(with_both, "a.ldi");
  REQUIRE(both);
  CHECK(both->image.normal == more.image.normal);
  CHECK(both->image.triangle == more.image.triangle);
  CHECK(encode_layers(*both) == with_both);
  more.image.normal.clear();
  const auto triangles = decode_layers(encode_layers(more), "a.ldi");
  REQUIRE(triangles);
  CHECK(triangles->image.normal.empty());
  CHECK(triangles->image.triangle == more.image.triangle);
  const auto refused_section = [&](std::size_t at, std::byte value) {
    std::vector<std::byte> other = with_both;
    other.at(bytes.size() + at) = value;
    return !decode_layers(other, "bad.ldi");
  };
  const std::size_t section = 4 + 4 * layers.image.samples();
  CHECK(refused_section(0, std::byte{'N'}));        // an unknown section
  CHECK(refused_section(section, std::byte{'n'}));  // normals twice
  CHECK(refused_section(4, std::byte{127}));        // a normal that is too long
  CHECK(refused_section(7, std::byte{1}));          // a fourth number of a normal
  for (const std::size_t size : {bytes.size() + 1, bytes.size() + section - 1,
                                 bytes.size() + section + 1, with_both.size() - 1}) {
    CHECK_FALSE(decode_layers(std::span(with_both).first(size), "cut.ldi"));
  }

  // A changed byte may change the image, but never makes it invalid.
  Random random(6);
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::byte> other = i % 2 == 0 ? bytes : with_both;
    for (int k = 0; k < 3; ++k) {
      const auto at = random.integer(0, std::int64_t(other.size()) - 1);
      other[std::size_t(at)] = std::byte(random.integer(0, 255));
    }
    const auto read = decode_layers(other, "bad.ldi");
    if (read) CHECK(check(read->image, "read"));
  }
}
