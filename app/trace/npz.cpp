#include "app/trace/npz.h"

#include <utility>

#include <fmt/format.h>

#include "labs/framework/zip.h"

namespace glassbox::app {

namespace {

// The shape as a Python tuple: "(5, 3)", "(5,)", "()"
std::string tuple_of(const std::vector<std::size_t>& shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i)
    text += fmt::format("{}{}", i ? ", " : "", shape[i]);
  return text + (shape.size() == 1 ? ",)" : ")");
}

// The header that precedes an array's bytes.
std::string npy_header(const std::string& type, const std::vector<std::size_t>& shape) {
  std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type,
                                 tuple_of(shape));
  // Magic number, version and length take 10 bytes. The size of the whole header must be a multiple
  // of 64, and its last byte a line break.
  constexpr std::size_t kBefore = 10, kMultiple = 64;
  const std::size_t whole = (kBefore + text.size() + 1 + kMultiple - 1) / kMultiple * kMultiple;
  text.resize(whole - kBefore - 1, ' ');
  text += '\n';
  const std::size_t length = text.size();
  return std::string("\x93NUMPY\x01\x00", 8) + char(length & 0xffu) + char(length >> 8) + text;
}

labs::ZipEntry entry(const std::string& name, const std::string& type,
                     const std::vector<std::size_t>& shape, const std::string& bytes) {
  const std::string header = npy_header(type, shape);
  labs::ZipEntry file{name + ".npy", {}, false};
  file.text.reserve(header.size() + bytes.size());
  file.text += header;
  file.text += bytes;
  return file;
}

}  // namespace

Result<std::vector<std::byte>> make_npz(TraceArrays& arrays, const std::string& about) {
  std::vector<labs::ZipEntry> files;
  files.push_back(entry("about", "|u1", {about.size()}, about));
  for (Table& table : arrays.tables()) {
    for (Array& array : table.arrays()) {
      if (!array.wanted) continue;
      files.push_back(
          entry(array.name, array.type, table.shape_of(array), std::exchange(array.bytes, {})));
    }
  }
  return labs::make_zip(files);
}

}  // namespace glassbox::app
