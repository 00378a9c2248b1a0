// The colours of a PLY element. The format does not say in which range their numbers are.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <glassbox/mesh/input/text.h>
#include <glassbox/mesh/mesh.h>
#include <glassbox/mesh/ply/header.h>
#include <glassbox/mesh/ply/property_indices.h>

namespace glassbox::ply {

// Collects the colours of one element as written, because their range follows from the largest
// number of all.
//
// The range is from 0 to the largest number of the type (1 for float and double). Exporters also
// write 0 to 255 or 0 to 65535 in wider types. So for integers of 16 bits or more the range ends at
// the first of 255, 65535 and the type's largest number that is not below any number of the
// element. For float and double it ends at 255 or 65535 if a number is 2 or more: numbers a little
// above 1 are fractions that were not clamped.
class ColorTable {
public:
  bool empty() const { return written_.empty(); }
  std::size_t size() const { return written_.size(); }

  // Adds the colour that is in the row of an element.
  void add(const Element& element, const ColorPropertyIndices& indices,
           const std::vector<double>& row);

  // The colours as linear light. Numbers are clamped to their range, taken as sRGB, and rounded to
  // one of its 256 codes. Warns where the range is not that of the type; `element` ("vertex") is
  // named.
  std::vector<Rgba> take(const std::string& element, obj::Warnings& warnings);

private:
  static constexpr std::size_t kTypes = 8;

  std::vector<std::array<double, 4>> written_;  // red, green, blue, alpha
  std::array<Type, 4> types_{};
  bool has_alpha_ = false;
  std::array<double, kTypes> largest_{};  // by type: the largest number, or 0
};

}  // namespace glassbox::ply
