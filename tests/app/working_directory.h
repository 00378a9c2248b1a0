// Runs the program in a directory of its own.
#pragma once

#include <bit>
#include <cstdint>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/images/temporary_directory.h"
#include "tests/support/run_program.h"

namespace glassbox::test {

class WorkingDirectory {
public:
  // Runs the program with the words of `words`, which are separated by blanks.
  Outcome run(const std::string& words, const std::function<void(pid_t)>& meanwhile = {}) const {
    std::istringstream in(words);
    return run_program(GLASSBOX_PROGRAM, {std::istream_iterator<std::string>(in), {}},
                       directory_.path().string(), meanwhile);
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
  }
  std::string read(const std::string& name) const {
    std::ifstream in(file(name), std::ios::binary);
    if (!in) throw std::runtime_error(name + " is not there");
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string file(const std::string& name) const { return directory_.file(name); }
  std::vector<std::string> names() const { return directory_.names(); }
  std::string path() const { return directory_.path().string(); }

private:
  TemporaryDirectory directory_;
};

// Returns the numbers' bytes as glTF buffers store them.
inline std::string float_bytes(const std::vector<float>& values) {
  std::string bytes;
  for (const float value : values) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int k = 0; k < 4; ++k) bytes += char(bits >> (8 * k) & 0xffu);
  }
  return bytes;
}

// The contents of a PFM file, read without the library. Rows are from the top, although the file
// stores them from the bottom.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;
  float at(int x, int y) const { return values[std::size_t(y * width + x)]; }
};

inline Plane parse_pfm(const std::string& bytes) {
  std::istringstream in(bytes);
  std::string magic;
  double scale = 0;
  Plane plane;
  in >> magic >> plane.width >> plane.height >> scale;
  in.get();
  const std::size_t count = std::size_t(plane.width) * std::size_t(plane.height);
  if (magic != "Pf" || scale != -1 || bytes.size() != std::size_t(in.tellg()) + 4 * count) {
    throw std::runtime_error("not a little-endian one-channel PFM of the size it says");
  }
  const char* pixels = bytes.data() + in.tellg();
  plane.values.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t bits = 0;
    for (int k = 3; k >= 0; --k) {
      bits = bits << 8 | static_cast<unsigned char>(pixels[4 * i + std::size_t(k)]);
    }
    const std::size_t width = std::size_t(plane.width);
    const std::size_t row = std::size_t(plane.height) - 1 - i / width;
    plane.values[row * width + i % width] = std::bit_cast<float>(bits);
  }
  return plane;
}

}  // namespace glassbox::test
