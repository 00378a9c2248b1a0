// Several measurements for every pixel, such as those of a satellite at several wavelengths.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace glassbox::views {

struct Band {
  std::string name;
  std::vector<double> samples;  // row by row from the top
};

// All bands have width * height samples.
struct Bands {
  int width = 0, height = 0;  // in px
  std::vector<Band> bands;

  int count() const { return int(bands.size()); }
  std::size_t pixels() const { return std::size_t(width) * std::size_t(height); }
};

}  // namespace glassbox::views
