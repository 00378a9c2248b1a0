// The numbers after the header of a PLY file, one after the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <glassbox/base/error.h>
#include <glassbox/mesh/ply/header.h>

namespace glassbox::ply {

// Numbers are returned as double, which represents every type of PLY exactly; text becomes the
// nearest number of its type.
class Values {
public:
  Values(std::string_view file, const Header& header)
      : rest_(file.substr(header.data_begin)),
        size_(file.size()),
        line_(header.data_line),
        format_(header.format) {}

  // Reads the next number. Returns false if there is no number that the type can represent;
  // problem() then has the reason.
  bool next(Type type, double& number);

  // Whether there are at least as many bytes left as `count` numbers need.
  bool has_room_for(std::uint64_t count, Type type) const {
    const std::uint64_t each = format_ == Format::kAscii ? 2 : bytes_of(type);
    return count <= (std::uint64_t(rest_.size()) + 1) / each;
  }

  // The current place in the file: "line 12", or "byte 300" of a binary file.
  std::string position_text() const;
  const std::string& problem() const { return problem_; }

private:
  bool next_binary(Type type, double& number);
  bool next_text(Type type, double& number);
  bool refuse(std::string problem) {
    problem_ = std::move(problem);
    return false;
  }

  std::string_view rest_;
  std::size_t size_;
  std::uint64_t line_;
  Format format_;
  std::string problem_;
};

}  // namespace glassbox::ply
