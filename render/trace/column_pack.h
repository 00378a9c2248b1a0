// Stores columns of numbers as bytes that compress well: the binary form of a trace for HTML pages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace glassbox {

struct ColumnEntry {
  std::string name;
  const char* type = "";  // "u8", "u16", "u32", "f32" or "f64"
  std::size_t count = 0;
};

// Stores columns one after the other. Numbers of up to 32 bits are stored, by their bits, as
// differences from the previous number, modulo 2^bits, because consecutive numbers of a run are
// similar. First come the lowest bytes of all numbers of the column, then the next ones, and so on.
// Doubles are only split into bytes. inspect/columns.js decodes them.
class ColumnPack {
public:
  template <class T>
  void add(std::string name, std::span<const T> numbers) {
    entries_.push_back({std::move(name), type_name<T>(), numbers.size()});
    append({reinterpret_cast<const std::uint8_t*>(numbers.data()), numbers.size_bytes()},
           sizeof(T));
  }
  template <class T>
  void add(std::string name, const std::vector<T>& numbers) {
    add(std::move(name), std::span<const T>(numbers));
  }

  const std::vector<ColumnEntry>& entries() const { return entries_; }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

private:
  template <class T>
  static constexpr const char* type_name() {
    if constexpr (std::is_same_v<T, std::uint8_t>) return "u8";
    if constexpr (std::is_same_v<T, std::uint16_t>) return "u16";
    if constexpr (std::is_same_v<T, std::uint32_t>) return "u32";
    if constexpr (std::is_same_v<T, float>) return "f32";
    if constexpr (std::is_same_v<T, double>) return "f64";
  }
  void append(std::span<const std::uint8_t> numbers, std::size_t size);

  std::vector<ColumnEntry> entries_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace glassbox
