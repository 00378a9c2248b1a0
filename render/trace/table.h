// Columns of numbers with names, types and shapes, like NumPy's arrays.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <glassbox/base/arithmetic.h>

namespace glassbox {

struct Array {
  std::string name;                // for example "corner.clip"
  std::string type;                // NumPy's name: "<f4", "|b1"
  std::vector<std::size_t> shape;  // of one row
  std::size_t row_bytes = 0;
  bool wanted = true;
  std::string bytes;  // row after row, the last index fastest; matrices row by row
};

// A table of records of one kind, with a column for each of their numbers. A fill function names
// every number of a record, always in the same order: declare() makes the columns, add_row() fills
// them.
class Table {
public:
  // If `group` > 1, this many rows belong together, and the arrays have `group` as their second
  // dimension. If it is 0, there is one row, and no dimension for it.
  explicit Table(std::string prefix, std::size_t group = 1)
      : prefix_(std::move(prefix)), group_(group) {}

  // Calls `fill` only to make the columns.
  template <class Fill>
  void declare(const Fill& fill) {
    declaring_ = true;
    fill(*this);
    declaring_ = false;
  }

  template <class Fill>
  void add_row(const Fill& fill) {
    next_ = 0;
    fill(*this);
    ++rows_;
  }

  template <class T>
  void operator()(const char* name, const T& value) {
    if (declaring_) {
      Array array;
      array.name = prefix_ + "." + name;
      describe(value, array);
      arrays_.push_back(std::move(array));
      return;
    }
    Array& array = arrays_[next_++];
    if (array.wanted) append(value, array.bytes);
  }

  // Whether `name` is the name of the table or of one of its arrays.
  bool names(const std::string& name) const {
    return name == prefix_ || std::any_of(arrays_.begin(), arrays_.end(),
                                          [&](const Array& array) { return array.name == name; });
  }

  // Selects the arrays that are filled.
  void choose(const std::vector<std::string>& names) {
    const auto is_among = [&](const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (Array& array : arrays_) array.wanted = is_among(prefix_) || is_among(array.name);
  }

  // Returns the number of bytes that a row takes in all wanted arrays.
  std::size_t row_bytes() const {
    std::size_t bytes = 0;
    for (const Array& array : arrays_) bytes += array.wanted ? array.row_bytes : 0;
    return bytes;
  }

  // Reserves memory for this many rows, so that the arrays take no more than they need.
  void reserve(std::size_t rows) {
    for (Array& array : arrays_) {
      if (array.wanted) array.bytes.reserve(rows * array.row_bytes);
    }
  }

  std::size_t rows() const { return rows_; }
  std::vector<Array>& arrays() { return arrays_; }
  const std::vector<Array>& arrays() const { return arrays_; }

  // Returns all dimensions of one of the arrays: of its rows, then of the numbers in a row.
  std::vector<std::size_t> shape_of(const Array& array) const {
    std::vector<std::size_t> shape;
    if (group_ > 0) shape.push_back(rows_ / group_);
    if (group_ > 1) shape.push_back(group_);
    shape.insert(shape.end(), array.shape.begin(), array.shape.end());
    return shape;
  }

private:
  template <Arithmetic T>
  static void describe(const T&, Array& array) {
    const bool one_byte = sizeof(T) == 1;
    const char order = one_byte ? '|' : std::endian::native == std::endian::little ? '<' : '>';
    const char kind = std::is_same_v<T, bool>       ? 'b'
                      : std::is_floating_point_v<T> ? 'f'
                      : std::is_signed_v<T>         ? 'i'
                                                    : 'u';
    array.type = {order, kind, char('0' + sizeof(T))};
    array.row_bytes = sizeof(T);
    for (const std::size_t n : array.shape) array.row_bytes *= n;
  }
  template <class T, std::size_t N>
  static void describe(const std::array<T, N>& values, Array& array) {
    array.shape.push_back(N);
    describe(values[0], array);
  }
  template <int N, class T>
  static void describe(const glm::vec<N, T>& values, Array& array) {
    array.shape.push_back(std::size_t(N));
    describe(values[0], array);
  }
  template <class T>
  static void describe(const std::optional<T>&, Array& array) {
    describe(T{}, array);
  }
  template <class T>
  static void describe(const glm::mat<4, 4, T>& values, Array& array) {
    array.shape.push_back(4);
    describe(values[0], array);
  }

  template <Arithmetic T>
  static void append(const T& value, std::string& bytes) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  template <class T, std::size_t N>
  static void append(const std::array<T, N>& values, std::string& bytes) {
    for (const T& value : values) append(value, bytes);
  }
  template <int N, class T>
  static void append(const glm::vec<N, T>& values, std::string& bytes) {
    for (int i = 0; i < N; ++i) append(values[i], bytes);
  }
  // A missing value is stored as NaN.
  template <class T>
  static void append(const std::optional<T>& value, std::string& bytes) {
    append(value.value_or(T(std::numeric_limits<double>::quiet_NaN())), bytes);
  }
  template <class T>
  static void append(const glm::mat<4, 4, T>& m, std::string& bytes) {
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) append(m[column][row], bytes);
    }
  }

  std::string prefix_;
  std::size_t group_;
  bool declaring_ = false;
  std::size_t rows_ = 0, next_ = 0;
  std::vector<Array> arrays_;
};

}  // namespace glassbox
