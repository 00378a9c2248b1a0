// Files that Windows programs wrote in UTF-16 are read like those in UTF-8, or refused by that
// name.
#include <span>
#include <string>
#include <vector>

#include <glassbox/base/utf8.h>
#include <glassbox/mesh/formats/load_memory.h>
#include <glassbox/mesh/obj/load.h>

#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

// ASCII text in UTF-16.
std::string in_utf16(const std::string& ascii, ByteOrder order, bool mark) {
  std::string text;
  const auto append = [&](char high, char low) {
    text += order == ByteOrder::kBigEndian ? high : low;
    text += order == ByteOrder::kBigEndian ? low : high;
  };
  if (mark) append('\xfe', '\xff');
  for (const char c : ascii) append('\0', c);
  return text;
}

// The same text in the four forms that occur.
std::vector<std::string> all_forms(const std::string& ascii) {
  std::vector<std::string> forms;
  for (const ByteOrder order : {ByteOrder::kLittleEndian, ByteOrder::kBigEndian}) {
    for (const bool mark : {true, false}) forms.push_back(in_utf16(ascii, order, mark));
  }
  return forms;
}

const std::string kObj = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nusemtl m\r\nf 1 2 3\r\n";
const std::string kMtl = "newmtl m\nKd 1 0 0\n";

}  // namespace

TEST_CASE("OBJ and MTL text in UTF-16 is read like text in UTF-8") {
  for (const std::string& mtl : all_forms(kMtl)) {
    for (const std::string& obj : all_forms(kObj)) {
      const auto scene = load_obj_memory(obj, mtl);
      REQUIRE(scene);
      CHECK(scene->meshes[0].faces.size() == 1);
      CHECK(scene->materials[0].base_color == Rgba{1, 0, 0, 1});
      CHECK(scene->warnings.empty());
    }
  }
  const auto wrong =
      load_obj_memory(in_utf16(kObj + "f 1 2 9\n", ByteOrder::kLittleEndian, true), "");
  REQUIRE_FALSE(wrong);
  CHECK(wrong.error().place == "line 6");
}

TEST_CASE("a scene from memory is recognised in UTF-16, and glTF in it is refused by that name") {
  for (const std::string& obj : all_forms(kObj)) {
    CHECK(format_of(std::as_bytes(std::span(obj))) == SceneFormat::kObj);
    CHECK(load_scene_memory(std::as_bytes(std::span(obj))));
  }
  for (const std::string& gltf : all_forms("{\"asset\": {\"version\": \"2.0\"}}")) {
    CHECK(format_of(std::as_bytes(std::span(gltf))) == SceneFormat::kGltf);
    const auto scene = load_scene_memory(std::as_bytes(std::span(gltf)));
    REQUIRE_FALSE(scene);
    CHECK(scene.error().cause == "is text in UTF-16, but glTF is UTF-8");
  }
}

TEST_CASE("UTF-16 becomes UTF-8 for every character, and halves of characters are replaced") {
  for (const char32_t c :
       {0x1u, 0x7fu, 0x80u, 0x7ffu, 0x800u, 0xd7ffu, 0xe000u, 0xffffu, 0x10000u, 0x10ffffu}) {
    std::string big = "\xfe\xff";
    const auto unit = [&](char32_t u) { big += {char(u >> 8), char(u & 0xff)}; };
    if (c < 0x10000) {
      unit(c);
    } else {
      unit(0xd800 + ((c - 0x10000) >> 10));
      unit(0xdc00 + ((c - 0x10000) & 0x3ff));
    }
    const std::string utf8 = utf8_of_utf16(big, ByteOrder::kBigEndian);
    std::string_view rest = utf8;
    CHECK(take_character(rest) == c);
    CHECK(rest.empty());
  }
  const std::string replaced = "\xef\xbf\xbd";
  CHECK(utf8_of_utf16(std::string("\xd8\x00", 2), ByteOrder::kBigEndian) == replaced);
  CHECK(utf8_of_utf16(std::string("\xdc\x00\x00\x41", 4), ByteOrder::kBigEndian) == replaced + "A");
  CHECK(utf8_of_utf16(std::string("\xd8\x00\x00\x41\x00", 5), ByteOrder::kBigEndian) ==
        replaced + "A");
}

TEST_CASE("text in UTF-8, ASCII and binary data are not taken for UTF-16") {
  for (const std::string& text :
       {std::string(""), std::string("v"), std::string("v 0"), std::string("\xef\xbb\xbfv 0"),
        std::string("\0\0", 2), std::string("\xc3\xa9"), std::string("\0\xc3", 2)}) {
    CHECK_FALSE(utf16_byte_order(text));
  }
}

}  // namespace glassbox::test
