// Builds PLY files in memory in each of the three formats.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include <glassbox/mesh/ply/load.h>

namespace glassbox::test {

enum class PlyFormat { kAscii, kLittleEndian, kBigEndian };

class PlyBuilder {
public:
  explicit PlyBuilder(PlyFormat format) : format_(format) {
    const char* name = format == PlyFormat::kAscii          ? "ascii"
                       : format == PlyFormat::kLittleEndian ? "binary_little_endian"
                                                            : "binary_big_endian";
    file_ = std::string("ply\nformat ") + name + " 1.0\n";
  }

  // ---- header ----

  PlyBuilder& comment(const std::string& text) { return line("comment " + text); }
  PlyBuilder& element(const std::string& name, std::uint64_t count) {
    return line("element " + name + " " + std::to_string(count));
  }
  PlyBuilder& property(const std::string& type, const std::string& name) {
    return line("property " + type + " " + name);
  }
  PlyBuilder& list(const std::string& count, const std::string& type, const std::string& name) {
    return line("property list " + count + " " + type + " " + name);
  }
  PlyBuilder& begin_data() { return line("end_header"); }

  // ---- data ----

  PlyBuilder& floats(const std::vector<double>& numbers) { return put<float>(numbers); }
  PlyBuilder& doubles(const std::vector<double>& numbers) { return put<double>(numbers); }
  PlyBuilder& uchars(const std::vector<int>& numbers) { return put<std::uint8_t>(numbers); }
  PlyBuilder& ushorts(const std::vector<int>& numbers) { return put<std::uint16_t>(numbers); }
  PlyBuilder& ints(const std::vector<int>& numbers) { return put<std::int32_t>(numbers); }
  PlyBuilder& uints(const std::vector<int>& numbers) { return put<std::uint32_t>(numbers); }
  PlyBuilder& words(const std::string& text) {
    file_ += text + " ";
    return *this;
  }
  PlyBuilder& end_row() {
    if (format_ == PlyFormat::kAscii) file_ += "\n";
    return *this;
  }

  const std::string& file() const { return file_; }

private:
  PlyBuilder& line(const std::string& text) {
    file_ += text + "\n";
    return *this;
  }

  template <class T, class Number>
  PlyBuilder& put(const std::vector<Number>& numbers) {
    for (const Number number : numbers) {
      const T value = static_cast<T>(number);
      if (format_ == PlyFormat::kAscii) {
        std::ostringstream text;
        text.precision(17);
        text << +value << ' ';
        file_ += text.str();
      } else {
        auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
        if (format_ == PlyFormat::kBigEndian) std::reverse(bytes.begin(), bytes.end());
        file_.append(bytes.data(), bytes.size());
      }
    }
    return *this;
  }

  PlyFormat format_;
  std::string file_;
};

// A triangle: a valid file, from which tests make invalid ones.
inline PlyBuilder ply_triangle(PlyFormat format) {
  PlyBuilder b(format);
  b.element("vertex", 3).property("float", "x").property("float", "y").property("float", "z");
  b.element("face", 1).list("uchar", "int", "vertex_indices");
  b.begin_data();
  for (int i = 0; i < 3; ++i) b.floats({double(i), double(i * i), 0}).end_row();
  b.uchars({3}).ints({0, 1, 2}).end_row();
  return b;
}

}  // namespace glassbox::test
